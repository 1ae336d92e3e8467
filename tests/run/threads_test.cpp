// Steps that several threads share: the bits of one.
#include <doctest/doctest.h>

#include <array>
#include <numbers>

#include "physics/scene.hpp"
#include "physics/solid_bodies.hpp"
#include "run/simulation.hpp"
#include "world/solid_model_builder.hpp"

namespace trilith::testing {
namespace {

/// Counts of threads that are tried against one: fewer and more than the machine has.
constexpr std::array more_threads{2, 3, 5};

StageOptions shaking(double duration) {
  StageOptions options;
  options.name = "tilted", options.duration = duration;
  return options;
}

/// A facade of one leaf between two returns, dry, under a weight that pulls it outward: it comes down.
Model<3> falling_facade() {
  SolidModelBuilder builder;
  Material stone;
  stone.name = "stone", stone.density = 2000;
  builder.add_material(stone);
  builder.add_law("dry", frictional(1e9, 4e8, 0.5, 1e-5));
  builder.set_contact("stone", "stone", "dry");
  const auto add = [&](const std::string& name, const Vec3& sides, const Vec3& centre, bool fixed) {
    SolidSpec spec;
    spec.name = name, spec.pieces = {box_at(sides, centre)}, spec.material = "stone";
    if (fixed) spec.support.fill(Support::fixed);
    builder.add_body(spec);
  };
  add("ground", {8, 8, 1}, {1.2, 0, -0.5}, true);
  for (int course = 0; course < 12; ++course) {
    const double z = 0.1 + 0.2 * course, shift = course % 2 == 0 ? 0 : 0.2;
    for (int i = 0; i < 6; ++i)
      add("u" + std::to_string(course) + "." + std::to_string(i), {0.4, 0.2, 0.2}, {0.2 + shift + 0.4 * i, 0, z},
          false);
    for (int i = 0; i < 3; ++i)
      add("r" + std::to_string(course) + "." + std::to_string(i), {0.2, 0.4, 0.2}, {0.1, 0.3 + 0.4 * i, z}, false);
  }
  builder.gravity = standard_gravity * Vec3(0, -std::sin(0.45), -std::cos(0.45));
  builder.mass_damping = 0.3;
  return builder.build();
}

/// Blocks of many turns that fall on each other in the plane.
Model<2> pour() {
  Scene scene(Frictional{1e7, 4e6, 0.5, 1e-3});
  scene.fixed("ground", box(-4, -1, 4, 0));
  for (int i = 0; i < 150; ++i) {
    const double x = -2.7 + 0.36 * (i % 15), y = 0.3 + 0.36 * (i / 15), turn = 0.7 * i;
    BodySpec spec;
    spec.name = "box" + std::to_string(i), spec.floating = true, spec.mass = 40;
    for (const Vec2& corner : {Vec2(-0.1, -0.07), Vec2(0.1, -0.07), Vec2(0.1, 0.07), Vec2(-0.1, 0.07)})
      spec.outline.push_back(Vec2(x, y) + Turn(turn).apply(corner));
    scene.add(spec);
  }
  return scene.builder.build();
}

template <int D>
void expect_same_bits(const Model<D>& model, double first, double second) {
  Simulation<D> alone(model);
  alone.run(shaking(first));
  const Snapshot<D> taken = alone.snapshot();
  alone.run(shaking(second));
  const std::uint64_t end = state_hash(alone.state());
  for (const int threads : more_threads) {
    CAPTURE(threads);
    Simulation<D> shared(model);
    shared.use_threads(threads);
    shared.run(shaking(first));
    RunListener<D> drops;
    int border = 0;
    drops.at_border = [&] {
      if (++border % 50 == 0) shared.drop_work();
    };
    shared.run(shaking(second), drops);
    CHECK(state_hash(shared.state()) == end);
  }
  alone.restore(taken);
  alone.use_threads(2);
  alone.run(shaking(second));
  CHECK(state_hash(alone.state()) == end);
}

}  // namespace

TEST_CASE("a facade in space comes down with the same bits on one and more threads, saved and with its work dropped") {
  const Model<3> model = falling_facade();
  Simulation<3> seen(model);
  seen.run(shaking(1.2));
  double farthest = 0;
  for (std::size_t n = 0; n < model.start_position.size(); ++n)
    farthest = std::max(farthest, (seen.state().position[n] - model.start_position[n]).norm());
  CHECK(farthest > 0.3);  // it does come down
  expect_same_bits(model, 0.8, 0.4);
}

TEST_CASE("blocks that are poured in the plane have the same bits on one and more threads") {
  expect_same_bits(pour(), 0.4, 0.4);
}

}  // namespace trilith::testing
