// Pressure of water on faces and in joints, against closed forms, with targets that hold positions alone.
#include "load/water/water.hpp"

#include <doctest/doctest.h>
#include <Eigen/LU>

#include <algorithm>

#include "base/rotation_3d.hpp"
#include "load/water/uplift.hpp"
#include "model/water/added_mass.hpp"
#include "near.hpp"

namespace trilith::testing {
namespace {

constexpr double gravity = 9.80665, weight = 1000 * gravity;

/// Skin points of the plane at given positions.
struct PlanePoints {
  std::vector<Vec2> at;
  ClosedJoints<2> joints;
  Vec2 force = Vec2::Zero();
  double moment = 0;  ///< about the origin

  [[nodiscard]] double time() const { return 0; }
  [[nodiscard]] double gravity() const { return trilith::testing::gravity; }
  [[nodiscard]] const ClosedJoints<2>& closed() const { return joints; }
  [[nodiscard]] Vec2 skin(int i) const { return at[static_cast<std::size_t>(i)]; }
  [[nodiscard]] Vec2 place_of(const Attachment<2>& point) const { return point.arm[0]; }
  void push_skin(int i, const Vec2& f) { force += f, moment += cross(skin(i), f); }
};

/// One rigid body in space.
struct SolidBody {
  Vec3 place = Vec3::Zero();
  UnitQuaternion rotation;
  ClosedJoints<3> joints;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< about the origin

  [[nodiscard]] double time() const { return 0; }
  [[nodiscard]] double gravity() const { return trilith::testing::gravity; }
  [[nodiscard]] const ClosedJoints<3>& closed() const { return joints; }
  [[nodiscard]] Vec3 place_of(const Attachment<3>& /*at*/) const { return place; }
  [[nodiscard]] Turn3 turn_of(const Attachment<3>& /*at*/) const { return Turn3(rotation); }
  void push(const Attachment<3>& /*at*/, const Vec3& f, const Vec3& m) { force += f, moment += m + cross(place, f); }
};

template <int D>
Water<D> water_at(double level) {
  Water<D> water;
  water.curve = {{0}, {level}};
  return water;
}

/// A face of a box about the origin: its outward axis, and the corners counter-clockwise from outside.
WetFace<3> box_face(int axis, double sign, const Vec3& half) {
  WetFace<3> face;
  face.body = 0, face.normal = sign * Vec3::Unit(axis);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    Vec3 x = sign * half[axis] * Vec3::Unit(axis);
    x[u] = sign * a * half[u], x[v] = b * half[v];
    face.corners.push_back(x);
  }
  return face;
}

}  // namespace

TEST_CASE("the forces at the ends of a face have the sum and the moment of a pressure that is clipped at 0") {
  const EndShares whole = pressed_ends(0, 3, 1, 3);
  CHECK(near(whole.a, 1.5, 1e-15));
  CHECK(near(whole.b, 1.5, 1e-15));
  // p = 6 s - 2 from s = 1/3: a triangle of height 4 with its centre at 1/3 + 2/3 of the rest.
  const EndShares part = pressed_ends(0, -2, 1, 4);
  CHECK(near(part.a + part.b, 0.5 * 4 * 2 / 3, 1e-15));
  CHECK(near(part.b / (part.a + part.b), 1.0 / 3 + 4.0 / 9, 1e-15));
  CHECK(pressed_ends(0, -2, 1, -1).a == 0);
}

TEST_CASE("buoyancy of a turned square is the weight of the displaced water through its centroid") {
  for (const double angle : {0.0, 0.3, 0.785, 2.0}) {
    CAPTURE(angle);
    PlanePoints points;
    const Turn turn(angle);
    for (const Vec2& x : {Vec2(-0.5, -0.5), Vec2(0.5, -0.5), Vec2(0.5, 0.5), Vec2(-0.5, 0.5)})
      points.at.push_back(Vec2(3, 0) + turn.apply(x));
    Water<2> deep = water_at<2>(2), half = water_at<2>(0);
    for (int i = 0; i < 4; ++i)
      deep.faces.push_back({0, i, (i + 1) % 4, 0, 1, 1}), half.faces.push_back({0, i, (i + 1) % 4, 0, 1, 1});
    for (int i = 0; i < 4; ++i) deep.apply(points, i);
    CHECK(near(points.force.y(), weight, 1e-12));
    CHECK(near_zero(points.force.x(), 1e-9));
    CHECK(near(points.moment, 3 * weight, 1e-12));
    // With the surface through the centre half of the square is under water, at any angle.
    points.force.setZero(), points.moment = 0;
    for (int i = 0; i < 4; ++i) half.apply(points, i);
    CHECK(near(points.force.y(), 0.5 * weight, 1e-12));
    CHECK(near_zero(points.force.x(), 1e-9));
  }
}

