#include "geometry/space/separation_3d.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/space/overlap_3d.hpp"
#include "geometry/space/random_convex_3d.hpp"
#include "geometry/space/separation_parts.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

PlacedSolid solid_at(const ConvexSolid& solid, const UnitQuaternion& rotation, const Vec3& at) {
  PlacedSolid out;
  place(solid, Turn3(rotation), at, out);
  return out;
}

ConvexSolid brick_of(double x, double y, double z) {
  return convex_solid(box_solid(Vec3(-x / 2, -y / 2, -z / 2), Vec3(x / 2, y / 2, z / 2)), "brick");
}

ConvexSolid any_solid(std::mt19937_64& bits) {
  return convex_solid(random_count(bits, 0, 1) == 0 ? random_convex_solid(bits, {.slenderest = 4})
                                                    : random_prism(bits, 0.2, 1.5, {.slenderest = 3}),
                      "solid");
}

/// Largest distance over all faces and all pairs of edges, each over all corners of both.
double largest_distance(const PlacedSolid& a, const PlacedSolid& b) {
  double best = -1e9;
  const auto along = [&](const Vec3& axis) {
    double top_a = -1e9, low_b = 1e9, low_a = 1e9, top_b = -1e9;
    for (const Vec3& p : a.corners) top_a = std::max(top_a, axis.dot(p)), low_a = std::min(low_a, axis.dot(p));
    for (const Vec3& p : b.corners) top_b = std::max(top_b, axis.dot(p)), low_b = std::min(low_b, axis.dot(p));
    best = std::max({best, low_b - top_a, low_a - top_b});
  };
  for (const Vec3& n : a.normals) along(n);
  for (const Vec3& n : b.normals) along(n);
  const auto edge = [](const PlacedSolid& of, const SolidEdge& e) {
    return Vec3(of.corners[static_cast<std::size_t>(e.to)] - of.corners[static_cast<std::size_t>(e.from)]);
  };
  for (const SolidEdge& of_a : a.solid->edges)
    for (const SolidEdge& of_b : b.solid->edges)
      if (const Vec3 p = edge(a, of_a), q = edge(b, of_b), n = cross(p, q); n.norm() > 1e-5 * p.norm() * q.norm())
        along(n.normalized());
  return best;
}

}  // namespace

TEST_CASE("boxes above each other are apart by their gap, or within each other by their overlap") {
  const ConvexSolid box = brick_of(1, 2, 3);
  const PlacedSolid a = solid_at(box, {}, Vec3(0, 0, 0));
  for (const double gap : {0.25, -0.25, 0.0}) {
    const Separation3 s = separation(a, solid_at(box, {}, Vec3(0.1, 0.2, 3 + gap)));
    CHECK(s.distance == gap);
    CHECK(s.axis == Vec3(0, 0, 1));
    CHECK(s.feature == SeparatingFeature::face_of_a);
    CHECK(box.normals[static_cast<std::size_t>(s.a)] == Vec3(0, 0, 1));
    CHECK(box.shape.corners[static_cast<std::size_t>(s.b)].z() == -1.5);
  }
}

TEST_CASE("a corner over a face and a face over a corner name each other") {
  const ConvexSolid floor = brick_of(4, 4, 1), cube = brick_of(1, 1, 1);
  const UnitQuaternion on_corner =
      rotation_by(Vec3(std::atan(std::numbers::sqrt2), 0, 0)) * rotation_by(Vec3(0, 0, std::numbers::pi / 4));
  const double reach = std::sqrt(3.0) / 2;
  const PlacedSolid a = solid_at(floor, {}, Vec3(0, 0, 0)),
                    b = solid_at(cube, on_corner, Vec3(0.3, 0.2, 0.5 + reach - 0.01));
  const Separation3 s = separation(a, b), back = separation(b, a);
  CHECK(near(s.distance, -0.01, 1e-12));
  CHECK(s.feature == SeparatingFeature::face_of_a);
  CHECK(near(b.corners[static_cast<std::size_t>(s.b)].z(), 0.49, 1e-13));
  CHECK(back.feature == SeparatingFeature::face_of_b);
  CHECK(back.a == s.b);
  CHECK(back.b == s.a);
  CHECK(back.axis == -s.axis);
}

