#include "geometry/space/face_overlap_3d.hpp"

#include <Eigen/LU>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "base/portable.hpp"
#include "base/rotation_3d.hpp"
#include "geometry/plane/overlap.hpp"
#include "geometry/plane/random_convex.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

/// A face with its own corners.
struct OwnFace {
  std::vector<Vec3> corners;
  Vec3 normal;
  [[nodiscard]] PlacedFace view() const { return {corners, normal}; }
};

/// The top of a block, at height z over an outline.
OwnFace face_up(const Polygon& outline, double z) {
  OwnFace face{{}, Vec3(0, 0, 1)};
  for (const Vec2& p : outline) face.corners.emplace_back(p.x(), p.y(), z);
  return face;
}

/// The underside of a block.
OwnFace face_down(const Polygon& outline, double z) {
  OwnFace face = face_up(outline, z);
  std::reverse(face.corners.begin(), face.corners.end());
  face.normal = Vec3(0, 0, -1);
  return face;
}

OwnFace face_moved(const OwnFace& face, const UnitQuaternion& rotation, const Vec3& shift) {
  const Turn3 turn(rotation);
  OwnFace out{{}, turn.apply(face.normal)};
  for (const Vec3& p : face.corners) out.corners.push_back(turn.apply(p) + shift);
  return out;
}

FaceOverlap3 faces_of(const OwnFace& a, const OwnFace& b) {
  FaceOverlap3 out;
  face_overlap(a.view(), b.view(), out);
  return out;
}

// Drawn in separate statements, here and below: the order of evaluation of arguments is unspecified.
UnitQuaternion face_rotation(std::mt19937_64& bits, double most) {
  const double z = random_between(bits, -most, most), y = random_between(bits, -most, most);
  return rotation_by(Vec3(random_between(bits, -most, most), y, z));
}

Polygon centred_face(double b, double h) {
  return rectangle(Vec2(-b / 2, -h / 2), Vec2(b / 2, h / 2));
}

/// Square with corners on the axes, `r` from its centre.
Polygon diamond(double r, const Vec2& at) {
  return {at + Vec2(r, 0), at + Vec2(0, r), at + Vec2(-r, 0), at + Vec2(0, -r)};
}

struct LoadedJoint {
  double peak, least, area, slope_x, slope_y;
};

/// A face B x H pressed onto another by 10 kN at e: Newton's method for its penetration and its rotations about x and
/// y.
LoadedJoint pressed_joint(double b, double h, const Vec2& e) {
  constexpr double stiffness = 1e8, load = 1e4;
  const OwnFace lower = face_up(centred_face(b, h), 0), upper = face_down(centred_face(b, h), 0);
  Vec3 u(load / (stiffness * b * h), 0, 0);  // down, slope along x, slope along y
  FaceOverlap3 now;
  for (int round = 0; round < 60; ++round) {
    // a slope s along x is a rotation by s about y, a slope s along y one by -s about x
    now = faces_of(lower, face_moved(upper, rotation_by(Vec3(-u[2], u[1], 0)), Vec3(0, 0, -u[0])));
    const FaceIntegrals k = integrals_in_contact(now);
    const Vec2 middle = now.plane.project(Vec3(0, 0, 0));
    const Vec2 s = k.area_moment - k.area * middle, moment = k.first_moment - k.first * middle;
    const double xx = k.xx - middle.x() * (s.x() + k.area_moment.x());
    const double xy = k.xy - middle.x() * k.area_moment.y() - middle.y() * s.x();
    const double yy = k.yy - middle.y() * (s.y() + k.area_moment.y());
    Eigen::Matrix3d tangent;
    tangent << k.area, s.x(), s.y(), s.x(), xx, xy, s.y(), xy, yy;
    const Vec3 wanted = load / stiffness * Vec3(1, e.x(), e.y());
    const Vec3 rest = wanted - Vec3(k.first, moment.x(), moment.y());
    u += tangent.inverse() * rest;
    if (rest.norm() < 1e-14 * wanted.norm()) break;
  }
  LoadedJoint out{0, 1e9, integrals_in_contact(now).area, now.plane.slope.x(), now.plane.slope.y()};
  for (int i = 0; i < now.shared.count; ++i) {
    const double stress = stiffness * now.plane.overlap_at(now.shared.corner[static_cast<std::size_t>(i)]);
    out.peak = std::max(out.peak, stress), out.least = std::min(out.least, stress);
  }
  return out;
}

}  // namespace

