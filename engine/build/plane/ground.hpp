// Ground bodies between a surface line and a level base.
#pragma once

#include <string>
#include <vector>

#include "build/plane/block.hpp"
#include "build/plane/part.hpp"

namespace trilith {

/// A ground body under a surface line.
struct GroundProfile {
  std::string name = "ground";
  std::vector<Vec2> surface = {};  ///< points from left to right [m]; two with the same x make a vertical step
  double base_level = 0;           ///< y of the bottom [m], below every surface point
};

/// One part, group "ground": the base from left to right, then the surface from right to left. Edge 0 is the base, edge
/// 1 the right side, the last edge the left side. Throws InputError for fewer than 2 points, points that are not sorted
/// by x, a base that is not below the surface, or points that form no simple polygon.
PolygonPart build_ground_profile(const GroundProfile& profile);

/// A level stretch of ground.
struct GroundStep {
  double from = 0;   ///< x of its left end [m]; it extends to the next step
  double level = 0;  ///< y of its surface [m]
};

/// Surface points of level steps, from left to right, ending at `end`, for use in a GroundProfile. Neighbours of equal
/// level are joined. Throws InputError for no steps or steps out of order.
std::vector<Vec2> stepped_surface(const std::vector<GroundStep>& steps, double end);

}  // namespace trilith
