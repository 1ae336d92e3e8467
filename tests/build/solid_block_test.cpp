#include "build/space/solid_block.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "base/rotation_3d.hpp"
#include "build/plane/arch.hpp"
#include "build/sound_parts.hpp"
#include "build/sound_solids.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("a box has its lower corner or its centre at the given point, to the bit") {
  const SolidPart part = build_box({.name = "b", .size = {0.3, 0.2, 0.1}, .at = {0, 0, 0}});
  REQUIRE(part.pieces.size() == 1);
  for (const Vec3& p : part.pieces[0].corners) {
    CHECK((p.x() == 0 || p.x() == 0.3));
    CHECK((p.y() == 0 || p.y() == 0.2));
    CHECK((p.z() == 0 || p.z() == 0.1));
  }
  CHECK(near(volume_of(part), 0.006, 1e-14));
  const SolidPart centred = build_box({.size = {2, 1, 4}, .at = {5, 6, 7}, .anchor = BoxAnchor::centre});
  CHECK(solid_moments(centred.pieces[0]).centroid == Vec3(5, 6, 7));
}

TEST_CASE("a box is turned about its anchor by an axis and an angle or by a quaternion") {
  const double quarter = std::numbers::pi / 2;
  const SolidPart turned =
      build_box({.size = {2, 1, 4}, .at = {5, 6, 7}, .turn = {.axis = {0, 0, 3}, .angle = quarter}});
  const Vec3 middle = solid_moments(turned.pieces[0]).centroid;
  CHECK((middle - Vec3(4.5, 7, 9)).norm() < 1e-14);
  CHECK(near(volume_of(turned), 8, 1e-14));
  const UnitQuaternion twice = {3, 0, 0, 3};
  const SolidPart same = build_box({.size = {2, 1, 4}, .at = {5, 6, 7}, .turn = {.quaternion = twice}});
  for (std::size_t i = 0; i < 8; ++i) CHECK((same.pieces[0].corners[i] - turned.pieces[0].corners[i]).norm() < 1e-14);
  check_convex(build_box({.size = {2, 1, 4}, .turn = {.axis = {1, 2, 3}, .angle = 1}}).pieces[0], "turned");
}

TEST_CASE("impossible boxes are rejected") {
  CHECK(mentions(refusal_of([] { build_box({.name = "b", .size = {1, 0, 1}}); }), "block 'b': size along y is 0 m"));
  CHECK(mentions(refusal_of([] { build_box({.size = {1, 1, 1}, .at = {0, NAN, 0}}); }), "block: y is nan"));
  CHECK(mentions(refusal_of([] {
                   build_box({.size = {1, 1, 1}, .turn = {.axis = {0, 0, 0}, .angle = 1}});
                 }),
                 "axis is (0, 0, 0)"));
  CHECK(mentions(refusal_of([] {
                   build_box({.size = {1, 1, 1}, .turn = {.quaternion = {0, 0, 0, 0}}});
                 }),
                 "has no length"));
  CHECK(mentions(refusal_of([] {
                   build_box({.size = {1, 1, 1}, .turn = {.angle = 1, .quaternion = {0, 1, 0, 0}}});
                 }),
                 "both an angle and a quaternion"));
}

TEST_CASE("an extruded outline has its area times the depth, in convex pieces that share faces to the bit") {
  const Polygon ell{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};
  for (const OutlinePlane plane : {OutlinePlane::upright, OutlinePlane::level}) {
    const NotedSolid made =
        build_extrusion({.name = "L", .outline = ell, .plane = plane, .from = 0.5, .depth = 0.3, .groups = {"g"}});
    CHECK(made.notes.empty());
    CHECK(made.part.pieces.size() == 2);
    CHECK(near(volume_of(made.part), 6 * 0.3, 1e-14));
    check_sound({made.part});
    Vec3 low = Vec3::Constant(10), high = -low;
    for (const Polyhedron& piece : made.part.pieces)
      for (const Vec3& p : piece.corners) low = low.cwiseMin(p), high = high.cwiseMax(p);
    CHECK(low == (plane == OutlinePlane::upright ? Vec3(0, 0.5, 0) : Vec3(0, 0, 0.5)));
    CHECK(high == (plane == OutlinePlane::upright ? Vec3(3, 0.8, 4) : Vec3(3, 4, 0.8)));
  }
  const NotedSolid clockwise = build_extrusion({.outline = {{0, 0}, {0, 1}, {1, 0}}, .depth = 1, .centred = true});
  CHECK(clockwise.notes.size() == 1);
  CHECK(near(volume_of(clockwise.part), 0.5, 1e-14));
}

TEST_CASE("an outline of many corners is parted so that contact takes every face") {
  Polygon round;
  for (int i = 0; i < 100; ++i) {
    const double t = 2 * std::numbers::pi * i / 100;
    round.emplace_back(std::cos(t), std::sin(t));
  }
  const SolidPart part = build_extrusion({.outline = round, .depth = 2, .groups = {"g"}}).part;
  CHECK(part.pieces.size() == 4);
  CHECK(near(volume_of(part), 2 * signed_area(round), 1e-13));
  check_sound({part});
}

TEST_CASE("parts of the plane become solids that share the faces their outlines share") {
  const std::vector<Part> arch =
      build_arch({.name = "A", .voussoirs = 11, .radius = 2, .thickness = 0.3, .sub_edges = 3});
  const std::vector<SolidPart> solids = extrude_parts(arch, {.depth = 0.7, .from = 1, .centred = true});
  REQUIRE(solids.size() == arch.size());
  for (std::size_t i = 0; i < arch.size(); ++i) {
    CHECK(solids[i].name == arch[i].name);
    CHECK(solids[i].groups == arch[i].groups);
    CHECK(near(volume_of(solids[i]), 0.7 * signed_area(arch[i].outline), 1e-13));
  }
  check_sound(solids);
  CHECK(mentions(refusal_of([&] { extrude_part(arch[0], {}); }), "part 'A.v1': depth is 0 m"));
}

TEST_CASE("a hull of rounded points gets exactly plane faces, and reports it") {
  std::vector<Vec3> points;
  for (const double z : {0.0, 1.0})
    for (int i = 0; i < 12; ++i) {
      const double t = 2 * std::numbers::pi * i / 12, r = z == 0 ? 1 : 0.777;
      points.emplace_back(std::round(r * std::cos(t) * 1e6) / 1e6, std::round(r * std::sin(t) * 1e6) / 1e6, z);
    }
  const NotedSolid rounded = build_hull({.name = "h", .points = points, .flat = 1e-5});
  CHECK(rounded.part.pieces[0].faces.count() == 14);
  REQUIRE(rounded.notes.size() == 1);
  CHECK(mentions(rounded.notes[0], "hull 'h': its faces were made plane: corners moved by up to"));
  check_convex(rounded.part.pieces[0], "h", 1e-12);
  const NotedSolid box = build_hull(
      {.points = {
           {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0.5, 0.5, 0.5}}});
  CHECK(box.notes.empty());
  CHECK(box.part.pieces[0].faces.count() == 6);
  CHECK(near(volume_of(box.part), 1, 1e-15));
  CHECK(mentions(refusal_of([] {
                   build_hull({.name = "h", .points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}});
                 }),
                 "hull 'h': all its points lie in one plane"));
  CHECK(mentions(refusal_of([] { build_hull({.flat = 1}); }), "flat is 1, must be from"));
}
