// Mortar that cracks gradually: cohesion and tension soften with their fracture energies, friction remains.
//
// Peak strengths are those in the bonded Coulomb law. A half keeps a share chi of both, from 1 to 0 (isotropic
// softening of cohesion and tension: Lourenco and Rots, "Multisurface interface model for analysis of masonry
// structures", J. Eng. Mech. 123(7), 1997). Softening is linear here, as in the bilinear law of Camanho and Davila,
// NASA/TM-2002-211737. Opening reduces chi along tension chi = kn hold g, sliding by its slip over `last_slip`; each
// alone dissipates its fracture energy. In between, an open bond unloads to the origin, with the share `hold` of its
// stiffness, and shear unloads with ks. Four parts of each half soften separately by their opening, and together by
// their slip.
//
// Dilation (default off): sliding opens the joint by tan(angle) times the slip. It stops at the slip at which the
// asperities are worn (limit as in Lourenco and Rots 1997) and where the faces separate.
//
// Crushing (default off), an elastic, perfectly plastic cap: each half keeps its crushed depth z, and its stresses
// follow from the gap g + z. While the mean stress over the pressed part of the half would exceed the compressive
// strength, z grows until it does not. If the whole half is pressed, the mean overlap becomes strength / kn. If it is
// pressed from one end, its stress is a triangle, and the overlap of that end stays at twice this value.
//
// Mortar is thin: crushing ends at a greatest depth. Unloading and reloading up to it are elastic (the cap of Lourenco
// and Rots without hardening and softening; each half counts as one integration point). The damping acts on the elastic
// part of the motion only. The crushed depth is kept while the two bodies are near each other.
//
// With a crushing energy the strength falls with the crushed depth, on a line to a residual strength at which crushing
// goes on. The energy per area is the work of crushing above the residual: (fc - fr)^2 / (2 G) is the fall of stress
// per depth. The softening of a joint pressed from one end is stable if it falls by less than half of kn.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

#include "base/schema.hpp"
#include "law/contact/mortar.hpp"

namespace trilith {

struct Cohesive {
  double kn = 0;                 ///< [Pa/m]
  double ks = 0;                 ///< [Pa/m]
  double mu = 0;                 ///< tan of the friction angle
  double beta = 0;               ///< [s]
  double cohesion = 0;           ///< [Pa]
  double tension = 0;            ///< [Pa]
  double energy_tension = 0;     ///< fracture energy of mode I [J/m2]
  double energy_shear = 0;       ///< fracture energy of mode II, without friction [J/m2]
  double dilation = 0;           ///< tan of the dilatancy angle
  double dilation_slip = 0;      ///< [m]
  double compression = 0;        ///< [Pa]; 0: it does not crush
  double crushing_depth = 2e-3;  ///< [m]
  double crush_energy = 0;       ///< fracture energy in compression [J/m2]; 0: the strength stays
  double crush_residual = 0.1;   ///< residual strength over the strength [1]

  static constexpr std::string_view name = "cohesive";
  static constexpr std::string_view sentence =
      "mortar that softens in tension and shear according to its fracture energies";
  static constexpr auto parameters() {
    using P = Parameter<Cohesive>;
    return std::array{
        P{&Cohesive::kn, "kn", "Pa/m", no_default, 0, unbounded, false, "normal stiffness, stress per overlap"},
        P{&Cohesive::ks, "ks", "Pa/m", no_default, 0, unbounded, false, "shear stiffness, stress per elastic slip"},
        P{&Cohesive::mu, "mu", "1", no_default, 0, 100, true, "friction coefficient, tan of the friction angle"},
        P{&Cohesive::beta, "beta", "s", 0, 0, 1, true, "damping stress per stiffness and velocity"},
        P{&Cohesive::cohesion, "cohesion", "Pa", no_default, 0, unbounded, false, "shear strength at no normal stress"},
        P{&Cohesive::tension, "tension", "Pa", no_default, 0, unbounded, false, "tensile strength of the bond"},
        P{&Cohesive::energy_tension, "energy_tension", "J/m2", no_default, 0, unbounded, false,
          "fracture energy in tension (mode I)"},
        P{&Cohesive::energy_shear, "energy_shear", "J/m2", no_default, 0, unbounded, false,
          "fracture energy in shear (mode II), without frictional work"},
        P{&Cohesive::dilation, "dilation", "1", 0, 0, 10, true, "opening per slip, tan of the dilatancy angle"},
        P{&Cohesive::dilation_slip, "dilation_slip", "m", 0, 0, unbounded, true, "slip up to which the joint dilates"},
        P{&Cohesive::compression, "compression", "Pa", 0, 0, unbounded, true,
          "compressive strength of the mortar; 0: no crushing"},
        P{&Cohesive::crushing_depth, "crushing_depth", "m", 2e-3, 0, unbounded, false,
          "largest crushing depth, as a share of the joint thickness"},
        P{&Cohesive::crush_energy, "crush_energy", "J/m2", 0, 0, unbounded, true,
          "fracture energy in compression, above the residual strength; 0: crushing does not soften"},
        P{&Cohesive::crush_residual, "crush_residual", "1", 0.1, 0.01, 0.9, true,
          "residual compressive strength over the strength, after softening"}};
  }
  /// Number of parameters, from the first, that every fingerprint of a model contains; the others are in it where they
  /// differ from their defaults.
  static constexpr std::size_t always_in_fingerprint = 12;

