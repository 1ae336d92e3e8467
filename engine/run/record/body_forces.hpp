// Forces on bodies: resultant of contacts and bearings on a set of bodies, mean stress of each body, and the line of
// thrust through a chain of bodies. `work` must be evaluated at the present instant.
#pragma once

#include <span>
#include <vector>

#include "assembly/contact/contact_resultants.hpp"
#include "assembly/contact/solid_resultants.hpp"
#include "model/state.hpp"

namespace trilith {

/// Force of all contacts and bearings on `bodies` [N]. Forces between bodies of the set cancel. The base shear is the
/// horizontal part of the force on the base: it equals minus the sum of m a_x of the structure.
Vec2 force_on(const Model<2>& model, const Work<2>& work, std::span<const int> bodies);
Vec3 force_on(const Model<3>& model, const Work<3>& work, std::span<const int> bodies);

/// Mean stress of a body [Pa], tension positive.
struct MeanStress {
  double xx = 0, yy = 0, xy = 0;
  /// Larger and smaller principal stress.
  [[nodiscard]] double major() const;
  [[nodiscard]] double minor() const;
};

/// [body] Mean stress from the forces on the surface: 1/V sum of x f, made symmetric, x from the centroid (Love 1927;
/// Weber 1966; for a moving body without its rotational inertia). It is zero for bodies with a constrained degree of
/// freedom, whose support forces have no known point of action.
std::vector<MeanStress> mean_stress(const Model<2>& model, const State<2>& state, const Work<2>& work,
                                    std::span<const TouchingContact> touching);

/// The moving body with the largest unbalanced force, and the fastest body; -1 if none moves.
struct WorstBodies {
  int unbalanced = -1, fastest = -1;
  double force = 0;  ///< unbalanced [N]
  double speed = 0;  ///< speed of the fastest point [m/s]
};
template <int D>
WorstBodies worst_bodies(const Model<D>& model, const Work<D>& work);

/// A point of the line of thrust: point of action of the force between two neighbours of a chain.
template <int D>
struct ThrustPoint {
  int body_a, body_b;
  Vec<D> point;  ///< [m]
  Vec<D> force;  ///< on body_b [N]
};

/// The line of thrust: for each pair of consecutive bodies in `chain`, the point of action of the resultant of their
/// contacts. Neighbours without contact give no point.
std::vector<ThrustPoint<2>> thrust_line(std::span<const int> chain, std::span<const TouchingContact> touching);
std::vector<ThrustPoint<3>> thrust_line(std::span<const int> chain, std::span<const SolidResultant> touching);

}  // namespace trilith
