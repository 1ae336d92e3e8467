// Fibre sections: shapes, elastic stiffness, moment-curvature relation (F9), cover and bars.
#include "element/section/fibre_section.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "geometry/plane/random_convex.hpp"
#include "law_sample.hpp"
#include "near.hpp"

namespace trilith {
namespace {

using testing::near;
using testing::near_zero;

constexpr double modulus = 2.1e11, yield_stress = 240e6;

std::vector<FibreShape> fibre_shapes() {
  return {RectangleSection{0.1, 0.2},
          CircleSection{0.5, 0},
          CircleSection{0.5, 0.4},
          ISection{0.4, 0.01, 0.2, 0.02, 0.3, 0.03},
          TSection{0.6, 0.2, 1.2, 0.15},
          BoxSection{2, 1.5, 0.6, 0.2, 0.25},
          SectionOutline{{{0, 0}, {1, 0}, {1, 0.3}, {0.6, 0.3}, {0.6, 1}, {1.4, 1}, {1.4, 1.2}, {0.2, 1.2}}}};
}

/// A section with prescribed strains.
struct LedSection {
  FibreSection section;
  std::vector<double> memory = std::vector<double>(section.memory_size(), 0.0), next = memory;
  SectionStrain at = {};
  SectionResponse now = {};
  double work = 0, lost = 0;

