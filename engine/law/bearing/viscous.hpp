// Viscous damper: f = F (|v| / v0)^a in the direction of the velocity v, e.g. oil forced through orifices.
//
// In the usual form f = C |v|^a: with v0 = 1 m/s, F equals C in newtons. Constantinou and Symans, Report NCEER-92-0032,
// 1992; Soong and Dargush, "Passive Energy Dissipation Systems in Structural Engineering", 1997. For a < 1 the slope is
// unbounded at rest. So the force is linear up to the speed `linear_to`, whose slope no other part of the curve
// exceeds; it limits the time step. For a long damper or one on a brace see law/bearing/maxwell.hpp.
#pragma once

#include <array>
#include <cmath>

#include "base/portable.hpp"
#include "base/schema.hpp"
#include "law/bearing/direction.hpp"

namespace trilith {

struct Viscous {
  double force = 0;      ///< F [N]
  double speed = 0;      ///< v0 [m/s]
  double exponent = 0;   ///< a [1]
  double linear_to = 0;  ///< [m/s]

  static constexpr std::string_view name = "viscous";
  static constexpr std::string_view sentence = "viscous damper, its force in proportion to a power of the velocity";
  static constexpr auto parameters() {
    using P = Parameter<Viscous>;
    return std::array{
        P{&Viscous::force, "force", "N", no_default, 0, unbounded, false, "force at `speed`"},
        P{&Viscous::speed, "speed", "m/s", 1, 0, unbounded, false, "with 1 m/s, `force` is C of f = C v^exponent"},
        P{&Viscous::exponent, "exponent", "1", 1, 0.05, 1, true, "1: a linear dashpot; of oil dampers mostly 0.2 to 1"},
        P{&Viscous::linear_to, "linear_to", "m/s", 1e-3, 0, unbounded, false,
          "exponent below 1: speed up to which the force is linear; it limits the time step"}};
  }
  [[nodiscard]] double tangent() const { return 0; }
  [[nodiscard]] double dashpot() const {
    return exponent == 1 ? force / speed : force / linear_to * portable::pow(linear_to / speed, exponent);
  }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    DirectionResponse out;
    out.memory.damping = force_at(m.rate);
    out.lost_damping = 0.5 * (out.memory.damping + before.damping) * m.mean * m.dt;
    return out;
  }

 private:
  [[nodiscard]] double force_at(double rate) const {
    if (exponent == 1 || std::abs(rate) <= linear_to) return dashpot() * rate;
    return std::copysign(force * portable::pow(std::abs(rate) / speed, exponent), rate);
  }
};

}  // namespace trilith
