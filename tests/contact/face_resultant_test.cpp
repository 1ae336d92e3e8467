#include "contact/joint/face_resultant.hpp"

#include <doctest/doctest.h>

#include <random>

#include "contact/plane/face_pair.hpp"

using namespace trilith;

namespace {

struct Pair {
  FaceEnds<double> a, b;
};

/// Two faces in contact, slightly tilted and overlapping, shifted along, at random positions and rotations, in motion.
Pair random_pair(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const Turn turn(3.2 * unit(random));
  const Vec2 at(10 * unit(random), 10 * unit(random));
  const auto place = [&](double x, double y) { return Vec2(at + turn.apply({x, y})); };
  const double shift = 0.4 * unit(random), sink = 1e-3 * unit(random), tilt = 1e-3 * unit(random);
  // A lies below, its face runs leftwards on top; B lies above, its face runs rightwards.
  const Vec2 a0 = place(1, 0), a1 = place(0, 0);
  const Vec2 b0 = place(shift, -1e-3 + sink - tilt), b1 = place(shift + 0.8, -1e-3 + sink + tilt);
  const auto v = [&] { return 0.1 * unit(random); };
  return {{a0.x(), a0.y(), a1.x(), a1.y(), v(), v(), v(), v()}, {b0.x(), b0.y(), b1.x(), b1.y(), v(), v(), v(), v()}};
}

ContactMemory to_memory(const FaceMemory<double>& m) {
  ContactMemory out;
  for (const int h : {0, 1}) {
    out.shear_elastic[h] = m.shear_elastic[h];
    out.shear_total[h] = m.shear_total[h];
    out.damping_force[h] = m.damping_force[h];
  }
  out.bonds = (m.bonds[0] ? 1U : 0U) | (m.bonds[1] ? 2U : 0U);
  return out;
}

template <class L>
void check_same(const L& numbers, bool bonded) {
  using K = typename L::Kernel;
  const K law(numbers, 1, 1e-4);
  std::mt19937 random(7);
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pair p = random_pair(random);
    FaceMemory<double> before{};
    before.bonds[0] = before.bonds[1] = bonded;
    before.shear_elastic[0] = 1e3;
    const auto r = respond_face_pair<K>(p.a, p.b, 1.0, before, LawMemory<K>{}, law);
    if (!r.is_face_pair || !r.touching) continue;
    ++touching;
    const ContactResultant out = face_resultant(p.a, p.b, to_memory(r.memory), r.own, law);
    const Vec2 b0(r.bx0, r.by0), b1(r.bx1, r.by1), sum = b0 + b1;
    const double scale = law.kn * 1e-3;
    CHECK((sum - out.force).norm() < 1e-9 * scale);
    if (!(out.normal > 0) || bonded) continue;
    // Moment about the resultant's point: only by the shear forces of the two halves. Their lines are separated by the
    // mid-gap line, which is not quite along the faces' common direction.
    const Vec2 arm0 = Vec2(p.b.x0, p.b.y0) - out.point, arm1 = Vec2(p.b.x1, p.b.y1) - out.point;
    const FaceOverlap<double> o(p.a, p.b);
    const double slope_a = (o.dy * (p.a.x1 - p.a.x0) - o.dx * (p.a.y1 - p.a.y0)) * o.inv_a;
    const double apart = std::abs(slope_a * o.shared + 0.5 * (o.gap_hi - o.gap_lo));
    const double shears = std::abs(r.memory.shear_total[0]) + std::abs(r.memory.shear_total[1]);
    CHECK(std::abs(cross(arm0, b0) + cross(arm1, b1)) <= shears * apart + 1e-9 * scale);
  }
  CHECK(touching > 500);
}

}  // namespace

TEST_CASE("the resultant of two faces is the force and moment at their ends") {
  check_same(Frictional{1e8, 4e7, 0.6, 2e-3}, false);
  check_same(Bonded{1e8, 4e7, 0.6, 2e-3, 1e9, 1e9, 0}, true);
}
