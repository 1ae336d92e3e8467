// How the forces of a beam on its two nodes answer to their motion: in the plane by hand, in space by differences.
#pragma once

#include <Eigen/Core>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Rows: force along x, y and moment on its first node, then on its second; columns: their places and rotations.
using BeamBlock = Eigen::Matrix<double, 6, 6>;

/// dF/dx + rate dF/dv at the present motion, for what the beam remembers in `state` [N/m] and so on. Damping of fibres
/// goes with their own tangent; how that changes is left out. `dt`: of the step that ends here [s], for damping over a
/// band; 0 leaves that out.
BeamBlock beam_block(const Model<2>& model, const State<2>& state, const Beam& beam, double rate, double dt = 0);

/// The same in space: forces and moments on both nodes, by their places and by turns about the axes of the world. By
/// differences of fourth order of the beam alone, exact to some 1e-12 of its largest entry; of one that yields by its
/// tangent.
using BeamBlock3 = Eigen::Matrix<double, 12, 12>;
BeamBlock3 beam_block(const Model<3>& model, const State<3>& state, const Beam3& beam, double rate, double dt = 0);

}  // namespace trilith
