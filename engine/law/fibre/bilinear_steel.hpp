// Bilinear steel: elastic to the yield stress, then `hardening` times the elastic modulus.
//
// Yield condition: s = E (e - p), |s - Hk p| <= yield + Hi a. Here p is the plastic strain, a its path length, and Hk +
// Hi = E b/(1 - b) for b = hardening. `isotropic` is the share of Hi in the sum: at 0 the elastic range moves
// (kinematic), at 1 it grows. Return mapping: Simo and Hughes, "Computational Inelasticity", 1998, box 1.5. The energy
// of the back stress Hk p is recoverable; all other plastic work is dissipated.
//
// Not modelled: the yield plateau, the round corner (see menegotto_pinto.hpp), rupture and buckling of bars, strain
// rate. Memory: strain, stress, p, a.
#pragma once

#include <array>
#include <cmath>

#include "base/schema.hpp"
#include "law/fibre/point.hpp"

namespace trilith {

struct BilinearSteel {
  double young = 0;      ///< [Pa]
  double yield = 0;      ///< [Pa]
  double hardening = 0;  ///< [1]
  double isotropic = 0;  ///< [1]

  static constexpr std::string_view name = "bilinear_steel";
  static constexpr std::string_view sentence = "steel fibre of two straight lines, kinematic and isotropic hardening";
  static constexpr auto parameters() {
    using P = Parameter<BilinearSteel>;
    return std::array{
        P{&BilinearSteel::young, "E", "Pa", no_default, 0, unbounded, false, "Young's modulus"},
        P{&BilinearSteel::yield, "yield", "Pa", no_default, 0, unbounded, false, "yield stress"},
        P{&BilinearSteel::hardening, "hardening", "1", 0, 0, 0.99, true, "modulus after yield over elastic modulus"},
        P{&BilinearSteel::isotropic, "isotropic", "1", 0, 0, 1, true,
          "share of isotropic hardening; the rest is kinematic"}};
  }
  static constexpr int memory_size = 4;
  using Memory = std::array<double, memory_size>;
  static constexpr bool loses_at_every_step = true;
  static constexpr int plastic = 2, way = 3;  ///< indices in the memory

  [[nodiscard]] double tangent() const { return young; }
  [[nodiscard]] double stored(const Memory& m) const {
    return 0.5 * m[last_stress] * m[last_stress] / young + 0.5 * kinematic() * m[plastic] * m[plastic];
  }

  [[nodiscard]] UniaxialResponse<memory_size> respond(double strain, const Memory& before) const {
    UniaxialResponse<memory_size> out;
    Memory& m = out.memory = before;
    const double widening = isotropic * gain(), moving = kinematic();
    const double trial = young * (strain - before[plastic]), from_middle = trial - moving * before[plastic];
    const double beyond = std::abs(from_middle) - (yield + widening * before[way]);
    out.tangent = young;
    if (beyond > 0) {
      const double flow = beyond / (young + gain());
      m[plastic] += std::copysign(flow, from_middle), m[way] += flow;
      out.tangent = young * hardening, out.yielding = true;
    }
    m[last_strain] = strain, m[last_stress] = young * (strain - m[plastic]);
    out.stored = stored(m);
    const double mean = 0.5 * (m[last_stress] + before[last_stress]),
                 back = 0.5 * moving * (m[plastic] + before[plastic]);
    out.dissipated = (mean - back) * (m[plastic] - before[plastic]);
    return out;
  }

 private:
  /// Stress increase per plastic strain [Pa].
  [[nodiscard]] double gain() const { return young * hardening / (1 - hardening); }
  [[nodiscard]] double kinematic() const { return (1 - isotropic) * gain(); }
};

}  // namespace trilith
