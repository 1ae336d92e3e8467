// Laws of solids at one point, against closed forms.
#include <doctest/doctest.h>

#include <random>

#include "base/error.hpp"
#include "law/material/list.hpp"
#include "law_sample.hpp"
#include "near.hpp"

namespace trilith {
namespace {

constexpr double young = 30e9, poisson = 0.2;

using testing::near;
using testing::near_zero;

/// Of a brittle solid; the law's own numbers in addition to Young's modulus and Poisson's ratio.
const testing::UsualNumbers usual_in_solids{{"Pa", 3e6}, {"rad", 0.5}, {"1", 0.2}, {"s", 0}};

/// Calls f with each sample of every law that is not elastic.
template <class F>
void for_each_plastic(F&& f) {
  SolidLaws::for_each([&]<class L>() {
    if constexpr (!L::is_elastic)
      for (L& law : testing::samples<L>(usual_in_solids)) {
        law.young = young, law.poisson = poisson;
        INFO(describe(law));
        f(law);
      }
  });
}

/// Follows a path of strains and checks the return mapping and the dissipation at each step.
template <class Law, class Path>
PointResponse walk(const Law& law, Plane plane, int steps, Path&& path, double size) {
  PointResponse r;
  double dissipated = 0, given = 0;
  PlaneVector before = PlaneVector::Zero(), strain;
  PlaneVector stress = PlaneVector::Zero();
  for (int i = 1; i <= steps; ++i) {
    strain = path(static_cast<double>(i) / steps);
    r = law.respond(plane, strain, r.memory);
    CHECK(r.dissipated >= 0);
    dissipated += r.dissipated;
    given += 0.5 * (stress + r.stress.in_plane()).dot(strain - before);
    before = strain, stress = r.stress.in_plane();
    // The point stays on its surface: the same strain again gives the same stress, without further flow.
    const PointResponse again = law.respond(plane, strain, r.memory);
    CHECK(near_zero((again.stress.in_plane() - r.stress.in_plane()).norm(), 1e-10 * size));
    CHECK(near_zero(again.dissipated, 1e-10 * size));
    if constexpr (requires { law.excess(r.stress); }) CHECK(law.excess(r.stress) <= 1e-10 * size);
    if constexpr (requires { law.excess(r.stress, r.memory.measure); })
      CHECK(law.excess(r.stress, r.memory.measure) <= 1e-10 * size);
  }
  // The work is stored or dissipated, except for the error of the step length.
  CHECK(near(r.stored + dissipated, given, 1e-3));
  return r;
}

TEST_CASE("J2 in uniaxial plane stress yields at its yield stress and hardens with E H/(E + H)") {
  const J2 law{young, poisson, 20e6, 5e9};
  const double most = 2e-3;
  // The lateral strain is free: found so that its stress is 0 at each step.
  PlasticMemory memory;
  PointResponse r;
  double across = 0;
  for (int i = 1; i <= 400; ++i) {
    const double along = most * i / 400;
    double low = across - 2 * most, high = across + 2 * most;
    for (int k = 0; k < 100; ++k) {
      across = 0.5 * (low + high);
      r = law.respond(Plane::stress, {along, across, 0}, memory);
      (r.stress.yy > 0 ? high : low) = across;
    }
    memory = r.memory;
  }
  const double expected = 20e6 + young * 5e9 / (young + 5e9) * (most - 20e6 / young);
  CHECK(near(r.stress.xx, expected, 1e-6));
}

TEST_CASE("J2 in pure shear yields at yield/sqrt(3) in plane stress and in plane strain") {
  const J2 law{young, poisson, 20e6, 0};
  for (const Plane plane : {Plane::stress, Plane::strain}) {
    const PointResponse r = walk(
        law, plane, 1000, [](double s) { return PlaneVector(0, 0, 5e-3 * s); }, 20e6);
    CHECK(near(r.stress.xy, 20e6 / std::sqrt(3.0), 1e-10));
  }
}

TEST_CASE("Mohr-Coulomb in uniaxial compression and tension yields at its closed forms") {
  const double friction = 35 * M_PI / 180, c = 5e6, squeeze = 2 * c * std::cos(friction) / (1 - std::sin(friction)),
               pull = 2 * c * std::cos(friction) / (1 + std::sin(friction));
  MohrCoulomb law{young, poisson, c, friction, 0.1};
  // Far beyond the limit the lateral strain is free: the law's own flow keeps the lateral stress at 0.
  const auto along = [&](double sign, const MohrCoulomb& l) {
    PlasticMemory memory;
    PointResponse r;
    for (int i = 1; i <= 200; ++i) {
      const double e = sign * 4e-3 * i / 200;
      double low = -0.05, high = 0.05;
      for (int k = 0; k < 120; ++k) {
        const double across = 0.5 * (low + high);
        r = l.respond(Plane::stress, {e, across, 0}, memory);
        (r.stress.yy > 0 ? high : low) = across;
      }
      memory = r.memory;
    }
    return r.stress.xx;
  };
  CHECK(near(-along(-1, law), squeeze, 1e-6));
  CHECK(near(along(1, law), pull, 1e-6));
  law.tension = 1e6;
  CHECK(near(along(1, law), 1e6, 1e-6));
}

TEST_CASE("Mohr-Coulomb and Drucker-Prager in plane strain shear yield at c cos(phi) without mean stress") {
  const double friction = 30 * M_PI / 180, c = 5e6;
  const MohrCoulomb mc{young, poisson, c, friction, 0};
  const auto shear = [](double s) { return PlaneVector(0, 0, 5e-3 * s); };
  CHECK(near(walk(mc, Plane::strain, 500, shear, c).stress.xy, c * std::cos(friction), 1e-9));
  const DruckerPrager dp{young, poisson, c, friction, 0};
  const double t = std::tan(friction);
  CHECK(near(walk(dp, Plane::strain, 500, shear, c).stress.xy, 3 / std::sqrt(9 + 12 * t * t) * c, 1e-9));
}

TEST_CASE("pulled on all sides both end at the tip of their surface, or at the cut-off") {
  const double friction = 30 * M_PI / 180, c = 5e6, tip = c / std::tan(friction);
  const auto swell = [](double s) { return PlaneVector(3e-3 * s, 3e-3 * s, 0); };
  for (const double tension : {no_cut_off, 2e6}) {
    const double end = std::min(tip, tension);
    const MohrCoulomb mc{young, poisson, c, friction, friction, tension};
    const DruckerPrager dp{young, poisson, c, friction, friction, tension};
    CHECK(near(walk(mc, Plane::strain, 500, swell, c).stress.xx, end, 1e-9));
    const PointResponse r = walk(dp, Plane::strain, 500, swell, c);
    CHECK(near((r.stress.xx + r.stress.yy + r.stress.zz) / 3, end, 1e-9));
  }
}

TEST_CASE("any strain path returns to the yield surface, dissipates energy and closes its balance") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int round = 0; round < 8; ++round) {
    const PlaneVector a(any(random), any(random), any(random)), b(any(random), any(random), any(random));
    const auto path = [&](double s) -> PlaneVector { return 2e-3 * (s * a + std::sin(3 * s) * b); };
    for (const Plane plane : {Plane::stress, Plane::strain}) {
      for_each_plastic([&](const auto& law) { walk(law, plane, 5000, path, 3e6); });
      walk(J2{young, poisson, 10e6, 1e9}, plane, 5000, path, 10e6);  // the hardening at the end equals the initial
                                                                     // yield stress
    }
  }
}

