// Contact of solids of any shape and pose, four pairs at once: from the sums over their pressed triangles to forces on
// both bodies, with friction on the resultant.
//
// Input: the sums of contact/space/triangle_sums.hpp of four pairs without a given direction, their motion, memory and
// law. Output: the same as of contact/space/flat_contact.hpp. The equations are in pressure_of_sums and
// polyhedron_contact_forces (contact/space/solid_contact.hpp), for a plain law.
#pragma once

#include "contact/space/flat_contact.hpp"
#include "contact/space/triangle_sums.hpp"

namespace trilith {

struct alignas(32) PressedContacts : ContactsInLanes {
  std::array<const PairSums*, lane_count> sums;
};

/// Computes four contacts. A lane whose area is 0 is not among FlatResponses::flat, and its other results must not be
/// used.
void respond_pressed(const PressedContacts& in, FlatResponses& out);

}  // namespace trilith
