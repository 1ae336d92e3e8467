// Softening faces that open from one end: integrals against numerical ones, force and moment against the law at each
// point, and the energy balance.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "contact/face_scene.hpp"
#include "contact/mortar_joint.hpp"
#include "law/contact/cohesive.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double kn_open = MortarJoint::kn, strength_open = MortarJoint::tension, energy_open = MortarJoint::gi;

/// Midpoint sum of f over [0, 1].
template <class F>
double mean_by_points(F&& f) {
  constexpr int points = 200000;
  double sum = 0;
  for (int i = 0; i < points; ++i) sum += f((i + 0.5) / points);
  return sum / points;
}

/// Two faces of 1 m with prescribed openings of both ends, and the work of the forces that open them.
struct OpenedJoint {
  Cohesive::Kernel law{MortarJoint::mortar(), 1, 1e-4};
  FaceMemory<double> memory = no_memory(true);
  LawMemory<Cohesive::Kernel> own;
  double end[2] = {0, 0}, pull[2] = {0, 0};  // [m], [N]
  double work = 0, lost = 0;                 // [J]

  void to(double first, double second) {
    const Vec2 v0(0, (first - end[0]) / law.dt), v1(0, (second - end[1]) / law.dt), still = Vec2::Zero();
    const auto r = respond_face_pair(face({1, 0}, {0, 0}, still, still), face({0, first}, {1, second}, v0, v1), 1.0,
                                     memory, own, law);
    REQUIRE(r.is_face_pair);
    const double next[2] = {-r.by0, -r.by1};
    work += 0.5 * (next[0] + pull[0]) * (first - end[0]) + 0.5 * (next[1] + pull[1]) * (second - end[1]);
    lost += r.lost_fracture + r.lost_friction + r.lost_damping;
    memory = r.memory, own = r.own;
    end[0] = first, end[1] = second, pull[0] = next[0], pull[1] = next[1];
  }
  void lead(double first, double second, int steps) {
    const double from[2] = {end[0], end[1]};
    for (int i = 1; i <= steps; ++i)
      to(from[0] + (first - from[0]) * i / steps, from[1] + (second - from[1]) * i / steps);
  }
  /// Elastic energy [J].
  [[nodiscard]] double stored() const {
    ContactMemory m;
    m.bonds = (memory.bonds[0] ? 1U : 0U) | (memory.bonds[1] ? 2U : 0U);
    const FaceOverlap<double> o(face({1, 0}, {0, 0}, Vec2::Zero(), Vec2::Zero()),
                                face({0, end[0]}, {1, end[1]}, Vec2::Zero(), Vec2::Zero()));
    const auto gaps = law.gaps(o, m, own);
    return stored_in_half(law, gaps[0], 0.5, m, own, 0) + stored_in_half(law, gaps[1], 0.5, m, own, 1);
  }
};

/// Stress of linear softening at an opening that grows from 0 [Pa].
double stress_at(double opening) {
  const double first = strength_open / kn_open, last = 2 * energy_open / strength_open;
  if (opening <= first) return kn_open * opening;
  return opening < last ? strength_open * (last - opening) / (last - first) : 0;
}

}  // namespace

TEST_CASE("the product of two gaps is integrated where both are open, wherever each of them closes") {
  std::mt19937_64 bits(44);
  for (int i = 0; i < 60; ++i) {
    HalfState<double> h{};
    h.g0 = random_between(bits, -1, 1), h.g1 = random_between(bits, -1, 1), h.length = random_between(bits, 0.1, 2);
    const double p0 = random_between(bits, -1, 1), p1 = random_between(bits, -1, 1);
    const int part = random_count(bits, 0, bond_parts - 1);
    const auto product = [&](double s) {
      return std::max(0.0, h.g0 + (h.g1 - h.g0) * s) * std::max(0.0, p0 + (p1 - p0) * s);
    };
    CAPTURE(i);
    CHECK(near_zero(open_product(h, p0, p1) - h.length * mean_by_points(product), 1e-8));
    const double start = part_start(part), width = 1.0 / bond_parts;
    const double exact = h.length * width * mean_by_points([&](double s) { return product(start + s * width); });
    CHECK(near_zero(open_product(h, p0, p1, start, start + width) - exact, 1e-8));
  }
}

TEST_CASE(
    "in a half that mortar fills, the thickness of the mortar is taken from both gaps before they are multiplied") {
  std::mt19937_64 bits(45);
  for (int i = 0; i < 20; ++i) {
    HalfState<double> h{};
    h.g0 = random_between(bits, 1, 2), h.g1 = random_between(bits, 1, 2), h.length = 0.7;
    const double p0 = random_between(bits, 1, 2), p1 = random_between(bits, 1, 2);
    const double set0 = random_between(bits, -1, 1), set1 = random_between(bits, -1, 1);
    h.filling = JointFilling<double>(set0, 2 * set1 - set0).half[0];
    const auto product = [&](double s) {
      const double mortar = std::max(0.0, set0 + (set1 - set0) * s);
      return (h.g0 + (h.g1 - h.g0) * s - mortar) * (p0 + (p1 - p0) * s - mortar);
    };
    CAPTURE(i);
    CHECK(near(open_product(h, p0, p1), h.length * mean_by_points(product), 1e-7));
    double sum = 0;
    for (int k = 0; k < bond_parts; ++k) sum += open_product(h, p0, p1, part_start(k), part_start(k + 1));
    CHECK(near(sum, open_product(h, p0, p1), 1e-12));
  }
}

TEST_CASE("faces that open about one end carry the softening stresses of all their points") {
  const double last = 2 * energy_open / strength_open;
  for (const bool far_end : {false, true})
    for (const double share : {0.002, 0.01, 0.1, 0.5, 0.9, 1.0, 1.5, 4.0}) {
      OpenedJoint joint;
      joint.lead(far_end ? 0 : share * last, far_end ? share * last : 0, 200);
      const double force = mean_by_points([&](double s) { return stress_at(share * last * s); });
      const double moment = mean_by_points([&](double s) { return s * stress_at(share * last * s); });
      CAPTURE(share);
      CHECK(near(joint.pull[0] + joint.pull[1], force, 1e-5));
      // Within each of the eight parts the stress is linear. So the force is exact, up to the kinks that the points
      // miss, and its centre is right within a share of the length of a part.
      constexpr double length = 0.5 / bond_parts;
      CHECK(near_zero((joint.pull[far_end ? 1 : 0] - moment) / force, 0.15 * length));
    }
}

TEST_CASE("the energy of faces that open and close from both ends balances, and none is gained by cracking") {
  std::mt19937_64 bits(46);
  const double last = 2 * energy_open / strength_open;
  for (int i = 0; i < 20; ++i) {
    OpenedJoint joint;
    double before = 0;
    CAPTURE(i);
    for (int stop = 0; stop < 6; ++stop) {
      joint.lead(random_between(bits, -0.3, 1.2) * last, random_between(bits, -0.3, 1.2) * last, 4000);
      CHECK(joint.lost >= before - 1e-9 * energy_open);
      before = joint.lost;
      // The trapezoidal work of a step across a place that closes misses its square.
      CHECK(near_zero(joint.work - joint.lost - joint.stored(), 1e-4 * energy_open));
    }
    joint.lead(20 * last, 20.001 * last, 20000);
    CHECK(joint.memory.bonds[0] == false);
    CHECK(joint.memory.bonds[1] == false);
    CHECK(near(joint.lost, energy_open, 0.02));
  }
}
