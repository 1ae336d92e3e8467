// Invariants of every run: repetition, dropping the Work, writing and reading the State give the same bits.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "assembly/evaluate.hpp"
#include "assembly/start.hpp"
#include "events/commit.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "integrate/explicit/mass_scaling.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "model/event/event_list.hpp"
#include "model/io/checkpoint.hpp"
#include "physics/collapses.hpp"

namespace trilith {
namespace {

using testing::Collapse;
using testing::collapses;

/// Digests along a run, its events, and its last state.
struct Trace {
  std::vector<std::uint64_t> digest;
  std::vector<std::string> events;
  State<2> state;
  int most_general = 0, chosen = 0;
};

std::string line_of(const Event& e) {
  return fmt::format("{} {} {} {} {} {} {} {:a} {:a} {:a} {:a}", e.step,
                     event_type_info[static_cast<std::size_t>(e.type)].name, e.body_a, e.body_b, e.bearing, e.text,
                     name_of(e.mode), e.time, e.value, e.x, e.y);
}

/// A trial state of an implicit integrator: every node displaced slightly, each in its own direction.
State<2> tried(State<2> state) {
  for (std::size_t n = 0; n < state.position.size(); ++n) {
    const double phase = static_cast<double>(n) + static_cast<double>(state.step);
    state.position[n] += 2e-3 * Vec2(std::sin(phase), std::cos(3 * phase));
    state.velocity[n] += 0.1 * Vec2(std::cos(phase), std::sin(5 * phase));
  }
  return state;
}

/// Continues from `state` for `duration` [s], with a fresh Work every `drop_every` steps (0: never). `trials`: before
/// each step's force evaluation the forces are evaluated at a trial state, then twice at the current state.
Trace follow(const Model<2>& model, State<2> state, double duration, int drop_every, bool trials = false) {
  Trace trace;
  Work<2> work;
  const double end = state.time + duration;
  while (state.time < end) {
    if (drop_every > 0 && state.step % drop_every == 0) work = Work<2>{};
    evaluate(model, state, work, state.last_dt);
    if (trials) {
      evaluate(model, tried(state), work, state.last_dt);
      evaluate(model, state, work, state.last_dt);
      evaluate(model, state, work, state.last_dt);
    }
    trace.most_general = std::max(trace.most_general, static_cast<int>(work.general_touching.size()));
    for (const FaceBatch& b : work.batches) trace.chosen = std::max(trace.chosen, static_cast<int>(b.choice.size()));
    if (state.step % 32 == 0) state.dt = settled_step(stable_step(model, state, work).dt, 0.5);
    add_inertia(model, state, work, {state.dt, {}});
    commit(model, state, work);
    advance(model, state, work, {state.dt, {}});
    for (const Event& e : work.events) trace.events.push_back(line_of(e));
    if (state.step % 20 == 0) trace.digest.push_back(state_hash(state));
  }
  trace.digest.push_back(state_hash(state));
  trace.state = std::move(state);
  return trace;
}

/// Index of the first digest that differs; -1 if all are equal.
int first_difference(const Trace& a, const Trace& b) {
  for (std::size_t i = 0; i < std::min(a.digest.size(), b.digest.size()); ++i)
    if (a.digest[i] != b.digest[i]) return static_cast<int>(i);
  return a.digest.size() == b.digest.size() ? -1 : static_cast<int>(std::min(a.digest.size(), b.digest.size()));
}

TEST_CASE("two runs of a model give the same bits, and so do the events") {
  for (const Collapse& c : collapses()) {
    const Model<2> one = c.model(), two = c.model();
    const Trace a = follow(one, start_state(one), c.duration, 0), b = follow(two, start_state(two), c.duration, 0);
    MESSAGE(c.name << ": " << a.state.step << " steps, " << a.events.size() << " events, up to " << a.most_general
                   << " general contacts and " << a.chosen << " rows that choose their faces");
    INFO(c.name);
    CHECK(first_difference(a, b) == -1);
    CHECK(a.events == b.events);
    CHECK(a.events.size() > 0);
  }
}

TEST_CASE("freeing scratch memory between steps changes neither the state nor the events") {
  for (const Collapse& c : collapses()) {
    const Model<2> model = c.model();
    const Trace kept = follow(model, start_state(model), c.duration, 0);
    for (const int every : {1, 7, 100}) {
      const Trace dropped = follow(model, start_state(model), c.duration, every);
      INFO(c.name, ", fresh every ", every, " steps");
      CHECK(first_difference(kept, dropped) == -1);
      CHECK(kept.events == dropped.events);
    }
  }
}

TEST_CASE("repeated and trial evaluations do not change a run") {
  for (const Collapse& c : collapses()) {
    const Model<2> model = c.model();
    const Trace once = follow(model, start_state(model), 0.5 * c.duration, 0);
    const Trace tried = follow(model, start_state(model), 0.5 * c.duration, 0, true);
    INFO(c.name);
    CHECK(first_difference(once, tried) == -1);
    CHECK(once.events == tried.events);
  }
}

TEST_CASE("a simulation with its scratch memory freed between stages continues with the same bits") {
  for (const Collapse& c : collapses()) {
    Simulation<2> kept(c.model()), dropped(c.model());
    for (int part = 0; part < 5; ++part) {
      testing::run_for(kept, c.duration / 8);
      dropped.drop_work();
      testing::run_for(dropped, c.duration / 8);
      INFO(c.name, ", part ", part);
      CHECK(state_hash(kept.state()) == state_hash(dropped.state()));
    }
  }
}

TEST_CASE("a state saved, loaded and continued equals the state continued") {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("trilith_continued_" + std::to_string(::getpid()));
  for (const Collapse& c : collapses()) {
    const Model<2> model = c.model();
    State<2> state = start_state(model);
    for (int part = 0; part < 3; ++part) {
      Trace gone_on = follow(model, state, c.duration / 3, 0);
      const Model<2> again = c.model();
      save_state(state, model, path);
      const Trace continued = follow(again, load_state(again, path), c.duration / 3, 0);
      INFO(c.name, ", part ", part);
      CHECK(first_difference(gone_on, continued) == -1);
      CHECK(gone_on.events == continued.events);
      state = std::move(gone_on.state);
    }
  }
  std::filesystem::remove(path);
}

TEST_CASE("a simulation begun from a loaded state continues with the bits of the saved one") {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("trilith_begun_" + std::to_string(::getpid()));
  for (const Collapse& c : collapses()) {
    Simulation<2> first(c.model());
    testing::run_for(first, 0.4 * c.duration);
    save_state(first.state(), first.model(), path);
    Simulation<2> second(c.model(), load_state(c.model(), path));
    testing::run_for(first, 0.3 * c.duration);
    testing::run_for(second, 0.3 * c.duration);
    INFO(c.name);
    CHECK(state_hash(first.state()) == state_hash(second.state()));
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace trilith
