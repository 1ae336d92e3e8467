#include "geometry/space/polyhedron.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include "base/error.hpp"
#include "base/rotation_3d.hpp"
#include "geometry/plane/random_convex.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

UnitQuaternion any_rotation(std::mt19937_64& bits) {
  return rotation_by(Vec3(random_between(bits, -3, 3), random_between(bits, -3, 3), random_between(bits, -3, 3)));
}

Eigen::Matrix3d matrix_of(const UnitQuaternion& q) {
  const Turn3 turn(q);
  Eigen::Matrix3d m;
  m << turn.x(), turn.y(), turn.z();
  return m;
}

/// An L of 3 m2 in plan, 2 m high.
Polyhedron angle_block() {
  return prism(std::array{Vec2(0, 0), Vec2(2, 0), Vec2(2, 1), Vec2(1, 1), Vec2(1, 2), Vec2(0, 2)}, 0, 2);
}

Polyhedron corner_tetrahedron(double a, double b, double c) {
  Polyhedron solid{{Vec3::Zero(), Vec3(a, 0, 0), Vec3(0, b, 0), Vec3(0, 0, c)}, {}};
  for (const auto& loop : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{0, 3, 2}, std::array{1, 2, 3}})
    solid.faces.add(loop);
  return solid;
}

/// Message of the check for a box after `spoil`; empty if the box is accepted.
std::string complaint(const std::function<void(Polyhedron&)>& spoil, double flat = kFlatFace) {
  Polyhedron solid = box_solid(Vec3(0, 0, 0), Vec3(3, 2, 1));
  spoil(solid);
  try {
    check_convex(solid, "body 'x'", flat);
  } catch (const InputError& e) {
    return e.what();
  }
  return {};
}

bool solid_says(const std::string& message, const std::string& words) {
  const bool found = message.find(words) != std::string::npos && message.starts_with("body 'x': ");
  if (!found) MESSAGE(message);
  return found;
}

}  // namespace

TEST_CASE("the moments of a box match their formula") {
  const SolidMoments m = solid_moments(box_solid(Vec3(1, 2, 3), Vec3(4, 4, 4)));
  CHECK(near(m.volume, 6, 1e-15));
  CHECK(m.centroid.isApprox(Vec3(2.5, 3, 3.5), 1e-15));
  CHECK(near(m.inertia(0, 0), 6 * (4 + 1) / 12.0, 1e-14));
  CHECK(near(m.inertia(1, 1), 6 * (9 + 1) / 12.0, 1e-14));
  CHECK(near(m.inertia(2, 2), 6 * (9 + 4) / 12.0, 1e-14));
  CHECK(near_zero((m.inertia - Eigen::Matrix3d(m.inertia.diagonal().asDiagonal())).cwiseAbs().maxCoeff(), 1e-14));
}

TEST_CASE("the moments of a tetrahedron match their formula") {
  const double a = 1.3, b = 0.7, c = 2.1, volume = a * b * c / 6;
  const SolidMoments m = solid_moments(corner_tetrahedron(a, b, c));
  CHECK(near(m.volume, volume, 1e-14));
  CHECK(m.centroid.isApprox(Vec3(a, b, c) / 4, 1e-14));
  // integral of (x - a/4)^2 is 3 V a^2 / 80, and of (x - a/4)(y - b/4) is -V a b / 80
  CHECK(near(m.inertia(0, 0), 3 * volume * (b * b + c * c) / 80, 1e-13));
  CHECK(near(m.inertia(0, 1), volume * a * b / 80, 1e-13));
  CHECK(near(m.inertia(1, 2), volume * b * c / 80, 1e-13));
}

TEST_CASE("the moments of a non-convex solid are the sum of its parts") {
  const SolidMoments m = solid_moments(angle_block());
  CHECK(near(m.volume, 6, 1e-15));
  CHECK(m.centroid.isApprox(Vec3(5.0 / 6, 5.0 / 6, 1), 1e-15));
  // three cubes in plan, each 2 m high: integral of (x - 5/6)^2 over the plan is 3/12 + 2/9 + 2/9 + 4/9 - ... = 11/12
  const double across = 2 * 11.0 / 12, up = 6 * 4 / 12.0;
  CHECK(near(m.inertia(2, 2), 2 * across, 1e-14));
  CHECK(near(m.inertia(0, 0), across + up, 1e-14));
}

