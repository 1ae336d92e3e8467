// Friction slider under the bearing's compression N, elastic before sliding: |f| <= mu N.
//
// The coefficient mu is constant (Coulomb), or rises with the speed v from mu to mu_fast: `mu(v) = mu_fast - (mu_fast -
// mu) exp(-rate |v|)` (Constantinou, Mokha and Reinhorn, "Teflon bearings in base isolation II: modeling", J. Struct.
// Eng. ASCE 116(2), 1990). It may also depend on the load as (N / reference_load)^(load_exponent - 1), as for plastics
// (Bowden and Tabor, "The Friction and Lubrication of Solids II", 1964).
//
// For both horizontal directions |f| is the resultant and v the speed along the path. The limit is a circle, and the
// slider moves along the force (Mosqueda, Whittaker and Fenves, "Characterization and modeling of friction pendulum
// bearings subjected to multiple components of excitation", J. Struct. Eng. ASCE 130(3), 2004).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable.hpp"
#include "base/schema.hpp"
#include "law/bearing/direction.hpp"
#include "law/bearing/horizontal.hpp"

namespace trilith {

struct Friction {
  double mu = 0;              ///< at rest, or at any speed [1]
  double stiffness = 0;       ///< before sliding [N/m]
  double damping = 0;         ///< [N s/m]
  double mu_fast = 0;         ///< at high speed, or 0 [1]
  double rate = 0;            ///< [s/m]
  double load_exponent = 1;   ///< [1]
  double reference_load = 0;  ///< [N]

  static constexpr std::string_view name = "friction";
  static constexpr std::string_view sentence = "Coulomb friction under the bearing's compression";
  /// The last four parameters, shared by all sliding laws.
  template <class Owner>
  static constexpr auto dependence() {
    using P = Parameter<Owner>;
    return std::array{P{&Owner::mu_fast, "mu_fast", "1", 0, 0, 100, true,
                        "friction coefficient of fast sliding; `mu` is for slow sliding; 0: mu at any speed"},
                      P{&Owner::rate, "rate", "s/m", 50, 0, unbounded, true,
                        "rate of the change from mu to mu_fast, mostly 20 to 100"},
                      P{&Owner::load_exponent, "load_exponent", "1", 1, 0, 1, false,
                        "exponent of friction over compression; 1: proportional"},
                      P{&Owner::reference_load, "reference_load", "N", 0, 0, unbounded, true,
                        "compression at which mu holds; needed where load_exponent is below 1"}};
  }
  static constexpr auto parameters() {
    using P = Parameter<Friction>;
    constexpr auto more = dependence<Friction>();
    return std::array{
        P{&Friction::mu, "mu", "1", no_default, 0, 100, true, "friction coefficient"},
        P{&Friction::stiffness, "stiffness", "N/m", no_default, 0, unbounded, false, "stiffness before sliding"},
        P{&Friction::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity"},
        more[0],
        more[1],
        more[2],
        more[3]};
  }
  /// A slider for tests, with the reference load that a load exponent requires.
  static Friction sample() { return {0.3, 1e6, 0, 0, 50, 1, 5e4}; }
  /// Throws InputError where the load that `load_exponent` requires is missing. `owner`: the law named in the message.
  void check(std::string_view owner = name) const {
    if (load_exponent < 1 && !(reference_load > 0))
      throw InputError(
          fmt::format("{}: load_exponent is {:g}, which needs reference_load, the compression at which mu "
                      "holds",
                      owner, load_exponent));
  }
  [[nodiscard]] double tangent() const { return stiffness; }
  /// Speed-dependent friction acts as a dashpot, most strongly at rest. The only known load is `reference_load`;
  /// without it the term is left out, because the force is bounded anyway.
  [[nodiscard]] double dashpot() const {
    return damping + (mu_fast > 0 ? std::abs(mu_fast - mu) * rate * reference_load : 0);
  }
  /// A slider that becomes live later starts unstressed at its current displacement.
  [[nodiscard]] static DirectionMemory begin_at(double displacement) {
    DirectionMemory memory;
    memory.inner = displacement;
    return memory;
  }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    DirectionResponse out;
    out.memory = before;
    const double limit = most(m.rate, m.compression);
    const double trial = stiffness * (m.displacement - before.inner);
    out.memory.force = std::clamp(trial, -limit, limit);
    if (std::abs(trial) > limit) {
      out.memory.inner = m.displacement - out.memory.force / stiffness;
      out.yielding = limit > 0;  // without load nothing holds, and nothing yields
    }
    const double slid = out.memory.inner - before.inner;
    out.memory.travelled += std::abs(slid);
    out.lost_inner = 0.5 * (out.memory.force + before.force) * slid;
    out.stored = 0.5 * out.memory.force * out.memory.force / stiffness;
    add_dashpot(damping, m, before, out);
    return out;
  }

  struct Horizontal {
    AlongAcross inner{}, force{};  ///< position of the slider [m], friction [N]
    double travelled = 0;          ///< path length of the slider [m]
  };
  [[nodiscard]] static Horizontal begin_horizontal_at(const Vec2& displacement) { return {along_across(displacement)}; }
  [[nodiscard]] HorizontalResponse<Horizontal> respond_horizontal(const HorizontalMotion& m,
                                                                  const Horizontal& before) const {
    const double limit = most(portable::hypot(m.rate.x(), m.rate.y()), m.compression);
    const Vec2 was = vector_of(before.inner), trial = stiffness * (m.displacement - was);
    const double size = portable::hypot(trial.x(), trial.y());
    HorizontalResponse<Horizontal> out{before, trial};
    Vec2 inner = was;
    if (size > limit) {
      out.force = limit / size * trial;
      inner = m.displacement - out.force / stiffness;
      out.yielding = limit > 0;
    }
    const Vec2 slid = inner - was;
    out.memory.travelled += portable::hypot(slid.x(), slid.y());
    out.lost_inner = 0.5 * (out.force + vector_of(before.force)).dot(slid);
    out.stored = 0.5 * out.force.squaredNorm() / stiffness;
    out.memory.inner = along_across(inner), out.memory.force = along_across(out.force);
    return out;
  }

 private:
  /// Friction limit under a compression at a speed [N].
  [[nodiscard]] double most(double speed, double compression) const {
    const double at_speed = mu_fast > 0 ? mu_fast - (mu_fast - mu) * portable::exp(-rate * std::abs(speed)) : mu;
    if (load_exponent == 1) return at_speed * compression;
    // This form gives 0 without load, where the coefficient itself is unbounded.
    return at_speed * reference_load * portable::pow(compression / reference_load, load_exponent);
  }
};

}  // namespace trilith
