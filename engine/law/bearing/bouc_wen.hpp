// Smooth hysteresis (Bouc-Wen): a spring that yields gradually, for rubber and lead bearings, ropes and timber joints.
//
// Force: f = a k d + (1 - a) k z, with dz/dd = 1 - |z/Y|^n (b sign(z dd) + 1 - b) and Y = yield / k. So |z| tends to Y
// and never exceeds it. Wen, "Method for random vibration of hysteretic systems", J. Eng. Mech. Div. ASCE 102(2), 1976,
// with A = 1 and beta + gamma = 1. For b >= 1/2 the dissipated energy never decreases (Erlicher and Point,
// "Thermodynamic admissibility of Bouc-Wen type hysteresis models", C. R. Mecanique 332, 2004).
//
// Optional degradation: dz/dd = (1 - nu |z/Y|^n (...)) / eta, with nu = 1 + strength_loss e and eta = 1 +
// stiffness_loss e. So |z| tends to Y / nu^(1/n), and the initial stiffness of the yielding part is k / eta (Baber and
// Wen, "Random vibration of hysteretic, degrading systems", J. Eng. Mech. Div. ASCE 107(6), 1981). e is the dissipated
// energy over yield Y; Baber and Wen also count the energy stored at the moment. The stored energy is (1 - a) k eta z^2
// / 2, because unloading follows k / eta. Memory: `inner` is z; `compression` is the dissipated energy [J] where the
// law degrades, else 0.
//
// For both horizontal directions z and d are vectors. With r = |z|/Y and p = z . d' / |z|,
//
//   z' = (d' - nu z/|z| r^n (b |p| + (1 - b) p)) / eta,
//
// so that |z| <= Y in every azimuth. Park, Wen and Ang, "Random vibration of hysteretic systems under bi-directional
// ground motions", Earthquake Eng. Struct. Dyn. 14, 1986, with n = 2. They take |p| axis by axis, which is equal on
// straight paths. As one product it is independent of the axes (Casciati, "Stochastic dynamics of hysteretic media",
// Struct. Safety 6, 1989).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable.hpp"
#include "base/schema.hpp"
#include "law/bearing/direction.hpp"
#include "law/bearing/horizontal.hpp"

namespace trilith {

struct BoucWen {
  double stiffness = 0;       ///< [N/m]
  double yield = 0;           ///< [N]
  double hardening = 0;       ///< [1]
  double exponent = 0;        ///< [1]
  double shape = 0;           ///< [1]
  double damping = 0;         ///< [N s/m]
  double strength_loss = 0;   ///< [1]
  double stiffness_loss = 0;  ///< [1]

  static constexpr std::string_view name = "bouc_wen";
  static constexpr std::string_view sentence = "smooth hysteresis of Bouc and Wen, and a dashpot";
  static constexpr auto parameters() {
    using P = Parameter<BoucWen>;
    return std::array{
        P{&BoucWen::stiffness, "stiffness", "N/m", no_default, 0, unbounded, false, "initial stiffness"},
        P{&BoucWen::yield, "yield", "N", no_default, 0, unbounded, false,
          "force at which the initial line and the final line, without hardening, meet"},
        P{&BoucWen::hardening, "hardening", "1", 0, 0, 0.99, true, "final stiffness over initial stiffness"},
        P{&BoucWen::exponent, "exponent", "1", 2, 1, 100, true, "1: gradual transition; 10 and more: nearly a corner"},
        P{&BoucWen::shape, "shape", "1", 0.5, 0.5, 1, true,
          "0.5: unloads with the initial stiffness; 1: unloads steeper, in a slender loop"},
        P{&BoucWen::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity"},
        P{&BoucWen::strength_loss, "strength_loss", "1", 0, 0, 100, true,
          "growth of nu for a dissipated energy yield^2/stiffness; the strength decreases as nu^(-1/exponent)"},
        P{&BoucWen::stiffness_loss, "stiffness_loss", "1", 0, 0, 100, true,
          "growth of eta for the same energy; the elastic stiffness decreases as 1/eta"}};
  }
  /// Unloading is the stiffest branch; |z| lags behind a strength that falls by a share of `strength_loss` over the
  /// exponent.
  [[nodiscard]] double tangent() const {
    const double unloading = 2 * shape + (2 * shape - 1) * strength_loss / exponent;
    return stiffness * (hardening + (1 - hardening) * unloading);
  }
  [[nodiscard]] double dashpot() const { return damping; }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    const double last = yield / stiffness, change = m.mean * m.dt;
    const Wear wear = worn(before.compression);
    const double z = last * hysteresis(before.inner / last, change / last, wear);
    const double slid = change - wear.eta * (z - before.inner);
    const double smooth = (1 - hardening) * stiffness, straight = hardening * stiffness;
    DirectionResponse out;
    out.memory = before;
    out.memory.inner = z;
    out.memory.travelled += std::abs(slid);
    out.memory.force = straight * m.displacement + smooth * z;
    // Dissipation softens the spring, which itself dissipates energy: hence the divisor.
    const double softer = 0.5 * smooth * z * z * stiffness_loss / (yield * last);
    out.lost_inner = 0.5 * smooth * (z + before.inner) * slid / (1 + softer);
    if (wears()) out.memory.compression += out.lost_inner;
    const double eta = worn(out.memory.compression).eta;
    out.stored = 0.5 * straight * m.displacement * m.displacement + 0.5 * smooth * eta * z * z;
    out.yielding = wear.nu * portable::pow(std::abs(z) / last, exponent) > 0.5;
    add_dashpot(damping, m, before, out);
    return out;
  }

