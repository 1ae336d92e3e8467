// Simulation of a model: stages run one after the other and notify listeners.
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
#include "edit/crack_scratch.hpp"
#include "edit/crack_search.hpp"
#include "edit/deactivate.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "integrate/explicit/tunnelling_limit.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/verdict.hpp"
#include "model/work.hpp"
#include "run/record/causes.hpp"
#include "run/seal.hpp"
#include "run/stage.hpp"
#include "run/stage_progress.hpp"
#include "run/thread_choice.hpp"

namespace trilith {

/// A simulation at a step border. Continuing after restore gives the same bits as continuing after the snapshot was
/// taken.
template <int D>
struct Snapshot {
  State<D> state;
  std::shared_ptr<const Model<D>> model;  ///< model at that time; shared by all snapshots between two changes
  Causes causes;
  std::optional<StageProgress> stage;  ///< stage that was running
  RestDamping rest;                    ///< of that stage, or of the last one
  Verdict verdict;
  Seal seal;
  std::vector<Event> untold;  ///< events at the border, to be reported at the next instant
  Cracking<D> cracking;
};

/// Limits of a nested run: it pauses at the first limit reached, counted from its call.
struct RunLimit {
  std::int64_t steps = 0;       ///< 0: no limit
  double time = unbounded;      ///< [s]
  std::function<bool()> leave;  ///< pauses when it returns true
};

/// The next step, as State will store it.
struct NextStep {
  double dt = 0;       ///< [s]; 0: there is none yet
  double safety = 0;   ///< see State::safety
  double longest = 0;  ///< longest stable step if it was estimated now, otherwise 0 [s]
};
class ByteReader;
class ByteWriter;
class FieldSolver;
class Watch;
template <int D>
class Tangent;
struct Divergence;
struct Equilibrium;
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
  /// Continues from a state of that model; bodies outside the bounds remain deactivated.
  Simulation(Model<D> model, State<D> state);
  Simulation(const Simulation<2>&) = delete;
  Simulation<2>& operator=(const Simulation<2>&) = delete;
  ~Simulation();

  /// Runs one stage to its end. Throws InputError for options out of range, for a fixed step that is not stable, and
  /// after a stage that diverged, whose state is meaningless. An exception of a listener ends the run and is passed on;
  /// the state is then at the last complete step.
  StageReport run(const StageOptions& options, const RunListener<D>& listener = {});
  /// A stage without time: static equilibrium under the present weight and loads by Newton's method
  /// (statics/equilibrium.hpp). If no equilibrium is found the state is unchanged, and the report states the reason.
  /// Only name, intervals and the process of `options` are used; with a process, equilibrium is found after each of its
  /// steps, and the stage lasts path_duration. `way`: the load path that led here, with a frame and a sample at
  /// each point; the stage then lasts path_duration (run/load_way.hpp).
  StageReport settle(const StageOptions& options, const EquilibriumOptions& how, const RunListener<D>& listener = {},
                     const LoadWay<D>* way = nullptr);
  /// Changes values of fields (State::fields has all rows) at this instant, between stages. The elastic energy that
  /// this puts into bodies is booked as `heat`.
  void change_fields(const std::function<void(State<D>&)>& change);
  /// Runs a restored stage to its end.
  StageReport resume(const RunListener<D>& listener = {});
  /// Within at_border of a running stage: takes further steps of that stage, up to `limit` or its end.
  void run_on(const RunListener<D>& listener, const RunLimit& limit);

  [[nodiscard]] const State<D>& state() const { return state_; }
  [[nodiscard]] const Work<D>& work() const { return work_; }
  [[nodiscard]] const Model<D>& model() const { return model_; }
  /// Verdict of all stages so far.
  [[nodiscard]] const Verdict& verdict() const { return verdict_; }
  /// Checks of all stages so far.
  [[nodiscard]] const Seal& seal() const { return seal_; }
  /// Adds a check that was made after a stage that began at `begun` [s].
  void add_check(const SealRow& row, double begun) { seal_.add(row, begun, verdict_); }
  /// Access for changes between stages (supports, drives, damping, gravity), or at the border of a step.
  Model<D>& edit_model();
  /// Change by a function. Call drop_step if it frees a degree of freedom. Not for supports and drives during a run.
  void edit(const std::function<void(Model<D>&)>& change);
  /// Deactivates, reactivates or adds bodies and bearings, between stages or at the border of a step: see
  /// edit/deactivate.hpp. The events of the change are reported at the next instant of a stage.
  void remove(const Parts& parts);
  void reactivate(const Parts& parts);
  void grow(Model<D> grown);
  /// Bodies that may crack; the search for cracks goes on where it was.
  void set_cracking(std::vector<CrackingBody<D>> bodies) { cracking_.bodies = std::move(bodies); }
  [[nodiscard]] const Cracking<D>& cracking() const { return cracking_; }
  /// Bodies that crack at this instant; see edit/crack_search.hpp.
  [[nodiscard]] CrackSearch<D> search_cracks();
  /// Stores when bodies are computed next, after a search.
  void keep_crack_watch(std::vector<CrackWatch>&& watch) { cracking_.watch = std::move(watch); }
  /// Replaces each of these bodies by its two parts, which `grown` has at its end: see edit/split.hpp.
  void split(Model<D> grown, std::span<const Crack<D>> cracks);
  /// Change of supports and drives during a run. Freed degrees of freedom start at this instant, and the ledger takes
  /// the energies of moving parts into account. Before the first step it is an edit like others.
  void change_supports(const std::function<void(Model<D>&)>& change);
  /// Change of laws; the ledger receives the difference in energy. Bearings in `begun` restart with their new laws.
  void modify(const std::function<void(Model<D>&)>& change, std::span<const int> begun);
  /// Forces a new estimate of the step length before the next step, because freed parts may need a shorter step.
  void drop_step() { state_.dt = 0; }
  /// The stage that runs, or that was restored and waits for resume(); nullptr without a stage.
  [[nodiscard]] const StageProgress* stage() const { return stage_ ? &*stage_ : nullptr; }