TEST_CASE("moments rotate and move with the solid") {
  std::mt19937_64 bits(3);
  const Polyhedron solid = angle_block();
  const SolidMoments m = solid_moments(solid);
  for (int trial = 0; trial < 200; ++trial) {
    const UnitQuaternion q = any_rotation(bits);
    const Vec3 shift(random_between(bits, -50, 50), random_between(bits, -50, 50), random_between(bits, -50, 50));
    const SolidMoments moved = solid_moments(placed(solid, q, shift));
    const Eigen::Matrix3d r = matrix_of(q);
    CHECK(near(moved.volume, m.volume, 1e-13));
    CHECK(near_zero((moved.centroid - r * m.centroid - shift).norm(), 1e-13));
    CHECK(near_zero((moved.inertia - r * m.inertia * r.transpose()).norm(), 1e-12));
  }
}

TEST_CASE("a prism over a polygon of n sides approaches a cylinder with 1/n^2") {
  double off[2];
  for (const int round : {0, 1}) {
    const int n = 32 << round;
    std::vector<Vec2> circle;
    for (int i = 0; i < n; ++i) circle.emplace_back(Turn(2 * std::numbers::pi * i / n).apply(Vec2(1, 0)));
    const SolidMoments m = solid_moments(prism(circle, 0, 1));
    off[round] = std::numbers::pi - m.volume;
    CHECK(near(m.inertia(2, 2), std::numbers::pi / 2, 30.0 / (n * n)));
  }
  CHECK(near(off[0] / off[1], 4, 0.01));
}

TEST_CASE("principal axes diagonalise the tensor, are right-handed and rotate least") {
  std::mt19937_64 bits(5);
  for (int trial = 0; trial < 500; ++trial) {
    const Eigen::Matrix3d r = matrix_of(any_rotation(bits));
    const Vec3 moments(random_between(bits, 1, 2), random_between(bits, 1, 2), random_between(bits, 1, 2));
    const Eigen::Matrix3d tensor = r * moments.asDiagonal() * r.transpose();
    const PrincipalInertia p = principal_inertia(tensor);
    const Eigen::Matrix3d axes = matrix_of(p.axes);
    // six off-diagonal terms of up to 1e-14 of 2 may remain
    CHECK(near_zero((axes * p.moments.asDiagonal() * axes.transpose() - tensor).norm(), 5e-14));
    CHECK(near(axes.determinant(), 1, 1e-13));
    // no exchange of axes, or reversal of two, gives a smaller rotation: at most 62.8 degrees
    CHECK(angle_of(p.axes).norm() < 1.0962);
  }
}

TEST_CASE("principal axes of a box along the axes and of a cube are the axes") {
  const PrincipalInertia box = principal_inertia(solid_moments(box_solid(Vec3(0.1, 7, 3), Vec3(0.4, 7.7, 9))).inertia);
  CHECK(box.axes.w == 1);
  CHECK(box.moments.x() > box.moments.y());
  CHECK(box.moments.y() > box.moments.z());
  const PrincipalInertia cube =
      principal_inertia(solid_moments(box_solid(Vec3(0.1, 0.2, 0.3), Vec3(0.8, 0.9, 1.0))).inertia);
  CHECK(cube.axes.w == 1);
  CHECK(near(cube.moments.x(), cube.moments.z(), 1e-13));
}

TEST_CASE("the pose of a slightly rotated box is recovered") {
  const Vec3 angle(0.2, -0.3, 0.1);
  const Polyhedron box = placed(box_solid(Vec3(0, 0, 0), Vec3(1, 2, 4)), rotation_by(angle), Vec3(3, 2, 1));
  CHECK(near_zero((angle_of(principal_inertia(solid_moments(box).inertia).axes) - angle).norm(), 1e-13));
}

