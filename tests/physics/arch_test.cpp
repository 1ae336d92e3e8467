// Arches against their limits: cases A2 and A4 to A7. Rigid voussoirs and joints without tensile strength. The joints
// are so stiff that hinges near the limit are short, as in masonry_test.cpp, which has A3.
#include "build/plane/arch.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "assembly/contact/contact_resultants.hpp"
#include "physics/masonry_scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// An arch of mid radius 1 m; its straight edges are so short that its weight equals the weight of the curved arch to
/// 1e-3.
Arch arch_of(int voussoirs, double thickness, double half_angle = 90 * degree) {
  Arch arch;
  arch.voussoirs = voussoirs, arch.thickness = thickness, arch.half_angle = half_angle;
  arch.sub_edges = voussoirs < 100 ? 2 : 1;
  return arch;
}

/// The arch with joints of friction coefficient `mu` and `stiffness` [Pa/m], damped by a `share` of critical damping.
std::unique_ptr<Simulation<2>> built(const Arch& arch, double mu = 10, double stiffness = 4e12, double share = 0.2) {
  const double length = 2 * arch.half_angle * arch.radius / arch.voussoirs;
  Scene scene(stiff_joint(mu, length, stiffness, share));
  add_parts(scene, build_arch(arch), "abutments");
  return std::make_unique<Simulation<2>>(scene.builder.build());
}

/// An arch whose joints can slide may flutter at first; see let_go.
Fate fate_of(const Arch& arch, double mu = 10, double stiffness = 4e12, double share = 0.2) {
  LettingGo how;
  if (mu < 1) how.times = 3;
  if (stiffness > 4e12) how.ratio = 5e-5;
  return let_go(*built(arch, mu, stiffness, share), how);
}

/// Horizontal force between two neighbours over the weight of all free bodies [1].
double thrust(const Simulation<2>& sim, const std::string& left, const std::string& right) {
  const Model<2>& model = sim.model();
  std::vector<TouchingContact> contacts;
  contact_resultants(model, sim.state(), sim.work(), contacts);
  const int a = model.find_body(left), b = model.find_body(right);
  double force = 0, weight = 0;
  for (const TouchingContact& c : contacts)
    if (std::minmax(c.body_a, c.body_b) == std::minmax(a, b)) force += std::abs(c.resultant.force.x());
  for (int n = 0; n < model.nodes(); ++n)
    if (model.moves(n)) weight += model.mass[n] * standard_gravity;
  return force / weight;
}

}  // namespace

TEST_CASE("A2: a semicircular arch of many voussoirs has the least thickness of the continuous one" *
          doctest::test_suite("long")) {
  const double least = .107478;  // Milankovitch 1907; 40 voussoirs need 0.10746
  CHECK(fate_of(arch_of(40, 1.03 * least)) == Fate::rests);
  CHECK(fate_of(arch_of(40, 0.97 * least)) == Fate::comes_down);
}

TEST_CASE("joints damped by less than a thousandth of critical leave an arch rattling" * doctest::test_suite("long")) {
  const Arch arch = arch_of(40, 1.03 * .107478);  // as in A2, where it comes to rest
  CHECK(fate_of(arch, 10, 4e12, 0.0005) == Fate::neither);
}

TEST_CASE("A4: an arch of smooth joints must be thicker" * doctest::test_suite("long")) {
  struct Case {
    double mu, least;
  };
  for (const Case& c : {Case{.40, .1075}, Case{.38, .1216}, Case{.35, .1518}, Case{.31, .198}}) {
    CAPTURE(c.mu);
    CHECK(fate_of(arch_of(100, 1.05 * c.least), c.mu) == Fate::rests);
    CHECK(fate_of(arch_of(100, 0.95 * c.least), c.mu) == Fate::comes_down);
  }
}

TEST_CASE("A4: at the transition from hinging to sliding an arch is most sensitive to the softness of its joints" *
          doctest::test_suite("long")) {
  const double least = .1122, stiffness = 4e13;  // with a tenth of this stiffness the arch needs 0.125
  CHECK(fate_of(arch_of(100, 1.05 * least), .39, stiffness) == Fate::rests);
  CHECK(fate_of(arch_of(100, 0.95 * least), .39, stiffness) == Fate::comes_down);
}

TEST_CASE("A5: the thrust of a standing arch lies between its least and its greatest") {
  struct Case {
    double thickness, least, most;
  };
  for (const Case& c : {Case{.12, .1907, .2073}, Case{.15, .1756, .2271}, Case{.20, .1540, .2546}}) {
    CAPTURE(c.thickness);
    const std::unique_ptr<Simulation<2>> sim = built(arch_of(30, c.thickness));
    REQUIRE(let_go(*sim) == Fate::rests);
    const double found = thrust(*sim, "v15", "v16");
    MESSAGE(
        fmt::format("A5, t/R {}: thrust over weight {:.4f}, limits {} and {}", c.thickness, found, c.least, c.most));
    CHECK(found >= c.least);
    CHECK(found <= c.most);
  }
}

TEST_CASE("A6: a tilted semicircular arch collapses at its limit" * doctest::test_suite("long")) {
  struct Case {
    double thickness, factor;
  };
  for (const Case& c : {Case{.12, .0468}, Case{.15, .1445}, Case{.20, .2843}}) {
    CAPTURE(c.thickness);
    const std::unique_ptr<Simulation<2>> sim = built(arch_of(40, c.thickness));
    REQUIRE(let_go(*sim) == Fate::rests);
    const double near_limit = 0.9 * std::atan(c.factor);
    REQUIRE(tilt_on(*sim, 0, near_limit, 4 * degree) == near_limit);
    const double factor = std::tan(tilt_on(*sim, near_limit, 40 * degree, 0.5 * degree));
    MESSAGE(fmt::format("A6, t/R {}: collapses at a factor of {:.4f}, limit {}", c.thickness, factor, c.factor));
    CHECK(factor <= c.factor);
    CHECK(factor >= 0.96 * c.factor);
  }
}

TEST_CASE("A7: a segmental arch of 150 degrees needs half the thickness of a semicircle" *
          doctest::test_suite("long")) {
  const double least = .05369;
  CHECK(fate_of(arch_of(200, 1.03 * least, 75 * degree)) == Fate::rests);
  CHECK(fate_of(arch_of(200, 0.97 * least, 75 * degree)) == Fate::comes_down);
}
