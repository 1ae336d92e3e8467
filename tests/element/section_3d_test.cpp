// Sections of beams in space against closed forms.
#include <doctest/doctest.h>

#include "base/error.hpp"
#include "element/section/section_3d.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("torsion constants of rectangles match Saint-Venant's tables") {
  // c1 in J = c1 a b^3 (Timoshenko and Goodier, art. 109, to the four printed digits)
  for (const auto& [ratio, share] : {std::pair(1.0, 0.1406), std::pair(1.2, 0.166), std::pair(1.5, 0.196),
                                     std::pair(2.0, 0.229), std::pair(4.0, 0.281), std::pair(10.0, 0.312)}) {
    CHECK(near(rectangle_torsion(ratio, 1), share * ratio, 3e-3));
    CHECK(rectangle_torsion(ratio, 1) == rectangle_torsion(1, ratio));
  }
  CHECK(near(rectangle_torsion(1, 1), 0.140577, 1e-5));
}

TEST_CASE("a circle's torsion constant is its polar second moment and a thin square box's is Bredt's") {
  const Section3 circle = section_in_space(CircleSection{0.4, 0.2});
  CHECK(near(circle.torsion, M_PI / 32 * (0.4 * 0.4 * 0.4 * 0.4 - 0.2 * 0.2 * 0.2 * 0.2), 1e-13));
  CHECK(circle.second_moment[0] == circle.second_moment[1]);
  // wall thickness t, middle line b: J = b^3 t
  const Section3 box = section_in_space(BoxSection{1.01, 1.01, 0.02, 0.01, 0.01});
  CHECK(near(box.torsion, 0.01, 1e-12));
  CHECK(near(box.second_moment[0], box.second_moment[1], 1e-12));
}

TEST_CASE("sections in space bend vertically as in the plane and laterally as the rotated section") {
  const Section3 wide = section_in_space(RectangleSection{0.5, 0.2}),
                 tall = section_in_space(RectangleSection{0.2, 0.5});
  CHECK(near(wide.second_moment[0], tall.second_moment[1], 1e-14));
  CHECK(near(wide.second_moment[1], RectangleSection{0.5, 0.2}.numbers().second_moment, 1e-14));
  const ISection i{0.4, 0.02, 0.3, 0.03, 0.2, 0.04};
  const Section3 made = section_in_space(i);
  CHECK(near(made.second_moment[1], i.numbers().second_moment, 1e-14));
  CHECK(near(made.second_moment[0], (0.03 * 0.027 + 0.04 * 0.008 + 0.33 * 8e-6) / 12, 1e-12));
  CHECK(near(made.torsion, (0.3 * 2.7e-5 + 0.2 * 6.4e-5 + 0.33 * 8e-6) / 3, 1e-12));
  REQUIRE(made.profile.size() == 3);
}

TEST_CASE("a polygon section bends about its principal axes, and a rotated one is rejected with the correction") {
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Section3 s = polygon_section_in_space(square);
  CHECK(near(s.second_moment[0], 1.0 / 12, 1e-12));
  CHECK(near(s.torsion, 0.1406, 0.07));  // 1 / (40 / 6), 6.7 % above
  const std::vector<Vec2> askew{{0, 0}, {2, 1}, {2, 1.5}, {0, 0.5}};
  CHECK_THROWS_WITH_AS(polygon_section_in_space(askew), doctest::Contains("principal axes"), InputError);
}
