// Elastic energy in the contacts at the instant of the last evaluation.
#pragma once

#include "contact/plane/overlap_pair.hpp"
#include "model/work.hpp"

namespace trilith {

/// [J], from the pose (normal) and the trial memories (shear).
double contact_energy(const Model<2>& model, const State<2>& state, const Work<2>& work);
double contact_energy(const Model<3>& model, const State<3>& state, const Work<3>& work);

/// Of a contact of any shape in the plane: of the overlap as its pieces stand, and of the shear `remembered` [J].
double general_energy(const PlacedPiece& a, const PlacedPiece& b, const Remembered& remembered, const LawInUse& law);

}  // namespace trilith
