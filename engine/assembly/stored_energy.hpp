// Elastic energy in the contacts at the instant of the last evaluation.
#pragma once

#include "contact/plane/overlap_pair.hpp"
#include "model/work.hpp"

namespace trilith {

/// Energy [J] from the pose (normal) and the trial memories (shear).
double contact_energy(const Model<2>& model, const State<2>& state, const Work<2>& work);
double contact_energy(const Model<3>& model, const State<3>& state, const Work<3>& work);

/// Energy of a contact of any shape in the plane [J]: of the overlap of its pieces, and of the shear in its memory.
double general_energy(const PlacedPiece& a, const PlacedPiece& b, const Remembered& remembered, const LawInUse& law);

}  // namespace trilith
