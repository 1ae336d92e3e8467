// Mortar joints between bodies in space: bond failure, dissipated energy, and independence of all other options.
#include <unistd.h>

#include <doctest/doctest.h>

#include <bit>
#include <filesystem>

#include "assembly/start.hpp"
#include "contact/held_joint.hpp"
#include "model/io/checkpoint.hpp"
#include "near.hpp"
#include "physics/space/solid_bodies.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

Cohesive lime(double beta = 1e-5) {
  Cohesive law = soft_mortar(2e9, 1e9, 0.7, 1e5, 5e4, 5, 20);
  law.beta = beta;
  return law;
}

/// A wall of `courses` of three bricks on a floor, every other course offset by a third of a brick; rotated with its
/// world. A stone flies at it if `speed` is above 0.
Model<3> wall(const ContactLaw& law, int courses, double speed, const UnitQuaternion& world = {}) {
  SpaceBuilder builder;
  const Turn3 turn(world);
  builder.gravity(turn.apply(Vec3(0, 0, -standard_gravity)));
  const Vec3 brick(0.25, 0.12, 0.08);
  const auto put = [&](const Vec3& sides, const Vec3& at) { return placed(box_at(sides, at), world, Vec3::Zero()); };
  builder.add(fixed_stone("floor", put(Vec3(3, 3, 0.2), Vec3(0, 0, -0.1))));
  for (int j = 0; j < courses; ++j)
    for (int i = 0; i < 3; ++i) {
      const double x = (i - 1 + (j % 2 == 0 ? 1 : -1) / 6.0) * brick.x();
      builder.add(stone("brick " + std::to_string(3 * j + i), put(brick, Vec3(x, 0, (j + 0.5) * brick.z())), 1800));
    }
  if (speed > 0) {
    SolidBody ball = stone("stone", put(Vec3(0.1, 0.1, 0.1), Vec3(0.03, -0.2, (courses - 0.7) * brick.z())), 2500);
    ball.velocity = turn.apply(Vec3(0, speed, 0));
    ball.surface = 1;
    builder.add(ball);
  }
  builder.contact(0, 0, law, "mortar");
  builder.contact(0, 1, frictional(2e9, 1e9, 0.5, 1e-5), "stone");
  return builder.build();
}

int bonds_of(const State<3>& state) {
  int sum = 0;
  for (const JointMemory& j : state.contacts.joint) sum += std::popcount(j.bonds);
  return sum;
}

constexpr double wall_step = 2e-6;

SolidRun struck(const ContactLaw& law, const UnitQuaternion& world = {}) {
  const Model<3> model = wall(law, 4, 12, world);
  return {model, start_state(model), wall_step};
}

}  // namespace

TEST_CASE("bonds are set between all bricks of a wall that touch") {
  const Model<3> model = wall(lime(), 4, 0);
  const State<3> state = start_state(model);
  // Bed joints: 3 on the floor, 5 between courses; head joints: 2 in each course.
  CHECK(state.contacts.joint.size() == 3 + 3 * 5 + 4 * 2);
  CHECK(bonds_of(state) == 16 * static_cast<int>(state.contacts.joint.size()));
}

TEST_CASE("a wall in mortar that a stone strikes breaks, and its energy balance closes") {
  for (const ContactLaw& law :
       {ContactLaw(lime()), ContactLaw(lime(0)), ContactLaw(brittle_mortar(2e9, 1e9, 0.7, 1e5, 5e4)),
        ContactLaw(brittle_mortar(2e9, 1e9, 0.7, 1e5, 5e4, 1))}) {
    SolidRun run = struck(law);
    const double begun = run.energy().balance(), blow = run.moving_energy();
    const int bonds = bonds_of(run.state());
    run.run(0.02);
    const Energy energy = run.energy();
    CHECK(bonds_of(run.state()) < bonds - 16);
    CHECK(energy[EnergyTerm::contact_fracture] > 0);
    CHECK(near_zero(energy.balance() - begun, 2e-4 * blow));
  }
}

TEST_CASE("a breaking wall has the same bits after its scratch memory is freed") {
  SolidRun plain = struck(lime()), dropped = struck(lime());
  for (int i = 0; i < 6000; ++i) {
    if (i % 37 == 0) dropped.drop_work();
    plain.step(), dropped.step();
    if (i % 500 == 0) REQUIRE(state_hash(plain.state()) == state_hash(dropped.state()));
  }
  CHECK(state_hash(plain.state()) == state_hash(dropped.state()));
}

TEST_CASE("a breaking wall saved and continued gives the same bits as one run without interruption") {
  SolidRun whole = struck(lime());
  whole.run(0.012);
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("joints" + std::to_string(::getpid()) + ".state");
  save_state(whole.state(), whole.model(), path);
  SolidRun rest(whole.model(), load_state(whole.model(), path), wall_step);
  std::filesystem::remove(path);
  CHECK(state_hash(rest.state()) == state_hash(whole.state()));
  whole.run(2e-3), rest.run(2e-3);
  CHECK(state_hash(rest.state()) == state_hash(whole.state()));
}

