#include "contact/space/solid_pressure.hpp"

#include <doctest/doctest.h>

#include "contact/space/solid_energy.hpp"
#include "geometry/space/random_convex_3d.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

PlacedSolid put(const ConvexSolid& solid, const UnitQuaternion& rotation, const Vec3& at) {
  PlacedSolid out;
  place(solid, Turn3(rotation), at, out);
  return out;
}

ContactLaw linear_law(double kn, double beta = 0) {
  Frictional law;
  law.kn = kn, law.beta = beta;
  return law;
}

ContactLaw hertz_law() {
  Power law;
  law.kn = 1e6, law.depth = 0.1, law.exponent = 1.5;
  return law;
}

SolidPressure pressure_of(const PlacedSolid& a, const PlacedSolid& b, const ContactLaw& law,
                          const Vec3& velocity = Vec3::Zero()) {
  SolidOverlapBuffer shared;
  solid_overlap(a, b, shared);
  return solid_pressure({a, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, {b, Vec3::Zero(), velocity, Vec3::Zero()}, {law},
                        shared);
}

double energy_of(const PlacedSolid& a, const PlacedSolid& b, const ContactLaw& law) {
  SolidOverlapBuffer shared, cell;
  return solid_energy(a, b, {law}, shared, cell);
}

ConvexSolid box(double x, double y, double z) {
  return convex_solid(box_solid(Vec3(-x, -y, -z) / 2, Vec3(x, y, z) / 2), "box");
}

ConvexSolid chance(std::mt19937_64& bits) {
  return convex_solid(
      random_count(bits, 0, 1) == 0 ? random_convex_solid(bits, {.slenderest = 2}) : random_prism(bits, 0.5, 1.5),
      "solid");
}

/// Checks that force and moment about the centre are the gradient of the energy, by central differences.
void check_gradient(const ContactLaw& law, std::uint64_t seed, int pairs, double h, double within) {
  std::mt19937_64 bits(seed);
  int touching = 0;
  while (touching < pairs) {
    const ConvexSolid sa = chance(bits), sb = chance(bits);
    const UnitQuaternion turn = random_rotation(bits);
    const Vec3 at = 0.8 * random_in_ball(bits);
    const PlacedSolid a = put(sa, {}, Vec3::Zero()), b = put(sb, turn, at);
    const SolidPressure p = pressure_of(a, b, law);
    if (!(p.area > 0) || p.force.norm() < 1e3) continue;
    ++touching;
    Vec3 force, moment;
    for (const int k : {0, 1, 2}) {
      const Vec3 e = Vec3::Unit(k);
      force[k] =
          -(energy_of(a, put(sb, turn, at + h * e), law) - energy_of(a, put(sb, turn, at - h * e), law)) / (2 * h);
      const auto turned = [&](double angle) {
        const UnitQuaternion q = rotation_by(angle * e);
        return energy_of(a, put(sb, q * turn, p.centre + Turn3(q).apply(at - p.centre)), law);
      };
      moment[k] = -(turned(h) - turned(-h)) / (2 * h);
    }
    CHECK((p.force - force).norm() <= within * force.norm());
    CHECK((p.moment - moment).norm() <= within * force.norm());
  }
}

}  // namespace

TEST_CASE("pressure of two solids is the gradient of its energy") {
  check_gradient(linear_law(1e6), 11, 60, 1e-5, 1e-5);
}

TEST_CASE("pressure of a law that is not linear is the gradient of its energy") {
  check_gradient(hertz_law(), 12, 30, 2e-3, 5e-3);  // the quadrature error is divided by the step here
}

TEST_CASE("two parallel faces have pressure stiffness times overlap, centred on the shared area") {
  const ConvexSolid a = box(2, 2, 1), b = box(1, 0.6, 1);
  const double overlap = 1e-4;
  const SolidPressure p =
      pressure_of(put(a, {}, Vec3(0, 0, -0.5)), put(b, {}, Vec3(0.1, -0.2, 0.5 - overlap)), linear_law(1e9));
  CHECK(near(p.force.z(), 1e9 * overlap * 0.6, 1e-3));
  CHECK(near_zero(p.force.x(), 1e-9 * p.force.z()));
  CHECK(near_zero(p.moment.norm(), 1e-6 * p.force.z()));
  CHECK(near(p.centre.x(), 0.1, 1e-6));
  CHECK(near(p.centre.y(), -0.2, 1e-6));
  CHECK(near(p.area, 0.6, 1e-3));
  CHECK(near(p.depth, overlap, 1e-9));
}

