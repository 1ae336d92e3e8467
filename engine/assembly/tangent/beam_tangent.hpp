// Derivative of the forces of a beam on its two nodes with respect to their motion: analytic in the plane, by
// differences in space.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Rows: force along x, y and moment on its first node, then on its second; columns: their positions and rotations.
using BeamBlock = Eigen::Matrix<double, 6, 6>;

/// dF/dx + rate dF/dv at the present motion, with the memory of the beam in `state` [N/m] and so on. `dt`: length of
/// the step that ends here [s], for band damping; 0 ignores it. `trial`: Work::beam_memory of an evaluation of `state`,
/// whose responses of fibres (assembly/element/fibre_answers.hpp) are used instead of another one; null without. The
/// damping of a fibre beam in its first step uses its present tangent, whose change is neglected.
BeamBlock beam_block(const Model<2>& model, const State<2>& state, const Beam& beam, double rate, double dt = 0,
                     const std::vector<double>* trial = nullptr);

/// The version for space: forces and moments on both nodes, by their positions and by rotations about world axes. It
/// uses differences of fourth order of the beam alone, accurate to about 1e-12 of its largest entry; a yielding beam
/// uses its tangent.
using BeamBlock3 = Eigen::Matrix<double, 12, 12>;
BeamBlock3 beam_block(const Model<3>& model, const State<3>& state, const Beam3& beam, double rate, double dt = 0,
                      const std::vector<double>* trial = nullptr);

}  // namespace trilith