  /// Throws InputError where a fracture energy is too small: an energy below the elastic energy at the peak cannot
  /// soften. The ranges above do not exclude this.
  void check() const {
    const auto require = [](double energy, double strength, double stiffness, const char* of, const char* strength_name,
                            const char* k) {
      const double least = 0.5 * strength / stiffness * strength;
      if (energy > least) return;
      throw InputError(
          fmt::format("cohesive: energy_{0} is {1:g} J/m2, must be above {4}^2/(2 {2}) = {3:g}, the energy that the "
                      "joint stores at its strength; give more energy, or a stiffer joint, or use the bonded law",
                      of, energy, k, least, strength_name));
    };
    require(energy_tension, tension, kn, "tension", "tension", "kn");
    require(energy_shear, cohesion, ks, "shear", "cohesion", "ks");
    check_crushing();
  }
  /// The same for the energy of crushing, with the depth over which it is spent.
  void check_crushing() const {
    if (!(crush_energy > 0)) {
      if (crush_residual == 0.1) return;
      throw InputError(
          fmt::format("cohesive: crush_residual is {:g} without crush_energy; give crush_energy, the "
                      "fracture energy in compression, or leave crush_residual out",
                      crush_residual));
    }
    if (!(compression > 0))
      throw InputError(
          fmt::format("cohesive: crush_energy is {:g} J/m2 without compression; give compression, the "
                      "compressive strength, or leave crush_energy out",
                      crush_energy));
    const double fall = (1 - crush_residual) * compression, least = fall / kn * fall;
    if (!(crush_energy > least))
      throw InputError(
          fmt::format("cohesive: crush_energy is {:g} J/m2, must be above (fc - fr)^2/kn = {:g}, so that "
                      "softening is stable; give more energy, or a stiffer joint, or leave it out",
                      crush_energy, least));
    if (const double depth = 2 * crush_energy / fall; !(depth <= crushing_depth))
      throw InputError(
          fmt::format("cohesive: crush_energy is {:g} J/m2, spent over a depth of {:g} m; crushing_depth "
                      "is {:g} m, must not be below it; give less energy, or a larger crushing_depth",
                      crush_energy, depth, crushing_depth));
  }

  struct Kernel;
};

/// Whether a part of a softening bond may be damaged, for the memories of several contacts at once: whoever reads them
/// has looked at the numbers of all. A single memory is always asked for its numbers.
template <class T>
struct DamageKnown {
  [[nodiscard]] static constexpr bool may_be_damaged() { return true; }
  static constexpr void set_damaged(bool /*some*/) {}
};
template <>
struct DamageKnown<Lanes> {
  bool some_damage = true;
  [[nodiscard]] bool may_be_damaged() const { return some_damage; }
  void set_damaged(bool some) { some_damage = some; }
};

/// Parameters and equations of softening, dilation and crushing.
struct Cohesive::Kernel : Mortar {
  double last_opening;    ///< opening without remaining tension [m]
  double last_slip;       ///< slip without remaining cohesion [m]
  double dilation;        ///< tan of the dilatancy angle
  double dilation_slip;   ///< slip up to which sliding opens the joint [m]
  double crushing;        ///< mean overlap at which a pressed joint crushes [m]; 0: never
  double crushing_depth;  ///< greatest depth of crushing [m]
  double crush_slope;     ///< fall of that overlap per crushed depth [1]; 0: it stays
  double crush_floor;     ///< least of that overlap, at the residual strength [m]
  double intact_hold;     ///< stiffness share of an open bond that is intact [1]

  Kernel(const Cohesive& law, double thickness, double step)
      : Mortar(law, thickness, step),
        last_opening(2 * law.energy_tension / law.tension),
        last_slip(2 * law.energy_shear / law.cohesion),
        dilation(law.dilation),
        dilation_slip(law.dilation_slip),
        crushing(law.compression / law.kn),
        crushing_depth(law.crushing_depth),
        crush_slope(law.crush_energy > 0 ? slope_of(law) : 0),
        crush_floor(law.crush_energy > 0 ? law.crush_residual * law.compression / law.kn : 0),
        intact_hold(held(1.0)) {}

