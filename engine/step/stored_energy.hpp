// Elastic energy in the contacts at the instant of the last evaluation.
#pragma once

#include "world/work.hpp"

namespace trilith {

/// [J], from the pose (normal) and the trial memories (shear).
double contact_energy(const Model<2>& model, const State<2>& state, const Work<2>& work);
double contact_energy(const Model<3>& model, const State<3>& state, const Work<3>& work);

}  // namespace trilith