TEST_CASE("a joint loaded within its kern is closed all over, with the stresses of a plane section") {
  const LoadedJoint j = pressed_joint(1, 1, Vec2(0.05, 0.05));
  CHECK(near(j.peak, 16000, 1e-3));
  CHECK(near(j.least, 4000, 1e-3));
  CHECK(near(j.area, 1, 1e-6));
  CHECK(near(j.slope_x, 6e-5, 1e-3));
  CHECK(near(j.slope_y, 6e-5, 1e-3));
}

TEST_CASE("a joint loaded outside of its kern opens over a corner, an edge or all but a triangle") {
  struct Row {
    double b, h;
    Vec2 e;
    double peak, area, slope_x, slope_y;
  };
  for (const Row& row : {Row{1, 1, Vec2(0.1, 0.1), 22045, 0.98532, 1.2055e-4, 1.2055e-4},
                         Row{1, 1, Vec2(0.2, 0.1), 29933, 0.83738, 2.6872e-4, 1.4202e-4},
                         Row{1.2, 0.8, Vec2(0.35, 0.05), 40118, 0.58610, 4.6025e-4, 1.5996e-4},
                         Row{1, 1, Vec2(0.3, 0.3), 93750, 0.32, 1.1719e-3, 1.1719e-3}}) {
    const LoadedJoint j = pressed_joint(row.b, row.h, row.e);
    CHECK(near(j.peak, row.peak, 1e-3));
    CHECK(near(j.area, row.area, 1e-3));
    CHECK(near(j.slope_x, row.slope_x, 1e-3));
    CHECK(near(j.slope_y, row.slope_y, 1e-3));
  }
}

TEST_CASE("two equal squares crossed at 45 degrees share a regular octagon") {
  const FaceOverlap3 o =
      faces_of(face_up(centred_face(1, 1), 0), face_down(diamond(std::sqrt(0.5), Vec2(0, 0)), -0.25));
  CHECK(o.shared.count == 8);
  const FaceIntegrals k = integrals_in_contact(o);
  const double area = 2 * (std::sqrt(2.0) - 1);
  CHECK(near(k.area, area, 1e-14));
  CHECK(near(k.first, area / 4, 1e-14));
  CHECK(near(k.energy, area / 32, 1e-14));
  CHECK(near_zero(o.plane.at(k.area_moment / k.area).norm() - 0.125, 1e-15));
}

TEST_CASE("faces shifted against each other share polygons of three to eight corners") {
  const Polygon square = centred_face(1, 1);
  OverlapBuffer buffer;
  const auto shared = [&](const Polygon& other) {
    const FaceOverlap3 o = faces_of(face_up(square, 0), face_down(other, -1e-3));
    const Overlap plane = convex_overlap(square, other, buffer);
    const FaceIntegrals k = integrals_in_contact(o);
    CHECK(near(k.area, plane.area, 1e-13));
    const Vec3 centre = o.plane.at(k.first_moment / k.first);
    CHECK(near_zero((centre - Vec3(plane.centroid.x(), plane.centroid.y(), -5e-4)).norm(), 1e-14));
    return o.shared.count;
  };
  CHECK(shared(diamond(0.3, Vec2(0.5, 0))) == 3);
  CHECK(shared(diamond(0.3, Vec2(0, 0))) == 4);
  CHECK(shared(diamond(0.3, Vec2(0.3, 0))) == 5);
  CHECK(shared(diamond(0.45, Vec2(0.3, 0.2))) == 6);
  CHECK(shared(diamond(0.6, Vec2(0.05, 0.2))) == 7);
  CHECK(shared(diamond(0.6, Vec2(0.05, 0.02))) == 8);
}

TEST_CASE("the overlap of faces of any shape equals the overlap in the plane") {
  std::mt19937_64 bits(2);
  OverlapBuffer buffer;
  int meeting = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Polygon a = random_convex(bits, {.slenderest = 5});
    const Polygon b = placed(random_convex(bits, {.slenderest = 5}), random_direction(bits),
                             Vec2(random_between(bits, -1, 1), random_between(bits, -1, 1)));
    FaceOverlap3 o;
    const bool found = face_overlap(face_up(a, 0).view(), face_down(b, -0.1).view(), o);
    const Overlap plane = convex_overlap(a, b, buffer);
    const FaceIntegrals k = integrals_in_contact(o);
    CHECK(found == (plane.area > 0));
    CHECK(near_zero(k.area - plane.area, 1e-14));
    meeting += found;
  }
  CHECK(meeting > 1000);
}

