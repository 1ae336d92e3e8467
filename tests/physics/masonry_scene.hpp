// Scenes of masonry made by the builders, for tests against limit loads.
#pragma once

#include <algorithm>
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

}  // namespace trilith::testing
