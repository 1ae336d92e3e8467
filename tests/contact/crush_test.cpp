// Crushing mortar: the strength limit of a joint, of halves pressed at one end, and of contacts of general shape.
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "contact/mortar_joint.hpp"
#include "contact/plane/overlap_energy.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double strength = 2e6, first = strength / MortarJoint::kn;  // [Pa], penetration at the strength [m]

Cohesive crushing_mortar() {
  Cohesive law = MortarJoint::mortar();
  law.compression = strength, law.crushing_depth = 0.02;
  return law;
}

MortarJoint crushing_joint() {
  MortarJoint joint;
  joint.law.crushing = first, joint.law.crushing_depth = 0.02;
  return joint;
}

/// Elastic normal force of both halves of faces with the gaps `at_left` and `at_right` at their ends [N].
struct Pressed {
  FaceResponse<double, LawMemory<Cohesive::Kernel>> response;
  double force = 0;
};

Pressed press(double at_left, double at_right, const FaceMemory<double>& memory, const LawMemory<Cohesive::Kernel>& own,
              const Cohesive::Kernel& law) {
  const Vec2 still = Vec2::Zero();
  const FaceEnds<double> a = rigid_face({1, 0}, {0, 0}, still, 0),
                         b = rigid_face({0, at_left}, {1, at_right}, still, 0);
  Pressed out{respond_face_pair(a, b, 1.0, memory, own, law)};
  out.force = on_b0(out.response).y() + on_b1(out.response).y();
  return out;
}

}  // namespace

TEST_CASE("the stress of mortar stays at its strength beyond it, and crushing dissipates the remaining work") {
  MortarJoint joint = crushing_joint();
  joint.lead(-0.999 * first, 0, 100);
  CHECK(joint.fracture == 0.0);
  CHECK(near(joint.normal, -0.999 * strength, 1e-12));
  joint.lead(-5 * first, 0, 1000, [&] { CHECK(-joint.normal <= strength * (1 + 1e-12)); });
  CHECK(near(-joint.normal, strength, 1e-12));
  CHECK(near(joint.own.crushed[0], 4 * first, 1e-12));
  CHECK(near(joint.fracture, strength * 4 * first, 1e-5));
  CHECK(near(joint.work, joint.fracture + joint.stored(), 1e-9));
  // Unloading along kn, to zero force at the crushed depth; then the bond is in tension.
  joint.lead(-4.5 * first, 0, 10);
  CHECK(near(joint.normal, -0.5 * strength, 1e-9));
  joint.lead(-4 * first, 0, 10);
  CHECK(std::abs(joint.normal) < 1e-9 * strength);
  const double opening = 0.5 * MortarJoint::tension / MortarJoint::kn;
  joint.lead(-4 * first + opening, 0, 10);
  CHECK(near(joint.normal, 0.5 * MortarJoint::tension, 1e-6));
}

TEST_CASE("crushed mortar stays crushed while the faces are apart") {
  MortarJoint joint = crushing_joint();
  joint.lead(-3 * first, 0, 100);
  joint.lead(2e-3, 0, 4000);
  CHECK_FALSE((joint.memory.bonds[0] || joint.memory.bonds[1]));
  const double given = joint.fracture;
  joint.lead(-1.99 * first, 0, 100);
  CHECK(joint.normal == 0.0);
  joint.lead(-2.5 * first, 0, 100);
  CHECK(near(joint.normal, -0.5 * strength, 1e-9));
  CHECK(joint.fracture == given);
}

TEST_CASE("mortar crushes by its largest depth and keeps its stiffness") {
  MortarJoint joint = crushing_joint();
  joint.law.crushing_depth = 3 * first;
  joint.lead(-6 * first, 0, 600);
  CHECK(near(joint.own.crushed[0], 3 * first, 1e-12));
  CHECK(near(joint.normal, -3 * strength, 1e-9));
  CHECK(near(joint.work, joint.fracture + joint.stored(), 1e-9));
}

