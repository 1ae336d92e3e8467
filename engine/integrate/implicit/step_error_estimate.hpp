// Increments of an implicit step: paths of the nodes, inertia forces of the scheme, and error estimate.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "assembly/implicit_turn.hpp"

namespace trilith {

/// Motion of the nodes at the start of the step.
template <int D>
struct StepStart {
  std::vector<Vec<D>> position, velocity, acceleration;
  std::vector<Rotation<D>> rotation;
  std::vector<Spin<D>> spin, spin_rate;

  explicit StepStart(const State<D>& s)
      : position(s.position),
        velocity(s.velocity),
        acceleration(s.acceleration),
        rotation(s.rotation),
        spin(s.spin),
        spin_rate(s.spin_rate) {}

  [[nodiscard]] TurnMotion<D> turn(int n) const { return {rotation[n], spin[n], spin_rate[n]}; }
  [[nodiscard]] Dofs<D> velocity_of(int n) const { return dofs_of(velocity[n], spin[n]); }
  [[nodiscard]] Dofs<D> acceleration_of(int n) const { return dofs_of(acceleration[n], spin_rate[n]); }
};

/// Coordinate of a node along dof k at the start of the step.
inline double place_along(const StepStart<2>& start, int n, int k) {
  return k == 2 ? start.rotation[n] : start.position[n][k];
}
inline double place_along(const StepStart<3>& start, int n, int k) {
  return k >= 3 ? angle_of(start.rotation[n])[k - 3] : start.position[n][k];
}

/// Magnitude that determines the rounding of a coordinate. In space a rotation counts as 1 rad.
inline double digits_along(const State<2>& state, int n, int k) {
  return std::abs(place_along(state, n, k));
}
inline double digits_along(const State<3>& state, int n, int k) {
  return k >= 3 ? 1 : std::abs(state.position[n][k]);
}

/// Half of the increment from the start of the step to now, and half of the increment of the last step and this one.
template <int D>
Dofs<D> half_way(const StepStart<D>& start, const State<D>& now, int n) {
  return dofs_of(Vec<D>(0.5 * (now.position[n] - start.position[n])),
                 Spin<D>(0.5 * turn_between(start.rotation[n], now.rotation[n])));
}
inline Dofs<2> half_of_both(const Vec2& place, double turn, const StepStart<2>& /*start*/, const State<2>& now, int n) {
  return dofs_of(Vec2(0.5 * (now.position[n] - place)), 0.5 * (now.rotation[n] - turn));
}
inline Dofs<3> half_of_both(const Vec3& place, const UnitQuaternion& turn, const StepStart<3>& start,
                            const State<3>& now, int n) {
  const Vec3 turned = turn_between(turn, start.rotation[n]) + turn_between(start.rotation[n], now.rotation[n]);
  return dofs_of(Vec3(0.5 * (now.position[n] - place)), Vec3(0.5 * turned));
}

/// Inertia force of the scheme for each dof of a node, M ((1 - alpha_m) a' + alpha_m a) [N], [N m]. `largest`: in space
/// the largest term of the rotational part; these terms cancel in a free body.
template <int D>
Dofs<D> inertia_of(const Model<D>& model, const State<D>& state, const StepStart<D>& start, double m, int n,
                   Dofs<D>& largest) {
  const Dofs<D> mass = mass_of(model, state, n), before = start.acceleration_of(n),
                now = dofs_of(state.acceleration[n], state.spin_rate[n]);
  Dofs<D> out;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = mass[k] * ((1 - m) * now[k] + m * before[k]);
  largest = {};
  if constexpr (D == 3) {
    const Vec3& own = model.inertia[n];
    const TurnMotion<3> end{state.rotation[n], state.spin[n], state.spin_rate[n]};
    const Vec3 turning = (1 - m) * moment_taken(own, end) + m * moment_taken(own, start.turn(n));
    const Vec3 carried = cross(end.spin, momentum_of(own, end.rotation, end.spin));
    for (int k = 0; k < 3; ++k)
      out[3 + k] = turning[k], largest[3 + k] = std::max(std::abs(turning[k]), carried.norm());
  }
  return out;
}

/// Change of the accelerations over the step along the free degrees of freedom, 0 elsewhere [node] [m/s2], [rad/s2].
template <int D>
std::vector<Dofs<D>> acceleration_change(const Model<D>& model, const State<D>& state, const StepStart<D>& start) {
  std::vector<Dofs<D>> jump(static_cast<std::size_t>(model.nodes()), Dofs<D>{});
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs<D> now = dofs_of(state.acceleration[n], state.spin_rate[n]), before = start.acceleration_of(n);
    for (int k = 0; k < Space<D>::dofs; ++k)
      if (model.support[n][k] == Support::free) jump[n][k] = now[k] - before[k];
  }
  return jump;
}

/// Energy of the velocity error dt (a' - a) / 12 [J], for `jump` = a' - a. The displacement error of the scheme over
/// the step is (b - 1/6) dt^2 (a' - a) with b = 1/4. Division by dt gives the velocity error (Zienkiewicz and Xie, "A
/// simple error estimator and adaptive time stepping procedure for dynamic analysis", Earthq. Eng. Struct. Dyn. 20,
/// 1991).
template <int D>
double step_error_estimate(const Model<D>& model, const State<D>& state, const std::vector<Dofs<D>>& jump, double dt) {
  double sum = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    for (int k = 0; k < Space<D>::translations; ++k) sum += model.mass[n] * jump[n][k] * jump[n][k];
    if constexpr (D == 2)
      sum += model.inertia[n] * jump[n][2] * jump[n][2];
    else
      sum += about_of(jump[n]).dot(momentum_of(model.inertia[n], state.rotation[n], about_of(jump[n])));
  }
  return 0.5 * sum * dt * dt / 144;
}

}  // namespace trilith