TEST_CASE("a linear overlap has the integrals of a wedge and of a pyramid's corner") {
  // c = 0.02 x over a unit square from x = -1/2: half of it is closed
  const double t = 0.02;
  FaceOverlap3 o = faces_of(face_up(centred_face(1, 1), 0), face_down(centred_face(1, 1), 0));
  o.plane.origin = Vec3::Zero(), o.plane.overlap = 0, o.plane.slope = Vec2(t, 0);
  const Polygon square = centred_face(1, 1);
  std::copy(square.begin(), square.end(), o.shared.corner.begin());
  FaceMoments k = moments_in_contact(o);
  CHECK(near(k.first_xx, t / 64, 1e-14));
  CHECK(near(k.first_yy, t / 96, 1e-14));
  CHECK(near_zero(k.first_xy, 1e-18));
  CHECK(near(k.area, 0.5, 1e-15));
  CHECK(near(k.first, t / 8, 1e-15));
  CHECK(near(k.first_moment.x(), t / 24, 1e-15));
  CHECK(near(k.energy, t * t / 48, 1e-15));
  CHECK(near(k.xx, 1 / 24.0, 1e-15));
  CHECK(near(k.yy, 1 / 24.0, 1e-15));
  // c = t (x + y - 0.6): a triangle with legs 0.4 at the corner (1/2, 1/2)
  o.plane.overlap = -0.6 * t, o.plane.slope = Vec2(t, t);
  k = moments_in_contact(o);
  const double leg = 0.4, peak = leg * t;
  CHECK(near(k.area, leg * leg / 2, 1e-14));
  CHECK(near(k.first, leg * leg * peak / 6, 1e-14));
  CHECK(near(k.first_moment.x() / k.first, 0.5 - leg / 4, 1e-14));
  CHECK(near(k.energy, leg * leg * peak * peak / 24, 1e-14));
  // a pyramid about its own middle: variances 3/80 of the legs' squares, their product -1/80
  const Vec2 at = k.first_moment / k.first;
  CHECK(near(k.first_xx / k.first - at.x() * at.x(), 3 * leg * leg / 80, 1e-12));
  CHECK(near(k.first_xy / k.first - at.x() * at.y(), -leg * leg / 80, 1e-12));
  // a tiny gap at this corner: no contact; closed everywhere: as over the full area
  o.plane.overlap = -1.0000001 * t;
  CHECK(integrals_in_contact(o).area == 0);
  o.plane.overlap = 1.0000001 * t;
  CHECK(near(integrals_in_contact(o).energy, integrals_over_all(o).energy, 1e-14));
  CHECK(near(integrals_in_contact(o).area, 1, 1e-14));
}

TEST_CASE("faces that do not oppose each other, or miss each other, have no overlap") {
  FaceOverlap3 o;
  const OwnFace a = face_up(centred_face(1, 1), 0);
  CHECK(!face_overlap(a.view(), face_up(centred_face(1, 1), 0).view(), o));
  CHECK(!face_overlap(a.view(), face_moved(a, rotation_by(Vec3(1.5, 0, 0)), Vec3(0, 0, 0)).view(), o));
  CHECK(!face_overlap(a.view(), face_down(diamond(0.4, Vec2(0.95, 0)), 0).view(), o));
  CHECK(!face_overlap(a.view(), face_down(rectangle(Vec2(0.5, -1), Vec2(1, 1)), 0).view(), o));
  CHECK(o.shared.count == 0);
  CHECK(integrals_in_contact(o).area == 0);
  CHECK(face_overlap(a.view(), face_down(rectangle(Vec2(0.499, -1), Vec2(1, 1)), 0).view(), o));
}

TEST_CASE("the mean plane lies midway between both faces, and the overlap is their distance along it") {
  std::mt19937_64 bits(8);
  for (int trial = 0; trial < 300; ++trial) {
    const OwnFace a = face_moved(face_up(centred_face(1, 2), 0), face_rotation(bits, 0.3), Vec3(0, 0, 0));
    const OwnFace b = face_moved(face_down(centred_face(2, 1), 0), face_rotation(bits, 0.3), Vec3(0.1, 0.2, 0.05));
    const MeanPlane plane = faces_of(a, b).plane;
    CHECK(near(a.normal.dot(plane.normal), -b.normal.dot(plane.normal), 1e-14));
    const Vec2 p(random_between(bits, -1, 1), random_between(bits, -1, 1));
    const Vec3 half = 0.5 * plane.overlap_at(p) * plane.normal;
    CHECK(near_zero(a.normal.dot(plane.at(p) + half - a.corners[2]), 1e-14));
    CHECK(near_zero(b.normal.dot(plane.at(p) - half - b.corners[2]), 1e-14));
  }
}

