// Steps shared by several threads have the bits of a single thread.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <numbers>

#include "model/space_builder/solid_model_builder.hpp"
#include "physics/scene.hpp"
#include "physics/space/solid_bodies.hpp"
#include "run/simulation.hpp"

namespace trilith::testing {
namespace {

/// Thread counts compared with one: fewer and more than the machine has.
constexpr std::array more_threads{2, 3, 5};

StageOptions shaking(double duration) {
  StageOptions options;
  options.name = "tilted", options.duration = duration;
  return options;
}

/// A dry single-leaf facade between two returns, under gravity that pulls it outward: it collapses.
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

/// Blocks of many rotations that fall on each other in the plane.
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

/// A wall in running bond whose ground is tilted, so that it breaks apart and slides down: more rows, bodies and
/// elements than one thread takes at a time.
Model<2> leaning_wall(const ContactLaw& law, BodyKind kind, int divisions) {
  ModelBuilder builder;
  builder.add_material({"stone", 2000, Solid{LinearElastic{1e9, 0.2, 1e-5}}});
  builder.add_law("joint", law);
  builder.set_contact("*", "*", "joint");
  builder.gravity = standard_gravity * Vec2(std::sin(0.6), -std::cos(0.6));
  const auto add = [&](const std::string& name, double x, double y, double width, double height, bool moves) {
    BodySpec spec;
    spec.name = name, spec.material = "stone", spec.outline = box(x, y, x + width, y + height);
    if (moves) spec.kind = kind, spec.divisions = {divisions, divisions};
    if (!moves) spec.support = held;
    builder.add_body(std::move(spec));
  };
  add("ground", -1, -1, 12, 1, false);
  for (int course = 0; course < 18; ++course)
    for (int i = 0; i < 18; ++i)
      add(fmt::format("u{}.{}", course, i), 0.4 * i + (course % 2) * 0.2, 0.2 * course, 0.4, 0.2, true);
  return builder.build();
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

TEST_CASE(
    "a collapsing facade in space has the same bits on one and more threads, continued and after freeing memory") {
  const Model<3> model = falling_facade();
  Simulation<3> seen(model);
  seen.run(shaking(1.2));
  double farthest = 0;
  for (std::size_t n = 0; n < model.start_position.size(); ++n)
    farthest = std::max(farthest, (seen.state().position[n] - model.start_position[n]).norm());
  CHECK(farthest > 0.3);  // the wall collapses
  expect_same_bits(model, 0.8, 0.4);
}

TEST_CASE("a dry wall in the plane slides down with the same bits on one and more threads") {
  const Model<2> model = leaning_wall(Frictional{1e9, 4e8, 0.4, 2e-5}, BodyKind::rigid, 1);
  Simulation<2> seen(model);
  seen.run(shaking(0.15));
  CHECK(seen.state().position.back().x() - model.start_position.back().x() > 0.01);  // it does slide
  expect_same_bits(model, 0.1, 0.05);
}

TEST_CASE("mortar that breaks between quads has the same bits on one and more threads") {
  Bonded mortar{1e9, 4e8, 0.4, 2e-5};
  mortar.cohesion = 4e3, mortar.tension = 4e3;
  expect_same_bits(leaning_wall(mortar, BodyKind::quad, 1), 0.05, 0.02);
}

TEST_CASE("a wall of meshed units has the same bits on one and more threads") {
  expect_same_bits(leaning_wall(Frictional{1e9, 4e8, 0.4, 2e-5}, BodyKind::mesh, 2), 0.01, 0.005);
}

TEST_CASE("blocks that are poured in the plane have the same bits on one and more threads") {
  expect_same_bits(pour(), 0.4, 0.4);
}

}  // namespace trilith::testing
