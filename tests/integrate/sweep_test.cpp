// Fast and thin bodies: stopped if the contact law can stop them, and reported if they pass through.
#include "integrate/explicit/tunnelling_limit.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <random>

#include "assembly/evaluate.hpp"
#include "assembly/start.hpp"
#include "base/error.hpp"
#include "events/commit.hpp"
#include "geometry/plane/random_convex.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "model/io/checkpoint.hpp"
#include "near.hpp"
#include "physics/collapses.hpp"
#include "physics/scene.hpp"
#include "physics/space/solids.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// The events body.passed of a run.
struct EventLog {
  std::vector<Event> passed;
  [[nodiscard]] RunListener<2> listener() {
    RunListener<2> l;
    l.on_event = [this](const Event& e, const Instant<2>&) {
      if (e.type == EventType::body_passed) passed.push_back(e);
    };
    return l;
  }
};

/// A square of 5 cm and 6 kg that flies down at a fixed plate, without gravity and damping.
struct Shot {
  double kn, plate, speed;  ///< [Pa/m], [m], [m/s]
  double dt = 0;            ///< of the stage [s]

  /// Speed at which flat faces store all energy at the penetration `depth` [m] [m/s].
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
    std::vector<Event> passed;
    StageReport report;
  };
  /// Runs over a flight of 20 cm.
  [[nodiscard]] End fly() const {
    Simulation<2> sim = scene().start();
    EventLog log;
    const StageReport report = run_for(sim, 0.2 / speed, dt, log.listener());
    const int n = node_of(sim.model(), "shot");
    return {sim.state().position[n].y(), sim.state().velocity[n].y(), log.passed, report};
  }
};

}  // namespace

TEST_CASE("a plate stops any body that its law can stop within a third of its thickness, at any speed") {
  for (const double plate : {0.001, 0.01})
    for (const double kn : {1e8, 1e10, 1e12}) {
      const double speed = Shot::speed_for(kn, plate / 3);
      const Shot::End end = Shot{kn, plate, speed}.fly();
      INFO("kn ", kn, " plate ", plate, " speed ", speed, " back at ", end.speed, ", ", end.report.steps, " steps");
      CHECK(end.passed.empty());
      CHECK(end.y > 0.025);
      CHECK(near(end.speed, speed, 0.05));
    }
}

TEST_CASE("a penetration beyond half a thickness is reported once with place and depth") {
  for (const double plate : {0.001, 0.01})
    for (const double kn : {1e8, 1e10}) {
      for (const double share : {0.8, 3.0, 30.0, 3000.0}) {
        const double speed = Shot::speed_for(kn, share * plate);
        const Shot::End end = Shot{kn, plate, speed}.fly();
        INFO("kn ", kn, " plate ", plate, " speed ", speed);
        REQUIRE(end.passed.size() == 1);
        const Event& e = end.passed[0];
        CHECK(e.value > 0.5 * plate);
        CHECK(e.value < (0.5 + 1.5 * depth_per_step) * plate);
        CHECK(std::abs(e.y) < plate);
        CHECK(std::abs(e.x) <= 0.025 + 1e-9);
        CHECK(e.body_a == 1);
        CHECK(e.body_b == 0);
        CHECK(e.text.find("would prevent it") != std::string::npos);
      }
    }
}

TEST_CASE("a projectile is stopped with the recommended stiffness") {
  for (const double speed : {30.0, 1000.0, 10000.0}) {
    const Shot::End end = Shot{1e8, 0.01, speed}.fly();
    REQUIRE(end.passed.size() == 1);
    const std::string& text = end.passed[0].text;
    const double kn = std::stod(text.substr(text.find("kn of ") + 6));
    const Shot::End held = Shot{kn, 0.01, speed}.fly();
    INFO(text);
    CHECK(held.passed.empty());
    CHECK(held.y > 0.025);
    CHECK_FALSE(Shot{0.05 * kn, 0.01, speed}.fly().passed.empty());
  }
}

