// Contacts of several pieces of one body at one place.
//
// Comes in: rows of contacts of any shape; the ridges that pieces of a body share (model/builder/shared_edges.hpp).
// Goes out: of each row in which such a ridge lies in the other piece the push of its springs, and the direction of the
// sum of those at the same ridges:
//
//   n = sum of s_i / |sum of s_i|,     i: the row, and all rows of pieces that share a met ridge with one of its two
//
// Damping and friction of these rows go by n. So the ridge of a chevron slides as that of a convex stone does. A piece
// comes in by nothing as the ridge does, so n turns without a jump.
#pragma once

#include <array>
#include <cstddef>

#include "model/work.hpp"

namespace trilith {

/// Fills work.met from work.awake_rows.
void join_shared_edges(const Model<2>& model, const State<2>& state, Work<2>& work, double dt);
/// ... from all rows of work.pairs.
void join_shared_edges(const Model<3>& model, const State<3>& state, Work<3>& work, double dt);

/// Rows that are summed at most at the ridges of one; of more, as where very many tetrahedra meet, the first ones.
inline constexpr std::size_t most_at_shared_edges = 64;

/// The rows of which n is the direction for one of them, which is the first.
template <int D>
struct SharedEdgeRows {
  std::array<const MetRow<D>*, most_at_shared_edges> row;
  std::size_t count = 0;
  Vec<D> push = Vec<D>::Zero();  ///< the sum of theirs [N]

  /// Something presses there beside the first row.
  [[nodiscard]] bool has_others() const { return count > 1 && push != row[0]->push && push.norm() > 0; }
};

/// None at all where no ridge of the row is met.
template <int D>
SharedEdgeRows<D> rows_at_shared_edges(const Work<D>& work, int row);
extern template SharedEdgeRows<2> rows_at_shared_edges(const Work<2>& work, int row);
extern template SharedEdgeRows<3> rows_at_shared_edges(const Work<3>& work, int row);

/// What the springs of a contact in the plane push b by [N]; `law_after`: room of its law.
Vec2 spring_force(const PlacedPiece& a, const PlacedPiece& b, const Remembered& before, const LawInUse& law,
                  double* law_after);
/// ... one in space, by its row.
Vec3 spring_force(const Model<3>& model, const State<3>& state, Work<3>& work, int row, double dt, SolidRoom& room);

/// Sets `along` to n; false where nothing else presses at the ridges of the row.
template <int D>
bool direction_at_shared_edges(const Work<D>& work, int row, Vec<D>& along);
extern template bool direction_at_shared_edges(const Work<2>& work, int row, Vec2& along);
extern template bool direction_at_shared_edges(const Work<3>& work, int row, Vec3& along);

}  // namespace trilith