TEST_CASE("faces carry at most the strength times the pressed length, for any previous gaps") {
  std::mt19937_64 bits(11);  // gaps of up to 4 mm, a depth of up to 20 mm
  const Cohesive::Kernel law = crushing_joint().law;
  for (int trial = 0; trial < 200; ++trial) {
    FaceMemory<double> memory = no_memory(false);
    LawMemory<Cohesive::Kernel> own;
    double g0 = 0, g1 = 0;
    for (int leg = 0; leg < 4; ++leg) {
      const double from0 = g0, from1 = g1;
      const double to0 = random_between(bits, -4e-3, 1e-3), to1 = random_between(bits, -4e-3, 1e-3);
      for (int i = 1; i <= 50; ++i) {
        g0 = from0 + (to0 - from0) * i / 50, g1 = from1 + (to1 - from1) * i / 50;
        const Pressed now = press(g0, g1, memory, own, law);
        const FaceMemory<double>& after = now.response.memory;
        CHECK(now.force <= strength * (after.active[0] + after.active[1]) * (1 + 1e-9));
        CHECK(now.response.lost_fracture >= 0.0);
        for (const int h : {0, 1}) CHECK(now.response.own.crushed[h] >= own.crushed[h]);
        memory = now.response.touching ? after : no_memory(false);
        own = now.response.touching ? now.response.own : law.parted(now.response.own);
      }
    }
  }
}

TEST_CASE("a face pressed from one end carries a triangle of stress with its mean at the strength") {
  const Pressed now = press(-5e-3, 5e-3, no_memory(false), {}, crushing_joint().law);
  // The remaining penetration falls by 1 cm per 1 m from twice `first`.
  const double length = 2 * first / 1e-2;
  CHECK(near(now.response.memory.active[1], length, 1e-4));
  CHECK(now.response.memory.active[0] < 1e-4);
  CHECK(near(now.force, strength * length, 1e-4));
}

namespace {

const Polygon lower{{-1, -1}, {1, -1}, {1, 0}, {-1, 0}}, upper{{-0.5, 0}, {0.5, 0}, {0.5, 1}, {-0.5, 1}};

/// Response of an upper block at `at`, rotated by `angle`, with mortar crushed by `depth`.
struct General {
  OverlapResponse response;
  LawMemory<Cohesive::Kernel> after;
  double energy;

  General(const Vec2& at, double angle, double depth, const Cohesive& law) {
    const std::vector<std::uint8_t> faces(4, 1);
    Polygon corners;
    for (const Vec2& p : upper) corners.push_back(at + Turn(angle).apply(p));
    const PlacedPiece a{lower, faces, Vec2(0, -0.5), Vec2::Zero(), 0}, b{corners, faces, at, Vec2::Zero(), 0};
    ContactMemory memory;
    LawMemory<Cohesive::Kernel> own;
    own.crushed[0] = depth, own.crushed[1] = 0.5 * depth;
    if (depth > 0) memory.state = contact_kept;
    std::vector<Vec2> on_a(4, Vec2::Zero()), on_b(4, Vec2::Zero());
    const ContactLaw used = law;
    std::array<double, law_numbers<Cohesive::Kernel>> row{};
    keep_law_memory<Cohesive::Kernel>(own, row.data());
    response = respond_overlap(a, b, {memory, row.data()}, {used, 1, 1e-4}, on_a, on_b, row.data());
    after = law_memory<Cohesive::Kernel>(row.data());
    energy = overlap_energy(a, b, {used}, depth);
  }
};

}  // namespace

TEST_CASE("the force of a crushed contact of any shape is the gradient of its energy") {
  Cohesive law = crushing_mortar();
  law.compression = MortarJoint::kn;  // a penetration of 1 m, more than any here
  const double h = 1e-7, depth = 2e-3;
  for (const double angle : {0.0, 0.02, -0.3, 0.7})
    for (const double down : {1e-3, 4e-3, 2e-2}) {
      const Vec2 at(0.1, 0.5 * std::sin(std::abs(angle)) - down);
      const Vec2 dx(h, 0), dy(0, h);
      const double fx =
          (General(at - dx, angle, depth, law).energy - General(at + dx, angle, depth, law).energy) / (2 * h);
      const double fy =
          (General(at - dy, angle, depth, law).energy - General(at + dy, angle, depth, law).energy) / (2 * h);
      const General now(at, angle, depth, law);
      CHECK(near_zero((now.response.force - Vec2(fx, fy)).norm(), 1e-5 * Vec2(fx, fy).norm()));
      CHECK(now.energy < General(at, angle, 0, law).energy);
    }
}

TEST_CASE("a contact of any shape crushes until its stress equals its strength over the pressed length") {
  const Vec2 at(0, -5e-3);
  const General general(at, 0, 0, crushing_mortar());
  const OverlapResponse& last = general.response;
  const double depth = general.after.crushed[0];
  // The length includes the parts of the block's sides below the surface.
  CHECK(near(last.force.y(), strength * last.length, 1e-3));
  CHECK(near(last.length, 1, 0.005));
  CHECK(near(depth, 5e-3 - first, 0.005));
  // Pressed from zero to its strength in this step.
  CHECK(near(last.lost_fracture, 0.5 * strength * depth, 0.01));
  CHECK((last.memory.state & contact_kept) != 0);
}
