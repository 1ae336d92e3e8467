// Concrete after Mander, Priestley and Park: one smooth curve over the peak, crushed at the ultimate strain.
//
// Envelope: `s = f x r / (r - 1 + x^r),  x = e / e_c,  r = E / (E - f / e_c),  f = K fc,  e_c = e_0 (1 + 5 (K - 1))`.
// "Theoretical stress-strain model for confined concrete", J. Struct. Eng. ASCE 114(8), 1988, eqs. 1 to 6, after
// Popovics, Cement and Concrete Research 3, 1973. K is f'cc/f'co there and follows from the hoops. Beyond `ultimate`,
// where hoops break or the cover spalls, the stress is `residual` f; it is never less before. `stretch` multiplies
// the strains beyond the peak, and `ultimate`; with `crush_energy` the length of the beam defines it, see
// softening_length.hpp. Cycles and tension: concrete_cycle.hpp.
#pragma once

#include "law/fibre/concrete_cycle.hpp"
#include "law/fibre/softening_length.hpp"

namespace trilith {

struct Mander {
  double strength = 0;                          ///< fc [Pa]
  double young = 0;                             ///< E [Pa]
  double strain = 0;                            ///< e_0 [1]
  double ultimate = 0;                          ///< [1]
  double residual = 0;                          ///< [1]
  double confinement = 0;                       ///< K [1]
  double tension = 0;                           ///< [Pa]
  double tension_end = 0;                       ///< [1]
  double stretch = 1;                           ///< [1]
  double crush_energy = 0, energy_tension = 0;  ///< [J/m2]; 0: from the strains

  static constexpr std::string_view name = "mander";
  static constexpr std::string_view sentence = "concrete fibre: one smooth curve over the peak; cracks in tension";
  static constexpr auto parameters() {
    using P = Parameter<Mander>;
    return std::array{
        P{&Mander::strength, "strength", "Pa", no_default, 0, unbounded, false, "compressive strength, unconfined"},
        P{&Mander::young, "E", "Pa", no_default, 0, unbounded, false, "initial modulus"},
        P{&Mander::strain, "strain", "1", 0.002, 0, 0.1, false, "strain at that strength"},
        P{&Mander::ultimate, "ultimate", "1", 0.006, 0, 1, false, "crushing strain"},
        P{&Mander::residual, "residual", "1", 0, 0, 1, true, "residual stress over the confined strength"},
        P{&Mander::confinement, "confinement", "1", 1, 1, 10, true,
          "K: confined strength over strength; strain at the peak grows by 1 + 5 (K - 1)"},
        P{&Mander::tension, "tension", "Pa", 0, 0, unbounded, true, "strength in tension"},
        P{&Mander::tension_end, "tension_end", "1", 0, 0, 1, true,
          "opening strain at which a crack carries no more stress; 0: at once"},
        P{&Mander::stretch, "stretch", "1", 1, 0, 1e4, false, "factor on the strains beyond the peak, up to ultimate"},
        P{&Mander::crush_energy, "crush_energy", "J/m2", 0, 0, unbounded, true,
          "fracture energy in compression, dissipated beyond the peak up to ultimate per area: in beams it gives "
          "stretch, so that softening does not depend on their length; 0: stretch counts"},
        P{&Mander::energy_tension, "energy_tension", "J/m2", 0, 0, unbounded, true,
          "fracture energy of a crack: in beams it gives tension_end"}};
  }
  static constexpr std::size_t always_in_fingerprint = 8;
  static Mander sample() { return {30e6, 27e9, 0.002, 0.015, 0.1, 1.2, 2e6, 4e-4}; }
  void check() const {
    if (!(ultimate > peak_strain()))
      throw InputError(
          fmt::format("mander: ultimate is {:g}, must be above the strain at the peak, {:g}", ultimate, peak_strain()));
    if (young < 1.01 * confinement * strength / peak_strain())
      throw InputError(fmt::format("mander: E is {:g} Pa, must be above the confined strength over its strain, {:g} Pa",
                                   young, confinement * strength / peak_strain()));
    if (tension > strength)
      throw InputError(fmt::format("mander: tension is {:g} Pa, above the strength of {:g} Pa", tension, strength));
    if (crush_energy > 0 && stretch != 1)
      throw InputError(
          fmt::format("mander: stretch is {:g}, and crush_energy gives it in beams; leave one out", stretch));
    check_crack_energy(*this);
  }
  /// As KentPark::for_length, by `stretch`.
  [[nodiscard]] Mander for_length(double length) const {
    Mander law = with_crack_of(*this, length);
    law.crush_energy = 0;
    if (crush_energy == 0) return law;
    const double top = confinement * strength, last = envelope(ultimate).stress,
                 elastic = 0.5 * (top - last) * (top + last) / young;
    const double most = crush_energy / (elastic + least_stretch * softening_work());
    require_length(name, "crush_energy", crush_energy, most, length);
    law.stretch = (crush_energy / length - elastic) / softening_work();
    return law;
  }
  using Cycle = ConcreteCycle<Mander>;
  static constexpr int memory_size = concrete_memory;
  using Memory = Cycle::Memory;
  static constexpr bool loses_at_every_step = false;  // a step over the kink of a closed crack: error of second order

  [[nodiscard]] double initial() const { return young; }
  [[nodiscard]] double peak_strain() const { return strain * (1 + 5 * (confinement - 1)); }
  [[nodiscard]] double tangent() const { return young; }
  [[nodiscard]] double stored(const Memory& m) const { return Cycle::stored(*this, m); }

  [[nodiscard]] EnvelopePoint envelope(double e) const {
    const double top = confinement * strength, rest = residual * top;
    double factor = 1;
    if (stretch != 1 && e > peak_strain()) factor = 1 / stretch, e = peak_strain() + factor * (e - peak_strain());
    if (e > ultimate) return {rest, 0};
    const double x = e / peak_strain(), r = young / (young - top / peak_strain());
    const double power = portable::pow(x, r), under = r - 1 + power, stress = top * x * r / under;
    if (x > 1 && stress < rest) return {rest, 0};
    return {stress, factor * top / peak_strain() * r * (r - 1) * (1 - power) / (under * under)};
  }
  [[nodiscard]] UniaxialResponse<memory_size> respond(double e, const Memory& before) const {
    return Cycle::respond(*this, e, before);
  }

 private:
  /// The steepest softening in beams, relative to the curve.
  static constexpr double least_stretch = 1e-3;

  /// Area below the curve from the peak to `ultimate`, by Simpson's rule [J/m3].
  [[nodiscard]] double softening_work() const {
    constexpr int pairs = 200;
    const double step = (ultimate - peak_strain()) / (2 * pairs);
    const auto at = [&](int i) { return envelope(i == 2 * pairs ? ultimate : peak_strain() + i * step).stress; };
    double sum = at(0) - at(2 * pairs);
    for (int i = 0; i < pairs; ++i) sum += 4 * at(2 * i + 1) + 2 * at(2 * i + 2);
    return step / 3 * sum;
  }
};

}  // namespace trilith
