#include "geometry/space/overlap_3d.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/plane/overlap.hpp"
#include "geometry/space/random_convex_3d.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

PlacedSolid standing(const ConvexSolid& solid, const UnitQuaternion& rotation, const Vec3& at) {
  PlacedSolid out;
  place(solid, Turn3(rotation), at, out);
  return out;
}

ConvexSolid block_between(const Vec3& low, const Vec3& high) {
  return convex_solid(box_solid(low, high), "block");
}

ConvexSolid solid_by_chance(std::mt19937_64& bits) {
  return convex_solid(random_count(bits, 0, 1) == 0 ? random_convex_solid(bits, {.slenderest = 4})
                                                    : random_prism(bits, 0.2, 1.5, {.slenderest = 3}),
                      "solid");
}

/// A complete solid, to be clipped.
void begin_whole(const PlacedSolid& solid, SolidOverlapBuffer& buffer) {
  buffer.points = solid.corners;
  buffer.edges.clear(), buffer.faces.clear();
  const FaceLoops& faces = solid.solid->shape.faces;
  for (int f = 0; f < faces.count(); ++f) {
    const auto loop = faces[f];
    for (std::size_t k = 0; k < loop.size(); ++k)
      buffer.edges.push_back({loop[k], loop[k + 1 == loop.size() ? 0 : k + 1]});
    buffer.faces.push_back({f, static_cast<int>(buffer.edges.size())});
  }
}

/// Two adjacent solids.
struct SolidPair {
  ConvexSolid a, b;
  UnitQuaternion turn;
  Vec3 at;
  explicit SolidPair(std::mt19937_64& bits)
      : a(solid_by_chance(bits)), b(solid_by_chance(bits)), turn(random_rotation(bits)), at(random_in_ball(bits)) {}
};

}  // namespace

TEST_CASE("two boxes share the box between them") {
  const ConvexSolid a = block_between(Vec3(0, 0, 0), Vec3(2, 1, 1)), b = block_between(Vec3(0, 0, 0), Vec3(2, 3, 4));
  SolidOverlapBuffer buffer;
  const SolidOverlap o = solid_overlap(standing(a, {}, Vec3(0, 0, 0)), standing(b, {}, Vec3(1.5, 0.25, 0.5)), buffer);
  CHECK(near(o.volume, 0.5 * 0.75 * 0.5, 1e-15));
  CHECK(o.centroid.isApprox(Vec3(1.75, 0.625, 0.75), 1e-15));
  // a's faces at x = 2, y = 1 and z = 1 bound it
  CHECK(o.area_vector.isApprox(Vec3(0.75 * 0.5, 0.5 * 0.5, 0.5 * 0.75), 1e-15));
  CHECK(buffer.faces.size() == 6);
  double area = 0;
  for (int f = 0; f < 6; ++f) {
    const int of = buffer.faces[static_cast<std::size_t>(f)].of;
    const Vec3 normal =
        of >= 0 ? a.normals[static_cast<std::size_t>(of)] : b.normals[static_cast<std::size_t>(-1 - of)];
    const SharedFace face = shared_face(buffer, f, normal);
    area += face.area;
    CHECK(near_zero((face.centroid - o.centroid).cwiseAbs().dot(Vec3(1, 1, 1) - normal.cwiseAbs()), 1e-15));
  }
  CHECK(near(area, 2 * (0.375 + 0.25 + 0.375), 1e-15));
}

TEST_CASE("a solid inside another overlaps with its whole volume without force") {
  const ConvexSolid small = block_between(Vec3(-0.2, -0.3, -0.1), Vec3(0.2, 0.3, 0.1));
  const ConvexSolid large = block_between(Vec3(-2, -2, -2), Vec3(2, 2, 2));
  SolidOverlapBuffer buffer;
  std::mt19937_64 bits(2);
  for (int trial = 0; trial < 20; ++trial) {
    const PlacedSolid inner = standing(small, random_rotation(bits), random_in_ball(bits));
    const PlacedSolid outer = standing(large, random_rotation(bits), Vec3(0, 0, 0));
    for (const bool first : {true, false}) {
      const SolidOverlap o = first ? solid_overlap(inner, outer, buffer) : solid_overlap(outer, inner, buffer);
      CHECK(near(o.volume, 0.4 * 0.6 * 0.2, 1e-13));
      CHECK(near_zero(o.area_vector.norm(), 1e-14));
      CHECK(near_zero(o.area_moment.norm(), 1e-14));
    }
  }
}

