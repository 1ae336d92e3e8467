// Parts of a mortar joint and of a force that is spread over an area: closed forms and sums over a partition.
#include "contact/joint/intact_joint.hpp"
#include "edit/split_contacts_space.hpp"
#include "near.hpp"
#include "readings/spread_force.hpp"

#include <doctest/doctest.h>

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A rectangle with its lower left corner at (x, y), counter-clockwise.
std::vector<Vec2> rectangle(double x, double y, double wide, double high) {
  return {{x, y}, {x + wide, y}, {x + wide, y + high}, {x, y + high}};
}

JointMemory sound_joint(const std::vector<Vec2>& outline, const Vec3& shear) {
  const auto plan = std::make_shared<JointPlan>();
  plan->outline = outline;
  divide_joint(*plan);
  JointMemory joint;
  joint.plan = plan, joint.sound = true, joint.elastic = shear, joint.total = 2 * shear;
  return joint;
}

}  // namespace

TEST_CASE("a couple about the normal of an area shears its half by the couple over its polar moment") {
  const double wide = 0.4, high = 0.3, couple = 70;
  const SpreadForce all(Vec3(1, 2, 3), Vec3::UnitX(), Vec3::UnitY(), rectangle(0, 0, wide, high), Vec3::Zero(),
                        Vec3(0, 0, couple));
  const double polar = wide * high * (wide * wide + high * high) / 12;
  const SpreadPart left = all.behind(all.centre, Vec3::UnitX());
  CHECK(near(left.force.y(), -couple / polar * (wide / 4) * (wide * high / 2), 1e-12));
  CHECK(near_zero(left.force.x(), 1e-10 * couple));
  CHECK(near(left.moment.z(), couple / 2, 1e-12));
  const SpreadPart low = all.behind(all.centre, Vec3::UnitY());
  CHECK(near(low.force.x(), couple / polar * (high / 4) * (wide * high / 2), 1e-12));
  CHECK(near_zero(low.force.y(), 1e-10 * couple));
}

TEST_CASE("the parts of an intact joint carry its shear and its couple, with the same stress at each point") {
  const double wide = 0.5, high = 0.3, cut = -0.08;
  const Vec3 shear(300, -200, 40);
  const JointMemory whole = sound_joint(rectangle(-wide / 2, -high / 2, wide, high), shear);
  const std::vector<std::vector<Vec2>> outlines{rectangle(-wide / 2, -high / 2, cut + wide / 2, high),
                                                rectangle(cut, -high / 2, wide / 2 - cut, high)};
  Vec3 sum = Vec3::Zero();
  for (const std::vector<Vec2>& outline : outlines) {
    const JointMemory part = part_of_joint(whole, outline);
    REQUIRE(part.plan != nullptr);
    const Vec2 middle = 0.5 * (outline[0] + outline[2]);
    for (const Vec2& p : outline) {
      const Vec2 here = intact_shear_at(*part.plan, part.elastic, p - middle);
      CHECK((here - intact_shear_at(*whole.plan, shear, p)).norm() < 1e-10 * 4e3);
      CHECK((intact_shear_at(*part.plan, part.total, p - middle) - 2 * here).norm() < 1e-10 * 4e3);
    }
    sum += Vec3(part.elastic.x(), part.elastic.y(), part.elastic.z() + cross(middle, part.elastic.head<2>()));
  }
  CHECK((sum - shear).norm() < 1e-11 * shear.norm());
}
