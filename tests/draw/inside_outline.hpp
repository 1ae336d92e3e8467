// Point-in-polygon test for pictures.
#pragma once

#include <cstddef>
#include <vector>

#include "base/space.hpp"

namespace trilith::testing {

/// By the number of sides that a ray from `p` crosses.
inline bool contains(const std::vector<Vec2>& outline, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0, k = outline.size() - 1; i < outline.size(); k = i++)
    if ((outline[i].y() > p.y()) != (outline[k].y() > p.y()) &&
        p.x() < outline[i].x() +
                    (p.y() - outline[i].y()) / (outline[k].y() - outline[i].y()) * (outline[k].x() - outline[i].x()))
      inside = !inside;
  return inside;
}

}  // namespace trilith::testing
