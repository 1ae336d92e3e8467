// Softening of concrete fibres by fracture energy instead of strain.
//
// Once a member softens, the deformation gathers in one beam element, and in a beam of uniform axial strain all of its
// stations soften together. With a softening curve in strains the energy of the collapse is then proportional to the
// length h of that beam, so the answer depends on the number of beams. Instead the curve in displacements is given, by
// its area G, and the strains follow:
//
//     G = h [ integral of s de from the peak on + (f^2 - s_u^2) / 2E ]
//
// The second term is the elastic energy that the beam itself releases as it unloads from the peak stress f to s_u.
// Coleman and Spacone, "Localization issues in force-based frame elements", J. Struct. Eng. ASCE 127(11), 2001, eq. 6,
// for the law of Kent and Park (20 % residual: 0.6 f h (e_20 - e_0 + 0.8 f / E) = G). A crack: G = h t e_end / 2.
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "base/error.hpp"

namespace trilith {

/// Throws InputError if a beam of `length` [m] is longer than `most`, at which it would snap back. `key` [J/m2].
inline void require_length(std::string_view law, std::string_view key, double energy, double most, double length) {
  if (length < most) return;
  throw InputError(fmt::format(
      "{}: {} is {:g} J/m2, with which a beam of {:g} m would snap back as it softens; beams must be shorter "
      "than {:.3g} m, so give the member more divisions",
      law, key, energy, length, most));
}

/// Throws InputError for an energy of cracks without tension, or with tension_end.
template <class L>
void check_crack_energy(const L& law) {
  if (law.energy_tension == 0) return;
  if (law.tension == 0)
    throw InputError(fmt::format("{}: energy_tension is {:g} J/m2, and tension is 0; give the strength in tension",
                                 L::name, law.energy_tension));
  if (law.tension_end > 0)
    throw InputError(fmt::format(
        "{}: energy_tension and tension_end are both given; leave one out: the energy gives the strain", L::name));
}

/// The law with the tension_end that dissipates energy_tension in a beam of `length` [m], and without that energy.
template <class L>
[[nodiscard]] L with_crack_of(const L& law, double length) {
  L out = law;
  out.energy_tension = 0;
  if (law.energy_tension == 0) return out;
  require_length(L::name, "energy_tension", law.energy_tension,
                 2 * law.energy_tension * law.initial() / (law.tension * law.tension), length);
  out.tension_end = 2 * law.energy_tension / (law.tension * length);
  return out;
}

}  // namespace trilith
