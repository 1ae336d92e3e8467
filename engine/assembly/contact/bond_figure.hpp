// The figure that the event of a bond tells: the force it carried, or what broke it where that force did not.
#pragma once

#include <cmath>

#include "base/quantity_text.hpp"
#include "model/event.hpp"

namespace trilith {

/// What a bond stood for as it broke or cracked.
struct BondLimits {
  double tension, cohesion;  ///< of the whole joint [N]
  double stress;             ///< its tension [Pa]
  double couple = 0;         ///< that it carried about its normal [N m]
  double arm = 0;            ///< mean distance of its area from its middle [m]
  bool softened = false;     ///< it lost its strength by and by: of the last that broke, no limit is known
};

/// A net force this much below the strength of the joint has not broken it: stresses that hold each other in balance
/// did, or a blow within one step.
inline constexpr double idle_share = 1e-2;
/// ... and one this much below it is rounding.
inline constexpr double rounding_share = 1e-9;

/// Completes an event that has its mode and its force: by the stress that a bond broke at where moments broke it, by
/// the couple where it was twisted off, and by no figure where none is known.
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
