// Friction pendulum: f = (N / R) d + Coulomb friction mu N. Zayas, Low and Mahin, Report UCB/EERC-87/01, 1987.
#pragma once

#include <array>

#include "bearing/friction.hpp"

namespace trilith {

struct Pendulum {
  double radius = 0;     ///< [m]
  double mu = 0;         ///< [1]
  double stiffness = 0;  ///< before sliding [N/m]
  double damping = 0;    ///< [N s/m]

  static constexpr std::string_view name = "pendulum";
  static constexpr std::string_view sentence = "friction pendulum: Coulomb slider on a dish of given radius";
  static constexpr auto parameters() {
    using P = Parameter<Pendulum>;
    return std::array{
        P{&Pendulum::radius, "radius", "m", no_default, 0, unbounded, false, "radius of the dish"},
        P{&Pendulum::mu, "mu", "1", no_default, 0, 100, true, "friction coefficient"},
        P{&Pendulum::stiffness, "stiffness", "N/m", no_default, 0, unbounded, false, "stiffness before sliding"},
        P{&Pendulum::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity"}};
  }
  [[nodiscard]] double tangent() const { return stiffness; }
  [[nodiscard]] double dashpot() const { return damping; }
  [[nodiscard]] static DirectionMemory begin_at(double displacement) { return Friction::begin_at(displacement); }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    // The last force is taken apart: the slider's share is needed for its loss, the dish's for its work.
    const double from = m.displacement - m.rate * m.dt;
    const double dish_before = before.compression / radius, dish = m.compression / radius;
    DirectionMemory slider = before;
    slider.force = before.force - dish_before * from;
    DirectionResponse out = Friction{mu, stiffness, damping}.respond(m, slider);
    out.memory.compression = m.compression;
    out.memory.force += dish * m.displacement;
    out.stored += 0.5 * dish * m.displacement * m.displacement;
    // Where the compression changes, it does work on the rise of the dish, which the axial direction does not see.
    out.lost_inner += 0.5 * (dish_before - dish) * from * m.displacement;
    return out;
  }
};

}  // namespace trilith
