// Fibre beams: agreement with the elastic beam, energies, tangents, plastic moments.
#include "element/beam/fibre_beam.hpp"

#include <doctest/doctest.h>
#include <Eigen/Dense>

#include <cmath>
#include <random>

#include "geometry/plane/random_convex.hpp"
#include "near.hpp"

namespace trilith {
namespace {

using testing::near;
using testing::near_zero;

constexpr double young = 2.1e11, span = 2.0;
const RectangleSection profile{0.1, 0.2};

struct LedBeam {
  FibreSection section;
  FibreBeam beam;
  std::vector<double> memory = std::vector<double>(beam.memory_size(section), 0.0), next = memory;
  BeamStrain at = {};
  FibreBeamResponse now = {};
  double work = 0, lost = 0;

  FibreBeamResponse probe(const BeamStrain& d) { return respond(beam, section, d, memory, next); }
  void to(const BeamStrain& d) {
    const FibreBeamResponse r = probe(d);
    for (int k = 0; k < 3; ++k) work += 0.5 * (r.stress[k] + now.stress[k]) * (d[k] - at[k]);
    lost += r.dissipated, at = d, now = r, memory = next;
  }
  void along(const BeamStrain& d, int steps) {
    const BeamStrain from = at;
    for (int i = 1; i <= steps; ++i) {
      BeamStrain next_d;
      for (int k = 0; k < 3; ++k) next_d[k] = from[k] + (d[k] - from[k]) * i / steps;
      to(next_d);
    }
  }
};

LedBeam beam_of(const UniaxialLaw& law, const std::array<bool, 2>& pinned, BeamRule rule = BeamRule::lobatto,
                int stations = 4, double shear = 0) {
  FibreSection section = make_fibres({profile, law, 20});
  const FibreBeam beam = make_fibre_beam(section, span, pinned, shear, rule, stations);
  return {section, beam};
}

}  // namespace

TEST_CASE("a beam of elastic fibres is the elastic beam, pinned or not, with shear or without, by any rule") {
  const Section numbers = profile.numbers();
  const double shear_modulus = 8e10;
  std::mt19937_64 bits(2);
  for (const std::array<bool, 2>& pinned : {std::array{false, false}, {true, false}, {false, true}, {true, true}})
    for (const bool shear : {false, true}) {
      const BeamStiffness k = beam_stiffness({young, shear ? shear_modulus : 0}, numbers, span, pinned);
      for (const auto& [rule, least] : {std::pair(BeamRule::lobatto, 3), {BeamRule::gauss, 2}})
        for (int stations = least; stations < least + 4; ++stations) {
          LedBeam led =
              beam_of(UniaxialElastic{young}, pinned, rule, stations, shear ? shear_modulus * numbers.shear_area : 0);
          const BeamStrain d{random_between(bits, -1e-3, 1e-3), random_between(bits, -0.02, 0.02),
                             random_between(bits, -0.02, 0.02)};
          led.to(d);
          const BeamStress expected = stress_of(k, d);
          const double size = std::abs(expected[0]) * span + std::abs(expected[1]) + std::abs(expected[2]);
          for (int i = 0; i < 3; ++i) CHECK(near_zero(led.now.stress[i] - expected[i], 1e-12 * size));
          CHECK(near(led.now.stored, stored_in(k, d), 1e-12));
          CHECK(led.now.dissipated == 0);
        }
    }
}

TEST_CASE("the tangent of a beam of fibres matches finite differences, with its bow") {
  std::mt19937_64 bits(12);
  for (const UniaxialLaw& law :
       {UniaxialLaw(MenegottoPinto{young, 3e8, 0.02, 20, 0.925, 0.15, 0, 1}), UniaxialLaw(KentPark::sample())})
    for (const std::array<bool, 2>& pinned : {std::array{false, false}, {true, false}}) {
      LedBeam led = beam_of(law, pinned, BeamRule::lobatto, 4, 1e9);
      for (int i = 0; i < 40; ++i) {
        const BeamStrain d{random_between(bits, -2e-3, 1e-3), random_between(bits, -0.02, 0.02),
                           random_between(bits, -0.02, 0.02)};
        const FibreBeamResponse r = led.probe(d);
        const double h = 1e-9;
        Eigen::Matrix3d k;
        for (int c = 0; c < 3; ++c) {
          BeamStrain up = d, down = d;
          up[c] += h, down[c] -= h;
          const FibreBeamResponse a = led.probe(up), b = led.probe(down);
          for (int row = 0; row < 3; ++row) k(row, c) = (a.stress[row] - b.stress[row]) / (2 * h);
        }
        CHECK(near_zero((k - r.tangent).norm() / r.tangent.norm(), 1e-6));
        CHECK(near_zero((r.tangent - r.tangent.transpose()).norm() / r.tangent.norm(), 1e-12));
        led.to(d);
      }
    }
}

TEST_CASE("work on a beam of fibres is stored or dissipated: exactly without bow, with it to the square of the step") {
  for (const bool bowed : {false, true}) {
    double before = 0;
    for (const int steps : {100, 200}) {
      LedBeam led = beam_of(BilinearSteel{young, 3e8, 0.02, 0.3}, {false, false});
      if (!bowed) led.beam.bow = {};
      for (const BeamStrain& d : {BeamStrain{1e-3, 0.03, 0.01}, {-2e-3, -0.02, 0.03}, {0, 0, 0}}) led.along(d, steps);
      const double off = std::abs(led.work - led.now.stored - led.lost) / led.work;
      MESSAGE("bow " << bowed << ", " << steps << " steps: missing " << off << " of the work");
      if (!bowed) CHECK(off < 1e-12);
      if (bowed) CHECK(off < 1e-3);
      if (bowed && before > 0) CHECK(off < 0.3 * before);
      before = off;
    }
  }
}

TEST_CASE("the stiffest beam is the elastic one, and no tangent of a beam with bars on one side is above it") {
  const Section numbers = profile.numbers();
  const LedBeam elastic =
      beam_of(UniaxialElastic{young}, {false, true}, BeamRule::lobatto, 3, 8e10 * numbers.shear_area);
  const BeamStiffness expected = beam_stiffness({young, 8e10}, numbers, span, {false, true}),
                      bound = stiffest_beam(elastic.beam, elastic.section);
  CHECK(near(bound.axial, expected.axial, 1e-12));
  for (int i = 0; i < 3; ++i) {
    CHECK(near_zero(bound.bend[i] - expected.bend[i], 1e-12 * expected.bend[0]));
    CHECK(near_zero(bound.bow[i] - expected.bow[i], 1e-12 * span));
  }
  FibreSpec spec{profile, KentPark::sample()};
  spec.bars = {{1e-3, 0.03}}, spec.bar_law = BilinearSteel{young, 4e8, 0.01, 0};
  const FibreSection section = make_fibres(spec);
  LedBeam led{section, make_fibre_beam(section, span, {false, false})};
  led.beam.bow = {};
  const BeamStiffness most = stiffest_beam(led.beam, section);
  Eigen::Matrix3d above = Eigen::Matrix3d::Zero();
  above(0, 0) = most.axial, above(1, 1) = most.bend[0], above(2, 2) = most.bend[2];
  above(1, 2) = above(2, 1) = most.bend[1];
  std::mt19937_64 bits(21);
  for (int i = 0; i < 200; ++i) {
    led.to({random_between(bits, -4e-3, 1e-3), random_between(bits, -0.02, 0.02), random_between(bits, -0.02, 0.02)});
    const Eigen::Vector3d least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(above - led.now.tangent).eigenvalues();
    CHECK(least[0] >= -1e-9 * above.norm());
  }
}

TEST_CASE("a beam bent evenly carries the plastic moment, as its section does") {
  LedBeam led = beam_of(BilinearSteel{young, 240e6, 0, 0}, {false, false});
  led.beam.bow = {};
  const double phi_y = 0.08 / 7;
  for (const double ratio : {1.5, 3.0, 5.0}) {
    const double bend = 0.5 * ratio * phi_y * span;
    led.along({0, -bend, bend}, 50);
    CHECK(near(led.now.stress[2], 160e3 * (1.5 - 0.5 / (ratio * ratio)), 0.005));
    CHECK(near(led.now.stress[1], -led.now.stress[2], 1e-12));
  }
}

TEST_CASE("many short beams of fibres model a yielding cantilever: the end rotation follows from the moments") {
  // Tip load up to 0.9 of the plastic one; curvature by the closed form of the rectangle, integrated twice.
  const int count = 16;
  const double h = span / count, moment_y = 160e3, tip = 0.9 * 1.5 * moment_y / span, phi_y = 0.08 / 7;
  const FibreSection section = make_fibres({profile, BilinearSteel{young, 240e6, 0, 0}, 40});
  const FibreBeam beam = make_fibre_beam(section, h, {false, false}, 0, BeamRule::lobatto, 4);
  const std::size_t size = beam.memory_size(section);
  std::vector<double> zero(size, 0.0), next(size);
  // Element by element from the fixed end: shear forces and moments are known, so each element yields its own end
  // rotations.
  double deflection = 0, turn = 0;
  for (int i = 0; i < count; ++i) {
    const double near_moment = tip * (span - i * h), far_moment = tip * (span - (i + 1) * h);
    BeamStrain d{};
    std::vector<double> memory = zero;
    for (int step = 1; step <= 20; ++step) {
      FibreBeamResponse r;
      for (int turns = 0; turns < 50; ++turns) {
        r = respond(beam, section, d, memory, next);
        const Eigen::Vector3d left(-r.stress[0], -near_moment * step / 20 - r.stress[1],
                                   far_moment * step / 20 - r.stress[2]);
        if (left.norm() < 1e-3) break;
        const Eigen::Vector3d go = r.tangent.partialPivLu().solve(left);
        for (int k = 0; k < 3; ++k) d[k] += go[k];
      }
      memory = next;
    }
    // End 0 rotates with the elements before it; the chord rotates by turn - theta_0.
    const double chord = turn - d[1];
    deflection += chord * h, turn = chord + d[2];
  }
  double expected = 0;
  const int parts = 200000;
  for (int i = 0; i < parts; ++i) {
    const double x = span * (i + 0.5) / parts, m = tip * x / moment_y;
    expected += (m <= 1 ? m : 1 / std::sqrt(3 - 2 * m)) * phi_y * x * span / parts;
  }
  MESSAGE("cantilever: tip " << deflection << " m, closed form " << expected);
  CHECK(near(deflection, expected, 0.005));
}

TEST_CASE("unknown integration rules are rejected") {
  const FibreSection section = make_fibres({profile, UniaxialElastic{young}});
  CHECK_THROWS_AS(make_fibre_beam(section, span, {false, false}, 0, BeamRule::lobatto, 2), InputError);
  CHECK_THROWS_AS(make_fibre_beam(section, span, {false, false}, 0, BeamRule::gauss, 6), InputError);
  CHECK_THROWS_AS(make_fibre_beam(section, 0, {false, false}), InputError);
}

}  // namespace trilith
