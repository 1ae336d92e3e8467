// Properties of the contact of convex pieces of any shape and pose.
#include "contact/plane/overlap_energy.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "contact/face_scene.hpp"
#include "geometry/plane/convex_parts.hpp"
#include "geometry/plane/overlap.hpp"
#include "model/flatness.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double stiffness = 1e8;
const ContactLaw springs = Frictional{stiffness, 0, 0, 0}, rough = Frictional{stiffness, 0.5 * stiffness, 0.6, 1e-3};

/// A body of convex pieces, in the axes of its node.
struct Shape {
  std::vector<Polygon> pieces;
  std::vector<std::vector<std::uint8_t>> is_face;
  double radius = 0;

  explicit Shape(const Polygon& outline) {
    for (const ConvexPiece& piece : convex_parts(outline)) {
      const PieceEdges edges = piece_edges(outline, piece);
      Polygon corners;
      for (const int c : edges.corner) corners.push_back(outline[c]);
      pieces.push_back(corners);
      is_face.push_back(edges.is_face);
    }
    for (const Vec2& p : outline) radius = std::max(radius, p.norm());
  }
};

struct Pose {
  Vec2 place = Vec2::Zero();
  double angle = 0;
  Vec2 velocity = Vec2::Zero();
  double spin = 0;
};

/// Forces on two bodies: sums over all pairs of their pieces, about their nodes.
struct Felt {
  Vec2 on_a = Vec2::Zero(), on_b = Vec2::Zero(), on_b_normal = Vec2::Zero();
  double moment_a = 0, moment_b = 0, energy = 0, pressure = 0;
  bool touching = false;
};

Felt feel(const Shape& a, const Pose& pa, const Shape& b, const Pose& pb, const ContactLaw& law) {
  Felt felt;
  for (std::size_t i = 0; i < a.pieces.size(); ++i)
    for (std::size_t j = 0; j < b.pieces.size(); ++j) {
      const Polygon ca = placed(a.pieces[i], Turn(pa.angle).apply(Vec2::UnitX()), pa.place);
      const Polygon cb = placed(b.pieces[j], Turn(pb.angle).apply(Vec2::UnitX()), pb.place);
      const PlacedPiece piece_a{ca, a.is_face[i], pa.place, pa.velocity, pa.spin};
      const PlacedPiece piece_b{cb, b.is_face[j], pb.place, pb.velocity, pb.spin};
      std::vector<Vec2> on_a(ca.size(), Vec2::Zero()), on_b(cb.size(), Vec2::Zero());
      const OverlapResponse r = respond_overlap(piece_a, piece_b, {{}, nullptr}, {law, 1, 1e-4}, on_a, on_b, nullptr);
      felt.touching = felt.touching || r.touching;
      felt.energy += overlap_energy(piece_a, piece_b, {law});
      felt.on_b_normal += r.force;
      for (std::size_t c = 0; c < ca.size(); ++c)
        felt.on_a += on_a[c], felt.moment_a += cross(Vec2(ca[c] - pa.place), on_a[c]);
      for (std::size_t c = 0; c < cb.size(); ++c)
        felt.on_b += on_b[c], felt.moment_b += cross(Vec2(cb[c] - pb.place), on_b[c]);
      for (const Vec2& f : on_b) felt.pressure = std::max(felt.pressure, f.norm());
    }
  return felt;
}

/// Force and moment on b as the negative gradient of the energy, by central differences.
Eigen::Vector3d slope_of_energy(const Shape& a, const Pose& pa, const Shape& b, const Pose& pb) {
  const double h = 1e-6;
  Eigen::Vector3d slope;
  for (int k = 0; k < 3; ++k) {
    const auto at = [&](double step) {
      Pose moved = pb;
      if (k < 2) moved.place[k] += step;
      if (k == 2) moved.angle += step;
      return feel(a, pa, b, moved, springs).energy;
    };
    slope[k] = -(8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
  }
  return slope;
}

Polygon random_concave(std::mt19937_64& bits) {
  const int n = random_count(bits, 5, 9);
  Polygon outline;
  for (int i = 0; i < n; ++i) {
    const double share = i % 2 == 0 ? random_between(bits, 0.7, 1) : random_between(bits, 0.3, 0.6);
    outline.emplace_back(share * Turn(2 * M_PI * (i + random_between(bits, 0.2, 0.8)) / n).apply(Vec2::UnitX()));
  }
  return outline;
}

/// A pose of B with an overlap with A of up to a few tenths of their size.
Pose random_pose(std::mt19937_64& bits, const Shape& a, const Shape& b, double nearness) {
  Pose pose;
  pose.place = random_between(bits, 0.4, nearness) * (a.radius + b.radius) * random_direction(bits);
  pose.angle = random_between(bits, -M_PI, M_PI);
  pose.velocity = {random_between(bits, -1, 1), random_between(bits, -1, 1)};
  pose.spin = random_between(bits, -1, 1);
  return pose;
}

/// Largest difference of force and gradient, relative to either.
template <class Make>
void check_slope(Make&& make, int count) {
  std::mt19937_64 bits(23);
  int touching = 0;
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    const Shape a(make(bits)), b(make(bits));
    const Pose pa{Vec2::Zero(), random_between(bits, -M_PI, M_PI)}, pb = random_pose(bits, a, b, 1.0);
    const Felt felt = feel(a, pa, b, pb, springs);
    if (!felt.touching) continue;
    ++touching;
    const Eigen::Vector3d force(felt.on_b.x(), felt.on_b.y(), felt.moment_b), slope = slope_of_energy(a, pa, b, pb);
    // The second derivative of the energy has kinks where a corner passes a face: there the difference is of order h.
    const double apart = (force - slope).norm() / (felt.pressure + stiffness * 1e-4);
    worst = std::max(worst, apart);
    CHECK(apart < 1e-4);
  }
  MESSAGE(touching, " touching pairs, largest difference ", worst);
  REQUIRE(touching > count / 4);
}

}  // namespace