TEST_CASE("integrals over faces do not depend on the frame or on the order of the faces") {
  std::mt19937_64 bits(12);
  int partly = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const OwnFace a = face_up(random_convex(bits), 0);
    const OwnFace b = face_moved(
        face_down(random_convex(bits), 0), face_rotation(bits, 0.2),
        Vec3(random_between(bits, -0.5, 0.5), random_between(bits, -0.5, 0.5), random_between(bits, -0.1, 0.1)));
    const FaceOverlap3 o = faces_of(a, b), back = faces_of(b, a);
    const UnitQuaternion q = face_rotation(bits, 3);
    const Vec3 shift(random_between(bits, -9, 9), random_between(bits, -9, 9), random_between(bits, -9, 9));
    const FaceOverlap3 turned = faces_of(face_moved(a, q, shift), face_moved(b, q, shift));
    const FaceIntegrals k = integrals_in_contact(o), kb = integrals_in_contact(back), kt = integrals_in_contact(turned);
    for (const FaceIntegrals& other : {kb, kt}) {
      CHECK(near_zero(other.area - k.area, 1e-12));
      CHECK(near_zero(other.first - k.first, 1e-13));
      CHECK(near_zero(other.energy - k.energy, 1e-14));
    }
    if (k.first < 1e-4) continue;
    partly += k.area < 0.99 * integrals_over_all(o).area;
    const Vec3 centre = o.plane.at(k.first_moment / k.first);
    CHECK(near_zero((back.plane.at(kb.first_moment / kb.first) - centre).norm(), 1e-11));
    CHECK(near_zero((turned.plane.at(kt.first_moment / kt.first) - Turn3(q).apply(centre) - shift).norm(), 1e-10));
  }
  CHECK(partly > 300);
}

TEST_CASE("edges of the shared polygon lie on the edges they are named after") {
  std::mt19937_64 bits(13);
  for (int trial = 0; trial < 500; ++trial) {
    const OwnFace a = face_up(random_convex(bits), 0), b = face_down(random_convex(bits), 0);
    const FaceOverlap3 o = faces_of(a, b);
    for (int i = 0; i < o.shared.count; ++i) {
      const int e = o.shared.edge[static_cast<std::size_t>(i)], next = (i + 1) % o.shared.count;
      const auto& of = e >= 0 ? a.corners : b.corners;
      const auto k = static_cast<std::size_t>(e >= 0 ? e : -1 - e);
      const Vec3 from = of[k], along = of[(k + 1) % of.size()] - of[k];
      for (const int end : {i, next}) {
        const Vec3 arm = o.plane.at(o.shared.corner[static_cast<std::size_t>(end)]) - from;
        CHECK(near_zero(cross(along, arm).norm(), 1e-13));
      }
    }
  }
}

TEST_CASE("the force between faces is the change of their energy, along the normal and sliding") {
  std::mt19937_64 bits(21);
  int tried = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const OwnFace a = face_up(random_convex(bits), 0);
    const double y = random_between(bits, -0.5, 0.5), x = random_between(bits, -0.5, 0.5);
    const UnitQuaternion turn = face_rotation(bits, 0.1);
    const OwnFace b = face_moved(face_down(random_convex(bits), 0), turn, Vec3(x, y, 0));
    const FaceOverlap3 o = faces_of(a, b);
    const FaceIntegrals k = integrals_in_contact(o);
    if (k.first < 1e-3) continue;
    ++tried;
    const double h = 1e-5;
    const auto change = [&](const Vec3& along) {
      const double more = integrals_in_contact(faces_of(a, face_moved(b, {}, h * along))).energy;
      const double less = integrals_in_contact(faces_of(a, face_moved(b, {}, -h * along))).energy;
      return (more - less) / (2 * h);
    };
    CHECK(near(-change(o.plane.normal), k.first, 1e-6));
    const Vec2 sliding = energy_by_sliding(o);
    CHECK(near_zero((change(o.plane.x) - sliding.x()) / k.first, 1e-6));
    CHECK(near_zero((change(o.plane.y) - sliding.y()) / k.first, 1e-6));
    const Vec2 other_x(o.plane.x.dot(faces_of(b, a).plane.x), o.plane.y.dot(faces_of(b, a).plane.x));
    // as a slides instead, the change has the opposite sign
    CHECK(near_zero((energy_by_sliding(faces_of(b, a)).x() + other_x.dot(sliding)) / k.first, 1e-12));
  }
  CHECK(tried > 300);
}

