#include "run/record/recording.hpp"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <numeric>

#include "base/error.hpp"
#include "near.hpp"
#include "results/reading/reader.hpp"
#include "results/sample_run.hpp"
#include "run/dropped_block.hpp"

using namespace trilith;
using testing::dropped_block;
using testing::fall_stage;
using testing::near;

namespace {

RecordingOptions<2> options() {
  RecordingOptions<2> o;
  o.provenance.start_time = "2025-11-21T09:30:00Z";
  o.sync = false;
  o.histories = {{"block.y", "m", "height of the block's centre",
                  [](const Instant<2>& now) { return now.state.position[1].y(); }}};
  return o;
}

/// Runs the fall and records it to `path`; returns the hash of the last state.
std::uint64_t record_fall(const std::filesystem::path& path, double height, double duration = 1.5) {
  Simulation<2> simulation(dropped_block(height));
  Recording<2> recording(path, simulation.model(), simulation.state(), options());
  simulation.run(fall_stage(duration), recording.listener());
  recording.finish();
  CHECK(recording.energy_check().input() > 0);
  return state_hash(simulation.state());
}

}  // namespace

TEST_CASE("a recorded fall reads back: model, frames, histories, events, stages and energy") {
  const testing::Folder folder;
  record_fall(folder / "fall.h5", 0.3);
  const results::ResultsReader reader(folder / "fall.h5");
  CHECK(reader.finished());
  const results::Header& header = reader.header();
  REQUIRE(header.bodies.size() == 2);
  CHECK(header.bodies[0].support == "fixed");
  CHECK(header.bodies[1].support == "free");
  CHECK(header.bodies[1].groups == "stones");
  CHECK(header.energy_terms.size() == energy_terms);
  CHECK(header.energy_terms[0].name == "kinetic");
  REQUIRE(header.laws.size() == 3);
  CHECK(header.laws[0].text.find("kn=1e+08 Pa/m") != std::string::npos);

  CHECK(reader.frame_count() == 76);
  const results::Frame half = reader.frame(5);  // still falling
  CHECK(near(half.time, 0.1, 0.01));
  CHECK(half.contacts.empty());
  CHECK(near(half.position[3], 0.55 - 0.5 * standard_gravity * half.time * half.time, 1e-3));
  CHECK(reader.history("block.y").size() == reader.history_times().size());

  const std::vector<results::EventRow> events = reader.events();
  REQUIRE(events.size() >= 3);
  CHECK(events.front().type == "stage.begun");
  CHECK(events.back().type == "stage.ended");
  CHECK(events[1].type == "impact");
  CHECK(near(events[1].time, std::sqrt(2 * 0.3 / standard_gravity), 0.01));
  CHECK(near(events[1].first.value, std::sqrt(2 * 0.3 * standard_gravity), 0.01));
  CHECK(events[1].text.find("hit") != std::string::npos);
  CHECK(events[1].has_place);
  CHECK(events[1].cause == events[0].id);
  const std::vector<results::StageRow> stages = reader.stages();
  REQUIRE(stages.size() == 1);
  CHECK(stages[0].name == "fall");
  CHECK(stages[0].ended);
  CHECK(stages[0].why == "time");
  CHECK(near(stages[0].end, 1.5, 1e-12));

  const results::EnergyTable energy = reader.energy();
  REQUIRE(energy.time.size() == 76);
  CHECK(energy.residual[0] == 0);
  for (const double r : energy.residual) CHECK(std::abs(r) < 0.01 * testing::block_weight * 0.3);
}

TEST_CASE("the recorded contact forces on a block at rest sum to its weight") {
  const testing::Folder folder;
  record_fall(folder / "rest.h5", 0.001, 2.0);
  const results::ResultsReader reader(folder / "rest.h5");
  const results::Frame last = reader.frame(reader.frame_count() - 1);
  REQUIRE(last.contacts.size() == 1);
  const results::ContactForce& c = last.contacts[0];
  const double sign = c.body_a == 1 ? 1 : -1;  // `force` acts on body a
  CHECK(near(sign * c.force[1], testing::block_weight, 1e-6));
  CHECK(std::abs(c.force[0]) < 1e-6 * testing::block_weight);
  CHECK(std::abs(c.point[0]) < 1e-6);
  CHECK(std::abs(c.point[1]) < 1e-3);
  CHECK(c.state == results::ContactState::sticking);
}

TEST_CASE("recording does not change a run") {
  const testing::Folder folder;
  const std::uint64_t recorded = record_fall(folder / "fall.h5", 0.3);
  Simulation<2> alone(dropped_block(0.3));
  alone.run(fall_stage());
  CHECK(state_hash(alone.state()) == recorded);
}

TEST_CASE("two runs write the same bytes") {
  const testing::Folder folder;
  record_fall(folder / "one.h5", 0.3);
  record_fall(folder / "two.h5", 0.3);
  const std::string one = testing::bytes_of(folder / "one.h5");
  CHECK(one.size() > 1000);
  CHECK(one == testing::bytes_of(folder / "two.h5"));
}

