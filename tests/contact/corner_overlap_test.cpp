// One corner under one face, several pairs at once: the same response as the contact of general shape.
#include "contact/plane/corner_overlap.hpp"

#include <doctest/doctest.h>

#include <array>
#include <random>
#include <vector>

#include "geometry/plane/random_convex.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A convex piece of a rigid body, with its edges placed.
struct LooseStone {
  Polygon corner;
  std::vector<std::uint8_t> is_face;
  std::vector<EdgeRow> row;
  PlacedPiece piece;

  LooseStone(Polygon outline, const Vec2& origin, const Vec2& velocity, double spin)
      : corner(std::move(outline)), is_face(corner.size(), 1) {
    const auto fours = static_cast<std::size_t>(edge_blocks(static_cast<int>(corner.size())));
    row.resize(fours * lane_count);
    place_edges(corner, row.data());
    piece = {corner, is_face, origin, velocity, spin};
    piece.sides = {row.data(), surface_bits(is_face)};
  }
};

/// Two stones with a small overlap, and the contact's history.
struct StoneMeeting {
  LooseStone a, b;
  ContactMemory before;
};

StoneMeeting random_meeting(std::mt19937_64& bits) {
  const auto number = [&](double size) { return random_between(bits, -size, size); };
  RandomConvex wanted;
  wanted.fewest_corners = 3, wanted.most_corners = 7;
  const Vec2 away(number(200), number(200)), way = random_direction(bits);
  const Polygon first = random_convex(bits, wanted), second = random_convex(bits, wanted);
  // The distance along a random direction is slightly less than the sum of their extents.
  double reach = 0, low = 1e9;
  for (const Vec2& p : first) reach = std::max(reach, p.dot(way));
  for (const Vec2& p : second) low = std::min(low, p.dot(way));
  const double depth = random_between(bits, 1e-6, 0.05);
  const Vec2 side(-way.y(), way.x()), shift = (reach - low - depth) * way + number(0.3) * side;
  StoneMeeting m{
      LooseStone(placed(first, Vec2::UnitX(), away), away, {number(1), number(1)}, number(2)),
      LooseStone(placed(second, Vec2::UnitX(), away + shift), away + shift, {number(1), number(1)}, number(2)),
      {}};
  if (random_count(bits, 0, 3) == 0) return m;
  m.before.state = contact_touching | contact_general;
  for (const int h : {0, 1}) {
    m.before.shear_elastic[h] = h == 0 ? number(1e3) : m.before.shear_elastic[0];
    m.before.shear_total[h] = h == 0 ? number(1e3) : m.before.shear_total[0];
    m.before.active[h] = h == 0 ? random_between(bits, 1e-5, 1e-2) : m.before.active[0];
  }
  m.before.damping_force[0] = number(1e3), m.before.damping_force[1] = number(1e3);
  m.before.damping_moment = number(1e2), m.before.slip = random_between(bits, 0, 1);
  return m;
}

/// A response with its forces about the origins of both bodies.
struct PairResponse {
  OverlapResponse r;
  CornerPush push;
  std::array<double, 6> felt{};

  void feel(const StoneMeeting& m, const std::vector<Vec2>& on_a, const std::vector<Vec2>& on_b) {
    const auto add = [&](const LooseStone& stone, const std::vector<Vec2>& on, std::size_t at) {
      for (std::size_t c = 0; c < on.size(); ++c) {
        felt[at] += on[c].x(), felt[at + 1] += on[c].y();
        felt[at + 2] += cross(Vec2(stone.corner[c] - stone.piece.origin), on[c]);
      }
    };
    add(m.a, on_a, 0), add(m.b, on_b, 3);
  }
  void feel_push(const StoneMeeting& m, const CornerOnFace& at) {
    std::vector<Vec2> on_a(m.a.corner.size(), Vec2::Zero()), on_b(m.b.corner.size(), Vec2::Zero());
    std::vector<Vec2>&on_wedge = at.wedge_is_b ? on_b : on_a, &on_owner = at.wedge_is_b ? on_a : on_b;
    on_wedge[(at.corner + on_wedge.size() - 1) % on_wedge.size()] = push.on_wedge[0];
    on_wedge[at.corner] = push.on_wedge[1];
    on_owner[at.face] = push.on_owner[0], on_owner[(at.face + 1U) % on_owner.size()] = push.on_owner[1];
    feel(m, on_a, on_b);
  }
};

PairResponse of_any_shape(const StoneMeeting& m, const Frictional& law, double dt) {
  PairResponse given;
  std::vector<Vec2> on_a(m.a.corner.size(), Vec2::Zero()), on_b(m.b.corner.size(), Vec2::Zero());
  given.r = respond_overlap(m.a.piece, m.b.piece, {m.before, nullptr}, {law, 1, dt}, on_a, on_b, nullptr);
  given.feel(m, on_a, on_b);
  return given;
}

void check_same(const PairResponse& is, const PairResponse& should) {
  const double force = should.r.force.norm(), size = 0.5;
  const auto same = [](double x, double y, double scale) { return std::abs(x - y) <= 1e-7 * scale; };
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(
        same(is.felt[k], should.felt[k], (k % 3 == 2 ? size : 1) * (force + std::abs(should.r.memory.shear_total[0]))));
  CHECK(same((is.r.force - should.r.force).norm(), 0, force));
  CHECK(same((is.r.centre - should.r.centre).norm(), 0, should.r.length));
  CHECK(near(is.r.length, should.r.length, 1e-7));
  CHECK(near(is.r.depth, should.r.depth, 1e-7));
  const double loss = std::abs(should.r.lost_damping) + std::abs(should.r.lost_friction) + 1e-9;
  CHECK(same(is.r.lost_damping, should.r.lost_damping, loss));
  CHECK(same(is.r.lost_friction, should.r.lost_friction, loss));
  const ContactMemory &m = is.r.memory, &n = should.r.memory;
  const double shear = std::abs(n.shear_total[0]) + force * 1e-3;
  for (const int h : {0, 1}) {
    CHECK(same(m.shear_elastic[h], n.shear_elastic[h], shear));
    CHECK(same(m.shear_total[h], n.shear_total[h], shear));
    CHECK(same(m.active[h], n.active[h], n.active[h]));
    CHECK(same(m.damping_force[h], n.damping_force[h], force));
  }
  CHECK(same(m.damping_moment, n.damping_moment, 300 * force));
  CHECK(same(m.slip, n.slip, n.slip + 1e-9));
  CHECK(m.state == n.state);
}

