// The longest stable step of explicit central differences, from the stiffness in contact, damping included.
//
// For every body: the 3 x 3 stiffness and damping of its contacts and bearings about its node, scaled by mass and
// inertia, doubled where the other side moves too (for two bodies and one spring, (a - b)^2 <= 2 a^2 + 2 b^2, so the
// largest eigenvalue of the whole is bounded by the largest of these). With lambda_K and lambda_C their bounds by row
// sums, dt <= (sqrt(4 lambda_K + lambda_C^2) - lambda_C) / lambda_K (central differences with lagged damping;
// Belytschko, Liu and Moran, "Nonlinear finite elements", 2000, sec. 6.2.3). A body in no contact counts as lying on
// its stiffest face, so that a contact that forms before the next estimate finds a safe step.
//
// In space rigid bodies have 6 x 6, about the principal axes, and the bound of a matrix M is the fourth root of the
// Frobenius norm of M^4, at most a quarter above the largest eigenvalue.
//
// For a deformable body: the largest eigenvalue of an element over its own lumped masses bounds that of all (Irons),
// and the row sums of the contacts on its nodes are added to it.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

inline constexpr double longest_step = 0.1;  ///< where nothing is stiff [s]
/// Where no step is given [s]: of implicit steps; and of explicit ones without an accuracy, which could be far longer
/// where all is soft, and would then see too little of a record, and of a limit before it is passed.
inline constexpr double usual_longest_step = 0.005;

struct StableStep {
  double dt = 0;         ///< [s]; longest_step where nothing is stiff
  int body = -1;         ///< the body that governs
  double stiffness = 0;  ///< its lambda_K [1/s2]
  double damping = 0;    ///< its lambda_C [1/s]
};

/// What bounds the step of one body, by its own masses: its elements, contacts and bearings on its nodes, and the same
/// of the body as if it were rigid (of bodies of elements that have some rigid motion, else nothing).
struct BodyRates {
  RateBound elements, contacts, rigid;
  double plain = longest_step;  ///< the step that these masses take [s]
};
std::vector<BodyRates> body_rates(const Model<2>& model, const State<2>& state, const Work<2>& work, bool as_rigid);
std::vector<BodyRates> body_rates(const Model<3>& model, const State<3>& state, const Work<3>& work, bool as_rigid);

/// From the last evaluation (faces and general contacts that touch, live bearings).
StableStep stable_step(const Model<2>& model, const State<2>& state, const Work<2>& work);
StableStep stable_step(const Model<3>& model, const State<3>& state, const Work<3>& work);

/// The longest step in which no rigid body of unlike principal moments turns by more than a tenth, so that its axis
/// goes round as it must, to some parts in ten thousand; longest_step where that is longer, and in the plane [s].
double turning_step(const Model<2>& model, const State<2>& state);
double turning_step(const Model<3>& model, const State<3>& state);

/// As stable_step, without what damping over a band adds to the stiffness of beams.
template <int D>
StableStep unbanded_step(Model<D> model, const State<D>& state, const Work<D>& work);

/// The root of lambda_K dt^2 + 2 lambda_C dt = 4, at most longest_step [s].
double step_for(double stiffness, double damping);

/// `step` times a safety, rounded down to a ladder of eight rungs per doubling, so that it rarely changes.
double settled_step(double stable, double safety);

/// In words: which body and contacts govern, and what the step would be without damping.
template <int D>
std::string explain_step(const Model<D>& model, const State<D>& state, const Work<D>& work);

}  // namespace trilith
