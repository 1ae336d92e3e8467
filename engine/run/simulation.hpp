// A model in time: stages run one after the other, listeners told of what happens.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "run/causes.hpp"
#include "run/stage.hpp"
#include "world/model.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

namespace trilith {

class Simulation {
 public:
  /// Starts from start_state(model).
  explicit Simulation(Model<2> model);
  /// Continues from a state of that model.
  Simulation(Model<2> model, State<2> state);

  /// Runs one stage to its end. Throws InputError for options out of range and for a fixed step that is not stable.
  /// What listeners throw ends the run and is passed on; the state is then that of the last whole step.
  StageReport run(const StageOptions& options, const RunListener& listener = {});

  [[nodiscard]] const State<2>& state() const { return state_; }
  [[nodiscard]] const Work<2>& work() const { return work_; }
  [[nodiscard]] const Model<2>& model() const { return model_; }
  /// For changes between stages (supports, drives, damping, gravity). Not while a stage runs.
  Model<2>& edit_model();

  /// Bonds of all joints are taken away, or made where faces meet now: see step/start.hpp. Not while a stage runs.
  void lift_bonds();
  void set_bonds(double reach = 1e-3);

  /// Asks a running stage to end at the next step border. May be called from a signal handler or another thread.
  void stop() { stop_.store(true, std::memory_order_relaxed); }
  /// Evaluates at the present pose, so that forces and contacts can be read before the first step.
  void refresh();
  /// Drops everything that is not State; no result changes by it.
  void drop_work();

 private:
  void choose_step(const StageOptions& options);
  void tell_events(const RunListener& listener, const Instant& now);
  void tell(EventType type, const std::string& text, const RunListener& listener, const Instant& now);

  Model<2> model_;
  State<2> state_;
  Work<2> work_;
  Causes causes_;
  std::atomic<bool> stop_{false};
  bool running_ = false;
};

}  // namespace trilith