TEST_CASE("two bars that cross edge on edge name their edges") {
  const ConvexSolid bar = brick_of(1, 0.1, 0.1);
  const double reach = 0.05 * std::numbers::sqrt2;
  const UnitQuaternion on_edge = rotation_by(Vec3(std::numbers::pi / 4, 0, 0));
  const UnitQuaternion across = rotation_by(Vec3(0, 0, std::numbers::pi / 2)) * on_edge;
  const PlacedSolid a = solid_at(bar, on_edge, Vec3(0, 0, 0));
  for (const double gap : {0.003, -0.003}) {
    const PlacedSolid b = solid_at(bar, across, Vec3(0.3, 0.2, 2 * reach + gap));
    const Separation3 s = separation(a, b);
    CHECK(s.feature == SeparatingFeature::edges);
    CHECK(near(s.distance, gap, 1e-12));
    CHECK(near(s.axis.z(), 1, 1e-14));
    const auto end = [](const PlacedSolid& solid, int edge) {
      return solid.corners[static_cast<std::size_t>(solid.solid->edges[static_cast<std::size_t>(edge)].from)];
    };
    CHECK(near(end(a, s.a).z(), reach, 1e-13));
    CHECK(near(end(b, s.b).z(), reach + gap, 1e-13));
  }
}

TEST_CASE("pairs of edges that cannot touch are left out without changing the best axis") {
  std::mt19937_64 bits(3);
  int edges = 0, apart = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const ConvexSolid of_a = any_solid(bits), of_b = any_solid(bits);
    const PlacedSolid a = solid_at(of_a, random_rotation(bits), Vec3(0, 0, 0));
    const PlacedSolid b = solid_at(of_b, random_rotation(bits), 1.5 * random_in_ball(bits));
    const Separation3 s = separation(a, b);
    const double of_all = largest_distance(a, b);
    // for separated solids, edges that cannot touch may give a larger distance
    CHECK(s.distance <= of_all + 1e-13);
    CHECK((s.distance > 0) == (of_all > 0));
    if (of_all < 0) CHECK(near_zero(s.distance - of_all, 1e-13));
    CHECK(near(s.axis.norm(), 1, 1e-14));
    CHECK(near_zero(separation(b, a).distance - s.distance, 1e-13));
    edges += s.feature == SeparatingFeature::edges;
    apart += s.distance > 0;
  }
  CHECK(edges > 500);
  CHECK(apart > 500);
  CHECK(apart < 2500);
}

TEST_CASE("solids share a volume where no axis separates them, and the least translation separates them") {
  std::mt19937_64 bits(4);
  SolidOverlapBuffer buffer;
  int within = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const ConvexSolid of_a = any_solid(bits), of_b = any_solid(bits);
    const UnitQuaternion turn = random_rotation(bits);
    const Vec3 at = 1.2 * random_in_ball(bits);
    const PlacedSolid a = solid_at(of_a, {}, Vec3(0, 0, 0)), b = solid_at(of_b, turn, at);
    const Separation3 s = separation(a, b);
    CHECK((solid_overlap(a, b, buffer).volume > 0) == (s.distance < 0));
    if (s.distance >= 0) continue;
    ++within;
    CHECK(near_zero(separation(a, solid_at(of_b, turn, at - s.distance * s.axis)).distance, 1e-13));
    CHECK(solid_overlap(a, solid_at(of_b, turn, at - (s.distance - 1e-9) * s.axis), buffer).volume == 0);
    CHECK(solid_overlap(a, solid_at(of_b, turn, at - 0.99 * s.distance * s.axis), buffer).volume > 0);
  }
  CHECK(within > 500);
}