TEST_CASE("buoyancy of a turned box in space is the weight of the displaced water through its centroid") {
  const Vec3 half(0.5, 0.4, 0.3);
  for (const Vec3& turn : {Vec3(0, 0, 0), Vec3(0.3, 0.1, -0.4), Vec3(1.2, -0.7, 0.5)}) {
    SolidBody body;
    body.place = Vec3(2, -1, 0), body.rotation = rotation_by(turn);
    Water<3> deep = water_at<3>(3), even = water_at<3>(0);
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0})
        deep.faces.push_back(box_face(axis, sign, half)), even.faces.push_back(box_face(axis, sign, half));
    for (int i = 0; i < 6; ++i) deep.apply(body, i);
    CHECK(near(body.force.z(), 0.48 * weight, 1e-12));
    CHECK(near_zero(Vec2(body.force.x(), body.force.y()).norm(), 1e-9));
    CHECK(near_zero((body.moment - cross(body.place, body.force)).norm(), 1e-9));
    body.force.setZero(), body.moment.setZero();
    for (int i = 0; i < 6; ++i) even.apply(body, i);
    CHECK(near(body.force.z(), 0.24 * weight, 1e-12));
    CHECK(near_zero(Vec2(body.force.x(), body.force.y()).norm(), 1e-9));
  }
}

TEST_CASE("a closed part of a face is dry in a sealed joint and wet in a wet one") {
  PlanePoints points;
  points.at = {{0, 0}, {4, 0}};  // a lower face: its inward normal points up
  points.joints.parts = {{0, 0.25, 0.5}, {0, 0.4, 0.75}};
  Water<2> water = water_at<2>(2);
  water.faces = {{0, 0, 1, 0, 1, 1}};
  water.apply(points, 0);
  CHECK(near(points.force.y(), 2 * weight * 2, 1e-14));
  CHECK(near(points.moment, 2 * weight * (0.5 + 3.5), 1e-14));
  points.force.setZero();
  water.sealed = false;
  water.apply(points, 0);
  CHECK(near(points.force.y(), 2 * weight * 4, 1e-14));
}

TEST_CASE("uplift has the full head in the open part and falls linearly behind its tip") {
  const double h = 11, L = 8, slope = 1e-4;
  const auto in_plane = [&](double crack, double efficiency) {
    PlanePoints points;
    // The upper body rests on a rock whose face runs from right to left.
    points.at = {{0, crack * slope}, {L, (crack - L) * slope}, {L + 2, 0}, {-2, 0}};
    Uplift<2> uplift;
    uplift.curve = {{0}, {h}};
    uplift.heel = Attachment<2>::to_node(0, Vec2(0, 0)), uplift.toe = Attachment<2>::to_node(0, Vec2(L, 0));
    uplift.upper = {{0, 0, 1, 0, 1, 1}}, uplift.lower = {{1, 2, 3, 0, 1, 1}};
    uplift.drain_at = efficiency > 0 ? 2 : 0, uplift.drain_efficiency = efficiency;
    uplift.apply(points, 0);
    return std::tuple(points.force.y(), points.moment, uplift.now(points).tip);
  };
  const double crack = 3;
  const double full = weight * h * crack, rest = weight * h * (L - crack) / 2;
  const double centre = (full * crack / 2 + rest * (crack + (L - crack) / 3)) / (full + rest);
  const auto [force, moment, tip] = in_plane(crack, 0);
  CHECK(near(tip, crack, 1e-3));
  CHECK(near(force, full + rest, 1e-3));
  CHECK(near(moment / force, centre, 1e-3));
  // A drain at 2 m behind a closed heel halves the linear head there.
  const auto [drained, drained_moment, closed] = in_plane(-1, 0.5);
  CHECK(closed == 0);
  const double at_drain = h * 0.75 * 0.5;
  CHECK(near(drained, weight * ((h + at_drain) / 2 * 2 + at_drain / 2 * 6), 1e-3));
  CHECK(drained_moment > 0);
}

