// Equilibria that a stage without time has come by, to be told as it is.
#pragma once

#include <vector>

#include "world/model.hpp"
#include "world/state.hpp"

namespace trilith {

/// An equilibrium, and what of the loads it has.
template <int D>
struct Waypoint {
  State<D> state;
  double factor = 0;
};

/// Loads that a path has scaled, at factor 1, and what it came by from its begin to its end.
template <int D>
struct LoadWay {
  std::vector<PointLoad<D>> loads;
  std::vector<Waypoint<D>> points;
};

}  // namespace trilith