TEST_CASE("T7, T8: a joint under a force off its middle carries no tension, and its pressure is linear") {
  // The analysis gives the penetration; force, its point of action and the contact area must equal the table.
  struct Row {
    double wide, high, peak, slope_x, slope_y, at_x, at_y, area;
  };
  const double kn = 1e8;
  for (const Row& r :
       {Row{1, 1, 16e3, 6e-5, 6e-5, 0.05, 0.05, 1}, Row{1, 1, 22.045e3, 1.2055e-4, 1.2055e-4, 0.1, 0.1, 0.98532},
        Row{1, 1, 29.933e3, 2.6872e-4, 1.4202e-4, 0.2, 0.1, 0.83738},
        Row{1.2, 0.8, 40.118e3, 4.6025e-4, 1.5996e-4, 0.35, 0.05, 0.58610},
        Row{1, 1, 93.75e3, 1.1719e-3, 1.1719e-3, 0.3, 0.3, 0.32}}) {
    const ConvexSolid ground = box(4, 4, 1), block = box(r.wide, r.high, 1);
    // The bottom's corner at (wide, high) / 2 is deepest; rotation by slope_y about x and -slope_x about y.
    const UnitQuaternion turn = rotation_by({-r.slope_y, r.slope_x, 0});
    const Vec3 corner = Turn3(turn).apply(Vec3(r.wide / 2, r.high / 2, -0.5));
    const Vec3 at(0, 0, -r.peak / kn - corner.z());
    const SolidPressure p = pressure_of(put(ground, {}, Vec3(0, 0, -0.5)), put(block, turn, at), linear_law(kn));
    CHECK(near(p.force.z(), 10e3, 5e-3));
    CHECK(near(p.area, r.area, 5e-3));
    const Vec3 middle = Turn3(turn).apply(Vec3(0, 0, -0.5)) + at;
    CHECK(near_zero(p.centre.x() - middle.x() - r.at_x, 5e-3 * r.wide));
    CHECK(near_zero(p.centre.y() - middle.y() - r.at_y, 5e-3 * r.high));
  }
}

TEST_CASE("damping takes the power of its force, and never pulls") {
  const ConvexSolid a = box(2, 2, 1), b = box(1, 1, 1);
  const PlacedSolid below = put(a, {}, Vec3(0, 0, -0.5)), above = put(b, {}, Vec3(0, 0, 0.5 - 1e-4));
  const SolidPressure closing = pressure_of(below, above, linear_law(1e9, 1e-3), Vec3(0, 0, -0.05));
  CHECK(near(closing.force.z(), 1e9 * (1e-4 + 1e-3 * 0.05), 1e-3));
  CHECK(near(closing.damping.z(), 1e9 * 1e-3 * 0.05, 1e-3));
  CHECK(near(closing.damped, closing.damping.z() * 0.05, 1e-3));
  const SolidPressure parting = pressure_of(below, above, linear_law(1e9, 1e-3), Vec3(0, 0, 1));
  CHECK(parting.force.norm() < 1e-12 * closing.force.norm());
  CHECK(near(parting.damping.z(), -1e9 * 1e-4, 1e-3));
  CHECK(near(parting.damped, 1e9 * 1e-4, 1e-3));
}

TEST_CASE("T10: the mean distance of an area from its centroid equals the exact integral") {
  const auto gyration = [](double a, double b) { return (a * a + b * b) / 12; };
  const auto product = [](double a, double b) { return a * a * b * b / 144; };
  const auto exact = [](double a, double b) {
    const double d = std::sqrt(a * a + b * b);
    return (2 * a * b * d + a * a * a * std::log((b + d) / a) + b * b * b * std::log((a + d) / b)) / (12 * a * b);
  };
  CHECK(near(mean_distance(gyration(1, 1), product(1, 1)), 0.38260, 1e-2));
  for (const double b : {0.8, 0.5, 0.3, 0.1, 0.01})
    CHECK(near(mean_distance(gyration(1, b), product(1, b)), exact(1, b), 1.5e-2));
  CHECK(near(mean_distance(0.5, 0.0625), 2.0 / 3, 1e-2));  // a disc of radius 1
  // An equilateral triangle of side 1: six right triangles of height 1 / (2 sqrt 3) and 60 degrees about its middle.
  const double triangle = (2 * std::sqrt(3.0) + std::log(2 + std::sqrt(3.0))) / 18;
  CHECK(near(mean_distance(1.0 / 12, 1.0 / 576), triangle, 2.2e-2));
}