TEST_CASE("a killed run is readable up to its last flush") {
  const testing::Folder folder;
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    Simulation<2> simulation(dropped_block(0.3));
    RecordingOptions<2> o = options();
    o.flush_frames = 10;
    Recording<2> recording(folder / "killed.h5", simulation.model(), simulation.state(), std::move(o));
    RunListener<2> listener = recording.listener();
    listener.on_step = [](const Instant<2>& now) {
      if (now.state.time > 0.5) ::raise(SIGKILL);
    };
    simulation.run(fall_stage(), listener);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status));
  const results::ResultsReader reader(folder / "killed.h5");
  CHECK_FALSE(reader.finished());
  CHECK_FALSE(reader.running());
  CHECK(reader.frame_count() >= 20);
  REQUIRE(reader.stages().size() == 1);
  CHECK_FALSE(reader.stages()[0].ended);
  CHECK(reader.events().size() >= 2);
}

TEST_CASE("the first frame is safe before the first step") {
  const testing::Folder folder;
  Simulation<2> simulation(dropped_block(0.3));
  Recording<2> recording(folder / "fall.h5", simulation.model(), simulation.state(), options());
  RunListener<2> listener = recording.listener();
  std::size_t frames = 0, events = 0;
  listener.on_step = [&](const Instant<2>&) {
    const results::ResultsReader reader(folder / "fall.h5");
    frames = reader.frame_count();
    events = reader.events().size();
    simulation.stop();
  };
  listener.on_energy = [&, inner = listener.on_energy](const Instant<2>& now, const Energy& e) {
    if (frames == 0) CHECK(results::ResultsReader(folder / "fall.h5").frame_count() == 1);
    inner(now, e);
  };
  simulation.run(fall_stage(), listener);
  CHECK(frames == 1);
  CHECK(events == 1);
}

TEST_CASE("buffered rows reach the disk in time without further rows") {
  for (const bool soon : {true, false}) {
    const testing::Folder folder;
    Simulation<2> simulation(dropped_block(0.3));
    RecordingOptions<2> o = options();
    o.flush_seconds = soon ? 0.02 : 1e9;
    Recording<2> recording(folder / "fall.h5", simulation.model(), simulation.state(), std::move(o));
    RunListener<2> listener = recording.listener();
    const auto hit = [&] { return results::ResultsReader(folder / "fall.h5").events().size() > 1; };
    bool has_hit = false, seen = false;
    listener.on_event = [&, inner = listener.on_event](const Event& e, const Instant<2>& now) {
      inner(e, now);
      has_hit = has_hit || e.type == EventType::impact;
    };
    listener.on_step = [&](const Instant<2>&) {
      if (!has_hit) return;
      for (int i = 0; !seen && (soon || i < 50); ++i) {  // steps of a run that records nothing more
        recording.step();
        seen = hit();
      }
      simulation.stop();
    };
    StageOptions stage = fall_stage();
    stage.frame_interval = stage.history_interval = stage.energy_interval = 100;
    simulation.run(stage, listener);
    CHECK(seen == soon);
  }
}

TEST_CASE("an abandoned recording has its reason and stays unfinished") {
  const testing::Folder folder;
  {
    Simulation<2> simulation(dropped_block(0.3));
    Recording<2> recording(folder / "early.h5", simulation.model(), simulation.state(), options());
    RunListener<2> listener = recording.listener();
    listener.on_step = [](const Instant<2>& now) {
      if (now.state.time > 0.2) throw InputError("script.lua:3: no such body");
    };
    CHECK_THROWS_AS(simulation.run(fall_stage(), listener), InputError);
    recording.abandon("script.lua:3: no such body");
  }
  CHECK_FALSE(std::filesystem::exists(folder / "early.h5"));
  const results::ResultsReader reader(folder / "early.h5");
  CHECK_FALSE(reader.finished());
  CHECK(reader.stages()[0].why == "broken off");
  REQUIRE(reader.notes().size() == 1);
  CHECK(reader.notes()[0].text.find("no such body") != std::string::npos);
}

TEST_CASE("a history that gives no number is rejected, with its name") {
  const testing::Folder folder;
  Simulation<2> simulation(dropped_block(0.3));
  RecordingOptions<2> o = options();
  o.histories[0].sample = [](const Instant<2>&) { return std::nan(""); };
  Recording<2> recording(folder / "nan.h5", simulation.model(), simulation.state(), std::move(o));
  CHECK_THROWS_AS(simulation.run(fall_stage(), recording.listener()), results::ResultsError);
}

TEST_CASE("a motion that starts with a later stage is noted") {
  const testing::Folder folder;
  Simulation<2> simulation(dropped_block(0.001));
  Recording<2> recording(folder / "shaken.h5", simulation.model(), simulation.state(), options());
  StageOptions o = fall_stage(0.1);
  o.name = "consolidation";
  o.rest_share = 0.8, o.until_rest = true;
  simulation.run(o, recording.listener());
  const std::vector<double> samples{0, 1, -1, -1, 1, 0};
  set_drive(simulation.edit_model(), 0, 0, std::make_shared<GroundMotion>(samples, 0.02), 0.1, 0);
  simulation.run(fall_stage(0.1), recording.listener());
  recording.finish();
  const results::ResultsReader reader(folder / "shaken.h5");
  REQUIRE(reader.notes().size() == 1);
  CHECK(reader.notes()[0].text.find("'ground' (x)") != std::string::npos);
  REQUIRE(reader.stages().size() == 2);
  CHECK(reader.stages()[0].kind == "consolidation");
  CHECK(reader.stages()[1].kind == "dynamic");
}