  /// (fc - fr)^2 / (2 G), over kn [1].
  static double slope_of(const Cohesive& law) {
    const double fall = (1 - law.crush_residual) * law.compression;
    return fall / law.kn * fall / (2 * law.crush_energy);
  }

  using FrictionRemains = Kernel;  ///< see law/contact/law_forms.hpp
  using JointForm = Kernel;

  static constexpr bool crushes = true;
  static constexpr bool softens = true;
  static constexpr int parts = bond_parts;

  template <class T>
  struct Memory : DamageKnown<T> {
    T set[2]{};                ///< gaps at both ends of the shared length when the mortar set [m]
    T damage[2 * bond_parts];  ///< of the parts of both bonded halves: lost share of their strength
    T crushed[2]{};            ///< crushed depth of the mortar of each half [m]
    /// 1: was a general contact after first touching, and no longer dilates. Negative: minus the opening by the slip of
    /// the last step [m].
    T worn{};
    T crushing_force{};  ///< general contact: force that crushes its mortar, 0 while intact [N]
    /// The numbers from the first to before the last, in the order of `fields`, are 0 in all but damaged contacts.
    static constexpr int damage_begin = 2, damage_end = 2 + 2 * bond_parts;
    /// Damage is set number by number: one block of memory set to 0 would stall the loads that follow.
    TRILITH_INLINE Memory() {
      const auto clear = [this]<std::size_t... i>(std::index_sequence<i...>) TRILITH_INLINE_LAMBDA {
        ((damage[i] = T{}), ...);
      };
      clear(std::make_index_sequence<2 * bond_parts>());
    }
    template <class F>
    TRILITH_INLINE void fields(F&& two) {
      two(set[0], set[1]);
      for (int i = 0; i < 2 * bond_parts; i += 2) two(damage[i], damage[i + 1]);
      two(crushed[0], crushed[1]), two(worn, crushing_force);
    }
  };

  template <class T>
  TRILITH_INLINE T begin(FaceHalves<T>& halves, const FaceMemory<T>& before, const Memory<T>& own,
                         Memory<T>& after) const;
  template <class T>
  TRILITH_INLINE void press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const;
  template <class T>
  TRILITH_INLINE T slide(HalfState<T>& half, T active, const ShearBefore<T>& before, HalfResponse<T>& out) const;
  template <class T>
  TRILITH_INLINE T end(const FaceHalves<T>& halves, const FaceMemory<T>& before, const Memory<T>& own,
                       FaceMemory<T>& memory, Memory<T>& after) const;
  template <class T>
  TRILITH_INLINE T lifting(const FaceHalves<T>& halves, const FaceMemory<T>& before, const FaceMemory<T>& memory,
                           const Memory<T>& own, const HalfResponse<T>* s, Memory<T>& after) const;
  template <class T>
  TRILITH_INLINE static Mask<T> changes(const FaceMemory<T>& before, const Memory<T>& own, const FaceMemory<T>& memory,
                                        const Memory<T>& after);
  template <class T>
  TRILITH_INLINE static Mask<T> keeps(const Memory<T>& own) {
    return larger(own.crushed[0], own.crushed[1]) > T{};
  }

  /// Mean overlap at which a pressed joint crushes, after crushing by `depth` [m].
  [[nodiscard]] double crush_limit(double depth) const { return std::max(crush_floor, crushing - crush_slope * depth); }
  /// General contact: returns the crushed depth after the step, `before` being the depth so far. At the returned depth
  /// `excess(depth)` [m] is 0: the mean overlap minus the overlap at which it crushes.
  template <class Excess>
  [[nodiscard]] double crush(double before, Excess&& excess) const;
  /// Energy dissipated by this crushing [J]. `touched`: some stress was carried before; `general`: as a general
  /// contact; `force`: the present crushing force [N].
  [[nodiscard]] static double crushed_by(const Memory<double>& own, double depth, double force, bool touched,
                                         bool general, Memory<double>& after);

  [[nodiscard]] std::array<HalfGaps, 2> gaps(const FaceOverlap<double>& o, const ContactMemory& m,
                                             const Memory<double>& own) const;
  [[nodiscard]] static double opening_to_come(const Memory<double>& own) { return std::max(0.0, -own.worn); }
  [[nodiscard]] double hold(const ContactMemory& m, const Memory<double>& own, int half, int part) const {
    return m.bonded(half) ? held(1 - own.damage[half * bond_parts + part]) : 0;
  }
  [[nodiscard]] ShapeLoss leave_faces(const FaceOverlap<double>& o, const ContactMemory& m,
                                      const Memory<double>& own) const;