TEST_CASE("a warm start from the last axis gives the same result, or a lower bound if that axis still separates") {
  std::mt19937_64 bits(5);
  int kept = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const ConvexSolid of_a = any_solid(bits), of_b = any_solid(bits);
    const UnitQuaternion turn = random_rotation(bits);
    const Vec3 at = 1.5 * random_in_ball(bits), way = 0.1 * random_in_ball(bits);
    const PlacedSolid a = solid_at(of_a, {}, Vec3(0, 0, 0)), b = solid_at(of_b, turn, at);
    const Separation3 first = separation(a, b);
    CHECK(near_zero(separation_from(first, a, b).distance - first.distance, 1e-14));
    const PlacedSolid later = solid_at(of_b, rotation_by(0.2 * random_in_ball(bits)) * turn, at + way);
    const Separation3 next = separation_from(first, a, later), best = separation(a, later);
    if (next.distance > 0 && next.feature == first.feature && next.a == first.a) ++kept;
    CHECK(next.distance <= best.distance + 1e-14);
    if (next.distance <= 0) CHECK(next.distance == best.distance);
    CHECK((next.distance > 0) == (best.distance > 0));
  }
  CHECK(kept > 100);
}

TEST_CASE("the search stops at the first axis with a sufficient distance") {
  const ConvexSolid box = brick_of(1, 1, 1);
  const PlacedSolid a = solid_at(box, {}, Vec3(0, 0, 0)), b = solid_at(box, {}, Vec3(2, 3, 4));
  CHECK(separation(a, b).distance == 3);
  CHECK(separation(a, b, 0).distance > 0);
  CHECK(separation(a, b, 2.5).distance == 3);
}

TEST_CASE("the two stages of the separating axis test give its bits, and faces alone a lower bound") {
  std::mt19937_64 bits(83);
  const auto turned = [&] {
    return rotation_by(Vec3(random_between(bits, -3, 3), random_between(bits, -3, 3), random_between(bits, -3, 3)));
  };
  int by_edges = 0;
  for (int trial = 0; trial < 400; ++trial) {
    // Boxes have few enough features for tables, the other solids often not.
    const ConvexSolid one = trial % 2 == 0 ? brick_of(1, 0.7, 0.4) : any_solid(bits), other = any_solid(bits);
    const PlacedSolid a = solid_at(one, turned(), Vec3(0, 0, 0)),
                      b = solid_at(other, turned(), Vec3(random_between(bits, -2, 2), random_between(bits, -2, 2), 1));
    const Separation3 whole = separation(a, b), faces = face_separation(a, b), both = separation_beyond(a, b, faces);
    CAPTURE(trial);
    CHECK(both.distance == whole.distance);
    CHECK(both.axis == whole.axis);
    CHECK(both.a == whole.a);
    CHECK(both.b == whole.b);
    CHECK(faces.distance <= whole.distance);
    if (whole.feature == SeparatingFeature::edges) ++by_edges;
  }
  CHECK(by_edges > 40);
}

TEST_CASE("distances in lanes have the bits of products one by one") {
  std::mt19937_64 bits(84);
  int faces = 0, edges = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const ConvexSolid of_a = brick_of(1, 0.7, 0.4), of_b = trial % 2 == 0 ? of_a : any_solid(bits);
    const PlacedSolid a = solid_at(of_a, random_rotation(bits), Vec3(0.1, 0.2, 0.3)),
                      b = solid_at(of_b, random_rotation(bits), Vec3(1.5 * random_in_ball(bits)));
    const Separation3 s = separation(a, b);
    if (s.feature == SeparatingFeature::face_of_a) {
      double lowest = 1e9;
      for (const Vec3& x : b.corners) lowest = std::min(lowest, s.axis.dot(x));
      const Vec3& on_face = a.corners[static_cast<std::size_t>(of_a.shape.faces[s.a][0])];
      CHECK(s.distance == lowest - s.axis.dot(on_face));
      CHECK(s.axis.dot(b.corners[static_cast<std::size_t>(s.b)]) == lowest);
      ++faces;
    }
    if (s.feature == SeparatingFeature::edges) {
      const Vec3& from_a = a.corners[static_cast<std::size_t>(of_a.edges[static_cast<std::size_t>(s.a)].from)];
      const Vec3& from_b = b.corners[static_cast<std::size_t>(of_b.edges[static_cast<std::size_t>(s.b)].from)];
      CHECK(s.distance == s.axis.dot(from_b - from_a));
      ++edges;
    }
  }
  CHECK(faces > 50);
  CHECK(edges > 50);
}