TEST_CASE("solids that touch at a face, an edge or a corner, or are separated, have no overlap") {
  const ConvexSolid cube = block_between(Vec3(0, 0, 0), Vec3(1, 1, 1));
  SolidOverlapBuffer buffer;
  const PlacedSolid a = standing(cube, {}, Vec3(0, 0, 0));
  for (const Vec3& at : {Vec3(1, 0, 0), Vec3(0.3, -1, 0.2), Vec3(1, 1, 0.5), Vec3(1, 1, 1), Vec3(3, 0, 0)}) {
    CHECK(solid_overlap(a, standing(cube, {}, at), buffer).volume == 0);
    CHECK(buffer.faces.empty());
    const double nearer = solid_overlap(a, standing(cube, {}, 0.999999 * at), buffer).volume;
    CHECK((nearer > 0) == (at.x() < 3));
    CHECK(nearer < 1.1e-6);
  }
}

TEST_CASE("a corner that penetrates a face overlaps in a tetrahedron") {
  const ConvexSolid cube = block_between(Vec3(-0.5, -0.5, -0.5), Vec3(0.5, 0.5, 0.5));
  const ConvexSolid floor = block_between(Vec3(-3, -3, -1), Vec3(3, 3, 0));
  const UnitQuaternion on_corner =
      rotation_by(Vec3(std::atan(std::numbers::sqrt2), 0, 0)) * rotation_by(Vec3(0, 0, std::numbers::pi / 4));
  SolidOverlapBuffer buffer;
  for (const double depth : {1e-1, 1e-4, 1e-7}) {
    const Vec3 at(0.1, 0.2, std::sqrt(3.0) / 2 - depth);
    const SolidOverlap o = solid_overlap(standing(floor, {}, Vec3(0, 0, 0)), standing(cube, on_corner, at), buffer);
    // three edges of sqrt(3) times the depth at right angles; corners have an error of 1e-16 of 1 m
    const double leg = std::sqrt(3.0) * depth, allowed = 1e-15 / depth;
    CHECK(near(o.volume, leg * leg * leg / 6, 10 * allowed));
    CHECK(near(o.centroid.z(), -depth / 4, 10 * allowed));
    CHECK(near(o.area_vector.z(), std::sqrt(3.0) / 2 * leg * leg, 10 * allowed));
    CHECK(near_zero(o.area_vector.x() / o.area_vector.z(), 1e-12));
  }
}

TEST_CASE("the overlap of prisms is the overlap of plans times the overlap of heights") {
  std::mt19937_64 bits(6);
  SolidOverlapBuffer buffer;
  OverlapBuffer plane_buffer;
  int meeting = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Polygon plan_a = random_convex(bits, {.slenderest = 4});
    const Polygon plan_b = placed(random_convex(bits, {.slenderest = 4}), Vec2(1, 0),
                                  Vec2(random_between(bits, -0.7, 0.7), random_between(bits, -0.7, 0.7)));
    const ConvexSolid a = convex_solid(prism(plan_a, 0, 1), "a"), b = convex_solid(prism(plan_b, 0.6, 2), "b");
    const Overlap plan = convex_overlap(plan_a, plan_b, plane_buffer);
    const UnitQuaternion q = random_rotation(bits);
    const Vec3 at = 10 * random_in_ball(bits);
    const SolidOverlap o = solid_overlap(standing(a, q, at), standing(b, q, at), buffer);
    CHECK(near_zero(o.volume - 0.4 * plan.area, 1e-13));
    if (o.volume < 1e-3) continue;
    ++meeting;
    const Vec3 centre(plan.centroid.x(), plan.centroid.y(), 0.8);
    CHECK(near_zero((o.centroid - at - Turn3(q).apply(centre)).norm(), 1e-11));
  }
  CHECK(meeting > 200);
}