  SectionResponse probe(const SectionStrain& e) { return respond(section, e, memory, next); }
  void to(const SectionStrain& e) {
    const SectionResponse r = probe(e);
    work += 0.5 * (r.normal + now.normal) * (e.axial - at.axial) +
            0.5 * (r.moment + now.moment) * (e.curvature - at.curvature);
    lost += r.dissipated, at = e, now = r, memory = next;
  }
  /// To a curvature at a given normal force, by Newton's iteration on the axial strain.
  void balanced(double curvature, double normal) {
    SectionStrain e{at.axial, curvature};
    for (int i = 0; i < 60; ++i) {
      const SectionResponse r = probe(e);
      if (std::abs(r.normal - normal) < 1e-3) break;
      e.axial += (normal - r.normal) / r.tangent(0, 0);
    }
    to(e);
    CHECK(near_zero(now.normal - normal, 1));
  }
  void along(double curvature, double normal, int steps = 100) {
    const double from = at.curvature;
    for (int i = 1; i <= steps; ++i) balanced(from + (curvature - from) * i / steps, normal);
  }
};

FibreSection f9_section(int layers) {
  FibreSpec spec{RectangleSection{0.1, 0.2}, BilinearSteel{modulus, yield_stress, 0, 0}};
  spec.layers = layers;
  return make_fibres(spec);
}

}  // namespace

TEST_CASE("strips of a shape add up to its area, centroid and second moment, wherever it is cut") {
  for (const FibreShape& shape : fibre_shapes()) {
    const Section whole = section_of(shape);
    const double depth = whole.depth();
    for (const double cut : {0.01, 0.37, 0.5, 0.93}) {
      StripMoments m = strip_of(shape, 0, cut * depth);
      m += strip_of(shape, cut * depth, depth);
      CHECK(near(m.area, whole.area, 1e-12));
      CHECK(near(m.first / m.area, whole.below, 1e-12));
      CHECK(near(m.second - m.first * m.first / m.area, whole.second_moment, 1e-11));
    }
  }
}

TEST_CASE("elastic fibres have the stiffness of their section, however few the layers") {
  for (const FibreShape& shape : fibre_shapes())
    for (const int layers : {1, 7, 20}) {
      FibreSpec spec{shape, UniaxialElastic{modulus}};
      spec.layers = layers;
      const Section whole = section_of(shape);
      const Eigen::Matrix2d k = make_fibres(spec).stiffest();
      CHECK(near(k(0, 0), modulus * whole.area, 1e-12));
      CHECK(near(k(1, 1), modulus * whole.second_moment, 1e-11));
      CHECK(near_zero(k(0, 1), 1e-12 * modulus * whole.area * whole.depth()));
      LedSection led{make_fibres(spec)};
      led.to({1e-4, 2e-3});
      CHECK(near(led.now.normal, modulus * whole.area * 1e-4, 1e-10));
      CHECK(near(led.now.moment, modulus * whole.second_moment * 2e-3, 1e-10));
    }
}

TEST_CASE("core and cover together are the shape, and the core lies within the cover") {
  for (const FibreShape& shape : fibre_shapes()) {
    if (std::holds_alternative<SectionOutline>(shape)) continue;
    const Section whole = section_of(shape);
    const double cover = 0.004;
    FibreSpec spec{shape, UniaxialElastic{modulus}, 20, cover, UniaxialElastic{modulus}};
    FibreSection both = make_fibres(spec);
    CHECK(near(both.stiffest()(0, 0), modulus * whole.area, 1e-12));
    CHECK(near(both.stiffest()(1, 1), modulus * whole.second_moment, 1e-10));
    REQUIRE(both.parts.size() == 2);
    double area = 0;
    for (int i = 0; i < both.parts[0].count; ++i) area += both.fibres[i].area;
    CHECK(near(area, section_of(core_of(shape, cover)).area, 1e-11));
  }
  const FibreSpec none{RectangleSection{0.1, 0.2}, UniaxialElastic{modulus}, 20, 0.05, UniaxialElastic{modulus}};
  CHECK_THROWS_AS(make_fibres(none), InputError);
  CHECK_THROWS_AS(core_of(fibre_shapes().back(), 0.01), InputError);
  FibreSpec given{fibre_shapes().back(), UniaxialElastic{modulus}, 20, 0.05, UniaxialElastic{modulus}};
  given.core = SectionOutline{{{0.65, 0.05}, {0.95, 0.05}, {0.95, 0.25}, {0.65, 0.25}}};
  const Section whole = section_of(given.shape);
  CHECK(near(make_fibres(given).stiffest()(1, 1), modulus * whole.second_moment, 1e-10));
  given.core = RectangleSection{3, 1};
  CHECK_THROWS_AS(make_fibres(given), InputError);
}

TEST_CASE("F9: moment against curvature of a rectangle that yields, with 40 fibres") {
  const double phi_y = 2 * yield_stress / (modulus * 0.2), first_moment = yield_stress * 0.1 * 0.2 * 0.2 / 6;
  CHECK(near(phi_y, 0.0114286, 1e-5));
  CHECK(near(first_moment, 160e3, 1e-12));
  LedSection led{f9_section(20)};
  REQUIRE(led.section.fibres.size() == 40);
  for (const auto& [ratio, moment] : {std::pair(1.5, 1.27778), {2.0, 1.37500}, {3.0, 1.44444}, {5.0, 1.48000}}) {
    led.along(ratio * phi_y, 0);
    MESSAGE("F9 N = 0, " << ratio << " phi_y: M/My " << led.now.moment / first_moment << ", " << moment);
    CHECK(near(led.now.moment / first_moment, moment, 0.005));
  }
}

TEST_CASE("F9: with a normal force of 0.3 Np") {
  const double phi_y = 0.08 / 7, first_moment = 160e3, full = 4.8e6;
  LedSection led{f9_section(20)};
  for (int i = 1; i <= 10; ++i) led.balanced(0, 0.03 * i * full);
  struct Row {
    double ratio, moment, axial;
  };
  for (const Row& row :
       {Row{1, .92868, .32668}, Row{1.5, 1.14278, .45}, Row{2, 1.24, .6}, Row{3, 1.30944, .9}, Row{5, 1.345, 1.5}}) {
    led.along(row.ratio * phi_y, 0.3 * full);
    const double axial = led.at.axial * modulus / yield_stress;
    MESSAGE("F9 N = .3 Np, " << row.ratio << " phi_y: M/My " << led.now.moment / first_moment << ", " << row.moment
                             << "; e/ey " << axial << ", " << row.axial);
    CHECK(near(led.now.moment / first_moment, row.moment, 0.005));
    CHECK(near(axial, row.axial, 0.005));
  }
  led.along(100 * phi_y, 0.3 * full, 1000);
  CHECK(near(led.now.moment / first_moment, 1.5 * (1 - 0.09), 0.005));
}

TEST_CASE("F9: the residual curvature after unloading from 3 phi_y") {
  const double phi_y = 0.08 / 7;
  LedSection led{f9_section(20)};
  led.along(3 * phi_y, 0);
  double low = 0, high = 3 * phi_y;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (led.probe({0, middle}).moment < 0 ? low : high) = middle;
  }
  MESSAGE("F9 rest " << high / phi_y << " phi_y, 1.55556");
  CHECK(near(high / phi_y, 1.55556, 0.005));
}