/// Corners inside the other piece, found as by the contact of general shape.
CornerOnFace corner_within(const PlacedPiece& a, const PlacedPiece& b) {
  const Frictional law{1e8, 5e7, 0.6, 1e-3};
  const ContactMemory none;
  std::vector<Vec2> on_a(a.corner.size(), Vec2::Zero()), on_b(b.corner.size(), Vec2::Zero());
  CornerOnFace at;
  const OverlapResponse r = respond_overlap(a, b, {none, nullptr}, {law, 1, 1e-4}, on_a, on_b, nullptr, &at);
  CHECK_FALSE((at.is_there() && r.touching));
  return at;
}

/// Compares the corners of random stones of one kind: one under a face, or one of each in the other.
void check_corners(bool both) {
  std::mt19937_64 bits(71);
  const Frictional law{1e8, 5e7, 0.6, 1e-3};
  const double dt = 1e-4;
  const PlainFriction kernel(law, 1, dt);
  int found = 0, answered = 0, missed = 0, as_b = 0;
  for (int round = 0; round < 1500; ++round) {
    std::vector<StoneMeeting> meetings;
    for (int i = 0; i < most_corner_cases; ++i) meetings.push_back(random_meeting(bits));
    std::array<PairResponse, most_corner_cases> given;
    std::vector<CornerCase> cases;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < meetings.size(); ++i) {
      const StoneMeeting& m = meetings[i];
      const CornerOnFace at = corner_within(m.a.piece, m.b.piece);
      if (!at.is_there() || at.both != both) continue;
      cases.push_back({&m.a.piece, &m.b.piece, at, &m.before, &given[i].r.memory, &given[i].r, &given[i].push});
      which.push_back(i);
      as_b += at.wedge_is_b ? 1 : 0;
    }
    found += static_cast<int>(cases.size());
    if (cases.empty()) continue;
    const std::uint32_t done = respond_corners(cases, kernel);
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const StoneMeeting& m = meetings[which[k]];
      PairResponse& is = given[which[k]];
      if ((done >> k & 1U) == 0) {
        ++missed;
        CHECK_FALSE(is.r.touching);
        continue;
      }
      ++answered;
      is.feel_push(m, cases[k].at);
      check_same(is, of_any_shape(m, law, dt));
      // A pair evaluated alone has the same bits: neighbours in the vector have no influence.
      PairResponse alone;
      CornerCase own = cases[k];
      own.out = &alone.r, own.after = &alone.r.memory, own.push = &alone.push;
      CHECK(respond_corners({&own, 1}, kernel) == 1);
      CHECK(alone.push.on_wedge == is.push.on_wedge);
      CHECK(alone.push.on_owner == is.push.on_owner);
      CHECK(alone.r.memory.shear_total[0] == is.r.memory.shear_total[0]);
      CHECK(alone.r.force == is.r.force);
      CHECK(alone.r.lost_damping == is.r.lost_damping);
    }
  }
  CHECK(found > (both ? 300 : 1000));
  CHECK(answered > 0.8 * found);
  if (both) return;
  CHECK(missed > 0);
  CHECK(as_b > 0.3 * found);
  CHECK(as_b < 0.7 * found);
}

}  // namespace

TEST_CASE("a corner under a face has the force of the general contact, alone and several at once") {
  check_corners(false);
}

TEST_CASE("corners in each other have the forces of the general contact, alone and several at once") {
  check_corners(true);
}

TEST_CASE("a corner that is not below its stated face gives no result") {
  const Frictional law{1e8, 5e7, 0.6, 1e-3};
  const PlainFriction kernel(law, 1, 1e-4);
  const LooseStone floor({{-1, -1}, {1, -1}, {1, 0}, {-1, 0}}, {0, -0.5}, Vec2::Zero(), 0);
  const auto stone = [](double lift) {
    return LooseStone({{0, lift}, {0.2, 0.2 + lift}, {0, 0.4 + lift}, {-0.2, 0.2 + lift}}, {0, 0.2 + lift}, {0, -1}, 0);
  };
  const auto answers = [&](const LooseStone& wedge, CornerOnFace at) {
    OverlapResponse out;
    CornerPush push;
    const ContactMemory none;
    const CornerCase one{&floor.piece, &wedge.piece, at, &none, &out.memory, &out, &push};
    return respond_corners({&one, 1}, kernel) == 1;
  };
  const LooseStone low = stone(-1e-3), high = stone(1e-3);
  const CornerOnFace right = corner_within(floor.piece, low.piece);
  CHECK(right.corner == 0);
  CHECK(right.face == 2);
  CHECK(right.wedge_is_b);
  CHECK(answers(low, right));
  CHECK_FALSE(answers(high, right));
  for (std::uint8_t corner = 0; corner < 4; ++corner)
    for (std::uint8_t face = 0; face < 4; ++face)
      CHECK(answers(low, {corner, face, true}) == (corner == right.corner && face == right.face));
  CHECK_FALSE(corner_within(floor.piece, high.piece).is_there());
}
