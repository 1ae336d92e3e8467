// Pieces on the path of a step: position at a fraction of the step, bounds of their displacement, and depth of two
// pieces in each other.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "assembly/implicit_turn.hpp"
#include "broad_phase/moving_piece.hpp"
#include "geometry/hierarchical_hash_grid.hpp"
#include "integrate/explicit/tunnelling.hpp"

namespace trilith {

/// Displacement of the points of a piece over a step.
template <int D>
struct PieceWay {
  Vec<D> middle = Vec<D>::Zero();  ///< the displacement of all points lies within `spread` of this vector [m]
  double spread = 0;               ///< [m]
  double bend = 0;                 ///< additional distance of a point along its curved path [m]
};

/// AABB of values, each added with a radius.
template <int D>
struct ValueRange {
  Vec<D> low = Vec<D>::Constant(unbounded), high = Vec<D>::Constant(-unbounded);
  void add(const Vec<D>& v, double radius = 0) {
    low = low.cwiseMin(Vec<D>(v.array() - radius)), high = high.cwiseMax(Vec<D>(v.array() + radius));
  }
  [[nodiscard]] Vec<D> middle() const { return 0.5 * (low + high); }
  [[nodiscard]] double half() const { return 0.5 * (high - low).norm(); }
};

/// The nodes of a model over a step.
template <int D>
class StepPath {
 public:
  StepPath(const Model<D>& model, const State<D>& state, const StepBegin<D>& begin)
      : model_(model), state_(state), begin_(begin) {}

  [[nodiscard]] Vec<D> way(int n) const { return state_.position[n] - begin_.position[n]; }
  [[nodiscard]] Vec<D> bend(int n) const { return way(n) - begin_.dt * begin_.velocity[n]; }
  [[nodiscard]] Spin<D> turn(int n) const { return turn_between(begin_.rotation[n], state_.rotation[n]); }
  [[nodiscard]] Vec<D> position(int n, double s) const {
    return begin_.position[n] + s * (begin_.dt * begin_.velocity[n] + s * bend(n));
  }
  [[nodiscard]] Rotation<D> rotation(int n, double s) const {
    return turned_by(Spin<D>(s * turn(n)), begin_.rotation[n]);
  }
  /// Displacement of the points of a piece.
  [[nodiscard]] PieceWay<D> way_of(int piece) const;

 private:
  const Model<D>& model_;
  const State<D>& state_;
  const StepBegin<D>& begin_;
};

/// A piece at a fraction of the step, with scratch buffers.
struct PieceOnPath2 {
  MovingPiece piece;
  void place(const Model<2>& model, const StepPath<2>& path, int index, double s);
  [[nodiscard]] Vec2 middle() const;
};
struct PieceOnPath3 {
  PlacedSolid solid;
  std::vector<Vec3> position;  ///< [node] scratch, for pieces whose nodes do not turn
  std::vector<Fitted> faces;   ///< scratch
  void place(const Model<3>& model, const StepPath<3>& path, int index, double s);
  [[nodiscard]] Vec3 middle() const;
};
template <int D>
using PieceOnPath = std::conditional_t<D == 2, PieceOnPath2, PieceOnPath3>;

/// Least translation that separates the two pieces; negative if they are apart, and then a lower bound of the distance
/// [m].
double depth_between(const PieceOnPath2& a, const PieceOnPath2& b);
double depth_between(const PieceOnPath3& a, const PieceOnPath3& b);

/// Least relevant thickness of a piece: thickness of its body there, or its own width [m].
double thickness_of(const Model<2>& model, int piece);
double thickness_of(const Model<3>& model, int piece);

/// AABB of a piece at the last evaluation.
FatBox<2> box_of(const Model<2>& model, const Work<2>& work, int piece);
FatBox<3> box_of(const Model<3>& model, const Work<3>& work, int piece);

}  // namespace trilith
