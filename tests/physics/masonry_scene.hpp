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

/// Near its limit a hinge is millimetres long: joints so stiff that it still turns by less than 1e-3.
inline Frictional stiff_joint(double mu, double stiffness = 4e12) {
  return {stiffness, 0.5 * stiffness, mu, 5e-9 * std::sqrt(4e12 / stiffness)};
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
