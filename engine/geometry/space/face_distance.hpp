// Distance of a point from a plane convex polygon in space.
#pragma once

#include <span>
#include <vector>

#include "base/space.hpp"

namespace trilith {

/// Distance from the face with these corners, in order [m]; 0 on the face.
double face_distance(const std::vector<Vec3>& corners, std::span<const int> loop, const Vec3& point);

}  // namespace trilith