TEST_CASE("the error of a yielding rectangle falls with the layers") {
  double before = 1;
  for (const int layers : {5, 20, 80}) {
    LedSection led{f9_section(layers)};
    led.along(2.3 * 0.08 / 7, 0);
    const double off = std::abs(led.now.moment / 160e3 - (1.5 - 0.5 / (2.3 * 2.3)));
    CHECK(off < before);
    before = off;
  }
  CHECK(before < 1e-4);
}

TEST_CASE("a reinforced section has the strength of its bars and its stress block") {
  // Bars of 2000 mm2 at 0.06 m of 0.6 m, width 0.3 m; at a large curvature steel yields and concrete is past its
  // parabola.
  const double steel_area = 2e-3, width = 0.3, depth = 0.6, fy = 500e6, fc = 30e6;
  FibreSpec spec{RectangleSection{width, depth}, KentPark{fc, 0.002, 0.9, 1, 1, 0, 0}};
  spec.layers = 200;
  spec.bars = {{steel_area, 0.06}};
  spec.bar_law = BilinearSteel{2e11, fy, 0, 0};
  LedSection led{make_fibres(spec)};
  led.along(0.03, 0, 300);
  // The parabola up to 0.002 has two thirds of the full block, over 0.002/k; the rest of the depth x is full.
  const double curved = 0.002 / 0.03, block = steel_area * fy / (width * fc), x = block + curved / 3;
  const double full = x - curved, force = width * fc;
  const double moment = force * full * (0.54 - full / 2) + force * curved * 2 / 3 * (0.54 - full - 0.375 * curved);
  MESSAGE("reinforced section " << led.now.moment << " N m, closed form " << moment);
  CHECK(near(led.now.moment, moment, 0.002));
}

TEST_CASE("stored plus dissipated energy of a section is its work, and its tangent matches finite differences") {
  std::mt19937_64 bits(8);
  UniaxialLaws::for_each([&]<class L>() {
    L law = testing::sample<L>({{"Pa", 2e11}, {"1", 0.3}});
    if constexpr (requires { law.yield; }) law.yield = 3e8;
    LedSection led{make_fibres({ISection{0.4, 0.05, 0.2, 0.05, 0.3, 0.06}, law, 4})};
    INFO(describe(law));
    double most = 0, fits = 0;
    for (int i = 0; i < 200; ++i) {
      const SectionStrain to{random_between(bits, -3e-3, 1e-3), random_between(bits, -0.02, 0.02)};
      Eigen::Matrix2d k;
      const double h = 1e-10;
      const SectionResponse r = led.probe(to), a = led.probe({to.axial + h, to.curvature}),
                            b = led.probe({to.axial - h, to.curvature}), c = led.probe({to.axial, to.curvature + h}),
                            d = led.probe({to.axial, to.curvature - h});
      k << a.normal - b.normal, c.normal - d.normal, a.moment - b.moment, c.moment - d.moment;
      if ((k / (2 * h) - r.tangent).norm() < 1e-6 * led.section.stiffest().norm()) ++fits;
      led.to(to);
      most = std::max(most, std::abs(led.work));
    }
    CHECK(near_zero(led.work - led.now.stored - led.lost, 1e-11 * most));
    CHECK(fits == 200);
  });
}

TEST_CASE("invalid fibres are rejected") {
  FibreSpec spec{RectangleSection{0.1, 0.2}, UniaxialElastic{modulus}};
  spec.layers = 0;
  CHECK_THROWS_AS(make_fibres(spec), InputError);
  spec.layers = 10, spec.bars = {{1e-4, 0.3}}, spec.bar_law = UniaxialElastic{modulus};
  CHECK_THROWS_AS(make_fibres(spec), InputError);
  spec.bars = {}, spec.law = UniaxialElastic{};
  CHECK_THROWS_AS(make_fibres(spec), InputError);
}

}  // namespace trilith
