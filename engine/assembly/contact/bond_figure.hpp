// Value in the event of a bond: the force it carried, or the stress or couple that broke it.
#pragma once

#include <cmath>

#include "base/quantity_text.hpp"
#include "model/event/event.hpp"

namespace trilith {

/// Loads and limits of a bond at its failure or first damage.
struct BondLimits {
  double tension, cohesion;  ///< strengths of the whole joint [N]
  double stress;             ///< tensile strength [Pa]
  double couple = 0;         ///< couple about its normal [N m]
  double arm = 0;            ///< mean distance of its area from its middle [m]
  bool softened = false;     ///< it softened before; the limit of the last part is unknown
};

/// A net force below this share of the joint strength did not break the joint. Self-balanced stresses, or an impact
/// within one step, did.
inline constexpr double idle_share = 1e-2;
/// A net force below this share of the strength is rounding.
inline constexpr double rounding_share = 1e-9;

/// Completes an event that has a mode and a force. The value becomes the failure stress if moments broke the bond, the
/// couple if torsion did, and is removed if no limit is known.
inline void tell_figure(Event& e, const BondLimits& limits) {
  const double strength = e.mode == JointMode::tension ? limits.tension : limits.cohesion;
  if (e.value < rounding_share * strength) e.value = 0;
  if (!(e.value < idle_share * strength)) return;
  if (e.mode == JointMode::shear && std::abs(limits.couple) > idle_share * strength * limits.arm)
    e.text = quantity_text(std::abs(limits.couple), "N·m");
  else if (e.mode == JointMode::tension && !limits.softened)
    e.text = quantity_text(limits.stress, "Pa");
}

}  // namespace trilith
