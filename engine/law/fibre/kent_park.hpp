// Kent-Park concrete: a parabola up to the peak, a straight descending line, a residual stress.
//
// Envelope: s = K fc (2 x - x^2), x = e / (K e_0), up to x = 1. From there it is straight to `residual` K fc at
// `ultimate`, and constant beyond. Kent and Park, "Flexural members with confined concrete", J. Struct. Div. ASCE
// 97(7), 1971. The confinement factor K on stress and strain: Scott, Park and Priestley, "Stress-strain behavior of
// concrete confined by overlapping hoops at low and high strain rates", ACI Journal 79(1), 1982. Cycles and tension:
// concrete_cycle.hpp.
#pragma once

#include "law/fibre/concrete_cycle.hpp"

namespace trilith {

struct KentPark {
  double strength = 0;     ///< fc [Pa]
  double strain = 0;       ///< e_0 [1]
  double ultimate = 0;     ///< [1]
  double residual = 0;     ///< [1]
  double confinement = 0;  ///< K [1]
  double tension = 0;      ///< [Pa]
  double tension_end = 0;  ///< [1]

  static constexpr std::string_view name = "kent_park";
  static constexpr std::string_view sentence =
      "concrete fibre: parabola, linear softening, residual stress; cracks in tension";
  static constexpr auto parameters() {
    using P = Parameter<KentPark>;
    return std::array{
        P{&KentPark::strength, "strength", "Pa", no_default, 0, unbounded, false, "compressive strength, unconfined"},
        P{&KentPark::strain, "strain", "1", 0.002, 0, 0.1, false, "strain at that strength"},
        P{&KentPark::ultimate, "ultimate", "1", 0.006, 0, 1, false, "strain at the end of softening"},
        P{&KentPark::residual, "residual", "1", 0.2, 0, 1, true, "residual stress over the strength"},
        P{&KentPark::confinement, "confinement", "1", 1, 1, 10, true,
          "K: confined strength over strength; strain at the peak grows by the same"},
        P{&KentPark::tension, "tension", "Pa", 0, 0, unbounded, true, "strength in tension"},
        P{&KentPark::tension_end, "tension_end", "1", 0, 0, 1, true,
          "opening strain at which a crack carries no more stress; 0: at once"}};
  }
  static KentPark sample() { return {30e6, 0.002, 0.006, 0.2, 1.1, 2e6, 4e-4}; }
  void check() const {
    if (!(ultimate > peak_strain()))
      throw InputError(fmt::format("kent_park: ultimate is {:g}, must be above the strain at the peak, {:g}", ultimate,
                                   peak_strain()));
    if (tension > strength)
      throw InputError(fmt::format("kent_park: tension is {:g} Pa, above the strength of {:g} Pa", tension, strength));
  }
  using Cycle = ConcreteCycle<KentPark>;
  static constexpr int memory_size = concrete_memory;
  using Memory = Cycle::Memory;
  static constexpr bool loses_at_every_step = false;  // a step over the kink of a closed crack: error of second order

  [[nodiscard]] double initial() const { return 2 * strength / strain; }
  [[nodiscard]] double peak_strain() const { return confinement * strain; }
  [[nodiscard]] double tangent() const { return initial(); }
  [[nodiscard]] double stored(const Memory& m) const { return Cycle::stored(*this, m); }

  [[nodiscard]] EnvelopePoint envelope(double e) const {
    const double top = confinement * strength, x = e / peak_strain();
    if (x <= 1) return {top * (2 - x) * x, initial() * (1 - x)};
    if (e >= ultimate) return {residual * top, 0};
    const double slope = (residual - 1) * top / (ultimate - peak_strain());
    return {top + slope * (e - peak_strain()), slope};
  }
  [[nodiscard]] UniaxialResponse<memory_size> respond(double e, const Memory& before) const {
    return Cycle::respond(*this, e, before);
  }
};

}  // namespace trilith
