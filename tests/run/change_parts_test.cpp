// Models that change: bodies are removed, reactivated and added; the others do not change, and the energy balance
// closes.
#include <fmt/format.h>

#include "integrate/explicit/central_difference.hpp"
#include "model/check/energy_check.hpp"
#include "model/io/checkpoint.hpp"
#include "near.hpp"
#include "physics/scene.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Two blocks on each other on the ground, and a fixed one in the air next to them.
Scene tower() {
  Scene scene(Frictional{1e8, 4e7, 0.6, 2e-3});
  scene.fixed("ground", box(-3, -1, 3, 0));
  scene.block("lower", box(-0.5, 0, 0.5, 0.5), 1000);
  scene.block("upper", box(-0.5, 0.5, 0.5, 1), 1000);
  scene.fixed("beside", box(1, 0.5, 2, 1));
  return scene;
}

StageOptions short_stage(double duration) {
  StageOptions options;
  options.duration = duration;
  options.dt = 1e-4;
  options.energy_interval = 5e-3;
  return options;
}

/// Runs a stage and passes the ledger to `check`, whose residuals are relative to the first sample of all.
void run_checked(Simulation<2>& sim, double duration, EnergyCheck& check, std::optional<double>& first) {
  RunListener<2> listener;
  listener.on_energy = [&](const Instant<2>&, const Energy& energy) {
    if (!first) first = energy.balance();
    check.add(energy, energy.balance() - *first);
  };
  sim.run(short_stage(duration), listener);
}

int body(const Simulation<2>& sim, const char* name) {
  return sim.model().find_body(name);
}

}  // namespace

TEST_CASE("a body removed and returned before any step leaves the bits of an unchanged run") {
  Simulation<2> plain(tower().builder.build()), changed(tower().builder.build());
  const std::vector<int> beside{body(plain, "beside")};
  for (const double duration : {0.1, 0.1, 0.1}) {
    plain.run(short_stage(duration));
    changed.run(short_stage(duration));
    if (changed.state().is_removed(static_cast<std::size_t>(beside[0])))
      changed.reactivate({beside, {}});
    else
      changed.remove({beside, {}});
  }
  REQUIRE(!changed.state().position.empty());
  for (std::size_t n = 0; n < plain.state().position.size(); ++n) {
    CHECK(plain.state().position[n] == changed.state().position[n]);
    CHECK(plain.state().velocity[n] == changed.state().velocity[n]);
  }
  CHECK(changed.state().given[EnergyTerm::removed] == 0);
  CHECK(changed.state().given[EnergyTerm::added] == 0);
}

TEST_CASE("a body supported by a removed body falls freely from the next step on, without an impulse") {
  Simulation<2> sim(tower().builder.build());
  StageOptions rest = short_stage(2);
  rest.rest_share = 0.8;
  sim.run(rest);
  const auto upper = static_cast<std::size_t>(sim.model().bodies[body(sim, "upper")].first_node);
  const double height = sim.state().position[upper].y();
  const std::vector<int> lower{body(sim, "lower")};
  sim.remove({lower, {}});
  const double t = 0.2;
  sim.run(short_stage(t));
  CHECK(near(sim.state().position[upper].y() - height, -0.5 * standard_gravity * t * t, 0.01));
  CHECK(std::abs(sim.state().position[upper].x()) < 1e-9);
}

TEST_CASE("the energy balance closes through the removal of moving and pressed bodies, with their energy in its term") {
  Simulation<2> sim(tower().builder.build());
  EnergyCheck check;
  std::optional<double> first;
  run_checked(sim, 0.05, check, first);
  const std::vector<int> upper{body(sim, "upper")};
  const auto node = static_cast<std::size_t>(sim.model().bodies[upper[0]].first_node);
  const double speed = sim.state().velocity[node].norm();
  CHECK(speed > 0);
  sim.remove({upper, {}});
  CHECK(sim.state().given[EnergyTerm::removed] > 0.5 * 1000 * speed * speed * 0.9);
  run_checked(sim, 0.5, check, first);
  sim.reactivate({upper, {}});
  run_checked(sim, 0.5, check, first);
  CHECK(check.share() < 1e-3);
  CHECK(check.input() > 0);
}

