// A model in time: stages run one after the other, listeners told of what happens.
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assembly/step_times.hpp"
#include "edit/deactivate.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "integrate/explicit/tunnelling_limit.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/verdict.hpp"
#include "model/work.hpp"
#include "run/record/causes.hpp"
#include "run/stage.hpp"
#include "run/stage_progress.hpp"
#include "run/thread_choice.hpp"

namespace trilith {

/// A simulation at a step border: what comes after restoring it has the bits of what came after taking it.
template <int D>
struct Snapshot {
  State<D> state;
  std::shared_ptr<const Model<D>> model;  ///< as it was then; shared by all snapshots between two changes of it
  Causes causes;
  std::optional<StageProgress> stage;  ///< the stage that ran then
  RestDamping rest;                    ///< of that stage, or of the last one
  Verdict verdict;
  std::vector<Event> untold;  ///< what happened at the border, to be told at the next instant
};

/// Where a nested run pauses: the first limit that is reached. Counted from its call.
struct RunLimit {
  std::int64_t steps = 0;       ///< 0: no limit
  double time = unbounded;      ///< [s]
  std::function<bool()> leave;  ///< pauses once this gives true
};

/// The step to come, as State will have it once it is taken.
struct NextStep {
  double dt = 0;       ///< [s]; 0: there is none yet
  double safety = 0;   ///< see State::safety
  double longest = 0;  ///< the longest stable one [s], where it was looked for just now; else 0
};
class Watch;
template <int D>
class Tangent;
struct EquilibriumOptions;
template <int D>
struct LoadWay;
template <int D>
struct Waypoint;

template <int D>
class Simulation {
 public:
  /// Starts from start_state(model).
  explicit Simulation(Model<D> model);
  /// Continues from a state of that model; what has left the bounds by it stays out.
  Simulation(Model<D> model, State<D> state);
  Simulation(const Simulation<2>&) = delete;
  Simulation<2>& operator=(const Simulation<2>&) = delete;
  ~Simulation();

  /// Runs one stage to its end. Throws InputError for options out of range and for a fixed step that is not stable.
  /// What listeners throw ends the run and is passed on; the state is then that of the last whole step. Throws
  /// InputError too after a stage that diverged: its state means nothing.
  StageReport run(const StageOptions& options, const RunListener<D>& listener = {});
  /// A stage without time: rest under the present weight and loads by Newton's method (statics/equilibrium.hpp). Where
  /// none is found the state is as it was, and the report says what fails. Of `options` name and intervals count.
  /// `way`: the load path that has led here, each of its points a frame and a sample; the stage then lasts as long as
  /// path_duration (run/load_way.hpp).
  StageReport settle(const StageOptions& options, const EquilibriumOptions& how, const RunListener<D>& listener = {},
                     const LoadWay<D>* way = nullptr);
  /// Runs a stage that restore() has brought back to its end.
  StageReport resume(const RunListener<D>& listener = {});
  /// Within at_border of a running stage: takes further steps of that stage, up to `limit` or its end.
  void run_on(const RunListener<D>& listener, const RunLimit& limit);

  [[nodiscard]] const State<D>& state() const { return state_; }
  [[nodiscard]] const Work<D>& work() const { return work_; }
  [[nodiscard]] const Model<D>& model() const { return model_; }
  /// Of all stages so far.
  [[nodiscard]] const Verdict& verdict() const { return verdict_; }
  /// For changes between stages (supports, drives, damping, gravity), or at the border of a step.
  Model<D>& edit_model();
  /// The same by a function; where it frees a degree of freedom, drop_step. Not of supports and drives in mid-run.
  void edit(const std::function<void(Model<D>&)>& change);
  /// Deactivates, reactivates or adds bodies and bearings, between stages or at the border of a step: see
  /// edit/deactivate.hpp. The events of the change are reported at the next instant of a stage.
  void remove(const Parts& parts);
  void reactivate(const Parts& parts);
  void grow(Model<D> grown);
  /// An edit of supports and drives: what is freed begins at this instant, and the ledger has what moved or begins to
  /// count. Before anything has run it is an edit like others.
  void change_supports(const std::function<void(Model<D>&)>& change);
  /// An edit of laws, whose difference of energy the ledger has; bearings of `begun` begin anew by theirs.
  void modify(const std::function<void(Model<D>&)>& change, std::span<const int> begun);
  /// The length of the step is looked for anew before the next one: what was freed may need a shorter one.
  void drop_step() { state_.dt = 0; }
  /// The stage that runs, or was restored and waits for resume(); nullptr where there is none.
  [[nodiscard]] const StageProgress* stage() const { return stage_ ? &*stage_ : nullptr; }

