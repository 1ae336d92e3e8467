// Contact with a force proportional to a power of the penetration: closed forms of faces, energy, and an impact.
#include "law/contact/power.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "contact/face_scene.hpp"
#include "contact/joint/face_resultant.hpp"
#include "contact/plane/overlap_energy.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double secant = 1e8, reach = 1e-3;

Power power_law(double exponent, double beta = 0) {
  return {secant, reach, exponent, 0, 0, beta};
}

/// Two fixed faces of 1 m with the gaps `at_left` and `at_right` at their ends.
Faces power_faces(double at_left, double at_right) {
  return {rigid_face({1, 0}, {0, 0}, Vec2::Zero(), 0), rigid_face({0, at_left}, {1, at_right}, Vec2::Zero(), 0)};
}

double pressed_by(const Faces& f, const Power& law) {
  const auto r = respond_fresh(f, no_memory(), Power::Kernel(law, 1, 1e-4));
  return (on_b0(r) + on_b1(r)).y();
}

}  // namespace

TEST_CASE("even faces press by kn d (overlap/d)^n, and by kn at an overlap of d") {
  for (const double exponent : {1.0, 1.5, 2.0, 2.7})
    for (const double overlap : {1e-5, 1e-4, reach, 3e-3}) {
      const double expected = secant * reach * std::pow(overlap / reach, exponent);
      CHECK(near(pressed_by(power_faces(-overlap, -overlap), power_law(exponent)), expected, 1e-12));
    }
  CHECK(pressed_by(power_faces(1e-6, 1e-6), power_law(1.5)) == 0);
}

TEST_CASE("faces that touch along a part of them press by the integral of the power") {
  // The penetration falls from 2 mm to zero over 0.8 m; the tilt is within the limit of flat contact.
  for (const double exponent : {1.0, 1.5, 2.0, 3.0}) {
    const double most = 2e-3, slope = most / 0.8;
    const double expected =
        secant * std::pow(reach, 1 - exponent) * std::pow(most, exponent + 1) / (slope * (exponent + 1));
    CHECK(near(pressed_by(power_faces(-most, -most + slope), power_law(exponent)), expected, 2e-5));
  }
}

TEST_CASE("with the exponent 1 the power law has the forces of the frictional one") {
  std::mt19937_64 bits(3);
  const Power::Kernel power({secant, reach, 1, 4e7, 0.6, 1e-3}, 1, 1e-4);
  const Coulomb linear(Frictional{secant, 4e7, 0.6, 1e-3}, 1, 1e-4);
  for (int i = 0; i < 500; ++i) {
    const Faces f = random_faces(bits, -5e-3, -3e-3, 1e-4);  // closed over the full length, also with damping
    const auto a = respond_fresh(f, no_memory(), power);
    const auto b = respond_fresh(f, no_memory(), linear);
    const double size = (on_b0(b) + on_b1(b)).norm();
    CHECK((on_b0(a) - on_b0(b)).norm() <= 1e-9 * size);
    CHECK((on_b1(a) - on_b1(b)).norm() <= 1e-9 * size);
  }
}

TEST_CASE("the force of a power contact of any shape is the gradient of its energy") {
  const Polygon lower{{-1, -1}, {1, -1}, {1, 0}, {-1, 0}}, upper{{-0.5, 0}, {0.5, 0}, {0.5, 1}, {-0.5, 1}};
  const std::vector<std::uint8_t> all(4, 1);
  const ContactLaw law = power_law(1.5);
  const auto at = [&](double y, bool energy) {
    Polygon corners;
    for (const Vec2& p : upper) corners.push_back(Vec2(0.1, y) + Turn(0.3).apply(p));
    const PlacedPiece a{lower, all, Vec2(0, -0.5), Vec2::Zero(), 0}, b{corners, all, Vec2(0.1, y), Vec2::Zero(), 0};
    if (energy) return overlap_energy(a, b, {law});
    std::vector<Vec2> on_a(4, Vec2::Zero()), on_b(4, Vec2::Zero());
    return respond_overlap(a, b, {{}, nullptr}, {law}, on_a, on_b, nullptr).force.y();
  };
  const double touching = 0.5 * std::sin(0.3), h = 1e-6;
  for (const double down : {5e-3, 2e-2, 5e-2}) {
    const double y = touching - down, slope = (at(y - h, true) - at(y + h, true)) / (2 * h);
    CHECK(near(at(y, false), slope, 2e-3));
  }
}

TEST_CASE("a block that strikes a power contact reaches the depth of its energy and rebounds with its speed") {
  const double mass = 2000, speed = 0.5;
  for (const double exponent : {1.5, 2.0}) {
    Scene scene(power_law(exponent));
    scene.set_gravity(Vec2::Zero());
    scene.fixed("base", box(-2, -1, 2, 0));
    scene.block("block", box(-0.5, 1e-4, 0.5, 1 + 1e-4), mass, {0, -speed});
    Simulation<2> sim = scene.start();
    const int node = node_of(sim.model(), "block");
    const double begun = 0.5 * mass * speed * speed;  // kinetic energy at the start
    double lowest = 1, most = 0;
    run_for(sim, 0.1, 2e-5, each_step([&](const Instant<2>& now) {
              lowest = std::min(lowest, now.state.position[node].y());
              most = std::max(most, std::abs(sim.energy().balance() - begun));
            }));
    // m v^2 / 2 = kn d^(1-n) x^(n+1) / (n+1) on 1 m2.
    const double deepest = std::pow(
        0.5 * mass * speed * speed * (exponent + 1) * std::pow(reach, exponent - 1) / secant, 1 / (exponent + 1));
    CHECK(near(0.5 - lowest, deepest, 1e-3));
    CHECK(near(sim.state().velocity[node].y(), speed, 1e-3));
    CHECK(most < 1e-3 * begun);
  }
}
