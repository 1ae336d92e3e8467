// Snapshots and nested runs at a step border: the bits equal a run without them.
#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "dropped_block.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

std::uint64_t plain_hash() {
  Simulation<2> s(dropped_block(0.1));
  s.run(fall_stage());
  return state_hash(s.state());
}

}  // namespace

TEST_CASE("a run restored to a snapshot between stages and resumed has the bits of an uninterrupted run") {
  Simulation<2> s(dropped_block(0.1));
  std::optional<Snapshot<2>> kept;
  RunListener<2> listener;
  listener.at_border = [&] {
    if (!kept && s.state().time > 0.4) kept = s.snapshot();
  };
  const StageReport first = s.run(fall_stage(), listener);
  REQUIRE(kept);
  s.restore(*kept);
  CHECK(s.state().time == kept->state.time);
  const StageReport second = s.resume();
  CHECK(state_hash(s.state()) == plain_hash());
  CHECK(second.steps == first.steps);
  CHECK(second.end == first.end);
  CHECK(s.stage() == nullptr);
}

TEST_CASE("a running stage restored at a step border has the bits of an uninterrupted one") {
  Simulation<2> s(dropped_block(0.1));
  std::optional<Snapshot<2>> kept;
  bool back = false;
  RunListener<2> listener;
  listener.at_border = [&] {
    if (!kept && s.state().time > 0.2) kept = s.snapshot();
    if (back || s.state().time < 0.7) return;
    back = true;
    s.restore(*kept);
  };
  s.run(fall_stage(), listener);
  CHECK(back);
  CHECK(state_hash(s.state()) == plain_hash());
}

TEST_CASE("steps taken within a border belong to the stage: same bits, samples and end") {
  const auto samples_of = [](bool nested) {
    Simulation<2> s(dropped_block(0.1));
    std::vector<double> times;
    RunListener<2> listener;
    listener.on_history = [&](const Instant<2>& now) { times.push_back(now.state.time); };
    RunListener<2> inner = listener;
    bool done = false;
    if (nested)
      listener.at_border = [&] {
        if (done || s.state().time < 0.3) return;
        done = true;
        const std::int64_t before = s.state().step;
        s.run_on(inner, {7, unbounded, {}});
        CHECK(s.state().step == before + 7);
        s.run_on(inner, {0, 0.5, {}});
        CHECK(s.state().time >= 0.5 - 1e-9);
        CHECK(s.state().time < 0.51);
      };
    s.run(fall_stage(), listener);
    CHECK(done == nested);
    times.push_back(static_cast<double>(state_hash(s.state()) % 1000003));
    return times;
  };
  CHECK(samples_of(false) == samples_of(true));
}

TEST_CASE("a nested run that reaches the end of the stage ends it once") {
  Simulation<2> s(dropped_block(0.1));
  int ended = 0;
  RunListener<2> listener;
  listener.on_event = [&](const Event& e, const Instant<2>&) { ended += e.type == EventType::stage_ended ? 1 : 0; };
  RunListener<2> inner = listener;
  listener.at_border = [&] { s.run_on(inner, {}); };
  const StageReport report = s.run(fall_stage(), listener);
  CHECK(ended == 1);
  CHECK(report.end == StageEnd::time);
  CHECK(state_hash(s.state()) == plain_hash());
}

TEST_CASE("a model changed at the end of a step is restored by the snapshot") {
  Simulation<2> s(dropped_block(0.1));
  std::optional<Snapshot<2>> before;
  RunListener<2> listener;
  listener.at_border = [&] {
    if (before || s.state().time < 0.1) return;
    before = s.snapshot();
    s.edit_model().gravity.field *= 2;
  };
  s.run(fall_stage(), listener);
  const std::uint64_t heavier = state_hash(s.state());
  CHECK(s.model().gravity.field.y() == -2 * standard_gravity);
  s.restore(*before);
  CHECK(s.model().gravity.field.y() == -standard_gravity);
  s.resume();
  CHECK(state_hash(s.state()) == plain_hash());
  CHECK(state_hash(s.state()) != heavier);
}

TEST_CASE("a stage ends exactly at its given time, to the bit, from any start") {
  Simulation<2> s(dropped_block(0.1));
  StageOptions o = fall_stage(0.333333);
  s.run(o);
  o.end_time = 0.7;
  o.duration = 0.7 - s.state().time;
  s.run(o);
  CHECK(std::abs(s.state().time - 0.7) < 1e-12);
}

TEST_CASE("profiling a run does not change the results, and the parts of the step sum to at most the whole") {
  Simulation<2> s(dropped_block(0.1));
  StepTimes times;
  s.measure(&times);
  const StageReport report = s.run(fall_stage());
  CHECK(state_hash(s.state()) == plain_hash());
  CHECK(times.steps == report.steps);
  double sum = 0;
  for (const double part : times.part) {
    CHECK(part >= 0);
    sum += part;
  }
  CHECK(sum > 0);
  double laws = 0;
  for (const double law : times.law) laws += law;
  CHECK(laws <= times.part[static_cast<std::size_t>(StepPart::faces)] * (1 + 1e-12));
}
