#include "geometry/plane/outline_moments.hpp"

#include <doctest/doctest.h>

#include "geometry/plane/polygon.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

OutlineMoments of_rectangle(const Vec2& low, const Vec2& high) {
  return OutlineMoments(rectangle(low, high));
}

void check_equal(const OutlineMoments& a, const OutlineMoments& b) {
  CHECK(near(a.area, b.area, 1e-12));
  CHECK(near_zero((a.middle - b.middle).norm(), 1e-12));
  CHECK(near(a.xx, b.xx, 1e-12));
  CHECK(near(a.yy, b.yy, 1e-12));
  CHECK(near_zero(a.xy - b.xy, 1e-12));
}

}  // namespace

TEST_CASE("two parts of a rectangle, divided along either axis, have its moments") {
  const OutlineMoments whole = of_rectangle({1, 2}, {4, 3});
  CHECK(near(whole.xx, 27.0 / 12, 1e-12));
  CHECK(near(whole.yy, 3.0 / 12, 1e-12));
  OutlineMoments beside = of_rectangle({1, 2}, {2, 3});
  beside.add(of_rectangle({2, 2}, {4, 3}), 1);
  check_equal(beside, whole);
  OutlineMoments above = of_rectangle({1, 2}, {4, 2.25});
  above.add(of_rectangle({1, 2.25}, {4, 3}), 1);
  check_equal(above, whole);
}

TEST_CASE("a part that is added and subtracted again leaves the moments") {
  const OutlineMoments whole = of_rectangle({0, 0}, {2, 1});
  OutlineMoments angle = whole;
  angle.add(of_rectangle({0, 1}, {0.5, 4}), 1);
  // Closed form of the product of inertia of an angle: area a b / (a + b) times both distances of the centroids.
  CHECK(near(angle.xy, -2 * 1.5 / 3.5 * 0.75 * 2, 1e-12));
  angle.add(of_rectangle({0, 1}, {0.5, 4}), -1);
  check_equal(angle, whole);
}

TEST_CASE("four points with a quarter of the area each have the moments of the figure") {
  OutlineMoments angle = of_rectangle({0, 0}, {2, 1});
  angle.add(of_rectangle({0, 1}, {0.5, 4}), 1);
  double xx = 0, xy = 0, yy = 0;
  for (const Vec2& arm : angle.arms()) {
    xx += 0.25 * angle.area * arm.x() * arm.x(), yy += 0.25 * angle.area * arm.y() * arm.y();
    xy += 0.25 * angle.area * arm.x() * arm.y();
  }
  CHECK(near(xx, angle.xx, 1e-12));
  CHECK(near(yy, angle.yy, 1e-12));
  CHECK(near(xy, angle.xy, 1e-12));
}
