#include "build/space/drum.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "build/sound_parts.hpp"
#include "build/sound_solids.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Area of a regular polygon with corners on a circle of radius `r`.
double ring_area(int n, double r) {
  return n / 2.0 * std::sin(2 * std::numbers::pi / n) * r * r;
}

}  // namespace

TEST_CASE("a regular prism has its closed volume, also where it comes in pieces") {
  for (const int n : {3, 6, 32, 33, 200}) {
    const SolidPart part =
        build_prism({.name = "p", .sides = n, .radius = 0.7, .height = 1.3, .phase = 0.2, .groups = {"g"}});
    CHECK(near(volume_of(part), 1.3 * ring_area(n, 0.7), 1e-12));
    CHECK(part.pieces.size() == (n <= 32 ? 1U : n == 33 ? 2U : 8U));
    check_sound({part});
  }
}

TEST_CASE("a drum of straight sides has the radius of its corners, its sides or the area of a round one") {
  const double area = std::numbers::pi * 0.25;
  CHECK(near(volume_of(build_cylinder_drum({.sides = 9, .radius = 0.5, .height = 2})), 2 * area, 1e-12));
  CHECK(volume_of(build_cylinder_drum({.radius = 0.5, .of = DrumRadius::corners, .height = 2})) < 2 * area);
  CHECK(volume_of(build_cylinder_drum({.radius = 0.5, .of = DrumRadius::sides, .height = 2})) > 2 * area);
  const SolidPart cone =
      build_cylinder_drum({.sides = 40, .radius = 0.5, .top_radius = 0.4, .height = 2, .groups = {"g"}});
  CHECK(near(volume_of(cone), 2 * std::numbers::pi / 3 * (0.25 + 0.2 + 0.16), 1e-12));
  check_sound({cone});
}

TEST_CASE("a column of drums stands flat from base to capital") {
  const Column column{.name = "C",
                      .drums = 5,
                      .height = 4,
                      .sides = 12,
                      .radius = 0.5,
                      .top_radius = 0.4,
                      .base = {1.2, 0.3},
                      .capital = {1.1, 0.25},
                      .at = {0.3, -0.2, 0.1}};
  const std::vector<SolidPart> parts = build_column(column);
  REQUIRE(parts.size() == 7);
  CHECK(parts[0].name == "C.base");
  CHECK(parts[3].name == "C.d3");
  CHECK(count_in_group(parts, "drums") == 5);
  CHECK(near(total_volume(parts), 1.44 * 0.3 + 1.21 * 0.25 + 4 * std::numbers::pi / 3 * (0.25 + 0.2 + 0.16), 1e-12));
  double beds = 0;
  for (int i = 0; i <= 5; ++i) beds += std::numbers::pi * std::pow(0.5 - 0.02 * i, 2);
  CHECK(near(check_sound(parts), beds, 1e-9));
  for (std::size_t d = 1; d < 5; ++d)
    for (std::size_t i = 0; i < 12; ++i) CHECK(parts[d].pieces[0].corners[12 + i] == parts[d + 1].pieces[0].corners[i]);
}

TEST_CASE("columns and drums out of range are rejected") {
  CHECK(mentions(refusal_of([] { build_prism({.name = "p", .sides = 2, .radius = 1, .height = 1}); }),
                 "prism 'p': number of sides is 2"));
  CHECK(mentions(refusal_of([] { build_prism({.radius = 1}); }), "prism: height is 0 m"));
  CHECK(mentions(refusal_of([] { build_cylinder_drum({.radius = -1, .height = 1}); }), "drum: radius is -1 m"));
  CHECK(mentions(refusal_of([] { build_cylinder_drum({.radius = 1, .top_radius = -1, .height = 1}); }),
                 "drum: top radius is -1 m"));
  CHECK(mentions(refusal_of([] { build_column({.name = "C", .drums = 0, .radius = 1}); }),
                 "column 'C': number of drums is 0"));
  CHECK(mentions(refusal_of([] {
                   build_column({.heights = {1, 0}, .radius = 1});
                 }),
                 "column: height of drum 2 is 0 m"));
  CHECK(mentions(refusal_of([] {
                   build_column({.height = 1, .radius = 1, .base = {1, 0}});
                 }),
                 "height of its base is 0 m"));
}
