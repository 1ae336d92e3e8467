// The longest stable step of explicit central differences, from the contact stiffness and damping.
//
// Each body has a 3 x 3 stiffness and damping matrix of its contacts and bearings about its node, scaled by mass and
// inertia. The entries are doubled if the other side moves too. For two bodies and one spring (a - b)^2 <= 2 a^2 + 2
// b^2, so the largest eigenvalue of the whole model is bounded by the largest of the bodies. With the row-sum bounds
// lambda_K and lambda_C, dt <= (sqrt(4 lambda_K + lambda_C^2) - lambda_C) / lambda_K. This holds for central
// differences with lagged damping (Belytschko, Liu and Moran, "Nonlinear finite elements", 2000, sec. 6.2.3). A body
// without contact counts as lying on its stiffest face. So the step is safe for a contact that forms before the next
// estimate.
//
// Rigid bodies in space have 6 x 6 matrices about the principal axes. The bound of a matrix M is the fourth root of the
// Frobenius norm of M^4, at most 25 % above the largest eigenvalue.
//
// For a deformable body, the largest eigenvalue of any element over its own lumped masses bounds the eigenvalues of the
// whole body (Irons). The row sums of the contacts on its nodes are added.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

inline constexpr double longest_step = 0.1;  ///< [s], if nothing is stiff
/// Default limit of the step [s], for implicit steps, and for explicit steps without an accuracy. Without stiff parts
/// the stable step could be much longer; it would then undersample records and pass bearing limits unnoticed.
inline constexpr double usual_longest_step = 0.005;

struct StableStep {
  double dt = 0;         ///< [s]; longest_step if nothing is stiff
  int body = -1;         ///< the governing body
  double stiffness = 0;  ///< its lambda_K [1/s2]
  double damping = 0;    ///< its lambda_C [1/s]
};

/// Rates that bound the step of one body, by its own masses. They contain its elements, the contacts and bearings on
/// its nodes, and these on the body as if it were rigid (only meshed bodies with a rigid motion).
struct BodyRates {
  RateBound elements, contacts, rigid;
  double plain = longest_step;  ///< step for these masses without mass scaling [s]
};
std::vector<BodyRates> body_rates(const Model<2>& model, const State<2>& state, const Work<2>& work, bool as_rigid);
std::vector<BodyRates> body_rates(const Model<3>& model, const State<3>& state, const Work<3>& work, bool as_rigid);

/// From the last evaluation: touching faces and general contacts, live bearings.
StableStep stable_step(const Model<2>& model, const State<2>& state, const Work<2>& work);
StableStep stable_step(const Model<3>& model, const State<3>& state, const Work<3>& work);

/// The longest step [s] in which no rigid body with different principal moments turns by more than 0.1 rad, at most
/// longest_step. Its axis then precesses with an error of some 1e-4. In the plane the result is always longest_step.
double turning_step(const Model<2>& model, const State<2>& state);
double turning_step(const Model<3>& model, const State<3>& state);

/// As stable_step, without the stiffness that band damping adds to beams.
template <int D>
StableStep unbanded_step(Model<D> model, const State<D>& state, const Work<D>& work);

/// The root of lambda_K dt^2 + 2 lambda_C dt = 4, at most longest_step [s].
double step_for(double stiffness, double damping);

/// `step` times a safety, rounded down to a ladder of eight rungs per doubling, so that it rarely changes.
double settled_step(double stable, double safety);

/// Text: the governing body and contacts, and the step without damping.
template <int D>
std::string explain_step(const Model<D>& model, const State<D>& state, const Work<D>& work);

}  // namespace trilith
