#include "geometry/space/facing_faces.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/space/overlap_3d.hpp"
#include "geometry/space/random_convex_3d.hpp"
#include "geometry/space/separation_3d.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

PlacedSolid solid_in(const ConvexSolid& solid, const UnitQuaternion& rotation, const Vec3& at) {
  PlacedSolid out;
  place(solid, Turn3(rotation), at, out);
  return out;
}

/// Integrals over the facing faces of two solids along their best axis.
struct FacingIntegrals {
  FacingFaces faces;
  FaceOverlap3 overlap;
  FaceIntegrals in_contact;
  FacingIntegrals(const PlacedSolid& a, const PlacedSolid& b) : faces(facing_faces(a, b, separation(a, b).axis)) {
    FaceRoom of_a, of_b;
    face_overlap(face_of(a, faces.a, of_a), face_of(b, faces.b, of_b), overlap);
    in_contact = integrals_in_contact(overlap);
  }
};

ConvexSolid stone_of(double x, double y, double z) {
  return convex_solid(box_solid(Vec3(-x / 2, -y / 2, -z / 2), Vec3(x / 2, y / 2, z / 2)), "stone");
}

}  // namespace

TEST_CASE("faces of stones laid on each other oppose each other over their joint, at any rotation of the whole") {
  const ConvexSolid stone = stone_of(0.4, 0.2, 0.2);
  std::mt19937_64 bits(1);
  SolidOverlapBuffer buffer;
  for (int trial = 0; trial < 300; ++trial) {
    const UnitQuaternion q = random_rotation(bits);
    const Turn3 turn(q);
    const double depth = 1e-4;
    const Vec3 shift(random_between(bits, -0.3, 0.3), random_between(bits, -0.15, 0.15), 0.2 - depth);
    const PlacedSolid a = solid_in(stone, q, Vec3(1, 2, 3));
    const PlacedSolid b = solid_in(stone, q, Vec3(1, 2, 3) + turn.apply(shift));
    const FacingIntegrals joint(a, b);
    const double area = (0.4 - std::abs(shift.x())) * (0.2 - std::abs(shift.y()));
    CHECK(near(joint.faces.opposed, 1, 1e-14));
    CHECK(near_zero((a.normals[static_cast<std::size_t>(joint.faces.a)] - turn.z()).norm(), 1e-14));
    CHECK(near(joint.in_contact.area, area, 1e-11));
    // the face overlap equals the overlap volume of the solids
    const SolidOverlap shared = solid_overlap(a, b, buffer);
    CHECK(near(joint.in_contact.first, area * depth, 1e-9));
    CHECK(near(shared.volume, joint.in_contact.first, 1e-9));
    const Vec3 centre = joint.overlap.plane.at(joint.in_contact.first_moment / joint.in_contact.first);
    CHECK(near_zero((shared.centroid - centre).norm(), 1e-9));
  }
}

TEST_CASE("the face overlap of slightly tilted stones approaches the shared volume with the square of the tilt") {
  const ConvexSolid stone = stone_of(0.4, 0.2, 0.2), slab = stone_of(2, 2, 0.2);
  SolidOverlapBuffer buffer;
  const PlacedSolid below = solid_in(slab, {}, Vec3(0, 0, 0));
  double off[2];
  for (const int round : {0, 1}) {
    const double tilt = round == 0 ? 0.02 : 0.01;
    const PlacedSolid above = solid_in(stone, rotation_by(Vec3(0.5 * tilt, tilt, 0.3)), Vec3(0, 0, 0.2));
    const FacingIntegrals joint(below, above);
    CHECK(joint.in_contact.area < 0.9 * 0.08);
    off[round] = joint.in_contact.first / solid_overlap(below, above, buffer).volume - 1;
    CHECK(near_zero(off[round], 2 * tilt * tilt));
  }
  CHECK(std::abs(off[1]) < 0.3 * std::abs(off[0]));
}

TEST_CASE("a face belongs to its solid and has its corners in order") {
  const ConvexSolid stone = stone_of(1, 2, 3);
  const PlacedSolid a = solid_in(stone, rotation_by(Vec3(0.1, 0.2, 0.3)), Vec3(5, 6, 7));
  FaceRoom room;
  for (int f = 0; f < 6; ++f) {
    const PlacedFace face = face_of(a, f, room);
    CHECK(face.corners.size() == 4);
    const Vec3 across = cross(Vec3(face.corners[1] - face.corners[0]), Vec3(face.corners[2] - face.corners[1]));
    CHECK(near(across.normalized().dot(face.normal), 1, 1e-14));
  }
}
