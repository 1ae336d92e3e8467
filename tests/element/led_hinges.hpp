// A beam with end hinges, with prescribed stretch and end rotations, and its energies.
#pragma once

#include <algorithm>

#include "element/beam/end_hinge.hpp"

namespace trilith::testing {

inline constexpr double hinge_young = 2.1e11, hinge_span = 4;
inline const Section hinge_profile = RectangleSection{0.1, 0.2}.numbers();

inline BeamStiffness hinge_beam(bool bowed, const std::array<bool, 2>& pinned = {false, false}) {
  BeamStiffness k = beam_stiffness({hinge_young, 0}, hinge_profile, hinge_span, pinned);
  if (!bowed) k.bow = {};
  return k;
}

struct LedHinges {
  BeamStiffness stiffness;
  std::array<HingeLaw, 2> law;
  EndHingeResponse now = {};
  BeamStrain at = {};
  double work = 0, lost = 0, least_loss = 0;

  [[nodiscard]] EndHingeResponse probe(const BeamStrain& d) const {
    return respond(stiffness, {&law[0], &law[1]}, d, now.memory);
  }
  void to(const BeamStrain& d) {
    const EndHingeResponse r = probe(d);
    for (int k = 0; k < 3; ++k) work += 0.5 * (r.stress[k] + now.stress[k]) * (d[k] - at[k]);
    lost += r.dissipated, least_loss = std::min(least_loss, r.dissipated);
    at = d, now = r;
  }
  void along(const BeamStrain& d, int steps = 200) {
    const BeamStrain from = at;
    for (int i = 1; i <= steps; ++i) {
      BeamStrain next;
      for (int k = 0; k < 3; ++k) next[k] = from[k] + (d[k] - from[k]) * i / steps;
      to(next);
    }
  }
  [[nodiscard]] double unbooked() const { return work - now.stored - lost; }
};

}  // namespace trilith::testing
