// Fibre sections and fibre beams in space: exact elastic numbers, plastic moments about any axis, agreement with the
// plane beam, energies and tangents.
#include "element/beam/fibre_beam_3d.hpp"

#include <doctest/doctest.h>
#include <Eigen/Dense>

#include <cmath>
#include <random>

#include "geometry/space/random_convex_3d.hpp"
#include "near.hpp"

namespace trilith {
namespace {

using testing::near;
using testing::near_zero;

constexpr double steel = 2.1e11, strength = 3e8, beam_length = 2.0;

BilinearSteel ideal_steel() {
  BilinearSteel law;
  law.young = steel, law.yield = strength, law.hardening = 0;
  return law;
}

FibreSection3 cut(const FibreShape& shape, const UniaxialLaw& law, std::array<int, 2> cells = {}) {
  FibreSpec spec{shape, law};
  spec.cells = cells;
  return make_fibres_in_space(spec);
}

/// A section with prescribed strains, with its history.
struct LedSection3 {
  FibreSection3 section;
  std::vector<double> memory = std::vector<double>(static_cast<std::size_t>(section.memory_size()), 0.0), next = memory;

  SectionResponse3 to(const Eigen::Vector3d& strain) {
    const SectionResponse3 r = respond(section, strain, memory, next);
    memory = next;
    return r;
  }
};

/// Section forces at curvatures so large that nearly all fibres yield, at zero axial strain of the centroid.
Eigen::Vector3d flowing(const FibreSection3& section, double about_y, double about_z) {
  return LedSection3{section}.to({0, about_y, about_z}).stress;
}

struct LedBeam3 {
  FibreSection3 section;
  FibreBeam3 beam;
  std::vector<double> memory = std::vector<double>(static_cast<std::size_t>(beam.memory_size(section)), 0.0),
                      next = memory;
  BeamStrain3 at{};
  FibreBeamResponse3 now{};
  double work = 0, lost = 0;

