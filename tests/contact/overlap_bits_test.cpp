// The general contact evaluates four edges, faces and segments at once: each bit equals the scalar evaluation.
#include <doctest/doctest.h>

#include "contact/overlap_reference.hpp"
#include "geometry/plane/random_convex.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

const Frictional damped{1e8, 0, 0, 1e-3};

/// A placed piece, with the data its spans point to.
struct Stone {
  Polygon corner;
  std::vector<std::uint8_t> is_face;
  std::vector<Vec2> corner_velocity;
  Vec2 origin, velocity;
  double spin;

  [[nodiscard]] PlacedPiece piece() const { return {corner, is_face, origin, velocity, spin, corner_velocity}; }
};

Vec2 random_vector(std::mt19937_64& bits, double most) {
  return {random_between(bits, -most, most), random_between(bits, -most, most)};
}

/// Some edges are inner cuts; some pieces belong to a deformable body.
Stone stone(std::mt19937_64& bits, Polygon outline, const Vec2& at) {
  Stone s{std::move(outline), {}, {}, at, random_vector(bits, 3), random_between(bits, -5, 5)};
  const bool deforms = random_count(bits, 0, 5) == 0;
  for (std::size_t c = 0; c < s.corner.size(); ++c) {
    s.is_face.push_back(random_count(bits, 0, 6) == 0 ? 0 : 1);
    if (deforms) s.corner_velocity.push_back(random_vector(bits, 3));
  }
  return s;
}

Stone random_stone(std::mt19937_64& bits, int fewest, int most, double spread) {
  RandomConvex wanted;
  wanted.fewest_corners = fewest, wanted.most_corners = most;
  const Vec2 at = random_vector(bits, spread);
  return stone(bits, placed(random_convex(bits, wanted), random_direction(bits), at), at);
}

/// A rectangle on a coarse grid: coincident edges and corners, equal depths.
Stone grid_stone(std::mt19937_64& bits) {
  const auto whole = [&](int low, int high) { return 0.25 * random_count(bits, low, high); };
  const double x = whole(-4, 4), y = whole(-4, 4), w = whole(1, 6), h = whole(1, 6);
  return stone(bits, {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, {x, y});
}

/// Number of closed contacts among `count` pairs.
template <class Make>
int check_bits(int count, Make&& make) {
  std::mt19937_64 bits(43);
  const ContactLaw law = damped;
  int touching = 0, unlike = 0;
  for (int i = 0; i < count; ++i) {
    const Stone sa = make(bits), sb = make(bits);
    const PlacedPiece a = sa.piece(), b = sb.piece();
    std::vector<Vec2> on_a(a.corner.size(), Vec2::Zero()), on_b(b.corner.size(), Vec2::Zero());
    const OverlapResponse r = respond_overlap(a, b, {{}, nullptr}, {law, 1, 1e-4}, on_a, on_b, nullptr);
    const ReferenceOverlap one = reference_overlap(a, b, Coulomb(damped, 1, 1e-4));
    touching += r.touching ? 1 : 0;
    const bool same_sums =
        r.touching == (one.length > 0) && r.force == one.force * one.normal && r.length == one.length &&
        r.depth == one.depth &&
        (!r.touching || (r.memory.damping_force[0] == one.damping.x() && r.memory.damping_force[1] == one.damping.y() &&
                         r.memory.damping_moment == one.damping_moment)) &&
        (one.pressure == 0 || r.centre == one.moment_arm / one.pressure);
    const bool same = same_sums && on_a == one.on_a && on_b == one.on_b && (r.separation > 0) == one.apart &&
                      (r.apart_by >= 0) == one.apart;
    unlike += same ? 0 : 1;
  }
  CHECK(unlike == 0);
  return touching;
}

}  // namespace

TEST_CASE("the general contact of pieces with up to four corners has the bits of one edge after the other") {
  CHECK(check_bits(20000, [](std::mt19937_64& bits) { return random_stone(bits, 3, 4, 0.8); }) > 8000);
}

TEST_CASE("the general contact of pieces with many corners has the bits of one edge after the other") {
  CHECK(check_bits(4000, [](std::mt19937_64& bits) { return random_stone(bits, 3, 16, 0.8); }) > 2000);
  CHECK(check_bits(200, [](std::mt19937_64& bits) { return random_stone(bits, 17, 64, 1); }) > 100);
}

TEST_CASE("the general contact of rectangles whose edges and corners meet has the bits of one edge after the other") {
  CHECK(check_bits(20000, grid_stone) > 5000);
}
