// Elastic energy in the contacts at the instant of the last evaluation.
#pragma once

#include "contact/face_law.hpp"
#include "world/work.hpp"

namespace trilith {

/// [J], from the pose (normal) and the trial memories (shear).
double contact_energy(const Model<2>& model, const State<2>& state, const Work<2>& work);

/// Elastic energy of the normal stresses of one contact of two faces, where Work is placed [J].
double pressing_energy(const Work<2>& work, const NearPair& pair, const ContactMemory& memory, const FaceLaw& law);

/// What of it dilation holds: let go where the contact goes over to general shape [J].
double dilation_energy(const Work<2>& work, const NearPair& pair, const ContactMemory& memory, const FaceLaw& law);

/// What of it one half holds because it is crushed less than the other: let go likewise [J].
double crushing_energy(const Work<2>& work, const NearPair& pair, const ContactMemory& memory, const FaceLaw& law);

}  // namespace trilith