  FibreBeamResponse3 probe(const BeamStrain3& d) { return respond(beam, section, d, memory, next); }
  void to(const BeamStrain3& d) {
    const FibreBeamResponse3 r = probe(d);
    for (std::size_t k = 0; k < 6; ++k) work += 0.5 * (r.stress[k] + now.stress[k]) * (d[k] - at[k]);
    lost += r.dissipated, at = d, now = r, memory = next;
  }
};

const RectangleSection led_profile{0.1, 0.2};

LedBeam3 led_beam(const UniaxialLaw& law, const std::array<bool, 2>& pinned = {},
                  const std::array<double, 2>& shear = {}, double torsion = 0) {
  FibreSection3 section = cut(led_profile, law, {6, 4});
  const FibreBeam3 beam = make_fibre_beam_in_space(section, beam_length, pinned, shear, torsion);
  return {section, beam};
}

BeamStrain3 random_space_strain(std::mt19937_64& bits, double size) {
  std::uniform_real_distribution<double> chance(-size, size);
  BeamStrain3 d;
  for (double& v : d) v = chance(bits);
  d[0] *= beam_length;
  return d;
}

}  // namespace

TEST_CASE("fibres in space have the area and both second moments of any shape by any number of cells") {
  ISection girder;
  girder.depth = 0.4, girder.web = 0.01, girder.top_width = 0.2, girder.top_thickness = 0.02;
  girder.bottom_width = 0.3, girder.bottom_thickness = 0.03;
  BoxSection box;
  box.width = 2, box.depth = 1.2, box.webs = 0.6, box.top = 0.25, box.bottom = 0.2;
  TSection tee;
  tee.depth = 0.5, tee.web = 0.2, tee.width = 0.8, tee.thickness = 0.15;
  const SectionOutline diamond{{{0, 0}, {0.5, 0.7}, {0, 1.4}, {-0.5, 0.7}}};
  for (const std::array<int, 2>& cells : {std::array{0, 0}, {1, 1}, {5, 3}, {12, 7}}) {
    const auto check = [&](const FibreShape& shape, const Section3& exact, double allowed) {
      const Eigen::Matrix3d k = cut(shape, UniaxialElastic{1}, cells).stiffest();
      CHECK(near(k(0, 0), exact.area, allowed));
      CHECK(near(k(1, 1), exact.second_moment[0], allowed));
      CHECK(near(k(2, 2), exact.second_moment[1], allowed));
      CHECK(near_zero(k(0, 1) / std::sqrt(k(0, 0) * k(1, 1)), 1e-12));
      CHECK(near_zero(k(0, 2) / std::sqrt(k(0, 0) * k(2, 2)), 1e-12));
    };
    check(led_profile, section_in_space(led_profile), 1e-12);
    check(girder, section_in_space(girder), 1e-12);
    check(box, section_in_space(box), 1e-12);
    check(tee, section_in_space(tee), 1e-12);
    check(diamond, polygon_section_in_space(diamond.outline), 1e-12);
    check(CircleSection{0.9, 0}, section_in_space(CircleSection{0.9, 0}), 2e-6);
    check(CircleSection{0.9, 0.5}, section_in_space(CircleSection{0.9, 0.5}), 2e-6);
  }
}

TEST_CASE("core and cover together are the section, and bars are at their given positions") {
  for (const FibreShape& shape : {FibreShape(RectangleSection{0.6, 0.9}), FibreShape(CircleSection{0.9, 0})}) {
    FibreSpec spec{shape, UniaxialElastic{3}};
    spec.cover = 0.05, spec.cover_law = UniaxialElastic{1};
    const FibreSection3 both = make_fibres_in_space(spec);
    FibreSpec core{core_of(shape, 0.05), UniaxialElastic{2}};
    const Eigen::Matrix3d whole = cut(shape, UniaxialElastic{1}).stiffest(),
                          more = make_fibres_in_space(core).stiffest();
    CHECK((both.stiffest() - whole - more).norm() < 1e-5 * whole.norm());
  }
  FibreSpec barred{RectangleSection{0.6, 0.9}, UniaxialElastic{1}};
  barred.bars = {{.area = 4e-3, .height = 0.05, .count = 4, .across = 0, .spread = 0.48},
                 {.area = 1e-3, .height = 0.45, .count = 1, .across = 0.25, .spread = 0}};
  barred.bar_law = UniaxialElastic{steel};
  const FibreSection3 section = make_fibres_in_space(barred);
  REQUIRE(section.parts.back().count == 5);
  const auto bar = section.fibres.end() - 5;
  CHECK(near(bar[0].across, -0.24, 1e-12));
  CHECK(near(bar[1].across, -0.08, 1e-12));
  CHECK(near(bar[3].across, 0.24, 1e-12));
  CHECK(near(bar[0].up, -0.4, 1e-12));
  CHECK(near(bar[4].across, 0.25, 1e-12));
  CHECK(near(bar[0].area, 1e-3, 1e-12));
  barred.bars[0].spread = 0.7;
  CHECK_THROWS_WITH_AS(
      make_fibres_in_space(barred),
      "fibres: bars at 0 m across, spread over 0.7 m, stand outside of the section, which is 0.6 m wide", InputError);
}

TEST_CASE("a plastic section has its plastic moment about both axes and the diagonal") {
  const double far = 1e3, a = 0.2;
  const FibreSection3 upright = cut(led_profile, ideal_steel(), {20, 20});
  CHECK(near(flowing(upright, 0, far)[2], strength * 0.1 * 0.2 * 0.2 / 4, 1e-3));
  CHECK(near(flowing(upright, far, 0)[1], strength * 0.2 * 0.1 * 0.1 / 4, 1e-3));
  // A square about its diagonal: a^3 sqrt(2)/6 times the strength.
  const Eigen::Vector3d s = flowing(cut(RectangleSection{a, a}, ideal_steel(), {40, 40}), far, far);
  CHECK(near(std::hypot(s[1], s[2]), strength * a * a * a * std::sqrt(2.0) / 6, 2e-3));
  CHECK(near(s[1], s[2], 1e-9));
  // A pipe about any axis: (D^3 - d^3)/6 times the strength.
  for (const double angle : {0.0, 0.4, 1.1}) {
    const Eigen::Vector3d m =
        flowing(cut(CircleSection{0.5, 0.4}, ideal_steel(), {40, 40}), far * std::cos(angle), far * std::sin(angle));
    CHECK(near(std::hypot(m[1], m[2]), strength * (0.125 - 0.064) / 6, 5e-3));
  }
}

TEST_CASE("the plastic moment of a rectangle falls with the square of the normal force") {
  const double squash = strength * 0.1 * 0.2, plastic = strength * 0.1 * 0.2 * 0.2 / 4, curvature = 1e3;
  const FibreSection3 section = cut(led_profile, ideal_steel(), {40, 4});
  for (const double share : {0.25, 0.5, 0.8}) {
    // The neutral axis is share/2 of the depth from the centroid.
    const SectionResponse3 r = LedSection3{section}.to({curvature * share * 0.1, 0, curvature});
    CHECK(near(r.stress[0], share * squash, 1e-3));
    CHECK(near(r.stress[2], (1 - share * share) * plastic, 2e-3));
  }
}

TEST_CASE("a beam of elastic fibres is the elastic beam in space") {
  std::mt19937_64 bits(5);
  const double shear_modulus = 8e10;
  const Section3 numbers = section_in_space(led_profile);
  for (const std::array<bool, 2>& pinned : {std::array{false, false}, {true, false}, {false, true}, {true, true}})
    for (const bool shears : {false, true}) {
      const BeamStiffness3 exact =
          beam_stiffness_in_space({steel, shear_modulus, shears}, numbers, beam_length, pinned);
      const std::array<double, 2> shear{shears ? shear_modulus * numbers.shear_area[0] : 0,
                                        shears ? shear_modulus * numbers.shear_area[1] : 0};
      LedBeam3 led = led_beam(UniaxialElastic{steel}, pinned, shear, shear_modulus * numbers.torsion);
      for (int i = 0; i < 20; ++i) {
        const BeamStrain3 d = random_space_strain(bits, 0.02);
        const FibreBeamResponse3 r = led.probe(d);
        const BeamStress3 s = stress_of(exact, d);
        const double size = std::max(std::abs(s[0]) * beam_length, std::abs(s[1]) + std::abs(s[2]) + std::abs(s[5]));
        for (std::size_t k = 0; k < 6; ++k) CHECK(near_zero(r.stress[k] - s[k], 1e-10 * size));
        CHECK(near(r.stored, stored_in(exact, d), 1e-10));
        CHECK_FALSE(r.yielding);
      }
      const BeamStiffness3 most = stiffest_beam(led.beam, led.section);
      CHECK(near(most.axial, exact.axial, 1e-9));
      CHECK(near(most.torsion, exact.torsion, 1e-9));
      for (const std::size_t axis : {0U, 1U})
        for (const std::size_t k : {0U, 1U, 2U})
          CHECK(near_zero(most.bend[axis].bend[k] - exact.bend[axis].bend[k], 1e-9 * exact.bend[axis].bend[0] + 1e-6));
    }
}

TEST_CASE("bent about z alone a beam of fibres in space equals the beam in the plane") {
  const FibreSection3 section = cut(led_profile, ideal_steel(), {20, 1});
  const FibreSection flat = make_fibres({led_profile, ideal_steel(), 20});
  LedBeam3 led{section, make_fibre_beam_in_space(section, beam_length, {}, {}, 0)};
  const FibreBeam plane = make_fibre_beam(flat, beam_length, {});
  std::vector<double> memory(static_cast<std::size_t>(plane.memory_size(flat)), 0.0), next = memory;
  for (int i = 1; i <= 60; ++i) {
    const double way = std::sin(0.2 * i), u = 2e-3 * way, from = 0.03 * way, to = -0.02 * way;
    led.to({u, 0, from, 0, to, 0});
    const FibreBeamResponse r = respond(plane, flat, {u, from, to}, memory, next);
    memory = next;
    CHECK(near(led.now.stress[0], r.stress[0], 1e-9));
    CHECK(near_zero(led.now.stress[2] - r.stress[1], 1e-9 * strength * 1e-3));
    CHECK(near_zero(led.now.stress[4] - r.stress[2], 1e-9 * strength * 1e-3));
    CHECK(near_zero(led.now.stress[1], 1e-6));
    CHECK(near(led.now.stored, r.stored, 1e-9));
    CHECK(led.now.yielding == r.yielding);
  }
}

TEST_CASE("the tangent of a beam of fibres in space is the derivative of its stress") {
  std::mt19937_64 bits(8);
  BilinearSteel hard = ideal_steel();
  hard.hardening = 0.05;
  LedBeam3 led = led_beam(hard, {}, {5e8, 7e8}, 1e6);
  for (int i = 0; i < 12; ++i) {
    led.to(random_space_strain(bits, 0.01));
    const BeamStrain3 at = random_space_strain(bits, 0.01);
    const FibreBeamResponse3 here = led.probe(at);
    Eigen::Matrix<double, 6, 6> differences;
    for (std::size_t j = 0; j < 6; ++j) {
      const double by = 1e-9;
      BeamStrain3 ahead = at, behind = at;
      ahead[j] += by, behind[j] -= by;
      const FibreBeamResponse3 p = led.probe(ahead), q = led.probe(behind);
      for (std::size_t k = 0; k < 6; ++k)
        differences(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) =
            (p.stress[k] - q.stress[k]) / (2 * by);
    }
    CHECK((differences - here.tangent).norm() < 1e-5 * here.tangent.norm());
    CHECK((here.tangent - here.tangent.transpose()).norm() < 1e-12 * here.tangent.norm());
  }
}

TEST_CASE("work on a beam of fibres in space is stored or dissipated") {
  std::mt19937_64 bits(4);
  LedBeam3 led = led_beam(ideal_steel(), {}, {5e8, 7e8}, 1e6);
  for (int leg = 0; leg < 10; ++leg) {
    const BeamStrain3 from = led.at, to = random_space_strain(bits, 0.02);
    for (int i = 1; i <= 400; ++i) {
      BeamStrain3 d;
      for (std::size_t k = 0; k < 6; ++k) d[k] = from[k] + (to[k] - from[k]) * i / 400;
      led.to(d);
      REQUIRE(led.now.dissipated >= -1e-12 * led.work);
    }
  }
  CHECK(led.lost > 0.5 * led.work);
  CHECK(near_zero(led.work - led.now.stored - led.lost, 1e-4 * led.work));
}

}  // namespace trilith
