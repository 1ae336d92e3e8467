// What flies fast and thin is held where the law can hold it.
#include "step/sweep.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "base/error.hpp"
#include "physics/collapses.hpp"
#include "physics/scene.hpp"
#include "step/central_difference.hpp"
#include "step/evaluate.hpp"
#include "step/stable_step.hpp"
#include "step/start.hpp"
#include "world/checkpoint.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A square of 5 cm and 6 kg that flies down at a held plate, without gravity and damping.
struct Shot {
  double kn, plate, speed;  ///< [Pa/m], [m], [m/s]
  double dt = 0;            ///< of the stage [s]

  /// Of the overlap at which all energy is elastic, as of two flat faces [m].
  [[nodiscard]] static double speed_for(double kn, double depth) { return depth * std::sqrt(kn * 0.05 / 6); }
  [[nodiscard]] Scene scene() const {
    Scene s(Frictional{kn, kn / 2, 0, 0});
    s.set_gravity({0, 0});
    s.fixed("plate", box(-0.5, -plate, 0.5, 0));
    s.block("shot", box(-0.025, 0.02, 0.025, 0.07), 6, {0, -speed});
    return s;
  }
  struct End {
    double y, speed;  ///< of its middle [m], upwards [m/s]
    StageReport report;
  };
  /// Followed for as long as it takes to go 20 cm.
  [[nodiscard]] End fly() const {
    Simulation sim = scene().start();
    const StageReport report = run_for(sim, 0.2 / speed, dt);
    const int n = node_of(sim.model(), "shot");
    return {sim.state().position[n].y(), sim.state().velocity[n].y(), report};
  }
};

}  // namespace

TEST_CASE("a plate holds what its law can stop in a third of its thickness however fast that comes") {
  for (const double plate : {0.001, 0.01})
    for (const double kn : {1e8, 1e10, 1e12}) {
      const double speed = Shot::speed_for(kn, plate / 3);
      const Shot::End end = Shot{kn, plate, speed}.fly();
      INFO("kn ", kn, " plate ", plate, " speed ", speed, " back at ", end.speed, ", ", end.report.steps, " steps");
      CHECK(end.y > 0.025);
      CHECK(end.speed == near(speed, 0.05));
    }
}

TEST_CASE("the step shrinks for the hit and goes back after it") {
  const double speed = Shot::speed_for(1e10, 0.01 / 3);
  Simulation sim = Shot{1e10, 0.01, speed}.scene().start();
  double longest = 0, shortest = 1, last = 0;
  double deepest_step = 0, before = unbounded;
  run_for(sim, 0.2 / speed, 0, each_step([&](const Instant& now) {
            last = now.state.last_dt;
            longest = std::max(longest, last), shortest = std::min(shortest, last);
            const double y = now.state.position[1].y();
            if (before < 0.025) deepest_step = std::max(deepest_step, before - y);
            before = y;
          }));
  CHECK(longest == sim.state().dt);
  CHECK(shortest <= longest);
  CHECK(deepest_step <= 1.001 * depth_per_step * 0.01);
}

TEST_CASE("collapses at common speeds take the steps they took without the sweep") {
  for (const Collapse& c : collapses()) {
    const Model<2> model = c.model();
    State<2> state = start_state(model);
    Work<2> work;
    std::int64_t shrunk = 0;
    while (state.time < c.duration) {
      evaluate(model, state, work, state.last_dt);
      if (state.step % 32 == 0) state.dt = settled_step(stable_step(model, state, work).dt, 0.5);
      shrunk += swept_step(model, state, work, state.dt).dt != state.dt ? 1 : 0;
      advance(model, state, work, {state.dt, {}});
    }
    INFO(c.name);
    CHECK(shrunk == 0);
  }
}

TEST_CASE("a run saved amid shrunk steps or with its Work dropped at each goes on with the same bits") {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("trilith_swept_" + std::to_string(::getpid()));
  const Shot shot{1e10, 0.001, 300};
  const double end = 0.2 / shot.speed;
  Simulation whole = shot.scene().start(), parts = shot.scene().start();
  StageOptions options;
  options.duration = options.end_time = end;
  std::int64_t saved_at = 0;
  RunListener listener;
  listener.on_step = [&](const Instant& now) {
    if (now.state.last_dt > 0.5 * now.state.dt || saved_at > 0) return;
    saved_at = now.state.step;
    save_state(now.state, now.model, path);
  };
  whole.run(options, listener);
  REQUIRE(saved_at > 0);
  Simulation loaded(shot.scene().builder.build(), load_state(shot.scene().builder.build(), path));
  loaded.run(options);
  CHECK(state_hash(loaded.state()) == state_hash(whole.state()));
  RunListener dropping;
  dropping.at_border = [&] { parts.drop_work(); };
  parts.run(options, dropping);
  CHECK(state_hash(parts.state()) == state_hash(whole.state()));
  std::filesystem::remove(path);
}

TEST_CASE("a step that is given and could carry a body past a middle is refused with the step it takes") {
  const double speed = Shot::speed_for(1e8, 0.03);
  const auto message = [&](double dt) -> std::string {
    try {
      static_cast<void>(Shot{1e8, 0.01, speed, dt}.fly());
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  const double past_middle = 0.005 / speed;
  CHECK(message(0.9 * past_middle).empty());
  const std::string refused = message(1.2 * past_middle);
  INFO(refused);
  CHECK(refused.find("'plate' and 'shot' meet at") != std::string::npos);
  CHECK(refused.find(fmt::format("at most {:.2g} s", 0.001 / speed)) != std::string::npos);
}
