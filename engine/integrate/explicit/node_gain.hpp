// Accelerations of nodes over the next step, from the present forces and prescribed motions.
#pragma once

#include <algorithm>
#include <cmath>

#include "assembly/node_forces.hpp"

namespace trilith {

/// Acceleration of a node: from the force for a free degree of freedom, from the motion over the step for a driven one.
template <int D>
struct NodeGain {
  Vec<D> along = Vec<D>::Zero();       ///< [m/s2]
  Spin<D> about = nothing<Spin<D>>();  ///< [rad/s2]
  [[nodiscard]] Vec<D> at(const Vec<D>& arm) const { return along + cross(about, arm); }
};

/// Magnitude of the angular acceleration of a free node, as an upper bound [rad/s2]; 0 for a node without rotary
/// inertia.
inline double angular_acceleration(double moment, double inertia) {
  return inertia > 0 ? std::abs(moment) / inertia : 0;
}
inline double angular_acceleration(const Vec3& moment, const Vec3& inertia) {
  return inertia.minCoeff() > 0 ? moment.norm() / inertia.minCoeff() : 0;
}

inline double turning_gain(const Model<2>& model, const State<2>& state, const Work<2>& work, int n, double dt,
                           double span) {
  const Support support = model.support[n][2];
  if (support == Support::free) return model.inertia[n] > 0 ? work.moment[n] / model.inertia[n] : 0;
  if (support == Support::driven) return (driven_velocity(model, state, n, 2, dt) - state.spin[n]) / span;
  return 0;
}
/// Angular acceleration of a node that is free about all axes; zero for others.
inline Vec3 turning_gain(const Model<3>& model, const State<3>& state, const Work<3>& work, int n, double /*dt*/,
                         double /*span*/) {
  const auto [x, y, z] = free_turns(model, n);
  if (!(x && y && z) || !(model.inertia[n].minCoeff() > 0)) return Vec3::Zero();
  const Turn3 turn = turn_of(state.rotation[n]);
  return turn.apply(turn.undo(work.moment[n]).cwiseQuotient(model.inertia[n]));
}

template <int D>
NodeGain<D> gain_of(const Model<D>& model, const State<D>& state, const Work<D>& work, int n, double dt) {
  const double span = 0.5 * (state.last_dt + dt);
  NodeGain<D> gain;
  if (!(span > 0)) return gain;
  for (int k = 0; k < Space<D>::translations; ++k) {
    const Support support = model.support[n][k];
    if (support == Support::free) gain.along[k] = work.force[n][k] / model.mass[n];
    if (support == Support::driven)
      gain.along[k] = (driven_velocity(model, state, n, k, dt) - state.velocity[n][k]) / span;
  }
  gain.about = turning_gain(model, state, work, n, dt, span);
  return gain;
}

/// Farthest distance of a motion with this speed [m/s] and acceleration [m/s2] within `dt` [s].
inline double farthest(double speed, double gain, double dt) {
  if (speed + gain * dt >= 0) return (speed + 0.5 * gain * dt) * dt;
  return speed > 0 ? -0.5 * speed * speed / gain : 0;
}
/// Speed [m/s] and time [s] at which the motion closes a gap, if it gets that far.
inline double speed_at_touch(double gap, double speed, double gain) {
  return std::sqrt(std::max(0.0, speed * speed + 2 * gain * gap));
}
inline double time_to_touch(double gap, double speed, double gain) {
  return 2 * gap / (speed + speed_at_touch(gap, speed, gain));
}

}  // namespace trilith
