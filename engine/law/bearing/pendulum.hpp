// Friction pendulum: f = (N / R) d + friction mu N. Zayas, Low and Mahin, Report UCB/EERC-87/01, 1987.
//
// mu may depend on speed and load as in law/bearing/friction.hpp. For both horizontal directions f and d are vectors:
// on frictionless dishes the period is 2 pi sqrt(R/g) in every azimuth and on circular paths.
#pragma once

#include <array>

#include "law/bearing/friction.hpp"

namespace trilith {

struct Pendulum {
  double radius = 0;          ///< [m]
  double mu = 0;              ///< [1]
  double stiffness = 0;       ///< before sliding [N/m]
  double damping = 0;         ///< [N s/m]
  double mu_fast = 0;         ///< see Friction for these four
  double rate = 0;            ///< [s/m]
  double load_exponent = 1;   ///< [1]
  double reference_load = 0;  ///< [N]
  double rise = 0;  ///< 1: rises on its dish if there is an axial law, see law/bearing/dish.hpp; 0: stays level

  static constexpr std::string_view name = "pendulum";
  static constexpr std::string_view sentence = "friction pendulum: Coulomb slider on a dish of given radius";
  static constexpr auto parameters() {
    using P = Parameter<Pendulum>;
    constexpr auto more = Friction::dependence<Pendulum>();
    return std::array{
        P{&Pendulum::radius, "radius", "m", no_default, 0, unbounded, false, "radius of the dish"},
        P{&Pendulum::mu, "mu", "1", no_default, 0, 100, true, "friction coefficient"},
        P{&Pendulum::stiffness, "stiffness", "N/m", no_default, 0, unbounded, false, "stiffness before sliding"},
        P{&Pendulum::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity"},
        more[0],
        more[1],
        more[2],
        more[3],
        P{&Pendulum::rise, "rise", "1", 0, 0, 1, true,
          "1: the slider rises by R - sqrt(R^2 - d^2), restoring force N tan(angle); 0: it stays level, N d/R"}};
  }
  /// See Friction.
  static Pendulum sample() { return {0.02, 0.3, 1e6, 0, 0, 50, 1, 5e4}; }
  void check() const {
    slider().check(name);
    if (rise != 0 && rise != 1)
      throw InputError(fmt::format("pendulum: rise is {:g}, must be 1 (it rises on its dish) or 0", rise));
  }
  [[nodiscard]] double tangent() const { return stiffness; }
  [[nodiscard]] double dashpot() const { return slider().dashpot(); }
  [[nodiscard]] static DirectionMemory begin_at(double displacement) { return Friction::begin_at(displacement); }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    // The last force is split: the slider's part gives the loss, the dish's part the work.
    const double from = m.displacement - m.mean * m.dt;
    const double dish_before = before.compression / radius, dish = m.compression / radius;
    DirectionMemory last = before;
    last.force = before.force - dish_before * from;
    DirectionResponse out = slider().respond(m, last);
    out.memory.compression = m.compression;
    out.memory.force += dish * m.displacement;
    out.stored += 0.5 * dish * m.displacement * m.displacement;
    // A change of the compression does work on the rise of the dish, which the axial direction does not account for.
    out.lost_inner += 0.5 * (dish_before - dish) * from * m.displacement;
    return out;
  }

  /// On a dish with the horizontal force `thrust` [N], see law/bearing/dish.hpp. The memory's force is the sum of
  /// slider and dish, and `compression` includes the thrust.
  [[nodiscard]] DirectionResponse respond_on_dish(const DirectionMotion& m, const DirectionMemory& before,
                                                  double thrust) const {
    DirectionMemory last = before;
    last.force -= before.compression;
    DirectionResponse out = slider().respond(m, last);
    out.memory.force += thrust, out.memory.compression = thrust;
    return out;
  }

  /// A dish is rotationally symmetric. `slider`: without the dish's part.
  struct Horizontal {
    Friction::Horizontal slider;
    double compression = 0;  ///< of the last step [N]
  };
  [[nodiscard]] static Horizontal begin_horizontal_at(const Vec2& displacement) {
    return {Friction::begin_horizontal_at(displacement)};
  }
  [[nodiscard]] HorizontalResponse<Horizontal> respond_horizontal(const HorizontalMotion& m,
                                                                  const Horizontal& before) const {
    const auto slid = slider().respond_horizontal(m, before.slider);
    const double dish_before = before.compression / radius, dish = m.compression / radius;
    const Vec2 from = m.displacement - m.dt * m.mean;
    HorizontalResponse<Horizontal> out{{slid.memory, m.compression}, slid.force + dish * m.displacement};
    out.stored = slid.stored + 0.5 * dish * m.displacement.squaredNorm();
    // As in one direction: a change of the compression does work on the rise of the dish.
    out.lost_inner = slid.lost_inner + 0.5 * (dish_before - dish) * from.dot(m.displacement);
    out.yielding = slid.yielding;
    return out;
  }
  [[nodiscard]] HorizontalResponse<Horizontal> respond_horizontal_on_dish(const HorizontalMotion& m,
                                                                          const Horizontal& before,
                                                                          const Vec2& thrust) const {
    const auto slid = slider().respond_horizontal(m, before.slider);
    return {{slid.memory, m.compression}, slid.force + thrust, slid.stored, slid.lost_inner, slid.yielding};
  }

 private:
  [[nodiscard]] Friction slider() const {
    return {mu, stiffness, damping, mu_fast, rate, load_exponent, reference_load};
  }
};

}  // namespace trilith
