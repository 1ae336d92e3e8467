#include "base/rotation_3d.hpp"

#include <Eigen/Geometry>

#include <array>

#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

const std::array<Vec3, 6> some_angles{Vec3(0, 0, 0),   Vec3(1e-9, 0, 0),     Vec3(0.3, -1.2, 2.1),
                                      Vec3(0, 3.1, 0), Vec3(-2, 0.5, -0.25), Vec3(0, 0, -M_PI)};

double length_of(const UnitQuaternion& q) {
  return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}

Eigen::Matrix3d matrix_of(const UnitQuaternion& q) {
  const Turn3 turn(q);
  Eigen::Matrix3d m;
  m << turn.x(), turn.y(), turn.z();
  return m;
}

}  // namespace

TEST_CASE("a rotation vector gives the rotation about its axis by its length") {
  for (const Vec3& angle : some_angles) {
    const UnitQuaternion q = rotation_by(angle);
    CHECK(near(length_of(q), 1, 1e-15));
    Eigen::Matrix3d expected = Eigen::Matrix3d::Identity();
    if (angle.norm() > 0) expected = Eigen::AngleAxisd(angle.norm(), angle.normalized()).toRotationMatrix();
    CHECK((matrix_of(q) - expected).norm() < 4e-15);
  }
}

TEST_CASE("the rotation vector of a rotation up to half a turn is recovered") {
  for (const Vec3& angle : some_angles) CHECK((angle_of(rotation_by(angle)) - angle).norm() < 1e-14);
  CHECK((angle_of(rotation_by({0, 0, 4})) - Vec3(0, 0, 4 - 2 * M_PI)).norm() < 1e-14);
}

TEST_CASE("a product of rotations rotates by the second and then by the first") {
  const UnitQuaternion a = rotation_by(some_angles[2]), b = rotation_by(some_angles[4]);
  const Vec3 v(1, -2, 0.5);
  CHECK((Turn3(a * b).apply(v) - Turn3(a).apply(Turn3(b).apply(v))).norm() < 1e-15 * 10);
  CHECK((Turn3(a).undo(Turn3(a).apply(v)) - v).norm() < 1e-15 * 10);
  CHECK((Turn3(inverse(a)).apply(v) - Turn3(a).undo(v)).norm() < 1e-15 * 10);
}

TEST_CASE("a rotation is recovered from its axes") {
  for (const Vec3& angle : some_angles) {
    const Eigen::Matrix3d axes = matrix_of(rotation_by(angle));
    CHECK((matrix_of(rotation_of(axes)) - axes).norm() < 4e-15);
  }
}

TEST_CASE("the unit length of a quaternion is restored after rounding") {
  const UnitQuaternion q = rotation_by(some_angles[2]);
  for (const double by : {1 + 1e-8, 1 - 1e-8}) {
    const UnitQuaternion off{by * q.w, by * q.x, by * q.y, by * q.z};
    CHECK(near(length_of(renormalised(off)), 1, 1e-15));
  }
}

TEST_CASE("rotation about the z axis in space equals rotation in the plane") {
  const Vec2 flat = Turn(0.7).apply({1.5, -0.25});
  CHECK((turn_by(Vec3(0, 0, 0.7)).apply({1.5, -0.25, 3}) - Vec3(flat.x(), flat.y(), 3)).norm() < 1e-15 * 4);
}
