// How far a point is from a plane convex polygon in space.
#pragma once

#include <span>
#include <vector>

#include "base/space.hpp"

namespace trilith {

/// Of the face with these corners, in order; 0 on it [m].
double face_distance(const std::vector<Vec3>& corners, std::span<const int> loop, const Vec3& point);

}  // namespace trilith
