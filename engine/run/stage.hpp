// Options of a stage, notifications during its run, and its result.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "integrate/explicit/mass_scaling.hpp"
#include "integrate/list.hpp"
#include "model/event/event.hpp"
#include "model/work.hpp"

namespace trilith {

template <int D>
struct Crack;  // edit/crack_search.hpp

/// Reason for which a stage ended.
enum class StageEnd { time, rest, stopped, not_at_rest, diverged, all_left, not_converged, unstable };
constexpr const char* name_of(StageEnd e) {
  constexpr const char* names[] = {"time",     "rest",     "stopped",       "not at rest",
                                   "diverged", "all left", "not converged", "unstable"};
  return names[static_cast<int>(e)];
}

/// A process of fields (run/process.cpp): their clock passes, and inertia does not act.
struct FieldProcess {
  double duration = 0, step = 0;  ///< of the clock of the fields [s]
  bool mechanics = true;          ///< equilibrium is found after each step; false: the structure stays as it is
};

struct StageOptions {
  std::string name = "run";
  double duration = 0;  ///< longest time the stage may last [s], above 0
  double end_time = 0;  ///< the stage ends at this time if it is later than the present one; otherwise after
                        ///< `duration` [s]
  double dt = 0;        ///< fixed step [s]; 0: chosen automatically and kept stable
  double safety = 0.5;  ///< share of the longest stable step, above 0 to 0.9. At 0.5 the energy error of a bounce is a
                        ///< few per cent, at 0.1 it is 0.1 per cent
  double rest_share = 0;  ///< damping of consolidation (RestDamping), from 0 to below 1

  std::optional<MassScaling> mass_scaling;  ///< longer explicit steps of meshed bodies

  AnyIntegrator integrator;  ///< CentralDifference unless set
  bool may_change = false;   ///< with a scheme bounded by accuracy: central differences where its steps are slower
  double tolerance = 1e-8;   ///< of schemes bounded by accuracy, see StepControl
  double accuracy = 1e-3;    ///< likewise
  /// Allowed energy error of an impact in explicit steps, as a share of the energy supplied, if dt is not given (see
  /// ImpactOptions). 0: impacts do not shorten steps.
  double impact_accuracy = 0;

  bool until_rest = false;       ///< end when the whole model is at rest
  double still_from = 0;         ///< rest is tested from this time after the start of the stage [s]
  double still_speed = 2.54e-7;  ///< at rest: every skin point of every moving body is slower than this ... [m/s]
  double still_ratio = 1;        ///< ... and the unbalanced force is at most this share of the largest one carried ...
  double still_hold = 0.5;       ///< ... for this long [s]

  std::optional<FieldProcess> process;  ///< of a stage without motion

  bool must_rest = false;  ///< with until_rest: the verdict of the run reports a stage without rest in place
  bool watched = true;     ///< unphysical speeds and energies end the stage as diverged.
  /// With until_rest: a body that rests farther than this share of its size from its position at the start has
  /// left its place, and the stage is unstable (statics/travel.hpp). 0: no limit.
  float within = 0;

  double frame_interval = 0;    ///< [s]; 0: none
  double history_interval = 0;  ///< [s]; 0: none
  double energy_interval = 0;   ///< [s]; 0: none
};

/// The step that the stage prescribes; 0 if it is found by the stability of the scheme [s].
inline double given_step(const StageOptions& options) {
  return bound_of(options.integrator) == StepBound::stability ? options.dt : 0;
}

/// True for a stage that searches for the rest of the structure as drawn, not for its rest after a collapse.
inline bool seeks_rest(const StageOptions& options) {
  return options.until_rest && (options.must_rest || options.rest_share > 0);
}

/// Throws InputError if an option is out of range or contradicts another one.
void require_valid(const StageOptions& options);

struct StageReport {
  std::string name;
  StageEnd end = StageEnd::time;
  double begun = 0, ended = 0;  ///< [s]
  std::int64_t steps = 0;
  double shortest_dt = 0, longest_dt = 0;  ///< [s]
  double speed = 0, ratio = 0;             ///< fastest skin point and unbalanced ratio at the end
  int threads = 1;                         ///< number that shared a step at the end
  double thread_gain = 0;                  ///< speed-up of these threads over one; 0: not timed
  std::optional<ScaledMass> scaled;        ///< with StageOptions::mass_scaling
  std::string reason;                      ///< text: if it did not end as requested, the reason, the place, and advice
  std::string found;       ///< if diverged or unstable: the finding and its place; otherwise Watch::ledger_text
  double sound_until = 0;  ///< if diverged: the last instant that was checked and valid [s]
};

/// A running stage at one instant.
template <int D>
struct Instant {
  const Model<D>& model;
  const State<D>& state;
  const Work<D>& work;
  const StageOptions& stage;
  double begun;  ///< time at which the stage began [s]
  double dt;     ///< next step [s]
  double speed;  ///< fastest skin point of a moving body [m/s]
  double ratio;  ///< unbalanced force over largest force carried
};

/// Listeners of a run. All are called at an evaluated instant, in this order. None may write State, Model or Work,
/// except change_model at the step border; its changes take effect from then on. Events refer to the last step and are
/// reported at the instant after it.
template <int D>
struct RunListener {
  std::function<void(const Instant<D>&)> on_frame, on_history;
  std::function<void(const Instant<D>&, const Energy&)> on_energy;
  std::function<void(const Instant<D>&)> on_step;  ///< after each step; leave empty if not needed
  std::function<void(const Event&, const Instant<D>&)> on_event;
  /// Called after on_step. It may change supports, drives, damping and gravity, and returns true if it changed
  /// something.
  std::function<bool(Model<D>&)> change_model;
  /// Called last, at the step border, where Simulation::edit_model, run_on, snapshot and restore are permitted.
  std::function<void()> at_border;
  /// Called within steps that solve equations, at each iteration. When it returns true the stage ends as stopped, at
  /// the last complete step. Leave it empty if not needed.
  std::function<bool()> is_stopped;
  /// Called at a point of a load path at which bodies crack; it divides them with Simulation::split.
  std::function<void(const std::vector<Crack<D>>&)> crack_bodies;
};

}  // namespace trilith
