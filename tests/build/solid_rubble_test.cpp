#include "build/space/solid_rubble.hpp"

#include <doctest/doctest.h>

#include "build/sound_parts.hpp"
#include "build/sound_solids.hpp"
#include "geometry/space/random_convex_3d.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("stones of rubble fill a box, convex, flat on each other, without overlap") {
  for (const double aspect : {1.0, 2.5}) {
    const std::vector<SolidPart> parts = build_solid_rubble(
        {.name = "R", .low = {1, 2, 3}, .high = {3, 2.5, 4}, .stones = 80, .aspect = aspect, .seed = 4});
    CHECK(parts.size() == 80);
    CHECK(near(total_volume(parts), 1, 1e-12));
    // each face is part of the box or in contact with other stones, except for the small stones that are not counted
    double faces = 0;
    for (const SolidPart& part : parts)
      for (int f = 0; f < part.pieces[0].faces.count(); ++f)
        faces += area_vector(part.pieces[0].corners, part.pieces[0].faces[f]).norm();
    CHECK(near(check_sound(parts), (faces - 7) / 2, 1e-8));
    double below = 0;
    for (const SolidPart& part : parts) {
      const double z = solid_moments(part.pieces[0]).centroid.z();
      CHECK(z >= below);
      below = z;
    }
  }
}

TEST_CASE("rubble fills any convex solid") {
  std::mt19937_64 bits(3);
  for (int i = 0; i < 5; ++i) {
    const Polyhedron within = random_convex_solid(bits, {.fewest_corners = 8, .most_corners = 20});
    const std::vector<SolidPart> parts =
        build_solid_rubble({.within = within, .stones = 30, .relaxations = 0, .seed = i});
    CHECK(near(total_volume(parts), solid_moments(within).volume, 1e-12));
    check_sound(parts);
  }
}

TEST_CASE("a joint sets stones apart by its width") {
  const SolidRubble rubble{.low = {0, 0, 0}, .high = {2, 1, 1}, .stones = 2, .aspect = 3, .joint = 0.1};
  const std::vector<SolidPart> parts = build_solid_rubble(rubble);
  REQUIRE(parts.size() == 2);
  const ConvexSolid a = convex_solid(parts[0].pieces[0], "a"), b = convex_solid(parts[1].pieces[0], "b");
  double widest = 0;
  for (const Vec3& n : a.normals) {
    double high = -10, low = 10;
    for (const Vec3& p : a.shape.corners) high = std::max(high, n.dot(p));
    for (const Vec3& p : b.shape.corners) low = std::min(low, n.dot(p));
    widest = std::max(widest, low - high);
  }
  CHECK(near(widest, 0.1, 1e-12));
}

TEST_CASE("the same seed gives the same stones, another one others, relaxation evens them out") {
  SolidRubble rubble{.high = {1, 1, 1}, .stones = 40, .relaxations = 0, .jitter = 0.01};
  const auto spread = [](const std::vector<SolidPart>& parts) {
    double least = 1, most = 0;
    for (const SolidPart& part : parts)
      least = std::min(least, volume_of(part)), most = std::max(most, volume_of(part));
    return most / least;
  };
  const std::vector<SolidPart> first = build_solid_rubble(rubble), again = build_solid_rubble(rubble);
  for (std::size_t i = 0; i < first.size(); ++i) CHECK(first[i].pieces[0].corners == again[i].pieces[0].corners);
  const double before = spread(first);
  rubble.seed = 2;
  CHECK(build_solid_rubble(rubble)[0].pieces[0].corners != first[0].pieces[0].corners);
  rubble.seed = 1, rubble.relaxations = 20;
  CHECK(spread(build_solid_rubble(rubble)) < before / 2);
}

TEST_CASE("impossible rubble in space is rejected") {
  CHECK(mentions(refusal_of([] {
                   build_solid_rubble({.name = "R", .high = {1, 1, 1}, .stones = 0});
                 }),
                 "rubble 'R': number of stones is 0"));
  CHECK(mentions(refusal_of([] { build_solid_rubble({.high = {1, 0, 1}}); }), "its box reaches from 0 to 0 m in y"));
  CHECK(mentions(refusal_of([] { build_solid_rubble({.high = {1, 1, 1}, .aspect = 20}); }), "aspect is 20"));
  CHECK(mentions(refusal_of([] {
                   build_solid_rubble({.high = {1, 1, 1}, .joint = 1});
                 }),
                 "joint is 1 m, must be at most half"));
  Polyhedron open = box_solid({0, 0, 0}, {1, 1, 1});
  open.faces.corner.resize(20), open.faces.start.pop_back();
  CHECK(mentions(refusal_of([&] { build_solid_rubble({.within = open}); }), "rubble: "));
}
