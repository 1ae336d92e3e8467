// Kent-Park concrete: a parabola up to the peak, a straight descending line, a residual stress.
//
// Envelope: s = K fc (2 x - x^2), x = e / (K e_0), up to x = 1. From there it is straight to `residual` K fc at
// `ultimate`, and constant beyond. Kent and Park, "Flexural members with confined concrete", J. Struct. Div. ASCE
// 97(7), 1971. With `crush_energy` the length of the beam defines `ultimate`, see softening_length.hpp. The confinement
// factor K on stress and strain: Scott, Park and Priestley, "Stress-strain behavior of concrete confined by overlapping
// hoops at low and high strain rates", ACI Journal 79(1), 1982. Cycles and tension: concrete_cycle.hpp.
#pragma once

#include "law/fibre/concrete_cycle.hpp"
#include "law/fibre/softening_length.hpp"

namespace trilith {

struct KentPark {
  double strength = 0;                          ///< fc [Pa]
  double strain = 0;                            ///< e_0 [1]
  double ultimate = 0;                          ///< [1]
  double residual = 0;                          ///< [1]
  double confinement = 0;                       ///< K [1]
  double tension = 0;                           ///< [Pa]
  double tension_end = 0;                       ///< [1]
  double crush_energy = 0, energy_tension = 0;  ///< [J/m2]; 0: from the strains

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
          "opening strain at which a crack carries no more stress; 0: at once"},
        P{&KentPark::crush_energy, "crush_energy", "J/m2", 0, 0, unbounded, true,
          "fracture energy in compression, dissipated beyond the peak per area: in beams it replaces ultimate, so that "
          "softening does not depend on their length; 0: ultimate counts"},
        P{&KentPark::energy_tension, "energy_tension", "J/m2", 0, 0, unbounded, true,
          "fracture energy of a crack: in beams it gives tension_end"}};
  }
  static constexpr std::size_t always_in_fingerprint = 7;
  static KentPark sample() { return {30e6, 0.002, 0.006, 0.2, 1.1, 2e6, 4e-4}; }
  void check() const {
    if (!(ultimate > peak_strain()))
      throw InputError(fmt::format("kent_park: ultimate is {:g}, must be above the strain at the peak, {:g}", ultimate,
                                   peak_strain()));
    if (tension > strength)
      throw InputError(fmt::format("kent_park: tension is {:g} Pa, above the strength of {:g} Pa", tension, strength));
    if (crush_energy > 0 && residual >= 1)
      throw InputError("kent_park: residual is 1, so the law does not soften; leave out crush_energy");
    check_crack_energy(*this);
  }
  /// The law of the fibres of a beam of `length` [m], without energies: strains that dissipate these energies in it.
  /// Throws InputError if the beam is so long that it would snap back.
  [[nodiscard]] KentPark for_length(double length) const {
    KentPark law = with_crack_of(*this, length);
    law.crush_energy = 0;
    if (crush_energy == 0) return law;
    const double top = confinement * strength, mean = 0.5 * (1 + residual) * top,
                 elastic = (1 - residual) * top / initial();
    require_length(name, "crush_energy", crush_energy, crush_energy / (mean * elastic), length);
    law.ultimate = peak_strain() + crush_energy / (mean * length) - elastic;
    return law;
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
