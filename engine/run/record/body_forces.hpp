// What contacts and bearings do to bodies: force on a set of them, mean stress in each, the line of thrust through a
// chain of them. `work` must hold the evaluation of the present instant.
#pragma once

#include <span>
#include <vector>

#include "assembly/contact/contact_resultants.hpp"
#include "assembly/contact/solid_resultants.hpp"
#include "model/state.hpp"

namespace trilith {

/// Force of all contacts and bearings on `bodies` [N]. Between bodies of the set it cancels. Base shear is the
/// horizontal part of that on the base: against the structure's acceleration, minus the sum of m a_x.
Vec2 force_on(const Model<2>& model, const Work<2>& work, std::span<const int> bodies);
Vec3 force_on(const Model<3>& model, const Work<3>& work, std::span<const int> bodies);

/// Mean stress of a body [Pa], tension positive.
struct MeanStress {
  double xx = 0, yy = 0, xy = 0;
  /// The larger and the smaller principal stress.
  [[nodiscard]] double major() const;
  [[nodiscard]] double minor() const;
};

/// Mean stress of each body from the forces on its surface: 1/V sum of x f, made symmetric, x from the centroid (Love
/// 1927; Weber 1966; for a body in motion without its rotational inertia). Zero for bodies that are not free in all
/// directions, whose supports' forces have no place. [body]
std::vector<MeanStress> mean_stress(const Model<2>& model, const State<2>& state, const Work<2>& work,
                                    std::span<const TouchingContact> touching);

/// The moving body with the largest unbalanced force, and the fastest one; -1 where none moves.
struct WorstBodies {
  int unbalanced = -1, fastest = -1;
  double force = 0;  ///< unbalanced [N]
  double speed = 0;  ///< of a point of the fastest [m/s]
};
template <int D>
WorstBodies worst_bodies(const Model<D>& model, const Work<D>& work);

/// A point of the line of thrust: where the force between two neighbours of a chain acts.
template <int D>
struct ThrustPoint {
  int body_a, body_b;
  Vec<D> point;  ///< [m]
  Vec<D> force;  ///< on body_b [N]
};

/// The line of thrust: for each two bodies that follow each other in `chain`, the point in which the resultant of their
/// contacts acts. Neighbours that do not touch give none.
std::vector<ThrustPoint<2>> thrust_line(std::span<const int> chain, std::span<const TouchingContact> touching);
std::vector<ThrustPoint<3>> thrust_line(std::span<const int> chain, std::span<const SolidResultant> touching);

}  // namespace trilith
