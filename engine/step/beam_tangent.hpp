// How the forces of a beam on its two nodes answer to their motion, by hand.
#pragma once

#include <Eigen/Core>

#include "world/model.hpp"
#include "world/state.hpp"

namespace trilith {

/// Rows: force along x, y and moment on its first node, then on its second; columns: their places and rotations.
using BeamBlock = Eigen::Matrix<double, 6, 6>;

/// dF/dx + rate dF/dv at the present motion, for what the beam remembers in `state` [N/m] and so on. Damping of fibres
/// goes with their own tangent; how that changes is left out. `dt`: of the step that ends here [s], for damping over a
/// band; 0 leaves that out.
BeamBlock beam_block(const Model<2>& model, const State<2>& state, const Beam& beam, double rate, double dt = 0);

}  // namespace trilith
