// A small wall for tests of the builder, and the message of a rejected one.
#pragma once

#include <string>

#include "build/plane/wall.hpp"
#include "build/sound_parts.hpp"
#include "near.hpp"

namespace trilith::testing {

/// A plain wall of whole and half units: 2.4 m in 5 courses of 0.4 m x 0.2 m.
inline Wall plain_wall(const std::string& bond = "running") {
  Wall wall;
  wall.length = 2.4, wall.bond = bond;
  wall.storeys = {{.courses = 5}};
  return wall;
}

inline std::string refusal_of_wall(const Wall& wall) {
  return refusal_of([&] { build_wall(wall); });
}

inline std::string refusal_of_opening(WallOpening opening) {
  Wall wall = plain_wall();
  wall.name = std::string("w"), wall.openings = {opening};
  return refusal_of_wall(wall);
}

}  // namespace trilith::testing
