// Piles of solids: they come to rest, with the same bits after Work is dropped, State is saved, or the world is
// rotated.
#include <unistd.h>

#include <doctest/doctest.h>

#include <filesystem>

#include "model/io/checkpoint.hpp"
#include "near.hpp"
#include "physics/space/solid_bodies.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Random stones that fall into a tray.
Model<3> poured(int count) {
  std::mt19937_64 bits(7);
  SpaceBuilder builder;
  builder.gravity(Vec3(0, 0, -standard_gravity));
  SolidBody tray;
  tray.name = "tray", tray.density = 2000, tray.fixed = true;
  tray.pieces = {box_solid(Vec3(-1.1, -1.1, -0.2), Vec3(1.1, 1.1, 0)), box_solid(Vec3(-1.1, -1.1, 0), Vec3(-1, 1.1, 1)),
                 box_solid(Vec3(1, -1.1, 0), Vec3(1.1, 1.1, 1)), box_solid(Vec3(-1, -1.1, 0), Vec3(1, -1, 1)),
                 box_solid(Vec3(-1, 1, 0), Vec3(1, 1.1, 1))};
  builder.add(tray);
  for (int i = 0; i < count; ++i) {
    const Vec3 at(0.6 * (i % 3 - 1), 0.6 * (i / 3 % 3 - 1), 0.4 + 0.6 * (i / 9));
    const Polyhedron shape = random_convex_solid(bits, {.smallest = 0.3, .largest = 0.5});
    builder.add(stone("stone " + std::to_string(i), placed(shape, {}, at + 0.03 * random_in_ball(bits))));
  }
  builder.contact(0, 0, frictional(5e7, 5e7, 0.6, 1e-3), "rubble");
  return builder.build();
}

constexpr double pour_step = 1e-4;

/// Bricks in a row on a plate, with gaps of 0.05 mm between them.
Model<3> row_of_bricks(int count) {
  SpaceBuilder builder;
  builder.gravity(Vec3(0, 0, -standard_gravity));
  builder.add(fixed_stone("plate", box_solid(Vec3(-1, -1, -0.2), Vec3(4, 1, 0))));
  for (int i = 0; i < count; ++i)
    builder.add(stone("brick " + std::to_string(i), box_at(Vec3(0.4, 0.2, 0.2), Vec3(0.40005 * i, 0, 0.1))));
  builder.contact(0, 0, frictional(1e9, 5e8, 0.2, 1e-5), "dry");
  return builder.build();
}

}  // namespace

TEST_CASE("stones poured into a tray stay in it and come to rest, and the energy balance closes") {
  const int count = 18;
  SolidRun run(poured(count), pour_step);
  double fall = 0;
  for (std::size_t n = 1; n <= count; ++n)
    fall += run.model().mass[n] * standard_gravity * run.model().start_position[n].z();
  const double begun = run.energy().balance();
  run.run(3);
  const Energy energy = run.energy();
  CHECK(energy[EnergyTerm::kinetic] < 1e-2 * fall);
  CHECK(near_zero(energy.balance() - begun, 1e-3 * fall));
  for (int n = 1; n <= count; ++n) {
    CHECK(run.place(n).z() > 0);
    CHECK(run.place(n).head<2>().cwiseAbs().maxCoeff() < 1);
  }
}

TEST_CASE("bricks whose joints open and close have the same bits on any number of threads") {
  const Model<3> model = row_of_bricks(60);
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 3}) {
    State<3> state = initial_state(model);
    for (int n = 1; n < model.nodes(); ++n) state.velocity[n] = Vec3(n % 2 == 0 ? -0.2 : 0.2, 0, 0);
    Work<3> work;
    work.threads = threads;
    StepOptions options;
    options.dt = 5e-5;
    std::size_t runs = 0, later = 0;
    for (int i = 0; i < 500; ++i) {
      evaluate(model, state, work, state.last_dt);
      runs = std::max(runs, work.general_runs.size());
      for (const GeneralRun<3>& run : work.general_runs) later = std::max(later, run.later.size());
      add_inertia(model, state, work, options);
      commit(model, state, work);
      advance(model, state, work, options);
    }
    CHECK((runs > 1) == (threads > 1));
    CHECK((later > 0) == (threads > 1));  // forces on bricks shared by two runs
    hashes.push_back(state_hash(state));
  }
  CHECK(hashes[0] == hashes[1]);
  CHECK(hashes[0] == hashes[2]);
}

TEST_CASE("a pile of solids has the same bits after its scratch memory is freed") {
  SolidRun plain(poured(18), pour_step), dropped(poured(18), pour_step);
  for (int i = 0; i < 8000; ++i) {
    if (i % 37 == 0) dropped.drop_work();
    plain.step(), dropped.step();
    if (i % 1000 == 0) REQUIRE(state_hash(plain.state()) == state_hash(dropped.state()));
  }
  CHECK(state_hash(plain.state()) == state_hash(dropped.state()));
}

// Joints that open and close: pairs change between flat face contacts, sleeping pairs, and separated but awake pairs.
TEST_CASE("bricks whose joints open and close have the same bits where their Work is dropped") {
  const int count = 5;
  SolidRun plain(row_of_bricks(count), 5e-5), dropped(row_of_bricks(count), 5e-5);
  for (SolidRun* run : {&plain, &dropped}) {
    for (std::size_t n = 1; n <= count; ++n) {
      run->state().velocity[n] = Vec3(n % 2 == 0 ? -0.2 : 0.2, 0, 0);
      run->state().spin[n] = Vec3(0, 0, n % 2 == 0 ? 0.01 : 0);
    }
    run->drop_work();
  }
  int opened_or_closed = 0;
  for (int i = 0; i < 2000; ++i) {
    if (i % 3 == 0) dropped.drop_work();
    plain.step(), dropped.step();
    for (const int row : plain.work().changed_rows)
      if (plain.work().pairs[static_cast<std::size_t>(row)].piece_a > 0) ++opened_or_closed;
    REQUIRE(state_hash(plain.state()) == state_hash(dropped.state()));
  }
  CHECK(opened_or_closed >= 4);  // two joints close, and the bricks bounce
}

TEST_CASE("a pile of solids saved and continued gives the same bits as one run without interruption") {
  const Model<3> model = poured(12);
  SolidRun whole(model, pour_step);
  whole.run(0.3);
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("pile" + std::to_string(::getpid()) + ".state");
  save_state(whole.state(), model, path);
  SolidRun rest(model, load_state(model, path), pour_step);
  std::filesystem::remove(path);
  CHECK(state_hash(rest.state()) == state_hash(whole.state()));
  whole.run(0.1), rest.run(0.1);
  CHECK(state_hash(rest.state()) == state_hash(whole.state()));
}
