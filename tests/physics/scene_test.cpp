// The fixture of the physics tests, against closed forms.
#include "physics/scene.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("a free body flies a parabola and keeps its spin, in any rotated frame") {
  for (const double turn : {0.0, 17 * degree, 90 * degree, 203 * degree}) {
    Scene scene(Frictional{1e8, 1e8, 0, 0}, turn);
    BodySpec spec;
    spec.name = "stone", spec.outline = {{0, 0}, {1, 0}, {0, 1}}, spec.velocity = {3, 4}, spec.spin = 2;
    spec.floating = true;
    scene.add(spec);
    Simulation<2> sim = scene.start();
    const Vec2 from = scene.to_scene(sim.state().position[0]);
    run_for(sim, 1.0, 1e-4);
    const Vec2 moved = scene.to_scene(sim.state().position[0]) - from;
    CHECK(near(moved.x(), 3.0, 1e-12));
    CHECK(near(moved.y(), 4.0 - 0.5 * standard_gravity, 1e-9));
    CHECK(near(sim.state().rotation[0], 2.0, 1e-12));
  }
}

TEST_CASE("a driven body follows its motion along the scene's axis, in any rotated frame") {
  const auto motion = motion_of(1.0, 1e-3, [](double t) { return 2 * t; });
  for (const double turn : {0.0, 17 * degree, 90 * degree, 203 * degree}) {
    Scene scene(Frictional{1e8, 1e8, 0, 0}, turn);
    scene.fixed("base", rectangle({-1, -1}, {1, 0}));
    Model<2> model = scene.builder.build();
    scene.drive_along_x(model, "base", *motion);
    Simulation<2> sim(std::move(model));
    const Vec2 from = scene.to_scene(sim.state().position[0]);
    run_for(sim, 0.5, 1e-3);
    const Vec2 moved = scene.to_scene(sim.state().position[0]) - from;
    CHECK(near(moved.x(), 0.125 / 3, 1e-9));  // u = t^3 / 3
    CHECK(std::abs(moved.y()) < 1e-12);
  }
}