TEST_CASE("the stress of a law rotates with the strain") {
  const auto turned = [](const PlaneVector& e, double angle, double shear) {
    const double cc = std::cos(2 * angle), ss = std::sin(2 * angle), m = 0.5 * (e[0] + e[1]), d = 0.5 * (e[0] - e[1]),
                 h = e[2] / shear;
    return PlaneVector(m + d * cc - h * ss, m - d * cc + h * ss, shear * (d * ss + h * cc));
  };
  const PlaneVector strain(1e-3, -2e-3, 1.5e-3);
  for (const Plane plane : {Plane::stress, Plane::strain})
    for (const double angle : {0.3, 1.2, 2.9}) {
      for_each_plastic([&](const auto& law) {
        const PlaneVector a = law.respond(plane, strain, {}).stress.in_plane(),
                          b = law.respond(plane, turned(strain, angle, 2), {}).stress.in_plane();
        CHECK((turned(a, angle, 1) - b).norm() < 1e-9 * a.norm());
      });
    }
}

TEST_CASE("laws of no strength or of more dilation than friction are rejected") {
  CHECK_THROWS_AS((MohrCoulomb{young, poisson, 0, 0, 0}.check()), InputError);
  CHECK_THROWS_AS((MohrCoulomb{young, poisson, 1e6, 0.2, 0.3}.check()), InputError);
  CHECK_THROWS_AS((DruckerPrager{young, poisson, 1e6, 0.2, 0.3}.check()), InputError);
}

}  // namespace
}  // namespace trilith
