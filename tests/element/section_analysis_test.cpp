// Moment-curvature curves and interaction of sections of fibres, compared with closed forms of perfectly plastic steel.
#include "element/section/section_analysis.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "near.hpp"

namespace trilith {
namespace {

using testing::near;

constexpr double wide = 0.1, tall = 0.2, steel_modulus = 2e11, steel_yield = 250e6;
constexpr double full_plastic_moment = wide * tall * tall / 4 * steel_yield, squash = wide * tall * steel_yield;
constexpr double first_curvature = 2 * steel_yield / (steel_modulus * tall);

/// A rectangle of elastic, perfectly plastic steel in 200 layers: moments are exact to about 1e-5.
FibreSection steel_bar() {
  return make_fibres({RectangleSection{wide, tall}, BilinearSteel{steel_modulus, steel_yield, 0, 0}, 200});
}

/// Moment of the bar at a curvature above yield, without normal force.
double plastic_curve(double curvature) {
  const double share = first_curvature / curvature;
  return full_plastic_moment * (1 - share * share / 3);
}

}  // namespace

TEST_CASE("the moment of a plastic rectangle is 1 - (k_y/k)^2/3 of its plastic moment, and E I k below yield") {
  const MomentCurvature curve = moment_curvature(steel_bar(), 0, 8 * first_curvature, 64);
  REQUIRE(curve.points.size() == 65);
  CHECK(curve.end == "curvature");
  CHECK(near(curve.points[4].moment, steel_modulus * wide * tall * tall * tall / 12 * 0.5 * first_curvature, 1e-6));
  for (const std::size_t i : {16, 32, 64})
    CHECK(near(curve.points[i].moment, plastic_curve(curve.points[i].curvature), 1e-4));
  // The outermost fibre lies 0.21 of a layer inside of the edge.
  REQUIRE(curve.yield);
  CHECK(near(curve.yield->curvature, first_curvature, 5e-3));
  CHECK(near(curve.yield->moment, full_plastic_moment * 2 / 3, 5e-3));
  REQUIRE(curve.largest);
  CHECK(curve.largest->moment == curve.points.back().moment);
}

TEST_CASE("a normal force brings the first yield of a section forward by its stress") {
  for (const double share : {-0.4, 0.25}) {
    const MomentCurvature curve = moment_curvature(steel_bar(), share * squash, 4 * first_curvature, 100);
    REQUIRE(curve.yield);
    CHECK(near(curve.yield->curvature, (1 - std::abs(share)) * first_curvature, 1e-2));
    CHECK(near(curve.points.front().axial, share * steel_yield / steel_modulus, 1e-8));
    CHECK(std::abs(curve.points.front().moment) < 1e-9 * full_plastic_moment);
  }
}

TEST_CASE("the interaction of a plastic rectangle is the parabola 1 - (N/N_p)^2") {
  // At a strain of 0.2 the elastic core is 1 % of the depth, so moments are 3e-5 below the parabola at N = 0.
  const std::vector<InteractionPoint> curve = interaction(steel_bar(), 11, {0.2, 0.2});
  REQUIRE(curve.size() == 11);
  CHECK(near(curve.front().normal, -squash, 1e-9));
  CHECK(near(curve.back().normal, squash, 1e-9));
  for (const InteractionPoint& p : curve) {
    const double share = p.normal / squash, exact = full_plastic_moment * (1 - share * share);
    CHECK(std::abs(p.sagging - exact) < 5e-3 * full_plastic_moment);
    CHECK(std::abs(p.hogging + exact) < 5e-3 * full_plastic_moment);
  }
}

TEST_CASE("a section bends to the other side as its mirror image, and alike if it is symmetric") {
  const FibreSection t_up =
      make_fibres({TSection{0.6, 0.2, 1.2, 0.15}, BilinearSteel{steel_modulus, steel_yield}, 120});
  const MomentCurvature sagging = moment_curvature(t_up, 0, 0.02, 40), hogging = moment_curvature(t_up, 0, -0.02, 40);
  FibreSection mirrored = t_up;
  for (Fibre& fibre : mirrored.fibres) fibre.height = -fibre.height;
  const MomentCurvature turned = moment_curvature(mirrored, 0, 0.02, 40);
  REQUIRE(hogging.points.size() == turned.points.size());
  for (std::size_t i = 1; i < turned.points.size(); ++i)
    CHECK(near(hogging.points[i].moment, -turned.points[i].moment, 1e-6));
  // The fully plastic moment is the same for both sides; the first yield is at the farther edge for both.
  CHECK(near(sagging.yield->curvature, -hogging.yield->curvature, 1e-6));
  const MomentCurvature bar = moment_curvature(steel_bar(), 0, -4 * first_curvature, 40);
  CHECK(near(bar.points.back().moment, -plastic_curve(4 * first_curvature), 1e-4));
}

TEST_CASE("curves end at the strain limits, and have no point beyond the capacity for normal force") {
  const MomentCurvature curve = moment_curvature(steel_bar(), 0, 1, 2000, {0.004, 0.005});
  CHECK(curve.end == "compression");
  CHECK(near(curve.points.back().curvature, 2 * 0.004 / tall, 1e-2));
  CHECK(near(longest_curvature(steel_bar(), {0.004, 0.005}), 0.009 / tall, 1e-2));
  const MomentCurvature none = moment_curvature(steel_bar(), 1.01 * squash, 0.1, 10);
  CHECK(none.points.empty());
  CHECK(none.end == "no equilibrium");
}

TEST_CASE("reinforced concrete carries its largest moment below the balanced normal force, not at zero") {
  FibreSpec spec{RectangleSection{0.4, 0.4}, KentPark::sample(), 40};
  spec.bars = {{1.2e-3, 0.05}, {1.2e-3, 0.35}};
  spec.bar_law = BilinearSteel{2e11, 420e6};
  const std::vector<InteractionPoint> curve = interaction(make_fibres(spec), 21);
  const auto most =
      std::max_element(curve.begin(), curve.end(),
                       [](const InteractionPoint& a, const InteractionPoint& b) { return a.sagging < b.sagging; });
  CHECK(most->normal < -1e6);
  CHECK(most->normal > curve.front().normal);
  // Pure tension: both rows of bars.
  CHECK(near(curve.back().normal, 2.4e-3 * 420e6, 0.02));
  for (const InteractionPoint& p : curve) CHECK(near(p.sagging + 1e3, -p.hogging + 1e3, 1e-2));
}

}  // namespace trilith
