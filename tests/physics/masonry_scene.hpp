// Scenes of masonry made by the builders, for tests against limit loads.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "build/plane/part.hpp"
#include "physics/scene.hpp"

namespace trilith::testing {

/// Adds parts; those of the group `fixed` are held.
inline void add_parts(Scene& scene, const std::vector<Part>& parts, const std::string& fixed) {
  for (const Part& part : parts) {
    BodySpec spec;
    spec.name = part.name, spec.outline = part.outline, spec.groups = part.groups;
    if (std::find(part.groups.begin(), part.groups.end(), fixed) != part.groups.end()) spec.support = held;
    scene.add(std::move(spec));
  }
}

/// Largest way any body has gone from its start [m].
inline double farthest(const Model<2>& model, const State<2>& state) {
  double most = 0;
  for (int n = 0; n < model.nodes(); ++n) most = std::max(most, (state.position[n] - model.start_position[n]).norm());
  return most;
}

/// Near its limit a hinge is millimetres long: joints so stiff that it still turns by less than 1e-3. They are damped
/// by a `share` of what is critical for a stone of `length` [m] that moves between its two joints. A fifth lets knocks
/// die out within a few periods and costs the step a quarter; with less than a thousandth an arch rattles and walks for
/// ever.
inline Frictional stiff_joint(double mu, double length, double stiffness = 4e12, double share = 0.2) {
  constexpr double density = 2000;                                         // of the stone of a Scene
  const double frequency = std::sqrt(2 * stiffness / (density * length));  // [rad/s]
  return {stiffness, 0.5 * stiffness, mu, 2 * share / frequency};
}

/// How a structure is let go.
struct LettingGo {
  int times = 1;        ///< so many times, see let_go
  double ratio = 1e-5;  ///< laid down until this unbalanced ratio, above what rounding leaves: 2e-6 with joints of
                        ///< 4e12 Pa/m, 2e-5 with 4e13
};

/// Lays a structure down on its joints under the damping of consolidation (dropped at once, the weight would tip what
/// stands by a few percent): until it rests, for 1.5 s at most.
inline StageEnd lay_down(Simulation<2>& sim, double ratio, const RunListener<2>& listener) {
  StageOptions options;
  options.name = "lay down";
  options.duration = 1.5, options.rest_share = 0.8, options.until_rest = true;
  options.still_speed = 1e-5, options.still_ratio = ratio, options.still_hold = 0.02;
  options.history_interval = 0.005;
  return sim.run(options, listener).end;
}

/// What becomes of a structure that is let go.
enum class Fate { rests, comes_down, neither };

/// Lays a structure down, then lets it go. It rests where, within 0.5 s, all is slower than 1e-5 m/s and out of balance
/// by less than 1e-4 for a tenth of a second; it comes down where anything has gone 10 mm, then or before. Where joints
/// are at the limit of their friction, equilibrium can be unstable: the least motion grows (flutter) until, some tenths
/// of a millimetre on, other joints stick. For such, what does neither is laid down as it then stands and let go again,
/// up to so many `times`; elsewhere that would hide joints that are damped too little.
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

/// Turns gravity from tilt `from` on at `rate` [rad/s], up to tilt `to`: the tilt at which some unit runs away, at
/// more than 20 mm/s [rad], or `to`.
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
