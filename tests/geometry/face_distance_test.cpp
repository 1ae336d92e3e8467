#include <doctest/doctest.h>

#include "geometry/space/face_distance.hpp"
#include "near.hpp"

namespace trilith {

using testing::near;
using testing::near_zero;

TEST_CASE("the distance from a face: above it from its plane, otherwise from its nearest edge or corner") {
  const std::vector<Vec3> corners{{0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1}, {9, 9, 9}};
  for (const std::vector<int>& loop : {std::vector{0, 1, 2, 3}, std::vector{3, 2, 1, 0}}) {
    CHECK(near_zero(face_distance(corners, loop, {1, 0.5, 1}), 1e-15));
    CHECK(near(face_distance(corners, loop, {1, 0.5, 4}), 3, 1e-12));
    CHECK(near(face_distance(corners, loop, {1, 0.5, -1}), 2, 1e-12));
    CHECK(near(face_distance(corners, loop, {1, -3, 1}), 3, 1e-12));
    CHECK(near(face_distance(corners, loop, {1, -3, 5}), 5, 1e-12));
    CHECK(near(face_distance(corners, loop, {4, 3, 2}), 3, 1e-12));
  }
}

}  // namespace trilith