  [[nodiscard]] Snapshot<D> snapshot();
  /// Goes back to a snapshot of this simulation. Within at_border: to a snapshot of the running stage, which then
  /// continues from there. Between stages: its stage waits for resume().
  void restore(const Snapshot<D>& snapshot);

  // For restart files (run/restart/simulation_bytes.cpp).
  /// Writes the state of the run at a step border or between stages: all but the model and the options of the stage.
  void write(ByteWriter& out) const;
  /// Returns to the instant of write(). Throws InputError if the model differs from the one at that instant. `options`:
  /// options of the running stage, which resume() continues; nullptr: no stage ran.
  void read(ByteReader& in, const StageOptions* options);
  /// Replaces the state for the present model, and drops all that depends on the previous one.
  void put_state(State<D> state);
  /// Stores the present positions as the initial ones of a stage with these options (Watch::keep_places).
  void keep_places(const StageOptions& options);
  /// Applies a change as RunListener::change_model does at a step border.
  void apply(const std::function<bool(Model<D>&)>& change);
  /// True if a stage was requested to end at the next step border.
  [[nodiscard]] bool stopping() const { return stop_.load(std::memory_order_relaxed); }

  /// Removes the bonds of all joints, or creates bonds where faces meet now: see assembly/start.hpp. Not while a stage
  /// runs.
  void lift_bonds();
  void set_bonds(double reach = 1e-3);

  /// Adds the run times of all parts to `times`, which must outlive this; nullptr: stop.
  void measure(StepTimes* times) { times_ = times; }
  /// Number of threads that share a step, 1 to most_threads; only as many as useful are active. The bits do not depend
  /// on it.
  void use_threads(int threads) { choose_threads(ThreadChoice::always(threads)); }
  /// As above, optionally with a number chosen by timing. Timings are kept while the request stays the same.
  void choose_threads(const ThreadChoice& choice);
  /// Requests that a running stage ends at the next step border. May be called from a signal handler or another thread.
  void stop() { stop_.store(true, std::memory_order_relaxed); }
  /// Evaluates the present state and the forces of the next step, so that all readable data refer to one instant. It
  /// does not change State, and costs nothing if already done. Handlers and histories see the same data.
  void refresh();
  /// Energy ledger at the present instant, as in the energy history. Call it after refresh().
  [[nodiscard]] Energy energy() const;
  /// Resets all data that are not State; no result changes.
  void drop_work();

 private:
  void begin_stage(const StageOptions& options);
  StageReport go_on(const RunListener<D>& listener);
  void pass(const RunListener<D>& listener);
  void see_off();
  bool ends(const RunListener<D>& listener, const Instant<D>& now);
  StageReport process(const StageOptions& options, const EquilibriumOptions& how, const RunListener<D>& listener);
  [[nodiscard]] Equilibrium process_step(const FieldProcess& process, double dt, FieldSolver& solver,
                                         const EquilibriumOptions& how);
  void tell_process_step(const Equilibrium& found, const RunListener<D>& listener, bool last);
  void end_process(const Equilibrium& found, const EquilibriumOptions& how, const std::optional<Divergence>& diverged);
  std::vector<Event> tell_change(const RunListener<D>& listener);
  bool cracks_now(const RunListener<D>& listener);
  void tell_way(const LoadWay<D>& way, const RunListener<D>& listener);
  std::optional<Divergence> find_rest(const EquilibriumOptions& how, const RunListener<D>& listener,
                                      const std::string& loads, Equilibrium& found);
  void tell_point(const Waypoint<D>& point, const RunListener<D>& listener);
  void tell_samples(const RunListener<D>& listener, const Instant<D>& now, bool ends);
  [[nodiscard]] NextStep choose_step() const;
  [[nodiscard]] VelocityTimes wanted_velocities() const;
  [[nodiscard]] const AnyIntegrator& integrator() const;
  void scale_masses();
  void unscale_masses();
  void choose_integrator();
  void change_velocities(VelocityTimes to);
  void leave_failed_step();
  bool take_step(double dt, const Energy& energy, const RunListener<D>& listener);
  bool step_in_time(double dt, const RunListener<D>& listener);
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
  void end_seal(const Instant<D>& now);

  Model<D> model_;
  State<D> state_;
  Work<D> work_;
  Causes causes_;
  Verdict verdict_;
  Seal seal_;
  std::optional<StageProgress> stage_;
  std::shared_ptr<const Model<D>> kept_model_;  // copy of model_, if unchanged
  StepTimes* times_ = nullptr;
  ThreadChoice threads_;
  NextStep next_;           // result of refresh()
  TunnellingLimit swept_;   // the step after all limits
  RestDamping rest_;        // of the present stage, or of the last one
  bool evaluated_ = false;  // work_, next_ and swept_ match state_ and model_
  std::unique_ptr<Watch> watch_;
  std::unique_ptr<Tangent<D>> tangent_;  // of steps that solve equations
  std::string stuck_;                    // reason for which a step failed
  std::string changed_;                  // reason for a change of integrator within the stage, until reported
  std::vector<Event> leaving_;           // events of bodies that left or changed at this instant, to be reported
  Cracking<D> cracking_;
  bool all_left_ = false;  // no body is free to move any more, because all have left
  std::atomic<bool> stop_{false};
  bool running_ = false, at_border_ = false;
  CrackScratch<D> crack_scratch_;
};

}  // namespace trilith
