// Scenes of masonry made by the builders, for tests against limit loads.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "build/part.hpp"
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

/// Near its limit a hinge is millimetres long: joints so stiff that it still turns by less than 1e-3. With
/// the `beta` that is preset, less than a thousandth of critical, an arch rattles: see calm_beta.
inline Frictional stiff_joint(double mu, double stiffness = 4e12, double beta = 5e-9) {
  return {stiffness, 0.5 * stiffness, mu, beta * std::sqrt(4e12 / stiffness)};
}

/// Damps such joints by some percent of critical, so that what stands lies still.
inline constexpr double calm_beta = 5e-7;

/// Lays a structure down on its joints under the damping of consolidation (dropped at once, the weight would tip what
/// stands by a few percent). Ends at rest, or stopped once anything has gone 10 mm, or after 2 s. Joints of 4e13 Pa/m
/// answer to the last bits of places with 2e-5 of the forces they carry, so less is not asked for.
inline StageEnd lay_down(Simulation& sim, const RunListener& listener = {}) {
  StageOptions options;
  options.name = "lay down";
  options.duration = 2, options.rest_share = 0.8, options.until_rest = true;
  options.still_speed = 1e-5, options.still_ratio = 5e-5, options.still_hold = 0.02;
  options.history_interval = 0.005;
  return sim.run(options, listener).end;
}

/// What becomes of a structure that is let go.
enum class Fate { rests, comes_down, neither };

/// Lays a structure down, then lets it go. It rests where, within 1 s, all is slower than 1e-5 m/s and out of balance
/// by less than 1e-4 for a tenth of a second; it comes down where anything has gone 10 mm, then or before.
inline Fate let_go(Simulation& sim) {
  RunListener listener;
  listener.on_history = [&](const Instant& now) {
    if (farthest(now.model, now.state) > 0.01) sim.stop();
  };
  if (lay_down(sim, listener) == StageEnd::stopped) return Fate::comes_down;
  StageOptions free;
  free.duration = 1, free.until_rest = true;
  free.still_speed = 1e-5, free.still_ratio = 1e-4, free.still_hold = 0.1;
  free.history_interval = 0.02;
  const StageEnd end = sim.run(free, listener).end;
  return end == StageEnd::rest ? Fate::rests : end == StageEnd::stopped ? Fate::comes_down : Fate::neither;
}

/// Turns gravity from tilt `from` on at `rate` [rad/s], up to tilt `to`: the tilt at which some unit runs away, at
/// more than 20 mm/s [rad], or `to`.
inline double tilt_on(Simulation& sim, double from, double to, double rate) {
  const double start = sim.state().time;
  Gravity& gravity = sim.edit_model().gravity;
  gravity.field = Turn(from).apply(Vec2(0, -standard_gravity));
  gravity.tilt_rate = rate, gravity.tilt_start = start;
  RunListener listener;
  listener.on_history = [&](const Instant& now) {
    if (now.speed > 0.02) sim.stop();
  };
  StageOptions options;
  options.duration = (to - from) / rate;
  options.history_interval = 0.002;
  return sim.run(options, listener).end == StageEnd::stopped ? from + rate * (sim.state().time - start) : to;
}

}  // namespace trilith::testing