  /// Memory that remains when the faces separate: the crushed depth.
  [[nodiscard]] static Memory<double> parted(const Memory<double>& own) {
    Memory<double> left;
    for (const int h : {0, 1}) left.crushed[h] = own.crushed[h];
    return left;
  }
  [[nodiscard]] static double crushed(const Memory<double>& own) { return std::max(own.crushed[0], own.crushed[1]); }
  /// Mean over a half.
  [[nodiscard]] static double damage(const Memory<double>& own, int half) {
    double sum = 0;
    for (int i = 0; i < bond_parts; ++i) sum += own.damage[half * bond_parts + i];
    return sum / bond_parts;
  }
  [[nodiscard]] static JointChange change(const ContactMemory& before, const Memory<double>& own,
                                          const ContactMemory& now, const Memory<double>& after);
  static void set_bond(Memory<double>& own, double lo, double hi) {
    lift_bond(own);
    own.set[0] = lo + own.crushed[0], own.set[1] = hi + own.crushed[1];
  }
  static void lift_bond(Memory<double>& own) { std::fill(std::begin(own.damage), std::end(own.damage), 0.0); }
  /// Marks that its faces were in general contact.
  void wear(Memory<double>& own) const { own.worn = dilation > 0 ? 1 : own.worn; }

  /// Remaining strength share of a bond at an opening [m], with the share `before` so far.
  template <class T>
  [[nodiscard]] TRILITH_INLINE T strength_left(T opening, T before) const {
    const double range = last_opening - first_opening();
    const T left = (last_opening - opening) * (1.0 / range);
    return larger(T{}, smaller(before, left));
  }
  /// The same for openings that are evenly distributed from `low` to `high` [m]: the bond then carries the mean of
  /// their stresses.
  template <class T>
  [[nodiscard]] TRILITH_INLINE T strength_left_over(T low, T high, T before) const {
    constexpr double least_spread = 1e-6;  // share of the opening
    const T zero{}, first = zero + first_opening(), last = zero + last_opening, range = last - first;
    const T from = larger(low, zero), to = larger(high, zero);
    const T e0 = smaller(from, first), e1 = smaller(to, first);
    const T s0 = smaller(larger(from, first), last), s1 = smaller(larger(to, first), last);
    const T elastic = (e1 - e0) * (e1 + e0), softening = first * (s1 - s0) * (2.0 * last - s0 - s1) / range;
    const Mask<T> spread = to - from > least_spread * to;
    const T hold = (elastic + softening) / select(spread, (to - from) * (to + from), zero + 1.0);
    const T left = larger(zero, smaller(before, hold * last / (first + hold * range)));
    return select(spread, left, strength_left(0.5 * (low + high), before));
  }
  /// Stiffness share of an open bond with the strength share `strength`.
  template <class T>
  [[nodiscard]] TRILITH_INLINE T held(T strength) const {
    const double range = last_opening - first_opening();
    return tension * strength / (kn * (last_opening - strength * range));
  }
  /// Opening of a joint due to its sliding so far [m].
  template <class T>
  [[nodiscard]] TRILITH_INLINE T dilated(T slip, T worn) const {
    return select(worn > T{}, T{}, dilation * smaller(slip, dilation_slip + T{}));
  }

 private:
  [[nodiscard]] double up_to_residual(double depth, double deeper) const;
  template <class T>
  TRILITH_INLINE T crush_half(HalfState<T>& h, T before) const;
  template <class T>
  TRILITH_INLINE void soften_by_opening(HalfState<T>& h, const T* damage, bool damaged) const;
  template <class T>
  TRILITH_INLINE void end_bond(HalfState<T>& h, Mask<T> bonded, T* damage) const;
  template <class T>
  TRILITH_INLINE T opening_loss(const HalfState<T>& h, const T* damage, Mask<T> was_bonded, T last) const;
  template <class T>
  TRILITH_INLINE T crushing_loss(const HalfState<T>& h, T deeper, const T* damage, Mask<T> was_bonded, T last) const;
  template <class T>
  TRILITH_INLINE LinearStress<T> bond_by_parts(const HalfState<T>& h, T c0, T c1, const HalfSpan<T>& closed,
                                               LinearStress<T> stress) const;
  template <class T>
  TRILITH_INLINE T mean_overlap(const HalfState<T>& h, T g0, T g1, const T* strengths, Mask<T> bonded) const;
  template <class T>
  TRILITH_INLINE T overlap_before(const HalfState<T>& h, const T* damage, Mask<T> was_bonded, T last) const;
  [[nodiscard]] double stored_in_both(const FaceOverlap<double>& o, const ContactMemory& m,
                                      const Memory<double>& own) const;
};

}  // namespace trilith

#include "law/contact/cohesive_kernel.hpp"  // definitions of the members above
#include "law/contact/cohesive_readings.hpp"
