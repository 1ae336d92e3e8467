#include "build/plane/stack.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "build/sound_parts.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("a stack's blocks stand on each other without gap") {
  const std::vector<Part> parts =
      build_stack({.name = "pile", .at = {1, 0.1}, .blocks = {{2, 0.3, 0}, {1, 0.7, 0.25}, {3, 0.1, -0.5}}});
  check_sound(parts);
  REQUIRE(parts.size() == 3);
  CHECK(parts[0].name == "pile.b1");
  for (std::size_t i = 1; i < parts.size(); ++i) CHECK(parts[i].outline[0].y() == parts[i - 1].outline[2].y());
  CHECK(near(polygon_moments(parts[0].outline).centroid.x(), 1, 1e-15));
  CHECK(near(polygon_moments(parts[2].outline).centroid.x(), 0.75, 1e-15));
}

TEST_CASE("the harmonic stack reaches out by half the harmonic sum") {
  const double reach[] = {0.5, 0.75, 0.916666666666667, 1.04166666666667, 1.14166666666667};
  for (int n = 1; n <= 5; ++n) {
    const std::vector<Part> parts = build_harmonic_stack({.count = n, .at = {2, 1}, .table_height = 0.5});
    check_sound(parts);
    REQUIRE(static_cast<int>(parts.size()) == n + 1);
    CHECK(parts[0].name == "table");
    CHECK(near(parts.back().outline[1].x() - 2, reach[n - 1], 1e-13));
    CHECK(parts[1].outline[0].y() == parts[0].outline[2].y());
    const std::vector<Part> less = build_harmonic_stack({.count = n, .factor = 0.98, .at = {2, 1}});
    CHECK(static_cast<int>(less.size()) == n);
    CHECK(near(less.back().outline[1].x() - 2, 0.98 * reach[n - 1], 1e-13));
  }
}

TEST_CASE("with factor 1 the blocks above every edge have their centre of mass over it") {
  const std::vector<Part> parts = build_harmonic_stack({.count = 8, .length = 0.7, .height = 0.1, .table_height = 1});
  for (std::size_t support = 0; support + 1 < parts.size(); ++support) {
    double middle = 0;
    for (std::size_t i = support + 1; i < parts.size(); ++i) middle += polygon_moments(parts[i].outline).centroid.x();
    middle /= static_cast<double>(parts.size() - support - 1);
    CHECK(std::abs(middle - parts[support].outline[1].x()) < 1e-14);
  }
}

TEST_CASE("stacks that cannot be built are rejected") {
  CHECK(mentions(refusal_of([] { build_stack({.name = "pile"}); }), "stack 'pile': has no blocks"));
  CHECK(mentions(refusal_of([] { build_stack({.blocks = {{1, 1, 0}, {1, 0, 0}}}); }), "stack, block 2: height is 0 m"));
  CHECK(mentions(refusal_of([] {
                   build_stack({.blocks = {{1, 1, 0}, {1, 1, 1}}});
                 }),
                 "offset is 1 m, must be within 1 m"));
  CHECK(mentions(refusal_of([] { build_harmonic_stack({.count = 0}); }), "count is 0"));
  CHECK(mentions(refusal_of([] { build_harmonic_stack({.factor = 2}); }), "factor is 2, must be below 2"));
  CHECK(mentions(refusal_of([] { build_harmonic_stack({.length = -1}); }), "length is -1 m"));
}
