// Smooth hysteresis: a spring that yields round a corner, as of rubber and lead bearings, ropes and timber joints.
//
// f = a k d + (1 - a) k z, with dz/dd = 1 - |z/Y|^n (b sign(z dd) + 1 - b), Y = yield / k; so |z| goes to Y and no
// further. Wen, "Method for random vibration of hysteretic systems", J. Eng. Mech. Div. ASCE 102(2), 1976, with A = 1
// and beta + gamma = 1. b from 1/2 on keeps what it gives off from falling below 0 (Erlicher and Point, "Thermodynamic
// admissibility of Bouc-Wen type hysteresis models", C. R. Mecanique 332, 2004).
#pragma once

#include <array>
#include <cmath>

#include "base/portable.hpp"
#include "base/schema.hpp"
#include "bearing/direction.hpp"

namespace trilith {

struct BoucWen {
  double stiffness = 0;  ///< [N/m]
  double yield = 0;      ///< [N]
  double hardening = 0;  ///< [1]
  double exponent = 0;   ///< [1]
  double shape = 0;      ///< [1]
  double damping = 0;    ///< [N s/m]

  static constexpr std::string_view name = "bouc_wen";
  static constexpr std::string_view sentence = "smooth hysteresis of Bouc and Wen, and a dashpot";
  static constexpr auto parameters() {
    using P = Parameter<BoucWen>;
    return std::array{
        P{&BoucWen::stiffness, "stiffness", "N/m", no_default, 0, unbounded, false, "force per displacement at first"},
        P{&BoucWen::yield, "yield", "N", no_default, 0, unbounded, false,
          "where the first line and the last one, without hardening, meet"},
        P{&BoucWen::hardening, "hardening", "1", 0, 0, 0.99, true, "stiffness at last over stiffness at first"},
        P{&BoucWen::exponent, "exponent", "1", 2, 1, 100, true, "1: a wide bend, 10 and more: nearly a corner"},
        P{&BoucWen::shape, "shape", "1", 0.5, 0.5, 1, true,
          "0.5: unloads along the first stiffness; 1: unloads steeper, in a slender loop"},
        P{&BoucWen::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity"}};
  }
  /// Unloading is the stiffest.
  [[nodiscard]] double tangent() const { return stiffness * (hardening + (1 - hardening) * 2 * shape); }
  [[nodiscard]] double dashpot() const { return damping; }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    const double last = yield / stiffness, change = m.rate * m.dt;
    const double z = last * hysteresis(before.inner / last, change / last), slid = change - (z - before.inner);
    const double smooth = (1 - hardening) * stiffness, straight = hardening * stiffness;
    DirectionResponse out;
    out.memory = before;
    out.memory.inner = z;
    out.memory.travelled += std::abs(slid);
    out.memory.force = straight * m.displacement + smooth * z;
    out.stored = 0.5 * straight * m.displacement * m.displacement + 0.5 * smooth * z * z;
    out.lost_inner = 0.5 * smooth * (z + before.inner) * slid;
    out.yielding = portable::pow(std::abs(z) / last, exponent) > 0.5;
    add_dashpot(damping, m, before, out);
    return out;
  }

 private:
  /// dz/dd at z in shares of the last, while d goes by `sign`.
  [[nodiscard]] double slope(double z, double sign) const {
    return 1 - portable::pow(std::abs(z), exponent) * (z * sign < 0 ? 1 - 2 * shape : 1.0);
  }
  /// z once d has gone on by `change`, both in shares of the last: fourth order (Runge and Kutta), in steps that a bend
  /// with the exponent needs. Never beyond 1.
  [[nodiscard]] double hysteresis(double z, double change) const {
    const int steps = 1 + static_cast<int>(std::min(1000.0, std::abs(change) * 10 * exponent));
    const double h = change / steps, sign = change < 0 ? -1 : 1;
    for (int i = 0; i < steps; ++i) {
      const double a = slope(z, sign), b = slope(z + 0.5 * h * a, sign), c = slope(z + 0.5 * h * b, sign),
                   d = slope(z + h * c, sign);
      z = std::min(1.0, std::max(-1.0, z + h / 6 * (a + 2 * b + 2 * c + d)));
    }
    return z;
  }
};

}  // namespace trilith