TEST_CASE("cutting with the smallest remainder first gives the result of cutting in order") {
  std::mt19937_64 bits(36);
  SolidOverlapBuffer buffer, in_turn;
  int meeting = 0;
  for (int trial = 0; trial < 10000; ++trial) {
    const SolidPair pair(bits);
    const PlacedSolid a = standing(pair.a, {}, Vec3(0, 0, 0)), b = standing(pair.b, pair.turn, 1.5 * pair.at);
    const SolidOverlap o = solid_overlap(a, b, buffer);
    begin_whole(a, in_turn);
    bool some = true;
    for (int f = 0; f < pair.b.shape.faces.count() && some; ++f) {
      const Vec3& n = b.normals[static_cast<std::size_t>(f)];
      const double offset = n.dot(b.corners[static_cast<std::size_t>(pair.b.shape.faces[f][0])]);
      some = cut({n, offset, -1 - f}, in_turn) && !in_turn.edges.empty();
    }
    const SolidMeasure all = some ? measured(in_turn) : SolidMeasure{0, Vec3(0, 0, 0)};
    CHECK(near_zero(o.volume - all.volume, 1e-14));
    if (o.volume < 1e-6) continue;
    ++meeting;
    CHECK((o.centroid - all.centroid).norm() < 1e-9);
    // a corner of many faces becomes several points by clipping, so the numbers of points may differ
    CHECK(buffer.faces.size() == in_turn.faces.size());
  }
  CHECK(meeting > 1500);
}

TEST_CASE("the shared volume is symmetric, and its two parts of surface close it") {
  std::mt19937_64 bits(7);
  SolidOverlapBuffer buffer;
  int meeting = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const SolidPair pair(bits);
    const PlacedSolid a = standing(pair.a, {}, Vec3(0, 0, 0)), b = standing(pair.b, pair.turn, pair.at);
    const SolidOverlap ab = solid_overlap(a, b, buffer), ba = solid_overlap(b, a, buffer);
    CHECK(near_zero(ab.volume - ba.volume, 1e-14));
    CHECK(near_zero((ab.area_vector + ba.area_vector).norm(), 1e-13));
    CHECK(ab.volume <= std::min(solid_moments(pair.a.shape).volume, solid_moments(pair.b.shape).volume) + 1e-14);
    if (ab.volume < 1e-4) continue;
    ++meeting;
    CHECK(near_zero((ab.centroid - ba.centroid).norm(), 1e-10));
    CHECK(near_zero((ab.area_moment + ba.area_moment).norm(), 1e-11));
  }
  CHECK(meeting > 700);
}

TEST_CASE("the shared volume does not depend on the frame") {
  std::mt19937_64 bits(8);
  SolidOverlapBuffer buffer;
  for (int trial = 0; trial < 500; ++trial) {
    const SolidPair pair(bits);
    const PlacedSolid a = standing(pair.a, {}, Vec3(0, 0, 0)), b = standing(pair.b, pair.turn, pair.at);
    const SolidOverlap o = solid_overlap(a, b, buffer);
    const UnitQuaternion q = random_rotation(bits);
    const Vec3 shift = 20 * random_in_ball(bits);
    const Turn3 turn(q);
    const SolidOverlap moved =
        solid_overlap(standing(pair.a, q, shift), standing(pair.b, q * pair.turn, turn.apply(pair.at) + shift), buffer);
    CHECK(near_zero(moved.volume - o.volume, 2e-13));
    CHECK(near_zero((moved.area_vector - turn.apply(o.area_vector)).norm(), 1e-12));
    if (o.volume < 1e-3) continue;
    CHECK(near_zero((moved.centroid - turn.apply(o.centroid) - shift).norm(), 1e-10));
    CHECK(near_zero((moved.area_moment - turn.apply(o.area_moment)).norm(), 1e-10));
  }
}

