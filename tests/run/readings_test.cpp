// All readings, wherever they are read, belong to one instant.
#include <algorithm>
#include <vector>

#include "assembly/contact/contact_resultants.hpp"
#include "base/error.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using testing::box;
using testing::near;
using testing::Scene;

namespace {

/// All readings of one instant, as numbers.
struct Reading {
  double time;
  std::vector<double> values;
};

Reading read(const Simulation<2>& sim) {
  Reading out{sim.state().time, {}};
  const Energy energy = sim.energy();
  out.values.assign(energy.value.begin(), energy.value.end());
  std::vector<TouchingContact> touching;
  contact_resultants(sim.model(), sim.state(), sim.work(), touching);
  for (const TouchingContact& c : touching)
    for (const int k : {0, 1}) out.values.insert(out.values.end(), {c.resultant.point[k], c.resultant.force[k]});
  for (const Vec2& f : sim.work().bearing_force) out.values.insert(out.values.end(), {f.x(), f.y()});
  out.values.insert(out.values.end(), {sim.work().unbalanced, sim.work().fastest_moving});
  return out;
}

/// A block that falls on its corner, bounces, tumbles and slides: faces, corners and flight alternate.
Scene tumbling() {
  Scene scene(Frictional{1e8, 5e7, 0.5, 1e-4});
  scene.fixed("base", box(-3, -1, 3, 0));
  BodySpec spec;
  spec.name = "block", spec.outline = box(-0.25, 0.1, 0.25, 0.4), spec.velocity = {1, -1}, spec.spin = 2,
  spec.floating = true;
  scene.add(spec);
  return scene;
}

/// Readings of histories at every step of a run, and readings of handlers.
struct Readings {
  std::vector<Reading> histories, handlers, events;
};

Readings readings_of(Scene scene, const StageOptions& asked, bool change = false) {
  Simulation<2> sim = scene.start();
  Readings out;
  StageOptions options = asked;
  options.history_interval = 1e-9;
  RunListener<2> listener;
  listener.on_history = [&](const Instant<2>&) { out.histories.push_back(read(sim)); };
  listener.on_step = [&](const Instant<2>&) { out.handlers.push_back(read(sim)); };
  listener.on_event = [&](const Event&, const Instant<2>&) { out.events.push_back(read(sim)); };
  if (change) listener.change_model = [](Model<2>&) { return true; };
  sim.run(options, listener);
  return out;
}

void check_equal(const std::vector<Reading>& some, const std::vector<Reading>& all) {
  for (const Reading& r : some) {
    const auto at = std::find_if(all.begin(), all.end(), [&](const Reading& h) { return h.time == r.time; });
    REQUIRE(at != all.end());
    REQUIRE(r.values == at->values);
  }
}

TEST_CASE("handlers of steps and events read the values of histories at the same time, to the bit") {
  StageOptions options;
  options.duration = 1;
  for (const double share : {0.0, 0.5}) {
    options.rest_share = share;
    const Readings all = readings_of(tumbling(), options);
    REQUIRE(all.handlers.size() > 500);
    CHECK(all.histories.size() == all.handlers.size() + 1);
    CHECK(all.events.size() > 4);
    check_equal(all.handlers, all.histories);
    check_equal(all.events, all.histories);
  }
}

TEST_CASE("a handler that requests no real change does not change the results") {
  StageOptions options;
  options.duration = 0.5;
  const Readings plain = readings_of(tumbling(), options), changed = readings_of(tumbling(), options, true);
  REQUIRE(plain.histories.size() == changed.histories.size());
  check_equal(changed.histories, plain.histories);
}

// Leapfrog starts from a full velocity with half a step, which shifts its energy from this point on: m g^2 dt^2 / 8.
TEST_CASE("the energy balance of a falling block closes at every step as handlers read it and after the stage") {
  Scene scene(Frictional{1e8, 5e7, 0.5, 1e-4});
  scene.fixed("base", box(-3, -1, 3, 0));
  BodySpec spec;
  spec.name = "block", spec.outline = box(-0.25, 20, 0.25, 20.3), spec.mass = 300, spec.floating = true;
  scene.add(spec);
  Simulation<2> sim = scene.start();
  sim.refresh();
  const double g = standard_gravity, dt = 1e-4, mass = 300, fallen = mass * g * g / 2;
  const double start = sim.energy().balance() - mass * g * g * dt * dt / 8;
  double worst = 0;
  testing::run_for(sim, 1, dt, testing::each_step([&](const Instant<2>&) {
                     worst = std::max(worst, std::abs(sim.energy().balance() - start));
                   }));
  CHECK(worst < 1e-10 * fallen);
  sim.refresh();
  CHECK(std::abs(sim.energy().balance() - start) < 1e-10 * fallen);
  CHECK(near(sim.energy()[EnergyTerm::kinetic], fallen, 1e-3));
}

TEST_CASE("reading between stages gives the last row of the stage and changes no later bit") {
  StageOptions options;
  options.duration = 0.3;
  options.energy_interval = 0.01;
  options.rest_share = 0.3;
  std::uint64_t hash[2];
  for (const int reads : {0, 1}) {
    Simulation<2> sim = tumbling().start();
    Energy last;
    RunListener<2> listener;
    listener.on_energy = [&](const Instant<2>&, const Energy& e) { last = e; };
    sim.run(options, listener);
    if (reads != 0) {
      sim.drop_work();
      sim.refresh();
      CHECK(sim.energy().value == last.value);
    }
    sim.run(options);
    hash[reads] = state_hash(sim.state());
  }
  CHECK(hash[0] == hash[1]);
}

/// Error message of a stage with `dt` on joints of `kn` [Pa/m]; empty if it runs.
std::string refusal(double kn, double dt, double duration, double safety = 0.5, double beta = 0) {
  Scene scene(Frictional{kn, kn / 2, 0.5, beta});
  scene.fixed("base", box(-3, -1, 3, 0));
  scene.block("block", box(-0.25, 0, 0.25, 0.3), 300);
  Simulation<2> sim = scene.start();
  StageOptions options;
  options.dt = dt;
  options.duration = duration;
  options.safety = safety;
  try {
    sim.run(options, testing::each_step([&](const Instant<2>&) { sim.stop(); }));
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST_CASE("a step too small to advance time is rejected with the governing part") {
  const std::string stiff = refusal(1e30, 0, 1);
  CHECK(stiff.find("must be at least 1e-09 s") != std::string::npos);
  CHECK(stiff.find("block") != std::string::npos);
  // With damping the longest stable step is so short that it is printed as 0.
  CHECK(refusal(1e30, 0, 1, 0.5, 1e-2).find("the step is 0 s") != std::string::npos);
  CHECK(refusal(1e8, 1e-300, 1).find("1e-300 s") != std::string::npos);
  CHECK(refusal(1e8, 0.9e-9, 1) != "");
  CHECK(refusal(1e8, 1.1e-9, 1) == "");
  CHECK(refusal(1e8, 0.9e-12, 1e-4) != "");
  CHECK(refusal(1e8, 1.1e-12, 1e-4) == "");
  CHECK(refusal(1e8, 1e-5, 1e9) == "");  // meant to end by another condition than time
}

TEST_CASE("nine tenths of the longest stable step are the most that is taken") {
  CHECK(refusal(1e8, 0, 1, 0.9) == "");
  CHECK(refusal(1e8, 0, 1, 0.91).find("at most 0.9") != std::string::npos);
}

}  // namespace