  struct Horizontal {
    AlongAcross inner{};                   ///< z [m]
    double dissipated = 0, travelled = 0;  ///< [J] where it degrades, path of d - z [m]
  };
  [[nodiscard]] HorizontalResponse<Horizontal> respond_horizontal(const HorizontalMotion& m,
                                                                  const Horizontal& before) const {
    const double last = yield / stiffness;
    const Wear wear = worn(before.dissipated);
    const Vec2 was = vector_of(before.inner), change = m.dt * m.mean,
               z = last * hysteresis_of_both(was / last, change / last, wear), slid = change - wear.eta * (z - was);
    const double smooth = (1 - hardening) * stiffness, straight = hardening * stiffness;
    HorizontalResponse<Horizontal> out{before, straight * m.displacement + smooth * z};
    const double softer = 0.5 * smooth * z.squaredNorm() * stiffness_loss / (yield * last);
    out.lost_inner = 0.5 * smooth * (z + was).dot(slid) / (1 + softer);
    out.memory.inner = along_across(z), out.memory.travelled += portable::hypot(slid.x(), slid.y());
    if (wears()) out.memory.dissipated += out.lost_inner;
    const double eta = worn(out.memory.dissipated).eta, size = portable::hypot(z.x(), z.y()) / last;
    out.stored = 0.5 * straight * m.displacement.squaredNorm() + 0.5 * smooth * eta * z.squaredNorm();
    out.yielding = wear.nu * portable::pow(size, exponent) > 0.5;
    return out;
  }

 private:
  struct Wear {
    double nu, eta;
  };
  [[nodiscard]] bool wears() const { return strength_loss > 0 || stiffness_loss > 0; }
  [[nodiscard]] Wear worn(double dissipated) const {
    const double e = wears() ? std::max(0.0, dissipated) * stiffness / (yield * yield) : 0;
    return {1 + strength_loss * e, 1 + stiffness_loss * e};
  }
  /// dz/dd at z, both relative to Y, while d changes with sign `sign`.
  [[nodiscard]] double slope(double z, double sign, const Wear& wear) const {
    const double bend = portable::pow(std::abs(z), exponent) * (z * sign < 0 ? 1 - 2 * shape : 1.0);
    return (1 - wear.nu * bend) / wear.eta;
  }
  /// z after d has changed by `change`, both relative to Y: fourth-order Runge-Kutta. The number of substeps follows
  /// from the exponent and increases as the strength falls, because the curve becomes sharper. Never beyond 1.
  [[nodiscard]] double hysteresis(double z, double change, const Wear& wear) const {
    double sharper = 1;
    if (wear.nu > 1)
      sharper = std::max(portable::pow(wear.nu, 1 / exponent), wear.nu * portable::pow(std::abs(z), exponent - 1));
    const int steps = 1 + static_cast<int>(std::min(1000.0, std::abs(change) * 10 * exponent * sharper));
    const double h = change / steps, sign = change < 0 ? -1 : 1;
    for (int i = 0; i < steps; ++i) {
      const double a = slope(z, sign, wear), b = slope(z + 0.5 * h * a, sign, wear),
                   c = slope(z + 0.5 * h * b, sign, wear), d = slope(z + h * c, sign, wear);
      z = std::min(1.0, std::max(-1.0, z + h / 6 * (a + 2 * b + 2 * c + d)));
    }
    return z;
  }
  /// dz/dd along the unit vector `way`, both relative to Y.
  [[nodiscard]] Vec2 slope_of_both(const Vec2& z, const Vec2& way, const Wear& wear) const {
    const double size = portable::hypot(z.x(), z.y());
    if (!(size > 0)) return way / wear.eta;
    const double p = z.dot(way) / size, bend = portable::pow(size, exponent) * (p < 0 ? (1 - 2 * shape) * p : p);
    return (way - wear.nu * bend / size * z) / wear.eta;
  }
  /// `hysteresis` for vectors.
  [[nodiscard]] Vec2 hysteresis_of_both(Vec2 z, const Vec2& change, const Wear& wear) const {
    const double path = portable::hypot(change.x(), change.y()), size = portable::hypot(z.x(), z.y());
    if (!(path > 0)) return z;
    double sharper = 1;
    if (wear.nu > 1)
      sharper = std::max(portable::pow(wear.nu, 1 / exponent), wear.nu * portable::pow(size, exponent - 1));
    const int steps = 1 + static_cast<int>(std::min(1000.0, path * 10 * exponent * sharper));
    const double h = path / steps;
    const Vec2 way = change / path;
    for (int i = 0; i < steps; ++i) {
      const Vec2 a = slope_of_both(z, way, wear), b = slope_of_both(z + 0.5 * h * a, way, wear),
                 c = slope_of_both(z + 0.5 * h * b, way, wear), d = slope_of_both(z + h * c, way, wear);
      z += h / 6 * (a + 2 * b + 2 * c + d);
      if (const double r = portable::hypot(z.x(), z.y()); r > 1) z /= r;
    }
    return z;
  }
};

}  // namespace trilith