TEST_CASE("a solid is the sum of its overlaps with the parts of a box around it") {
  std::mt19937_64 bits(9);
  SolidOverlapBuffer buffer;
  for (int trial = 0; trial < 300; ++trial) {
    const ConvexSolid solid = solid_by_chance(bits);
    const PlacedSolid a = standing(solid, random_rotation(bits), Vec3(0, 0, 0));
    const UnitQuaternion q = random_rotation(bits);
    const Vec3 at = 0.3 * random_in_ball(bits);
    double sum = 0;
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0}) {
          const Vec3 far(4 * x, 4 * y, 4 * z), zero(0, 0, 0);
          const ConvexSolid part = block_between(far.cwiseMin(zero), far.cwiseMax(zero));
          sum += solid_overlap(a, standing(part, q, at), buffer).volume;
        }
    CHECK(near(sum, solid_moments(solid.shape).volume, 1e-12));
  }
}

TEST_CASE(
    "the push between solids is the derivative of the shared volume, for translation and rotation in all directions") {
  std::mt19937_64 bits(10);
  SolidOverlapBuffer buffer;
  int meeting = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const SolidPair pair(bits);
    const PlacedSolid a = standing(pair.a, {}, Vec3(0, 0, 0));
    const SolidOverlap o = solid_overlap(a, standing(pair.b, pair.turn, pair.at), buffer);
    if (o.volume < 1e-4) continue;
    ++meeting;
    const double h = 1e-5;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 unit = Vec3::Unit(axis);
      const auto moved = [&](double by) {
        return solid_overlap(a, standing(pair.b, pair.turn, pair.at + by * unit), buffer).volume;
      };
      CHECK(near_zero((moved(h) - moved(-h)) / (2 * h) + o.area_vector[axis], 1e-8));
      const auto turned = [&](double by) {
        const UnitQuaternion q = rotation_by(by * unit);
        const Vec3 arm = Turn3(q).apply(pair.at - o.centroid);
        return solid_overlap(a, standing(pair.b, q * pair.turn, o.centroid + arm), buffer).volume;
      };
      CHECK(near_zero((turned(h) - turned(-h)) / (2 * h) + o.area_moment[axis], 1e-8));
    }
  }
  CHECK(meeting > 300);
}

TEST_CASE("bricks that are flush within rounding have the exact overlap") {
  std::mt19937_64 bits(11);
  SolidOverlapBuffer buffer;
  const ConvexSolid brick = block_between(Vec3(-0.2, -0.1, -0.1), Vec3(0.2, 0.1, 0.1));
  for (int trial = 0; trial < 500; ++trial) {
    const UnitQuaternion q = random_rotation(bits);
    const Turn3 turn(q);
    const Vec3 at = 30 * random_in_ball(bits);
    const PlacedSolid a = standing(brick, q, at);
    // stacked with ends flush, with one side flush, and at the same position
    for (const Vec3& shift : {Vec3(0, 0, 0.19), Vec3(0.2, 0, 0.19), Vec3(0, 0, 0)}) {
      const SolidOverlap o = solid_overlap(a, standing(brick, q, at + turn.apply(shift)), buffer);
      const double expected = (0.4 - shift.x()) * 0.2 * (0.2 - shift.z());
      CHECK(near(o.volume, expected, 1e-10));
      CHECK(near_zero((o.centroid - at - turn.apply(0.5 * shift)).norm(), 1e-11));
      if (shift.z() > 0) CHECK(o.area_vector.dot(turn.z()) > 0.99 * (0.4 - shift.x()) * 0.2);
    }
  }
}

TEST_CASE("repeated overlaps need no more memory than the first ones") {
  std::mt19937_64 bits(12);
  SolidOverlapBuffer buffer;
  const SolidPair pair(bits);
  const PlacedSolid a = standing(pair.a, {}, Vec3(0, 0, 0)), b = standing(pair.b, pair.turn, 0.3 * pair.at);
  for (int i = 0; i < 4; ++i) solid_overlap(a, b, buffer);
  const std::array before{buffer.points.capacity() + buffer.points_before.capacity(),
                          buffer.edges.capacity() + buffer.edges_before.capacity()};
  for (int i = 0; i < 100; ++i) solid_overlap(a, b, buffer);
  CHECK(buffer.points.capacity() + buffer.points_before.capacity() == before[0]);
  CHECK(buffer.edges.capacity() + buffer.edges_before.capacity() == before[1]);
}
