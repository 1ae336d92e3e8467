// Steel with round corners, as observed for reinforcing bars and structural steel under cyclic strain.
//
// From each reversal (e_r, s_r) the curve leaves with the slope E and approaches the hardening line. The tangent at the
// reversal meets that line at (e_0, s_0). The curve is:
//
//     s* = b e* + (1 - b) e* / (1 + |e*|^R)^(1/R),   e* = (e - e_r) / (e_0 - e_r),  s* = (s - s_r) / (s_0 - s_r)
//     R = R0 (1 - cR1 x / (cR2 + x)),   x = |e_m - e_0| / e_y
//
// Here e_m is the largest strain so far, at least e_y, on the side of loading. Menegotto and Pinto, IABSE Symposium
// Lisbon, 1973; Filippou, Popov and Bertero, "Effects of bond deterioration on hysteretic behavior of reinforced
// concrete joints", EERC 83-19, 1983, where a1 = R0 cR1 and a2 = cR2. Isotropic hardening is also theirs: the hardening
// line is shifted by a3 (e_max/e_y - a4) yield, not below 0, with e_max the largest strain on either side.
//
// Not modelled: earlier reversals (only the last one is stored, so after a small unloading within a large loop the
// stress returns slightly above the previous curve); rupture and buckling of bars.
//
// The stored energy is s^2 / 2E. Because the corner is round, part of the flow after a reversal is opposite to the
// stress. So such steps dissipate a slightly negative energy, and so may small loops at a high stress because of the
// higher return curve: about 1e-5 of the stored energy.
//
// Memory: strain, stress, loading direction (-1, 0, 1), e_r, s_r, e_0, s_0, least and greatest strain at reversals, R.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable.hpp"
#include "base/schema.hpp"
#include "law/fibre/point.hpp"

namespace trilith {

struct MenegottoPinto {
  double young = 0;      ///< [Pa]
  double yield = 0;      ///< [Pa]
  double hardening = 0;  ///< b [1]
  double r0 = 0, cr1 = 0, cr2 = 0;
  double a3 = 0, a4 = 0;

  static constexpr std::string_view name = "menegotto_pinto";
  static constexpr std::string_view sentence = "steel fibre with round corners (Menegotto and Pinto)";
  static constexpr auto parameters() {
    using P = Parameter<MenegottoPinto>;
    return std::array{
        P{&MenegottoPinto::young, "E", "Pa", no_default, 0, unbounded, false, "Young's modulus"},
        P{&MenegottoPinto::yield, "yield", "Pa", no_default, 0, unbounded, false,
          "yield stress, at which the two lines meet"},
        P{&MenegottoPinto::hardening, "hardening", "1", 0.01, 0, 0.99, true, "final modulus over elastic modulus"},
        P{&MenegottoPinto::r0, "R0", "1", 20, 1, 100, true, "sharpness of the first corner"},
        P{&MenegottoPinto::cr1, "cR1", "1", 0.925, 0, 0.99, true, "share of R0 lost after large plastic strain"},
        P{&MenegottoPinto::cr2, "cR2", "1", 0.15, 0, 100, false,
          "plastic strain, in yield strains, at which half is lost"},
        P{&MenegottoPinto::a3, "a3", "1", 0, 0, 10, true, "yield stress gained per yield strain of the largest strain"},
        P{&MenegottoPinto::a4, "a4", "1", 1, 0, unbounded, true,
          "largest strain, in yield strains, at which this gain begins"}};
  }
  void check() const {
    if (r0 * (1 - cr1) < 1)
      throw InputError(fmt::format("menegotto_pinto: R0 (1 - cR1) is {:g}, must be at least 1", r0 * (1 - cr1)));
  }
  static constexpr int memory_size = 10;
  using Memory = std::array<double, memory_size>;
  static constexpr bool loses_at_every_step = false;

  [[nodiscard]] double tangent() const { return young; }
  [[nodiscard]] double stored(const Memory& m) const { return 0.5 * m[last_stress] * m[last_stress] / young; }

  [[nodiscard]] UniaxialResponse<memory_size> respond(double strain, const Memory& before) const {
    UniaxialResponse<memory_size> out;
    Memory& m = out.memory = before;
    const double change = strain - before[last_strain];
    if (change != 0 && change * before[side] <= 0) turn(change > 0 ? 1 : -1, m);
    const double span = m[meet_strain] - m[from_strain], gone = strain - m[from_strain];
    double slope = hardening, share = hardening * gone;  // relative to E; stress lost over E
    if (m[side] == 0) {
      slope = 1, share = gone;
    } else if (span * m[side] > 1e-9 * yield / young) {
      const Bend bend = bend_of(std::abs(gone / span), m[sharpness]);
      share += (1 - hardening) * gone * bend.secant;
      slope += (1 - hardening) * bend.slope;
      out.yielding = std::abs(gone) > std::abs(span);
    }
    m[last_strain] = strain, m[last_stress] = m[from_stress] + young * share;
    out.tangent = young * slope;
    book_step(*this, before, out);
    return out;
  }

 private:
  static constexpr int side = 2, from_strain = 3, from_stress = 4, meet_strain = 5, meet_stress = 6, least = 7,
                       greatest = 8, sharpness = 9;

  /// 1/k of the odd numbers from 21 down to 1.
  static constexpr std::array odd_parts = [] {
    std::array<double, 11> part{};
    for (std::size_t i = 0; i < part.size(); ++i) part[i] = 1.0 / (21.0 - 2 * static_cast<double>(i));
    return part;
  }();

  /// Natural logarithm of x above 0 by the atanh series, to about 1e-16, with the same bits on every machine.
  /// portable::log, accurate to the last bit, takes several times as long.
  static double quick_log(double x) {
    int exponent = 0;
    double m = std::frexp(x, &exponent);  // from 1/2 to 1
    if (m < M_SQRT1_2) m *= 2, --exponent;
    const double s = (m - 1) / (m + 1), square = s * s;  // square below 0.0295
    double sum = 0;
    for (const double of : odd_parts) sum = sum * square + of;
    return exponent * M_LN2 + 2 * s * sum;
  }
  struct Bend {
    double secant, slope;
  };
  /// x / (1 + x^R)^(1/R) over x, and its slope; any x from 0 on.
  static Bend bend_of(double x, double r) {
    const double power = x > 0 ? portable::exp(-r * std::abs(quick_log(x))) : 0;
    const double root = power < 1e-18 ? 1 : portable::exp(-quick_log(1 + power) / r);
    return x <= 1 ? Bend{root, root / (1 + power)} : Bend{root / x, root / x * power / (1 + power)};
  }

  /// Starts the next curve at the end of the last step, towards `to` (-1 or 1).
  void turn(double to, Memory& m) const {
    const double first = yield / young, e = m[last_strain], s = m[last_stress];
    m[side] = to, m[from_strain] = e, m[from_stress] = s;
    m[least] = std::min({m[least], e, -first}), m[greatest] = std::max({m[greatest], e, first});
    const double shift = std::max(0.0, a3 * (std::max(-m[least], m[greatest]) / first - a4));
    // s + E (e_0 - e) = to yield (1 + shift) + b E (e_0 - to first)
    m[meet_strain] = (to * yield * (1 + shift - hardening) - s + young * e) / (young * (1 - hardening));
    m[meet_stress] = s + young * (m[meet_strain] - e);
    const double x = std::abs((to > 0 ? m[greatest] : m[least]) - m[meet_strain]) / first;
    m[sharpness] = r0 * (1 - cr1 * x / (cr2 + x));
  }
};

}  // namespace trilith
