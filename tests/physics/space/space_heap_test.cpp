// Heaps of deformable and rigid stones in space: bits, energy ledger.
#include <fmt/format.h>

#include <doctest/doctest.h>

#include <cmath>
#include <span>

#include "model/io/state_words.hpp"
#include "near.hpp"
#include "physics/space/soft_solids.hpp"

namespace trilith::testing {
namespace {

/// Stones of all kinds that fall on each other.
Model<3> heap() {
  SolidModelBuilder builder = soft_world(frictional(2e7, 2e7, 0.6, 1e-3), 5e7, 0.2, 1e-4);
  builder.add_body(fixed_box("ground", box_solid(Vec3(-2, -2, -0.5), Vec3(2, 2, 0))));
  for (int i = 0; i < 9; ++i) {
    const Polyhedron box = box_at(Vec3(0.5, 0.4, 0.3), Vec3(0.1 * (i % 3), 0.08 * (i % 2), 0.4 + 0.72 * i),
                                  rotation_by(Vec3(0.2 * i, 0.1, 0.3 * i)));
    SolidSpec spec =
        i % 4 == 3 ? rigid_box(fmt::format("s{}", i), box)
                   : box_of(fmt::format("s{}", i), box, "soft", {1, 1, 1}, all_shapes[static_cast<std::size_t>(i % 3)]);
    spec.floating = true;
    builder.add_body(std::move(spec));
  }
  return builder.build();
}

constexpr double heap_step = 1e-4;

TEST_CASE("a heap of deformable and rigid stones has the same bits on any number of threads, saved and continued" *
          doctest::test_suite("long")) {
  const Model<3> model = heap();
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 3}) {
    State<3> state = initial_state(model);
    Work<3> work;
    work.threads = threads;
    for (int i = 0; i < 4500; ++i) {
      StepOptions options;
      options.dt = heap_step;
      evaluate(model, state, work, state.last_dt);
      add_inertia(model, state, work, options);
      commit(model, state, work);
      advance(model, state, work, options);
      if (threads == 1 && i == 3000) {
        const auto words = state_words(state);
        state = state_from_words(model, std::span<const std::uint64_t>(words), "here");
        work.drop();
      }
    }
    hashes.push_back(state_hash(state));
  }
  CHECK(hashes[0] == hashes[1]);
  CHECK(hashes[0] == hashes[2]);
}

TEST_CASE("the energy balance of a heap of deformable stones that fall closes" * doctest::test_suite("long")) {
  const Model<3> model = heap();
  SolidRun run(model, heap_step);
  double fall = 0;
  for (int n = 0; n < model.nodes(); ++n)
    if (model.moves(n)) fall += model.mass[n] * standard_gravity * model.start_position[n].z();
  const double begun = run.energy().balance();
  run.run(1.5);
  CHECK(near_zero(run.energy().balance() - begun, 1e-2 * fall));
  // Stones that have rolled over the edge of the ground fall next to it.
  for (int n = 1; n < model.nodes(); ++n)
    if (const Vec3& at = run.state().position[n]; at.head<2>().cwiseAbs().maxCoeff() < 2) CHECK(at.z() > -0.2);
}

}  // namespace
}  // namespace trilith::testing