  [[nodiscard]] Snapshot<D> snapshot();
  /// Goes back to a snapshot of this simulation. Within at_border: to one of the running stage, which then goes on from
  /// there. Between stages: its stage waits for resume().
  void restore(const Snapshot<D>& snapshot);

  /// Bonds of all joints are taken away, or made where faces meet now: see assembly/start.hpp. Not while a stage runs.
  void lift_bonds();
  void set_bonds(double reach = 1e-3);

  /// From now on adds where the time goes to `times`, which must outlive this; nullptr: no more.
  void measure(StepTimes* times) { times_ = times; }
  /// How many threads share a step, 1 to most_threads; as many of them do as there is work for. The bits are those of
  /// one.
  void use_threads(int threads) { choose_threads(ThreadChoice::always(threads)); }
  /// The same, where it may be left open. What was found out by timing stays as long as the same is asked for.
  void choose_threads(const ThreadChoice& choice);
  /// Asks a running stage to end at the next step border. May be called from a signal handler or another thread.
  void stop() { stop_.store(true, std::memory_order_relaxed); }
  /// Everything that can be read is of one instant from then on: the present state, evaluated, with the forces of the
  /// step to come. Changes no bit of State; costs nothing where it was done. Handlers find it done, histories see the
  /// same.
  void refresh();
  /// The ledger at the present instant, as the energy history has it. After refresh().
  [[nodiscard]] Energy energy() const;
  /// Drops everything that is not State; no result changes by it.
  void drop_work();

 private:
  void begin_stage(const StageOptions& options);
  StageReport go_on(const RunListener<D>& listener);
  void pass(const RunListener<D>& listener);
  void see_off();
  bool ends(const RunListener<D>& listener, const Instant<D>& now);
  void tell_way(const LoadWay<D>& way, const RunListener<D>& listener);
  void tell_point(const Waypoint<D>& point, const RunListener<D>& listener);
  void tell_samples(const RunListener<D>& listener, const Instant<D>& now, bool ends);
  [[nodiscard]] NextStep choose_step() const;
  [[nodiscard]] bool wants_implicit() const;
  [[nodiscard]] bool goes_implicitly() const;
  void scale_masses();
  void unscale_masses();
  void choose_integrator();
  void change_integrator(bool implicit);
  void leave_implicit();
  bool take_step(double dt, const Energy& energy);
  bool step_in_time(double dt);
  bool step_implicitly(double dt, const Energy& energy);
  void fail_stage(const RunListener<D>& listener);
  [[nodiscard]] double whole_step() const;
  [[nodiscard]] double impact_accuracy() const;
  [[nodiscard]] Instant<D> instant() const;
  void require_step(const StageOptions& options) const;
  void tell_step(const RunListener<D>& listener);
  void edited();
  template <class Change>
  void change_parts(Change&& change);
  void tell(Event event, const RunListener<D>& listener, const Instant<D>& now);
  void tell_end(const RunListener<D>& listener, const Instant<D>& now);

  Model<D> model_;
  State<D> state_;
  Work<D> work_;
  Causes causes_;
  Verdict verdict_;
  std::optional<StageProgress> stage_;
  std::shared_ptr<const Model<D>> kept_model_;  // a copy of model_, where none was changed since
  StepTimes* times_ = nullptr;
  ThreadChoice threads_;
  NextStep next_;           // found by refresh()
  TunnellingLimit swept_;   // ... and what of it is taken
  RestDamping rest_;        // of the present stage, or of the last one
  bool evaluated_ = false;  // work_, next_ and swept_ are those of state_ and model_
  std::unique_ptr<Watch> watch_;
  std::unique_ptr<Tangent<D>> tangent_;  // of implicit steps
  std::string stuck_;                    // why an implicit step could not be taken
  std::string changed_;                  // why the integrator has changed within the stage, until that is told
  std::vector<Event> leaving_;           // events of what left or was changed at this instant, to be told
  bool all_left_ = false;                // nothing is free to move any more, as all of that has left
  std::atomic<bool> stop_{false};
  bool running_ = false, at_border_ = false;
};

}  // namespace trilith
