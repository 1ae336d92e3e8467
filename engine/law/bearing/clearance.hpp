// Bearing laws that close and open as bodies strike through them, and their clearance. A new law that does so has a row
// here; for all other laws no impact is expected.
#pragma once

#include <concepts>

#include "law/bearing/list.hpp"

namespace trilith {

/// Displacement increase (way = 1) or decrease (way = -1) until the law closes [m] or [rad]. Negative where it is
/// closed by that amount, unbounded where it never closes in this direction.
inline double clearance(const Gap& law, const DirectionMemory& /*memory*/, double displacement, double way) {
  return way * law.side >= 0 ? law.opening - way * displacement : unbounded;
}
inline double clearance(const Pounding& law, const DirectionMemory& /*memory*/, double displacement, double way) {
  return way * law.side >= 0 ? law.opening - way * displacement : unbounded;
}
inline double clearance(const Cable& law, const DirectionMemory& memory, double displacement, double way) {
  if (Cable::broken(memory) || way * (law.side < 0 ? -1 : 1) < 0) return unbounded;
  return law.slack - law.pretension / law.stiffness - way * displacement;
}

/// Laws of the list above.
template <class L>
concept ClosesAndOpens = requires(const L& law, const DirectionMemory& memory) {
  { clearance(law, memory, 0.0, 1.0) } -> std::same_as<double>;
};

}  // namespace trilith
