// Stacks and arches against their limits: cases A1 and A3. Rigid blocks without tensile strength, on both sides of each
// limit.
#include <doctest/doctest.h>

#include <cmath>

#include "build/plane/arch.hpp"
#include "build/plane/stack.hpp"
#include "physics/masonry_scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

Fate arch_fate(int voussoirs, double share, double turn = 0) {
  // Least t/R of n voussoirs of exact curved weight (VALIDATION A3), approached by 4 sub-edges.
  const double least = voussoirs == 7 ? .09624 : voussoirs == 11 ? .10491 : voussoirs == 15 ? .10627 : .10679;
  Arch arch;
  arch.voussoirs = voussoirs;
  arch.radius = 1;
  arch.thickness = share * least;
  arch.sub_edges = 4;
  Scene scene(stiff_joint(10, M_PI * arch.radius / voussoirs), turn);
  add_parts(scene, build_arch(arch), "abutments");
  Simulation<2> sim = scene.start();
  return let_go(sim);
}

}  // namespace

TEST_CASE("A1: a harmonic stack of 1 to 5 blocks stands at 0.98 of the largest overhang and falls at 1.02") {
  for (int count = 1; count <= 5; ++count)
    for (const double factor : {0.98, 1.02}) {
      CAPTURE(count);
      CAPTURE(factor);
      HarmonicStack stack;
      stack.count = count, stack.factor = factor, stack.table_height = 0.5;
      Scene scene(stiff_joint(0.7, stack.height));
      add_parts(scene, build_harmonic_stack(stack), "table");
      Simulation<2> sim = scene.start();
      CHECK(let_go(sim) == (factor < 1 ? Fate::rests : Fate::comes_down));
    }
}

TEST_CASE("A3: a semicircular arch stands at 1.03 of its least thickness and falls at 0.97" *
          doctest::test_suite("long")) {
  for (const int voussoirs : {7, 11, 15, 21}) {
    CAPTURE(voussoirs);
    CHECK(arch_fate(voussoirs, 1.03) == Fate::rests);
    CHECK(arch_fate(voussoirs, 0.97) == Fate::comes_down);
  }
}

TEST_CASE("A3: an arch stands and falls the same way in a frame rotated by 17 or 90 or 203 degrees" *
          doctest::test_suite("long")) {
  for (const double turn : {17 * degree, 90 * degree, 203 * degree}) {
    CAPTURE(turn);
    CHECK(arch_fate(11, 1.03, turn) == Fate::rests);
    CHECK(arch_fate(11, 0.97, turn) == Fate::comes_down);
  }
}
