// The elastic energy of a contact for records, which may be asked for often.
#pragma once

#include "contact/space/solid_contact.hpp"

namespace trilith {

/// solid_contact_energy() to rounding, in a closed form where there is one. Terms of the ledger keep
/// solid_contact_energy(), so that their bits stay.
double recorded_contact_energy(const PlacedSolid& a, const PlacedSolid& b, const SolidMemory& memory,
                               const LawInUse& law, SolidOverlapBuffer& shared, SolidOverlapBuffer& scratch);

}  // namespace trilith