TEST_CASE("a wall breaks the same way in a rotated frame") {
  const UnitQuaternion world = rotation_by({0.7, -1.1, 0.4});
  SolidRun upright = struck(lime()), turned = struck(lime(), world);
  upright.run(0.012), turned.run(0.012);
  CHECK(bonds_of(upright.state()) == bonds_of(turned.state()));
  for (int n = 1; n < 14; ++n) CHECK((Turn3(world).undo(turned.place(n)) - upright.place(n)).norm() < 1e-6);
}

TEST_CASE("two bricks that tear a joint between them keep momenta") {
  SpaceBuilder builder;
  SolidBody a = stone("a", box_at(Vec3(0.2, 0.1, 0.1), Vec3(0, 0, 0))),
            b = stone("b", box_at(Vec3(0.2, 0.1, 0.1), Vec3(0.04, 0, 0.1)));
  a.velocity = Vec3(-0.3, 0.1, -0.4), b.velocity = Vec3(0.2, 0.2, 0.3);
  a.spin = Vec3(1, 2, -1), b.spin = Vec3(-3, 1, 2);
  builder.add(a), builder.add(b);
  builder.contact(0, 0, lime(), "mortar");
  const Model<3> model = builder.build();
  SolidRun run(model, start_state(model), 1e-6);
  const Vec3 momentum = run.momentum(), turning = run.angular_momentum();
  const double begun = run.energy().balance();
  REQUIRE(run.run_until(0.02, [&] { return bonds_of(run.state()) == 0; }));
  run.run(1e-3);
  CHECK((run.momentum() - momentum).norm() < 1e-9 * model.mass[0]);
  CHECK((run.angular_momentum() - turning).norm() < 1e-9 * model.mass[0]);
  CHECK(run.energy()[EnergyTerm::contact_fracture] > 0);
  CHECK(near_zero(run.energy().balance() - begun, 1e-3 * run.moving_energy()));
}

TEST_CASE("a wall in mortar rests under its weight and loses no bond") {
  const Model<3> model = wall(lime(1e-3), 6, 0);
  SolidRun run(model, start_state(model), 1e-5);
  const int bonds = bonds_of(run.state());
  const double begun = run.energy().balance();
  run.run(0.25);
  CHECK(bonds_of(run.state()) == bonds);
  CHECK(run.moving_energy() < 1e-9);
  CHECK(near_zero(run.energy().balance() - begun, 1e-6));
}

TEST_CASE("fresh mortar has pressure and friction, sets without motion, and then bonds") {
  const Model<3> model = wall(lime(1e-3), 3, 0);
  State<3> state = start_state(model);
  lift_bonds(model, state);
  CHECK(bonds_of(state) == 0);
  SolidRun fresh(model, state, 1e-5);
  fresh.run(0.5);
  CHECK(fresh.moving_energy() < 1e-9);
  CHECK(bonds_of(fresh.state()) == 0);
  State<3> set = fresh.state();
  set_bonds(model, set, 1e-4);
  CHECK(bonds_of(set) > 0);
  SolidRun hard(model, set, 1e-5);
  const double begun = hard.energy().balance();
  const int bonds = bonds_of(set);
  std::vector<Vec3> places = set.position;
  hard.run(0.1);
  CHECK(bonds_of(hard.state()) == bonds);
  for (std::size_t n = 0; n < places.size(); ++n) CHECK((hard.state().position[n] - places[n]).norm() < 1e-9);
  CHECK(near_zero(hard.energy().balance() - begun, 1e-6));
}

TEST_CASE("a column of bricks hung from its top holds, or tears at its largest force") {
  const double height = 0.08, density = 1800, weight = 4 * density * standard_gravity * height;
  for (const double strength : {3 * weight, 0.9 * weight}) {
    SpaceBuilder builder;
    builder.gravity(Vec3(0, 0, -standard_gravity));
    builder.add(fixed_stone("ceiling", box_at(Vec3(1, 1, 0.1), Vec3(0, 0, 0.05))));
    for (int i = 0; i < 4; ++i)
      builder.add(stone("brick " + std::to_string(i), box_at(Vec3(0.25, 0.12, height), Vec3(0, 0, -(i + 0.5) * height)),
                        density));
    Bonded law = brittle_mortar(1e9, 1e9, 0.7, 1e5, strength);
    law.beta = 1e-3;
    builder.contact(0, 0, law, "glue");
    const Model<3> model = builder.build();
    SolidRun run(model, start_state(model), 1e-5);
    const double begun = run.energy().balance();
    run.run(0.1);
    const bool holds = strength > weight;
    CHECK(bonds_of(run.state()) == (holds ? 4 : 3) * most_patches);
    CHECK(near_zero(run.energy().balance() - begun, 1e-6 * weight));
    if (holds) {
      CHECK(run.moving_energy() < 1e-9);
      CHECK(near(-run.place(1).z() - 0.5 * height, weight / 1e9, 1e-3));
      continue;
    }
    // The detached part falls freely with a single velocity, slightly later than from the start.
    CHECK(near(run.velocity(1).z(), -standard_gravity * run.time(), 2e-2));
    for (const int n : {2, 3, 4}) CHECK(near(run.velocity(n).z(), run.velocity(1).z(), 1e-3));
  }
}