TEST_CASE("added bodies rest on present ones, and the energy balance closes") {
  Scene scene = tower();
  Simulation<2> sim(scene.builder.build());
  EnergyCheck check;
  std::optional<double> first;
  run_checked(sim, 1, check, first);
  scene.block("third", box(-0.5, 1.0001, 0.5, 1.5), 500);
  sim.grow(scene.builder.extended(sim.model(), sim.state()));
  CHECK(sim.model().bodies.size() == 5);
  CHECK(sim.state().position.size() == 5);
  run_checked(sim, 2, check, first);
  const auto third = static_cast<std::size_t>(sim.model().bodies[body(sim, "third")].first_node);
  CHECK(near(sim.state().position[third].y(), 1.25, 1e-3));
  CHECK(sim.state().velocity[third].norm() < 1e-3);
  CHECK(check.share() < 1e-3);
}

TEST_CASE("added and removed bodies are restored from a checkpoint") {
  const testing::Folder folder;
  Scene scene = tower();
  Simulation<2> sim(scene.builder.build());
  sim.run(short_stage(0.2));
  const std::vector<int> lower{body(sim, "lower")};
  sim.remove({lower, {}});
  sim.run(short_stage(0.1));
  save_state(sim.state(), sim.model(), folder / "changed");
  Simulation<2> again(tower().builder.build(), load_state(tower().builder.build(), folder / "changed"));
  CHECK(again.state().is_removed(static_cast<std::size_t>(lower[0])));
  CHECK(again.state().removed_at == sim.state().removed_at);
  sim.run(short_stage(0.2));
  again.run(short_stage(0.2));
  CHECK(state_hash(sim.state()) == state_hash(again.state()));
}

TEST_CASE("a run restored to before a removal and an addition has the bits of an uninterrupted run") {
  Scene scene = tower();
  Simulation<2> sim(scene.builder.build());
  sim.run(short_stage(0.1));
  const Snapshot<2> kept = sim.snapshot();
  sim.run(short_stage(0.2));
  const std::uint64_t through = state_hash(sim.state());
  sim.restore(kept);
  scene.block("third", box(-0.5, 1.0001, 0.5, 1.5), 500);
  sim.grow(scene.builder.extended(sim.model(), sim.state()));
  const std::vector<int> lower{body(sim, "lower")};
  sim.remove({lower, {}});
  sim.run(short_stage(0.2));
  sim.restore(kept);
  CHECK(sim.model().bodies.size() == 4);
  sim.run(short_stage(0.2));
  CHECK(state_hash(sim.state()) == through);
}

TEST_CASE("a new body may not stand in another, nor on one that was removed") {
  Scene scene = tower();
  Simulation<2> sim(scene.builder.build());
  sim.run(short_stage(0.1));
  const std::vector<int> upper{body(sim, "upper")};
  sim.remove({upper, {}});
  Scene inside = tower(), above = tower(), instead = tower();
  inside.block("third", box(-0.5, 0.2, 0.5, 0.7), 500);
  CHECK_THROWS_WITH_AS(inside.builder.extended(sim.model(), sim.state()), doctest::Contains("overlap by"), InputError);
  above.block("third", box(-0.5, 1.0001, 0.5, 1.5), 500);
  CHECK_THROWS_WITH_AS(above.builder.extended(sim.model(), sim.state()), doctest::Contains("'third' has no support"),
                       InputError);
  instead.block("third", box(-0.5, 0.5001, 0.5, 1), 500);
  CHECK(instead.builder.extended(sim.model(), sim.state()).bodies.size() == 5);
}
