// Equilibrium paths of frames and blocks under growing loads: limit points, snap-back, large bending.
#include "near.hpp"
#include "physics/members/statics_frames.hpp"

namespace trilith::testing {
namespace {

/// The path by arcs of `first` [m] until the followed displacement of node `n` is beyond `to`; positive down.
LoadPath arc_path(const Model<2>& model, int n, double first, double longest, double to) {
  State<2> state = initial_state(model);
  LoadPathOptions o;
  o.followed = {{{n, 1}, -1}};
  o.first = first, o.longest = longest;
  o.goes_on = [&](const PathPoint& p, const State<2>&) { return p.displacement < to; };
  return follow_loads(model, state, o);
}

TEST_CASE("F14: by arc length a truss of two pinned bars snaps through at its limit load") {
  const LoadPath path = arc_path(shallow_truss(), 1, 0.005, 0.005, 1.1);
  REQUIRE(path.end == PathEnd::arrived);
  REQUIRE(path.limits.size() == 2);
  CHECK(near(path.limits[0].factor, 47.9925, 1e-3));
  CHECK(near(path.limits[0].displacement, .211445, 1e-3));
  CHECK(near(path.limits[1].factor, -47.9925, 1e-3));
  CHECK(near(path.limits[1].displacement, 1 - .211445, 1e-3));
  MESSAGE(fmt::format("F14: {:.4f} N at {:.6f} m; {} points, {} iterations, {} cuts", path.limits[0].factor,
                      path.limits[0].displacement, path.points.size(), path.iterations, path.cuts));
}

TEST_CASE("F2, F3: by arc length toggles snap through at their limit loads") {
  struct Row {
    double span, rise, width, depth, young, force, drop, low, low_drop, low_allowed;
  };
  for (const Row& r : {Row{.3287522, .0098044, .0191262, .0061722, 71.016e9, 150.66, 5.910e-3, 139.15, 9.934e-3, .005},
                       Row{.5, .03, .02, .01, 210e9, 3404.0, 10.964e-3, 196.6, 35.452e-3, .02}}) {
    const LoadPath path =
        arc_path(toggle(r.span, r.rise, r.width, r.depth, r.young), 1, 0.01 * r.drop, 0.03 * r.drop, 1.3 * r.low_drop);
    REQUIRE(path.end == PathEnd::arrived);
    REQUIRE(path.limits.size() == 2);
    CHECK(near(path.limits[0].factor, r.force, 0.005));
    CHECK(near(path.limits[0].displacement, r.drop, 0.005));
    CHECK(near(path.limits[1].factor, r.low, r.low_allowed));
    CHECK(near(path.limits[1].displacement, r.low_drop, 0.005));
    MESSAGE(fmt::format("{:.2f} N at {:.3f} mm, {:.2f} N at {:.3f} mm; {} points, {} iterations", path.limits[0].factor,
                        1e3 * path.limits[0].displacement, path.limits[1].factor, 1e3 * path.limits[1].displacement,
                        path.points.size(), path.iterations));
  }
}

TEST_CASE("F4: by arc length Lee's frame snaps back beyond its first limit load and down to its lowest") {
  const LeeFrame lee(10);
  REQUIRE((lee.model.start_position[lee.loaded] - Vec2(0.24, 1.2)).norm() < 1e-12);
  const LoadPath path = arc_path(lee.model, lee.loaded, 0.01, 0.02, 0.9);
  REQUIRE(path.end == PathEnd::arrived);
  REQUIRE(path.limits.size() == 2);
  CHECK(near(path.limits[0].factor, 18198, 0.005));
  CHECK(near(path.limits[0].displacement, .4873, 0.005));
  CHECK(near(path.limits[1].factor, -9232.5, 0.005));
  CHECK(near(path.limits[1].displacement, .5822, 0.005));
  // Between the two limit points the loaded point moves backwards.
  double farthest = 0, back = 0;
  for (const PathPoint& p : path.points) {
    if (p.factor < path.limits[1].factor) break;
    farthest = std::max(farthest, p.displacement), back = std::max(back, farthest - p.displacement);
  }
  CHECK(back > 0.02);
  MESSAGE(
      fmt::format("F4: {:.1f} N at {:.4f} m, {:.1f} N at {:.4f} m, {:.3f} m back; {} points, {} iterations, {} cuts",
                  path.limits[0].factor, path.limits[0].displacement, path.limits[1].factor,
                  path.limits[1].displacement, back, path.points.size(), path.iterations, path.cuts));
}

TEST_CASE("B4: by load steps a cantilever under a dead end load bends as the elastica") {
  const Model<2> model = cantilever_under(1, 0, 10);
  struct Row {
    double number, deflection, shortening, angle;
  };
  // Mattiasson 1981, see frame_test.cpp.
  for (const Row& row : {Row{1, .30172, .05643, .29371}, Row{2, .49346, .16064, .49768}, Row{5, .71379, .38763, .77373},
                         Row{10, .81061, .55500, .91055}}) {
    State<2> state = initial_state(model);
    LoadPathOptions o;
    o.control = PathControl::load, o.first = 0.5, o.longest = 2, o.to = row.number;
    const LoadPath path = follow_loads(model, state, o);
    REQUIRE(path.end == PathEnd::arrived);
    CHECK(path.points.back().factor == row.number);
    CHECK(near(-state.position[1].y(), row.deflection, 0.01));
    CHECK(near(1 - state.position[1].x(), row.shortening, 0.01));
    CHECK(near(-state.rotation[1] * 2 / M_PI, row.angle, 0.01));
    MESSAGE(fmt::format("B4: {} {:.5f} {:.5f} {:.5f}; {} points, {} iterations", row.number, -state.position[1].y(),
                        1 - state.position[1].x(), -state.rotation[1] * 2 / M_PI, path.points.size(), path.iterations));
  }
}

TEST_CASE("B5: by load steps an end moment bends a cantilever to a circle") {
  const Model<2> model = cantilever_under(0, 1, 20);
  State<2> state = initial_state(model);
  LoadPathOptions o;
  o.control = PathControl::load, o.first = 0.2, o.longest = 0.5, o.to = 2 * M_PI;
  const LoadPath path = follow_loads(model, state, o);
  REQUIRE(path.end == PathEnd::arrived);
  CHECK(state.position[1].norm() < 0.01);
  CHECK(near(state.rotation[1], 2 * M_PI, 1e-6));
  MESSAGE(fmt::format("B5: tip {:.2e} m off; {} points, {} iterations", state.position[1].norm(), path.points.size(),
                      path.iterations));
}

TEST_CASE("I10: a rocking block on a no-tension joint follows its pushover curve past the peak") {
  Scene scene(Frictional{1e8, 5e7, 5, 0});
  scene.builder.thickness = 0.5;
  scene.fixed("base", box(-2, -1, 2, 0));
  scene.block("block", box(-0.25, 0, 0.25, 2), 1000);
  Model<2> model = scene.builder.build();
  add_load(model, "block", {0, 1}, {1, 0});
  const int block = node_of(model, "block");
  State<2> state = initial_state(model);
  LoadPathOptions o;
  o.control = PathControl::displacement, o.followed = {{{block, 2}, -1}};
  o.first = 1e-4, o.longest = 2e-4, o.to = 0.12;
  const LoadPath path = follow_loads(model, state, o);
  REQUIRE(path.end == PathEnd::arrived);
  REQUIRE(path.limits.size() == 1);
  CHECK(near(path.limits[0].factor, 1791.3, 0.005));
  CHECK(near(path.limits[0].displacement, .02157, 0.01));
  CHECK(near(factor_at(path, 1.5691e-3), 801.7, 0.005));
  CHECK(near(factor_at(path, 0.05), 1653.1, 0.01));
  CHECK(near(factor_at(path, 0.1), 1234.4, 0.01));
  MESSAGE(fmt::format("I10: {:.2f} N at {:.5f} rad; {:.2f}, {:.2f}, {:.2f} N", path.limits[0].factor,
                      path.limits[0].displacement, factor_at(path, 1.5691e-3), factor_at(path, 0.05),
                      factor_at(path, 0.1)));
}

}  // namespace
}  // namespace trilith::testing