TEST_CASE("the moment between faces is the derivative of their energy, with an error that falls with the overlap") {
  const OwnFace a = face_up(centred_face(1, 1), 0), b = face_down(centred_face(1.3, 0.7), 0);
  double off[2];
  for (const int round : {0, 1}) {
    const double depth = round == 0 ? 1e-3 : 1e-4;
    const auto at = [&](double turn) {
      return faces_of(a, face_moved(b, rotation_by(Vec3(0, turn, 0)) * rotation_by(Vec3(0.3 * depth, 5 * depth, 0.2)),
                                    Vec3(0.1, 0.2, -depth)));
    };
    const double h = 1e-4 * depth;
    const FaceOverlap3 o = at(0);
    const FaceIntegrals k = integrals_in_contact(o);
    const double change = (integrals_in_contact(at(h)).energy - integrals_in_contact(at(-h)).energy) / (2 * h);
    const Vec3 arm = o.plane.at(k.first_moment / k.first) - Vec3(0.1, 0.2, -depth);
    // moment of the force on b along +n about the world's y through b's pivot
    const double moment = cross(arm, Vec3(k.first * o.plane.normal)).y();
    off[round] = std::abs(change / -moment - 1);
  }
  CHECK(off[0] < 1e-2);
  CHECK(off[1] < 0.2 * off[0]);
}

TEST_CASE("integrals stay smooth as corners enter and leave") {
  // the error of the second difference of a function with bounded second derivative falls with the square of the step
  const OwnFace a = face_up(centred_face(1, 1), 0);
  const auto at = [&](double way) {
    const OwnFace b = face_moved(face_down(centred_face(1, 0.8), 0), rotation_by(Vec3(0.02, 0.03, 0.3)),
                                 Vec3(way, 0.6 * way, 0.005 - 0.01 * way));
    return integrals_in_contact(faces_of(a, b));
  };
  for (const double step : {1e-3, 1e-4})
    for (double way = -1.2; way < 1.2; way += 0.00137) {
      const FaceIntegrals less = at(way - step), now = at(way), more = at(way + step);
      CHECK(std::abs(less.first - 2 * now.first + more.first) < 0.2 * step * step);
      CHECK(std::abs(less.energy - 2 * now.energy + more.energy) < 0.02 * step * step);
      CHECK((less.first_moment - 2 * now.first_moment + more.first_moment).norm() < 2 * step * step);
    }
}

TEST_CASE("faces that are flush except for rounding share all of themselves") {
  std::mt19937_64 bits(31);
  for (int trial = 0; trial < 1000; ++trial) {
    const Polygon outline = trial % 2 == 0 ? centred_face(0.4, 0.2) : random_convex(bits);
    const UnitQuaternion q = face_rotation(bits, 3);
    const Vec3 at(random_between(bits, -30, 30), random_between(bits, -30, 30), random_between(bits, -30, 30));
    const OwnFace a = face_moved(face_up(outline, 0), q, at), b = face_moved(face_down(outline, -1e-5), q, at);
    const FaceIntegrals k = integrals_in_contact(faces_of(a, b));
    CHECK(near_zero(k.area - signed_area(outline), 1e-13));
    CHECK(near(k.first, 1e-5 * signed_area(outline), 1e-8));
  }
}

TEST_CASE("two faces of as many corners as there may be share a polygon of twice as many") {
  Polygon many, between;
  for (int i = 0; i < max_face_corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / max_face_corners;
    many.push_back(Turn(angle).apply(Vec2(1, 0)));
    between.push_back(Turn(angle + std::numbers::pi / max_face_corners).apply(Vec2(1, 0)));
  }
  const FaceOverlap3 o = faces_of(face_up(many, 0), face_down(between, -0.1));
  CHECK(o.shared.count == 2 * max_face_corners);
  // the regular polygon of 64 corners, with the inradius of the polygon of 32 corners
  const double inner = portable::cos(std::numbers::pi / 32);
  CHECK(near(integrals_in_contact(o).area, 64 * inner * inner * portable::tan(std::numbers::pi / 64), 1e-13));
}
