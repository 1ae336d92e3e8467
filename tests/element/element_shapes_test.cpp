// Shape functions, faces and areas of single elements against closed forms.
#include <doctest/doctest.h>

#include <array>
#include <vector>

#include "element/section/section.hpp"
#include "element/solid/element_point.hpp"
#include "element/solid/plane_element.hpp"
#include "geometry/plane/polygon.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

TEST_CASE("the weights of a plane element's points add up to its area") {
  const std::vector<Vec2> triangle{{0.1, 0.2}, {1.7, 0.4}, {0.6, 1.3}};
  const std::vector<Vec2> quadrilateral{{0.1, 0.2}, {1.7, 0.4}, {1.5, 1.8}, {0.3, 1.3}};
  for (const std::vector<Vec2>& corners : {triangle, quadrilateral}) {
    const ElementStrain strain = plain_strain(corners);
    double sum = 0;
    for (int p = 0; p < strain.points; ++p) sum += strain.area[static_cast<std::size_t>(p)];
    CHECK(near(sum, signed_area(corners), 1e-12));
  }
}

TEST_CASE("each shape function of a wedge is 1 at its node and 0 at the others") {
  for (std::size_t node = 0; node < 6; ++node) {
    const Vec3 at(node % 3 == 1 ? 1 : 0, node % 3 == 2 ? 1 : 0, node < 3 ? -1 : 1);
    const auto n = shape_functions(ElementShape::wedge, at);
    for (std::size_t i = 0; i < 6; ++i) CHECK(near_zero(n[i] - (i == node ? 1 : 0), 1e-14));
  }
}

TEST_CASE("the faces of a tetrahedron have the area of their triangles") {
  const std::array<Vec3, 4> nodes{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 3, 0), Vec3(0, 0, 1)};
  double sum = 0;
  for (int face = 0; face < 4; ++face) {
    const FaceFit fit = fit_face(ElementShape::tetrahedron, nodes, face);
    sum += fit.area;
    CHECK(near_zero(fit.mean[0] + fit.mean[1] + fit.mean[2] - 1, 1e-12));
  }
  // Three right triangles, and the slanted one: half the root of the sum of the squared products of the sides.
  CHECK(near(sum, 3 + 1 + 1.5 + 0.5 * std::sqrt(36.0 + 4 + 9), 1e-12));
}

TEST_CASE("a rectangular polygon has the section constants of the rectangle, also clockwise and elsewhere") {
  const Section known = RectangleSection{0.3, 0.7}.numbers();
  const std::vector<Vec2> turning_left{{1, 2}, {1.3, 2}, {1.3, 2.7}, {1, 2.7}},
      turning_right(turning_left.rbegin(), turning_left.rend());
  for (const std::vector<Vec2>& outline : {turning_left, turning_right}) {
    const Section found = polygon_section(outline);
    CHECK(near(found.area, known.area, 1e-12));
    CHECK(near(found.second_moment, known.second_moment, 1e-12));
    CHECK(near(found.shear_area, known.shear_area, 1e-12));
    CHECK(near(found.above, known.above, 1e-12));
    CHECK(near(found.below, known.below, 1e-12));
  }
}
