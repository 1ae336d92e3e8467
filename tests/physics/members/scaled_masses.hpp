// Invariants of runs with scaled masses, in the plane and in space.
#pragma once

#include <doctest/doctest.h>

#include <optional>
#include <string>

#include "base/error.hpp"
#include "model/io/state_words.hpp"
#include "run/simulation.hpp"

namespace trilith::testing {

/// A stage until `end` [s] gives the same bits with three threads. It also does when the Work is dropped at every 50th
/// step and the run is restored at `back_at` to the state kept at `kept_at`. From this point a state that was written
/// and read gives the same bits too. `start` makes the simulation.
template <int D, class Start>
void check_scaled_bits(Start&& start, const StageOptions& options, double kept_at, double back_at, double end) {
  Simulation<D> plain = start();
  plain.run(options);
  const std::uint64_t hash = state_hash(plain.state());
  {
    Simulation<D> sim = start();
    sim.use_threads(3);
    sim.run(options);
    CHECK(state_hash(sim.state()) == hash);
  }
  std::optional<State<D>> kept;
  {
    Simulation<D> sim = start();
    std::optional<Snapshot<D>> snapshot;
    bool back = false;
    RunListener<D> listener;
    listener.at_border = [&] {
      if (!snapshot && sim.state().time > kept_at) snapshot = sim.snapshot();
      if (sim.state().step % 50 == 0) sim.drop_work();
      if (back || sim.state().time < back_at) return;
      back = true;
      sim.restore(*snapshot);
    };
    sim.run(options, listener);
    CHECK(back);
    CHECK(state_hash(sim.state()) == hash);
    kept = snapshot->state;
    CHECK(kept->added_share.size() == 5);
  }
  const Model<D>& model = plain.model();
  Simulation<D> sim(model, state_from_words(model, state_words(*kept), "kept state"));
  StageOptions rest = options;
  rest.end_time = end;
  sim.run(rest);
  CHECK(state_hash(sim.state()) == hash);
}

/// Error message of a stage that requests mass scaling but scales no mass; empty if the stage is accepted.
template <int D>
std::string scaling_refusal(Simulation<D> sim, const StageOptions& options) {
  try {
    sim.run(options);
  } catch (const InputError& e) {
    CHECK(sim.state().added_share.empty());
    return e.what();
  }
  return "";
}

}  // namespace trilith::testing
