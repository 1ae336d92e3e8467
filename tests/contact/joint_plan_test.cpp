// Discretisation of a joint: its patches have the area and the moments of the common area of two faces, for any shape.
#include "contact/joint/joint_plan.hpp"

#include <doctest/doctest.h>

#include "contact/joint/joint_motion.hpp"
#include "contact/space/solid_faces.hpp"
#include "geometry/space/random_convex_3d.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

/// Two bricks across each other, at random positions and rotations, in a randomly rotated world.
struct AcrossEachOther {
  BodyMotion a, b;
  PlacedSolid below, above;
  FaceOverlap3 faces;
  bool meet = false;

  AcrossEachOther(const ConvexSolid& one, const ConvexSolid& other, std::mt19937_64& bits) {
    const UnitQuaternion world = random_rotation(bits);
    const Turn3 turn(world);
    const Vec3 aside = 0.4 * random_in_ball(bits), spun = 3 * random_in_ball(bits);
    a = {turn.apply(Vec3(0.1, 0.2, -0.1)), world, random_in_ball(bits), random_in_ball(bits)};
    b = {turn.apply(Vec3(0.1 + aside.x(), 0.2 + aside.y(), 0.1)), world * rotation_by(Vec3(0, 0, spun.z())),
         random_in_ball(bits), random_in_ball(bits)};
    place(one, Turn3(a.rotation), a.place, below), place(other, Turn3(b.rotation), b.place, above);
    meet = meeting_faces(below, above, 1e-6, 1e-3, faces);
  }
};

ConvexSolid slab(double x, double y) {
  return convex_solid(box_solid(Vec3(-x, -y, -0.2) / 2, Vec3(x, y, 0.2) / 2), "slab");
}

}  // namespace

TEST_CASE("patches and their places have the area and the moments of the polygon that they cut") {
  std::mt19937_64 bits(41);
  const ConvexSolid one = slab(1, 0.6), other = slab(0.7, 0.5);
  int cut = 0;
  for (int i = 0; i < 200; ++i) {
    const AcrossEachOther pair(one, other, bits);
    if (!pair.meet) continue;
    ++cut;
    const JointPlan plan = plan_joint(pair.faces, pair.a, pair.b);
    const FaceIntegrals whole = integrals_over_all(plan.outline, 0, Vec2::Zero());
    REQUIRE(plan.patch.size() <= most_patches);
    double area = 0, xx = 0, xy = 0, yy = 0, at_places = 0;
    Vec2 first = Vec2::Zero();
    for (const JointPatch& p : plan.patch) {
      area += p.area, first += p.area * p.middle;
      xx += p.xx + p.area * p.middle.x() * p.middle.x(), yy += p.yy + p.area * p.middle.y() * p.middle.y();
      for (std::size_t q = 0; q < patch_points; ++q) {
        xy += 0.25 * p.area * p.point_x[q] * p.point_y[q];
        at_places += 0.25 * p.area * (p.point_x[q] * p.point_x[q] + p.point_y[q] * p.point_y[q]);
      }
    }
    CHECK(near(area, whole.area, 1e-8));
    CHECK(near(area, integrals_over_all(pair.faces).area, 1e-8));
    CHECK(near_zero(first.norm(), 1e-8 * area));
    CHECK(near(xx, whole.xx, 1e-8));
    CHECK(near(yy, whole.yy, 1e-8));
    CHECK(near_zero(xy, 1e-7 * (xx + yy)));  // principal axes
    CHECK(near(at_places, xx + yy, 1e-8));
  }
  CHECK(cut > 150);
}

TEST_CASE("both frames of a joint coincide at its start, and its overlap grows at the stated rate") {
  std::mt19937_64 bits(42);
  const ConvexSolid one = slab(1, 0.6), other = slab(0.7, 0.5);
  for (int i = 0; i < 50; ++i) {
    AcrossEachOther pair(one, other, bits);
    if (!pair.meet) continue;
    const JointPlan plan = plan_joint(pair.faces, pair.a, pair.b);
    const JointMotion then(plan, pair.a, pair.b);
    CHECK(near_zero(then.moved.at, 1e-14));
    CHECK(near_zero(then.moved.slope.norm(), 1e-14));
    CHECK((then.normal - pair.faces.plane.normal).norm() < 1e-14);
    const double h = 1e-6;
    const auto moved = [&](const BodyMotion& m, double t) {
      return BodyMotion{m.place + t * m.velocity, rotation_by(t * m.spin) * m.rotation, m.velocity, m.spin};
    };
    const JointMotion ahead(plan, moved(pair.a, h), moved(pair.b, h)),
        behind(plan, moved(pair.a, -h), moved(pair.b, -h));
    CHECK(near_zero((ahead.moved.at - behind.moved.at) / (2 * h) - then.rate.at, 1e-8));
    CHECK(near_zero(((ahead.moved.slope - behind.moved.slope) / (2 * h) - then.rate.slope).norm(), 1e-8));
    CHECK(near_zero(((ahead.aside - behind.aside) / (2 * h) - then.slip).norm(), 1e-8));
    CHECK(near_zero((ahead.turn.z() - behind.turn.z()) / (2 * h) - then.spin, 1e-8));
  }
}

TEST_CASE("mortar that fills a gap in part changes no force and no moment") {
  JointPlan plan;
  plan.outline = {Vec2(-0.5, -0.3), Vec2(0.5, -0.3), Vec2(0.4, 0.3), Vec2(-0.5, 0.3)};
  plan.standing = {1e-6, Vec2(5e-6, -3e-6)};
  divide_joint(plan);
  CHECK(plan.filled);
  const FaceIntegrals pressed = integrals_in_contact(plan.outline, plan.standing.at, plan.standing.slope);
  double force = 0;
  Vec2 moment = Vec2::Zero();
  for (const JointPatch& p : plan.patch) {
    const FaceIntegrals laid = integrals_over_all(plan.corners(p), p.laid.at, p.laid.slope);
    force += laid.first, moment += laid.first_moment;
  }
  CHECK(near(force, pressed.first, 1e-12));
  CHECK((moment - pressed.first_moment).norm() < 1e-12 * pressed.first);
}