TEST_CASE("an extrusion bounds a solid for either order of its polygon and either direction") {
  std::vector<Vec3> polygon{Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(0, 1, 2), Vec3(0, 0.5, 3), Vec3(0, 0, 2)};
  for (const bool backwards : {false, true})
    for (const Vec3& along : {Vec3(2, 0.3, 0.1), Vec3(-2, 0.3, 0.1)}) {
      if (backwards) std::reverse(polygon.begin(), polygon.end());
      const Polyhedron solid = extrusion(polygon, along);
      CHECK_NOTHROW(check_convex(solid, "body"));
      CHECK(near(solid_moments(solid).volume, 5, 1e-14));
    }
}

TEST_CASE("every edge of a solid is found once, with the faces on both sides") {
  const Polyhedron box = box_solid(Vec3(0, 0, 0), Vec3(3, 2, 1));
  const auto edges = solid_edges(box.faces);
  CHECK(edges.size() == 12);
  const auto normals = face_normals(box);
  for (const SolidEdge& e : edges) {
    const Vec3 along = box.corners[static_cast<std::size_t>(e.to)] - box.corners[static_cast<std::size_t>(e.from)];
    const Vec3 across = cross(normals[static_cast<std::size_t>(e.left)], normals[static_cast<std::size_t>(e.right)]);
    CHECK(near(along.normalized().dot(across), 1, 1e-14));
  }
  CHECK(solid_edges(angle_block().faces).size() == 18);
}

TEST_CASE("the check of a solid reports error, place and amount") {
  CHECK(complaint([](Polyhedron&) {}).empty());
  const auto loops = [](Polyhedron& s, int left_out, int turned) {
    FaceLoops faces;
    for (int f = 0; f < s.faces.count(); ++f) {
      std::vector<int> loop(s.faces[f].begin(), s.faces[f].end());
      if (f == turned || turned == 99) std::reverse(loop.begin(), loop.end());
      if (f != left_out) faces.add(loop);
    }
    s.faces = faces;
  };
  CHECK(solid_says(complaint([&](Polyhedron& s) { loops(s, 2, -1); }), "the surface is open: the edge from corner"));
  CHECK(solid_says(complaint([&](Polyhedron& s) { loops(s, -1, 3); }), "one of them is reversed"));
  CHECK(solid_says(complaint([&](Polyhedron& s) { loops(s, -1, 99); }), "volume is -6 m3, so it is inside out"));
  CHECK(solid_says(complaint([](Polyhedron& s) { s.corners[6].z() += 0.01; }), "is not plane: corner"));
  CHECK(solid_says(complaint([](Polyhedron& s) { s.corners[6].z() = std::nan(""); }), "corner 7 is (3, 2, nan) m"));
  CHECK(solid_says(complaint([](Polyhedron& s) { s.corners.emplace_back(1, 1, 1); }), "corner 9 belongs to no face"));
  CHECK(solid_says(complaint([](Polyhedron& s) { s.faces.corner[5] = 20; }),
                   "face 2 names corner 21, but there are corners"));
  CHECK(solid_says(complaint([](Polyhedron& s) { s.faces.corner[1] = s.faces.corner[0]; }), "twice"));
  CHECK(solid_says(complaint([](Polyhedron& s) {
                     for (Vec3& p : s.corners) p.z() = 0;
                   }),
                   "too small for"));
  CHECK(solid_says(complaint([](Polyhedron& s) { s = angle_block(); }), "is not convex: corner"));
  CHECK(solid_says(complaint([](Polyhedron& s) { s = angle_block(); }), "lies 1 m outside of face"));
  CHECK_NOTHROW(check_polyhedron(angle_block(), "body"));
}

TEST_CASE("a face counts as plane within its tolerance on both sides of it") {
  // one corner of four lifted by d is at d/4 from their mean plane
  const auto lift = [](Polyhedron& s) { s.corners[6].z() += 4e-6; };
  const double size = std::sqrt(14.0);
  CHECK(complaint(lift, 1.01e-6 / size).empty());
  CHECK(solid_says(complaint(lift, 0.99e-6 / size), "is not plane"));
}