TEST_CASE("the step is reduced for an impact and restored afterwards") {
  const double speed = Shot::speed_for(1e10, 0.01 / 3);
  Simulation<2> sim = Shot{1e10, 0.01, speed}.scene().start();
  double longest = 0, shortest = 1, last = 0;
  double deepest_step = 0, before = unbounded;
  run_for(sim, 0.2 / speed, 0, each_step([&](const Instant<2>& now) {
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

TEST_CASE("no projectile passes a plate without a report, for any shape, angle, speed and stiffness") {
  std::mt19937_64 bits(11);
  int passed = 0, held = 0;
  for (int i = 0; i < 150; ++i) {
    const double kn = std::pow(10.0, random_between(bits, 7, 12)),
                 plate = std::pow(10.0, random_between(bits, -3.3, -1.7)),
                 speed = std::pow(10.0, random_between(bits, -1.5, 1.5)) * Shot::speed_for(kn, plate),
                 angle = random_between(bits, -1, 1);
    Scene scene(Frictional{kn, kn / 2, 0.5, i % 2 == 0 ? 0 : 0.2 / std::sqrt(kn)});
    scene.fixed("plate", box(-1, -plate, 1, 0));
    RandomConvex wanted;
    wanted.smallest = 0.02, wanted.largest = 0.1, wanted.slenderest = 10;
    BodySpec spec;
    spec.name = "shot", spec.outline = placed(random_convex(bits, wanted), random_direction(bits), {0, 0.06});
    spec.velocity = speed * Vec2(std::sin(angle), -std::cos(angle)),
    spec.spin = random_between(bits, -1, 1) * 5 * speed;
    spec.floating = true;
    scene.add(spec);
    Simulation<2> sim = scene.start();
    EventLog log;
    run_for(sim, 0.3 / speed, 0, log.listener());
    const bool through = sim.state().position[1].y() < -0.5 * plate;
    INFO("shot ", i, ": kn ", kn, " plate ", plate, " speed ", speed, " angle ", angle, " y ",
         sim.state().position[1].y());
    CHECK((log.passed.size() == 1 || !through));
    CHECK(log.passed.size() <= 1);
    passed += through ? 1 : 0;
    held += log.passed.empty() ? 1 : 0;
  }
  MESSAGE(passed, " passed, ", held, " never got deep");
  CHECK(passed > 20);
  CHECK(held > 20);
}

TEST_CASE("penetrations of deformable and of rigid plates and projectiles are limited and reported alike") {
  enum class Soft { plate, shot };
  const auto fly = [](Soft soft, double share) {
    const double kn = 1e10, plate = 0.01, speed = Shot::speed_for(kn, share * plate);
    ModelBuilder builder;
    builder.gravity = Vec2::Zero();
    builder.add_material(elastic("steel", 2400, 2e11, 0.2));
    builder.add_law("joint", Frictional{kn, kn / 2, 0, 0});
    builder.set_contact("*", "*", "joint");
    BodySpec low = grid_body("plate", box(-0.06, -plate, 0.06, 0), "steel", 6, 2);
    BodySpec high = grid_body("shot", box(-0.025, 0.02, 0.025, 0.07), "steel", 2, 2);
    (soft == Soft::plate ? high : low).kind = BodyKind::rigid;
    low.support = held, high.velocity = {0, -speed};
    if (soft == Soft::plate)
      low.support = {Support::free, Support::free, Support::free},
      low.supports.push_back({{-0.06, -plate}, {0.06, -plate}, {Support::fixed, Support::fixed}});
    builder.add_body(low);
    builder.add_body(high);
    Simulation<2> sim(builder.build());
    EventLog log;
    run_for(sim, 0.2 / speed, 0, log.listener());
    const Body& shot = sim.model().bodies[1];
    return std::pair(sim.state().position[shot.first_node].y() < -plate, log.passed);
  };
  for (const Soft soft : {Soft::plate, Soft::shot}) {
    const std::string who = soft == Soft::plate ? "plate" : "shot";
    INFO(who, " of elements");
    const auto [through, none] = fly(soft, 0.3);
    CHECK_FALSE(through);
    CHECK(none.empty());
    for (const double share : {3.0, 300.0}) {
      const auto [gone, reported] = fly(soft, share);
      CHECK(reported.size() == 1);
      for (const Event& e : reported) CHECK(e.value > 0.005);
    }
  }
}

TEST_CASE("a body crushed by another of 1e9 times its mass is reported") {
  Scene scene(Frictional{1e8, 5e7, 0.6, 1e-4});
  scene.fixed("base", box(-1, -0.2, 1, 0));
  scene.block("small", box(-0.05, 0, 0.05, 0.1), 10);
  scene.block("large", box(-0.5, 0.101, 0.5, 1.1), 1e10);
  Simulation<2> sim = scene.start();
  EventLog log;
  run_for(sim, 0.5, 0, log.listener());
  CHECK(log.passed.size() > 0);
}

TEST_CASE("a rotating thin bar is stopped by a peg, or its passage is reported") {
  const auto turn = [](double kn, double spin) {
    Scene scene(Frictional{kn, kn / 2, 0, 0});
    scene.set_gravity({0, 0});
    scene.fixed("peg", box(-0.01, 0.39, 0.01, 0.41));
    BodySpec bar;
    bar.name = "bar", bar.outline = box(-0.5, -0.002, 0.5, 0.002), bar.spin = spin, bar.floating = true;
    bar.support = {Support::fixed, Support::fixed, Support::free};
    scene.add(bar);
    Simulation<2> sim = scene.start();
    EventLog log;
    run_for(sim, 3 / spin, 0, log.listener());
    return std::pair(sim.state().rotation[1] > 1.7, !log.passed.empty());
  };
  for (const double spin : {3.0, 30.0, 300.0, 3000.0})
    for (const double kn : {1e8, 1e10, 1e12}) {
      const auto [through, reported] = turn(kn, spin);
      INFO("spin ", spin, " kn ", kn);
      CHECK((reported || !through));
      // 1/2 I w^2 against the energy stored by 2 cm of peg at a quarter of the bar's 4 mm.
      const double inertia = 8.0 / 12, energy = 0.5 * inertia * spin * spin, store = 0.5 * kn * 0.02 * 1e-6;
      if (energy < 0.3 * store) CHECK_FALSE(reported);
      if (energy > 30 * store) CHECK(reported);
    }
}

TEST_CASE("a body driven through a plate within one step is reported") {
  Scene scene(Frictional{1e6, 5e5, 0, 0});
  scene.set_gravity({0, 0});
  scene.fixed("plate", box(-0.5, -0.001, 0.5, 0));
  BodySpec spec;
  spec.name = "shot", spec.outline = box(-0.025, 0.01, 0.025, 0.06), spec.mass = 1, spec.load = {0, -1e9};
  spec.floating = true;
  scene.add(spec);
  Simulation<2> sim = scene.start();
  EventLog log;
  run_for(sim, 2e-3, 0, log.listener());
  CHECK(sim.state().position[1].y() < -0.1);
  CHECK(log.passed.size() == 1);
}

TEST_CASE("collapses at common speeds have the same steps without the tunnelling limit") {
  for (const Collapse& c : collapses()) {
    const Model<2> model = c.model();
    State<2> state = start_state(model);
    Work<2> work;
    std::int64_t shrunk = 0;
    while (state.time < c.duration) {
      evaluate(model, state, work, state.last_dt);
      if (state.step % 32 == 0) state.dt = settled_step(stable_step(model, state, work).dt, 0.4);
      shrunk += tunnelling_limit(model, state, work, state.dt).dt != state.dt ? 1 : 0;
      commit(model, state, work);
      advance(model, state, work, {state.dt, {}});
    }
    INFO(c.name);
    CHECK(shrunk == 0);
    CHECK(state.passed.empty());
  }
}

TEST_CASE(
    "a run saved during reduced steps, or with scratch memory freed at each, continues with the same bits and events") {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("trilith_swept_" + std::to_string(::getpid()));
  const Shot shot{1e10, 0.001, 300};
  const double end = 0.2 / shot.speed;
  Simulation<2> whole = shot.scene().start(), parts = shot.scene().start();
  EventLog of_whole, of_parts;
  StageOptions options;
  options.duration = options.end_time = end;
  std::int64_t saved_at = 0;
  RunListener<2> listener = of_whole.listener();
  listener.on_step = [&](const Instant<2>& now) {
    if (now.state.last_dt > 0.5 * now.state.dt || saved_at > 0) return;
    saved_at = now.state.step;
    save_state(now.state, now.model, path);
  };
  whole.run(options, listener);
  REQUIRE(saved_at > 0);
  Simulation<2> loaded(shot.scene().builder.build(), load_state(shot.scene().builder.build(), path));
  EventLog of_loaded;
  loaded.run(options, of_loaded.listener());
  CHECK(state_hash(loaded.state()) == state_hash(whole.state()));
  RunListener<2> dropping = of_parts.listener();
  dropping.at_border = [&] { parts.drop_work(); };
  parts.run(options, dropping);
  CHECK(state_hash(parts.state()) == state_hash(whole.state()));
  REQUIRE(of_whole.passed.size() == 1);
  REQUIRE(of_loaded.passed.size() + of_parts.passed.size() == 2);
  for (const Event& e : {of_loaded.passed[0], of_parts.passed[0]}) {
    CHECK(e.step == of_whole.passed[0].step);
    CHECK(e.value == of_whole.passed[0].value);
  }
  std::filesystem::remove(path);
}

TEST_CASE("a given step in which a body could pass the middle of another is rejected with the allowed step") {
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
