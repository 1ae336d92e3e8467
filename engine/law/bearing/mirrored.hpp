// A one-directional law with the sign of its displacement reversed, for a law of rotation whose axis points the other
// way. A law with a side has a row here; all other laws are symmetric.
#pragma once

#include <algorithm>

#include "law/bearing/list.hpp"

namespace trilith {

template <class L>
L mirrored(const L& law) {
  return law;
}
inline Gap mirrored(Gap law) {
  law.side = -law.side;
  return law;
}
inline Pounding mirrored(Pounding law) {
  law.side = -law.side;
  return law;
}
inline Cable mirrored(Cable law) {
  law.side = law.side < 0 ? 1 : -1;
  return law;
}
inline Table mirrored(Table law) {
  std::reverse(law.displacement.begin(), law.displacement.end());
  std::reverse(law.force.begin(), law.force.end());
  for (double& d : law.displacement) d = -d;
  for (double& f : law.force) f = -f;
  return law;
}

/// The mirrored law of a direction.
inline DirectionLaw mirrored(const DirectionLaw& law) {
  return std::visit([](const auto& l) -> DirectionLaw { return mirrored(l); }, law);
}

}  // namespace trilith