namespace {

/// A rigid dam with an upright face of 11 m to 12 m of water, a base of 8 m on a joint of stiffness kn, and a crest of
/// 2 m. It settles by `down` at its heel and turns by `slope`; friction holds it.
struct CrackingDam {
  static constexpr double base = 8, height = 12, kn = 1e11;
  double level;
  PlanePoints points;
  Uplift<2> uplift;

  explicit CrackingDam(double water_level) : level(water_level) {
    points.at = {{0, 0}, {base, 0}, {base, 0}, {0, 0}};
    uplift.curve = {{0}, {level}};
    uplift.heel = Attachment<2>::to_node(0, Vec2(0, 0)), uplift.toe = Attachment<2>::to_node(0, Vec2(base, 0));
    uplift.upper = {{0, 0, 1, 0, 1, 1}}, uplift.lower = {{1, 2, 3, 0, 1, 1}};
  }
  /// Out-of-balance force and moment about the heel.
  Vec2 residual(double down, double slope) {
    points.at[0] = Vec2(0, -down), points.at[1] = Vec2(base, -down - slope * base);
    points.force.setZero(), points.moment = 0;
    uplift.apply(points, 0);
    const double area = 2 * height + (base - 2) * height / 2, own = 2400 * gravity * area;
    const double arm = (2 * height * 1 + (base - 2) * height / 2 * (2 + (base - 2) / 3)) / area;
    // Contact: kn (down + slope x) where it is positive.
    const double from = slope > 0 ? std::clamp(-down / slope, 0.0, base) : 0;
    const auto sums = [&](double x) {
      return Vec2(down * x + slope * x * x / 2, down * x * x / 2 + slope * x * x * x / 3);
    };
    const Vec2 contact = kn * (sums(base) - sums(from));
    const double thrust = weight * level * level / 2 * level / 3;
    return {points.force.y() - own + contact.x(), points.moment - own * arm - thrust + contact.y()};
  }
  /// Newton iterations with a tangent by differences. Returns the length of the crack [m].
  double crack() {
    Vec2 x(1e-6, 1e-7);
    for (int i = 0; i < 60; ++i) {
      const double h = 1e-12;
      const Vec2 r = residual(x.x(), x.y());
      Eigen::Matrix2d a;
      a.col(0) = (residual(x.x() + h, x.y()) - residual(x.x() - h, x.y())) / (2 * h);
      a.col(1) = (residual(x.x(), x.y() + h) - residual(x.x(), x.y() - h)) / (2 * h);
      x -= a.inverse() * r;
    }
    CHECK(residual(x.x(), x.y()).norm() < 1);
    return uplift.now(points).tip;
  }
};

}  // namespace

TEST_CASE("a dam without tension cracks at its heel as the level rises, and the crack grows under its own uplift") {
  CHECK(near_zero(CrackingDam(11).crack(), 1e-3));
  CHECK(near(CrackingDam(11.5).crack(), 0.6546, 1e-3));
  CHECK(near(CrackingDam(11.7).crack(), 1.6033, 1e-3));
  CHECK(near(CrackingDam(12).crack(), 3.2, 1e-3));
}

TEST_CASE("strips of the added mass have the force and the moment of Westergaard's pressures") {
  const double depth = 9;
  for (const auto& [form, mass, moment] : {std::tuple{AddedMassForm::exact, 0.542755, 0.217875},
                                           std::tuple{AddedMassForm::parabola, 0.583333, 0.233333}}) {
    StripMass sum;
    for (int i = 0; i < 10; ++i) {
      const StripMass strip = strip_mass(form, depth, 0.1 * i * depth, 0.1 * (i + 1) * depth);
      CHECK(strip.moment > 0.1 * i * depth * strip.mass);
      CHECK(strip.moment < 0.1 * (i + 1) * depth * strip.mass);
      sum.mass += strip.mass, sum.moment += strip.moment;
    }
    CHECK(near(sum.mass, mass * depth * depth, 2e-6));
    CHECK(near(sum.moment, moment * depth * depth * depth, 3e-6));
    // The pressure at the bed, over a strip so thin that it is constant.
    const double at_bed = strip_mass(form, depth, 0, 1e-3).mass / 1e-3;
    CHECK(near(at_bed, (form == AddedMassForm::exact ? 0.742454 : 0.875) * depth, 1e-4));
  }
}

}  // namespace trilith::testing
