// Error of an implicit step in frames of fibres, without the vibrations that the step does not resolve.
//
// The stiffness of a section jumps where a crack closes or a fibre yields or crushes. Light nodes of the frame then
// vibrate at a few hundred hertz, with a very small share of the energy of the motion. But the changes a' - a of their
// accelerations are as large as at the joints, so an estimate by a' - a alone would follow these vibrations with steps
// of tens of microseconds. As for stiff equations, the estimate is multiplied by the inverse of Newton's matrix, here
// twice (E. Hairer and G. Wanner, "Solving Ordinary Differential Equations II", 1996, section IV.8):
//
//     z = (A^-1 a_m M)^2 (a' - a),   A = a_m M + (1 - alpha_f) (K + ...),   a_m = (1 - alpha_m) / (b dt^2)
//
// A mode of the angular frequency w keeps about the share 1 / (1 + (w dt)^2 / 4)^2 of its estimate. So motion that a
// step resolves counts in full, and as dt decreases the estimate becomes the usual one.
#pragma once

#include <vector>

#include "assembly/node_forces.hpp"
#include "assembly/tangent/tangent.hpp"

namespace trilith {

/// True if some member is of fibres.
template <int D>
bool has_fibres(const Model<D>& model);

/// Replaces `jump` = a' - a [node] [m/s2], [rad/s2] by z above, at nodes on beams of fibres of bodies that touch no
/// other body at the end of the step. Impacts keep the usual estimate, and so do all other nodes. `tangent` is
/// factorised with the coefficient `inertia` = a_m of the mass [1/s2]; `work` is evaluated at the end of the step.
template <int D>
void filter_fibre_error(const Model<D>& model, const State<D>& state, const Work<D>& work, const Tangent<D>& tangent,
                        double inertia, std::vector<Dofs<D>>& jump);

}  // namespace trilith
