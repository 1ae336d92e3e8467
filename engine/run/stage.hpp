// What a stage is asked for, what is told while it runs, and how it ended.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "assembly/alpha_scheme.hpp"
#include "integrate/explicit/mass_scaling.hpp"
#include "model/event.hpp"
#include "model/work.hpp"

namespace trilith {

/// Why a stage ended.
enum class StageEnd { time, rest, stopped, not_at_rest, diverged, all_left, not_converged, unstable };
constexpr const char* name_of(StageEnd e) {
  constexpr const char* names[] = {"time",     "rest",     "stopped",       "not at rest",
                                   "diverged", "all left", "not converged", "unstable"};
  return names[static_cast<int>(e)];
}

struct StageOptions {
  std::string name = "run";
  double duration = 0;    ///< longest time the stage may last [s], above 0
  double end_time = 0;    ///< it ends at this time, where that is above the present one; else after `duration` [s]
  double dt = 0;          ///< fixed step [s]; 0: found and kept stable by itself
  double safety = 0.5;    ///< share of the longest stable step that is taken, above 0 to 0.9. At 0.5 a bounce keeps its
                          ///< energy to some percent, at 0.1 to a tenth of one
  double rest_share = 0;  ///< damping of consolidation (RestDamping), 0 to below 1

  std::optional<MassScaling> mass_scaling;  ///< longer explicit steps of bodies of elements

  std::optional<AlphaScheme> implicit;  ///< steps of this scheme; else explicit central differences
  bool may_change = false;              ///< with `implicit`: explicit steps where those do not pay
  double tolerance = 1e-8;              ///< of implicit steps: largest force left over, as a share of that carried
  double accuracy = 1e-3;               ///< ... and what a step may miss of its energies, see ImplicitOptions
  /// Share of the energies put in that a blow may miss in explicit steps, see ImpactOptions, where dt is not given; 0:
  /// blows do not shorten steps.
  double impact_accuracy = 0;

  bool until_rest = false;       ///< end when all is at rest
  double still_from = 0;         ///< rest is looked for from this time after the stage's start [s]
  double still_speed = 2.54e-7;  ///< every skin point of every moving body slower than this ... [m/s]
  double still_ratio = 1;        ///< ... and the unbalanced force at most this share of the largest carried one ...
  double still_hold = 0.5;       ///< ... for this long [s]

  bool must_rest = false;  ///< with until_rest: where it is not reached, or not in place, the run's verdict says so
  bool watched = true;     ///< speeds and energies beyond what was put in end the stage as diverged
  /// With until_rest: a body that rests farther than this share of its size from where the stage began has left its
  /// place, and the stage is unstable (statics/travel.hpp); 0: any place.
  float within = 0;

  double frame_interval = 0;    ///< [s]; 0: none
  double history_interval = 0;  ///< [s]; 0: none
  double energy_interval = 0;   ///< [s]; 0: none
};

/// Throws InputError where an option is out of its range or does not go with another.
void require_valid(const StageOptions& options);

struct StageReport {
  std::string name;
  StageEnd end = StageEnd::time;
  double begun = 0, ended = 0;  ///< [s]
  std::int64_t steps = 0;
  double shortest_dt = 0, longest_dt = 0;  ///< [s]
  double speed = 0, ratio = 0;             ///< fastest skin point and unbalanced ratio at the end
  int threads = 1;                         ///< that shared a step at the end
  double thread_gain = 0;                  ///< how many times as fast as one these were; 0: not timed
  std::optional<ScaledMass> scaled;        ///< with StageOptions::mass_scaling
  std::string reason;                      ///< in words, where it did not end as asked: what, where, what to try
  std::string found;       ///< where it diverged or was unstable: what and where; else Watch::ledger_text
  double sound_until = 0;  ///< where it diverged: the last instant that was looked at and sound [s]
};

/// What a running stage looks like at one instant.
template <int D>
struct Instant {
  const Model<D>& model;
  const State<D>& state;
  const Work<D>& work;
  const StageOptions& stage;
  double begun;  ///< time at which the stage began [s]
  double dt;     ///< step about to be taken [s]
  double speed;  ///< fastest skin point of a moving body [m/s]
  double ratio;  ///< unbalanced force over largest carried force
};

/// Who listens to a run. All are called at an evaluated instant, in this order; none may write State, Model or Work,
/// but for change_model, which is the step border: what it changes holds from then on. Events tell of the step behind,
/// the instant they come with is the one after it.
template <int D>
struct RunListener {
  std::function<void(const Instant<D>&)> on_frame, on_history;
  std::function<void(const Instant<D>&, const Energy&)> on_energy;
  std::function<void(const Instant<D>&)> on_step;  ///< after each step; leave empty where it is not needed
  std::function<void(const Event&, const Instant<D>&)> on_event;
  /// After on_step. Supports, drives, damping and gravity may be changed; true where something was.
  std::function<bool(Model<D>&)> change_model;
  /// Last, at the step border, where Simulation::edit_model, run_on, snapshot and restore may be called.
  std::function<void()> at_border;
};

}  // namespace trilith
