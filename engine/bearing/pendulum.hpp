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

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    // The slider's share alone must be known to take its loss; the dish's share follows from the displacement.
    DirectionMemory slider = before;
    slider.force = before.force - m.compression / radius * (m.displacement - m.rate * m.dt);
    DirectionResponse out = Friction{mu, stiffness, damping}.respond(m, slider);
    const double rise = m.compression / radius;
    out.memory.force += rise * m.displacement;
    out.stored += 0.5 * rise * m.displacement * m.displacement;
    return out;
  }
};

}  // namespace trilith
