// Masonry scenes made by the builders, for tests against limit loads.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "build/plane/part.hpp"
#include "physics/scene.hpp"

namespace trilith::testing {

/// Adds parts; the parts of the group `fixed` are fixed.
inline void add_parts(Scene& scene, const std::vector<Part>& parts, const std::string& fixed) {
  for (const Part& part : parts) {
    BodySpec spec;
    spec.name = part.name, spec.outline = part.outline, spec.groups = part.groups;
    if (std::find(part.groups.begin(), part.groups.end(), fixed) != part.groups.end()) spec.support = held;
    scene.add(std::move(spec));
  }
}

/// Largest displacement of a body from its start [m].
inline double farthest(const Model<2>& model, const State<2>& state) {
  double most = 0;
  for (int n = 0; n < model.nodes(); ++n) most = std::max(most, (state.position[n] - model.start_position[n]).norm());
  return most;
}

/// Contact law of joints so stiff that a hinge near the limit, millimetres long, still turns by less than 1e-3 rad. The
/// joints are damped by a `share` of the critical damping of a stone of `length` [m] that moves between its two joints.
/// A share of 0.2 damps impacts within a few periods and shortens the step by a quarter; with less than 0.001 an arch
/// chatters and drifts without end.
inline Frictional stiff_joint(double mu, double length, double stiffness = 4e12, double share = 0.2) {
  constexpr double density = 2000;                                         // density of the stone of a Scene
  const double frequency = std::sqrt(2 * stiffness / (density * length));  // [rad/s]
  return {stiffness, 0.5 * stiffness, mu, 2 * share / frequency};
}

/// Options of a release (see let_go).
struct LettingGo {
  int times = 1;        ///< largest number of releases, see let_go
  double ratio = 1e-5;  ///< settled until this unbalanced ratio, which exceeds the rounding: 2e-6 with joints of 4e12
                        ///< Pa/m, 2e-5 with 4e13 Pa/m
};

/// Settles a structure on its joints under the damping of consolidation, until it rests, for 1.5 s at most. (Weight
/// applied at once would tip standing parts by a few percent.)
inline StageEnd lay_down(Simulation<2>& sim, double ratio, const RunListener<2>& listener) {
  StageOptions options;
  options.name = "lay down";
  options.duration = 1.5, options.rest_share = 0.8, options.until_rest = true;
  options.still_speed = 1e-5, options.still_ratio = ratio, options.still_hold = 0.02;
  options.history_interval = 0.005;
  return sim.run(options, listener).end;
}

/// Outcome of the release of a structure.
enum class Fate { rests, comes_down, neither };

/// Settles a structure, then releases it.
///
/// The structure rests if, within 0.5 s, all velocities are below 1e-5 m/s and the unbalanced ratio is below 1e-4 for
/// 0.1 s. It collapses if a displacement reaches 10 mm before. If joints are at their friction limit, the equilibrium
/// can be unstable: the least motion grows (flutter) until, after a few tenths of a millimetre, other joints stick. In
/// this case a structure that neither rests nor collapses is settled in its current position and released again, up to
/// `times` releases. In all other cases this would hide joints with too little damping.
inline Fate let_go(Simulation<2>& sim, const LettingGo& how = {}) {
  RunListener<2> listener;
  listener.on_history = [&](const Instant<2>& now) {
    if (farthest(now.model, now.state) > 0.01) sim.stop();
  };
  StageOptions free;
  free.duration = 0.5, free.until_rest = true;
  free.still_speed = 1e-5, free.still_ratio = 1e-4, free.still_hold = 0.1;
  free.history_interval = 0.02;
  for (int i = 0; i < how.times; ++i) {
    if (lay_down(sim, how.ratio, listener) == StageEnd::stopped) return Fate::comes_down;
    const StageEnd end = sim.run(free, listener).end;
    if (end == StageEnd::rest) return Fate::rests;
    if (end == StageEnd::stopped) return Fate::comes_down;
  }
  return Fate::neither;
}

/// Tilts gravity from `from` to `to` [rad] at `rate` [rad/s]. Returns the tilt at which the velocity of a unit exceeds
/// 20 mm/s [rad], or `to`.
inline double tilt_on(Simulation<2>& sim, double from, double to, double rate) {
  const double start = sim.state().time;
  Gravity<2>& gravity = sim.edit_model().gravity;
  gravity.field = Turn(from).apply(Vec2(0, -standard_gravity));
  gravity.tilt_rate = rate, gravity.tilt_start = start;
  RunListener<2> listener;
  listener.on_history = [&](const Instant<2>& now) {
    if (now.speed > 0.02) sim.stop();
  };
  StageOptions options;
  options.duration = (to - from) / rate;
  options.history_interval = 0.002;
  return sim.run(options, listener).end == StageEnd::stopped ? from + rate * (sim.state().time - start) : to;
}

}  // namespace trilith::testing