TEST_CASE("the general contact's force is the negative gradient of its energy, for convex bodies") {
  check_slope([](std::mt19937_64& bits) { return random_convex(bits); }, 400);
}

TEST_CASE("the general contact's force is the negative gradient of its energy, for bodies cut into pieces") {
  check_slope([](std::mt19937_64& bits) { return random_concave(bits); }, 300);
}

TEST_CASE("the general contact's forces are equal and opposite, in sum and in moment, with damping and friction too") {
  std::mt19937_64 bits(29);
  for (int i = 0; i < 400; ++i) {
    const Shape a(random_convex(bits)), b(random_convex(bits));
    const Pose pa{Vec2::Zero(), 0.3, {0.2, -0.1}, 0.5}, pb = random_pose(bits, a, b, 0.9);
    const Felt felt = feel(a, pa, b, pb, rough);
    const double moment = felt.moment_a + felt.moment_b + cross(pa.place, felt.on_a) + cross(pb.place, felt.on_b);
    CHECK((felt.on_a + felt.on_b).norm() <= 1e-12 * felt.pressure * 10);
    CHECK(std::abs(moment) <= 1e-12 * felt.pressure * 10 * (a.radius + b.radius));
    const Felt other = feel(b, pb, a, pa, rough);
    CHECK((felt.on_b - other.on_a).norm() <= 1e-10 * (1 + felt.pressure));
  }
}

TEST_CASE("the general contact does not depend on the axes") {
  std::mt19937_64 bits(31);
  for (int i = 0; i < 200; ++i) {
    const Shape a(random_convex(bits)), b(random_convex(bits));
    const Pose pa, pb = random_pose(bits, a, b, 0.9);
    const double angle = random_between(bits, -M_PI, M_PI);
    const Turn turn(angle);
    const Pose ta{turn.apply(pa.place), pa.angle + angle, turn.apply(pa.velocity), pa.spin};
    const Pose tb{turn.apply(pb.place), pb.angle + angle, turn.apply(pb.velocity), pb.spin};
    const Felt one = feel(a, pa, b, pb, rough), two = feel(a, ta, b, tb, rough);
    CHECK((turn.apply(one.on_b) - two.on_b).norm() <= 1e-8 * (1 + one.pressure));
    CHECK(std::abs(one.moment_b - two.moment_b) <= 1e-8 * (1 + one.pressure));
  }
}

TEST_CASE("separated pieces have no force and a safe lower bound of their distance") {
  std::mt19937_64 bits(37);
  int apart = 0;
  for (int i = 0; i < 500; ++i) {
    const Shape a(random_convex(bits)), b(random_convex(bits));
    const Pose pb = random_pose(bits, a, b, 1.6);
    const Polygon cb = placed(b.pieces[0], Turn(pb.angle).apply(Vec2::UnitX()), pb.place);
    const double separation = penetration(a.pieces[0], cb).separation;
    if (separation <= 0) continue;
    ++apart;
    std::vector<Vec2> on_a(a.pieces[0].size(), Vec2::Zero()), on_b(cb.size(), Vec2::Zero());
    const OverlapResponse r = respond_overlap({a.pieces[0], a.is_face[0], Vec2::Zero(), Vec2::Zero(), 0},
                                              {cb, b.is_face[0], pb.place, pb.velocity, pb.spin}, {{}, nullptr},
                                              {springs, 1, 1e-4}, on_a, on_b, nullptr);
    CHECK_FALSE(r.touching);
    CHECK(r.separation > 0);
    CHECK(r.separation <= separation * (1 + 1e-12));
    for (const Vec2& f : on_a) CHECK(f.norm() == 0.0);
  }
  REQUIRE(apart > 100);
}

TEST_CASE("for flat faces the general contact has the force of the face contact, up to depth over length") {
  for (const double depth : {1e-6, 1e-5, 1e-4, 1e-3}) {
    const Shape a(rectangle({-2, -1}, {2, 0})), b(rectangle({-0.5, 0}, {0.5, 1}));
    Pose pb;
    pb.place = {0.1, -depth};
    const Felt felt = feel(a, {}, b, pb, springs);
    const Faces f{rigid_face({2, 0}, {-2, 0}, Vec2::Zero(), 0),
                  rigid_face({-0.4, -depth}, {0.6, -depth}, Vec2::Zero(), 0)};
    const auto r = respond_fresh(f, no_memory(), Coulomb(std::get<Frictional>(springs), 1, 1e-4));
    const double face_force = (on_b0(r) + on_b1(r)).y();
    CHECK(near(face_force, stiffness * depth, 1e-12));
    CHECK(near(felt.on_b.y(), face_force, depth));
    CHECK(std::abs(felt.on_b.x()) <= 1e-9 * face_force);
    CHECK(near(felt.energy, 0.5 * stiffness * depth * depth, depth));
  }
}
