// A model in scripts, in either dimension: first a builder, from the first stage on a simulation. No Lua here.
//
// ScriptModel is the common part of plane and space; SimulatedModel<D> (simulated_model.hpp) runs and records;
// PlaneModel and SpaceModel contain the descriptions of their bodies.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bindings/core/host.hpp"
#include "bindings/restart/restart_book.hpp"
#include "bindings/stages/checkpoints.hpp"
#include "model/builder/builder.hpp"
#include "run/simulation.hpp"

namespace trilith::script {

/// A quantity followed over time, kept in memory and recorded.
struct History {
  std::string name, unit, sentence;
  std::function<double()> sample;  ///< empty: a Lua function computes it
  std::vector<double> values;
};

struct ResultsOptions {
  std::string file;
  double frames = 0.05, histories = 0.01, energy = 0.05;  ///< [s]
  bool with_velocity = false, with_joints = true;
};

/// Callbacks of the script during a stage, in either dimension; all are set.
struct ScriptListener {
  std::function<void(const Event&)> on_event;
  std::function<void(double time, double last_dt)> on_step;  ///< [s]
  std::function<void()> on_history;                          ///< before samples are taken
  std::function<void()> at_border;                           ///< empty: no pauses
  // For restart files: repeats a call that changed something; tables of m:keep as bytes, and back; names state of the
  // script that is not restored.
  std::function<void(const HandlerCall&)> replay;
  std::function<std::string()> kept, unkept;
  std::function<void()> watch_state;  ///< from the start of the stage
  std::function<void(const std::string&)> keep_again;
  std::function<bool()> is_stopped;  ///< within a step: a signal ends it
};

/// Numbers of a simulation that are available without evaluation.
struct StepNumbers {
  double last_dt = 0;  ///< [s]
  std::int64_t steps = 0;
  double speed = 0;  ///< fastest point of all moving bodies [m/s]
  double ratio = 0;  ///< unbalanced force over the largest carried one [1]
};

/// The load path of a model of either dimension, or none.
using AnyLoadWay = std::variant<std::monostate, const LoadWay<2>*, const LoadWay<3>*>;

class ScriptModel : public std::enable_shared_from_this<ScriptModel> {
 public:
  explicit ScriptModel(std::string model_name) : name(std::move(model_name)) {}
  ScriptModel(const ScriptModel&) = delete;
  ScriptModel& operator=(const ScriptModel&) = delete;
  virtual ~ScriptModel() = default;

  std::string name;
  bool closed = false;                                   ///< for all handles
  std::vector<std::pair<std::string, ContactLaw>> laws;  ///< as given to the builder
  std::map<std::string, int> last_unnamed_law;           ///< [kind] number of the last generated name of an unnamed law
  std::vector<Material> materials;                       ///< as given to the builder
  std::vector<std::string> bearings, seats;              ///< names, in their order
  std::vector<History> histories;
  std::vector<double> history_times;  ///< [s]
  double history_interval = 0.01;     ///< [s], without results
  int threads = 0;                    ///< threads that may share a step; 0: from the environment
  std::optional<ResultsOptions> results;
  std::vector<std::string> motions;  ///< one line for each motion used
  std::vector<Event> events;         ///< of all stages
  std::vector<Timer> timers;
  Checkpoints checkpoints;
  bool checkpoints_chosen = false;  ///< the script has enabled or disabled checkpoints; otherwise only at a console
  std::optional<Branch> undone;     ///< the part that the last rewind() removed
  double wake_at = unbounded;       ///< time at which a story must be resumed [s]
  bool has_step_handler = false;
  std::uint32_t wanted_events = 0;       ///< bit of each EventType with a handler
  bool adds_later = false;               ///< additions are deferred: parts that are stable only together
  std::unique_ptr<RestartBook> restart;  ///< from which another process can continue the run
  bool keeps_tables = false;             ///< the script has called m:keep
  std::uint64_t effects = 0;             ///< increases with each lasting change by a handler
  std::int64_t resumed_steps = 0;        ///< of the running stage, before the interruption
  std::string pause_reason;              ///< reason for a pause at the next step border; "": no pause

  [[nodiscard]] virtual int dim() const = 0;
  [[nodiscard]] std::string title() const { return name.empty() ? "model" : "model '" + name + "'"; }
  [[nodiscard]] virtual bool built() const = 0;
  [[nodiscard]] bool running() const { return running_; }
  /// At a step border of a running stage with an open console.
  [[nodiscard]] bool paused() const { return paused_; }
  [[nodiscard]] virtual bool recording() const = 0;

  /// Called before an addition: see catch_up.
  void adding() { ++additions_, ++effects; }
  /// Transfers additions into a built model: now, or at the next step border while a stage runs. Throws InputError if
  /// they are invalid in the present state; then they are removed.
  virtual void catch_up() = 0;
  /// Histories were added: the results file gets columns for them.
  virtual void follow_more() = 0;
  /// Removes or reactivates bodies and bearings: now, or at the next step border while a stage runs. Throws InputError
  /// for absent, or for present parts. `place`: place in the script, for a message at the border.
  virtual void remove(const std::vector<int>& which, const std::vector<int>& links, const std::string& place) = 0;
  /// `from_start`: displacements of the bearings count from their first position instead of the present one.
  virtual void reactivate(const std::vector<int>& which, const std::vector<int>& links, bool from_start,
                          const std::string& place) = 0;
  /// True if a part of the model is inactive. A body: removed or out of bounds. A bearing: removed, or with an inactive
  /// body. A seat: with an inactive body. A storey: all bodies at its top are inactive.
  [[nodiscard]] virtual bool is_out(int body) const = 0;
  [[nodiscard]] virtual bool is_bearing_out(int bearing) const = 0;
  [[nodiscard]] virtual bool is_seat_out(int seat) const = 0;
  [[nodiscard]] virtual bool is_storey_out(int number) = 0;
  /// Reason for which the body cannot be used: "was removed at 3.2 s", "is added at the next step border"; "" if it
  /// can.
  [[nodiscard]] virtual std::string why_absent(int body) const = 0;
  /// The first of the two parts of a body that has cracked; the other is the next body. -1 for other bodies.
  [[nodiscard]] virtual int first_part(int /*body*/) const { return -1; }
  /// The part that holds the centroid of a body that has cracked, and so on for parts that have cracked; -1 for other
  /// bodies.
  [[nodiscard]] virtual int heir_of(int /*body*/) const { return -1; }
  /// Time of its removal [s]; none if it was not removed, or is reactivated.
  [[nodiscard]] virtual std::optional<double> removed_at(int body) const = 0;
  /// InputError, beginning with `owner`, if it cannot be used.
  void require_present(int body, const std::string& owner) const;

  // Access to the builder. Functions that add throw InputError as the builder does.
  virtual void add_material(const Material& material) = 0;
  virtual void add_law(const std::string& law_name, const ContactLaw& law) = 0;
  virtual void set_contact(const std::string& a, const std::string& b, const std::string& law) = 0;
  [[nodiscard]] virtual std::vector<std::string> law_names() const = 0;
  [[nodiscard]] virtual int body_count() const = 0;
  [[nodiscard]] virtual const std::string& body_name(int body) const = 0;
  [[nodiscard]] virtual const std::string& material_of(int body) const = 0;
  [[nodiscard]] virtual const std::vector<std::string>& groups_of(int body) const = 0;
  [[nodiscard]] std::vector<std::string> body_names() const;
  /// Index of the body called `body`, or InputError with the nearest name; `owner` begins the message.
  [[nodiscard]] int require_body(const std::string& body, const std::string& owner) const;
  /// Repairs and other notes; complete after the model is built.
  [[nodiscard]] virtual const std::vector<std::string>& notes() const = 0;
  virtual void add_note(const std::string& line) = 0;
  /// Reasons for which it cannot be built, or after that cannot begin its first stage, one line each.
  [[nodiscard]] virtual std::vector<std::string> faults() const = 0;

  /// Builds the model if necessary. Throws InputError as the builder does.
  virtual void build() = 0;
  [[nodiscard]] virtual double time() const = 0;  ///< [s]
  /// At the present instant; all 0 before the model is built.
  [[nodiscard]] virtual StepNumbers step_numbers() = 0;
  /// Present energy ledger; builds the model.
  [[nodiscard]] virtual Energy energy() = 0;
  /// Energy error of the ledger from the start of the first stage [J].
  [[nodiscard]] virtual double residual() = 0;
  [[nodiscard]] virtual std::uint64_t hash() = 0;
  [[nodiscard]] virtual std::string step_text() = 0;  ///< the governing part of the step
  [[nodiscard]] virtual std::string text_of(const Event& event) const = 0;
  /// Mass of a body [kg], before and after building.
  [[nodiscard]] virtual double mass_of(int body) = 0;
  /// [body] height of the first node [m]; NaN for fixed, removed or not yet added bodies. For a built model.
  [[nodiscard]] virtual std::vector<double> heights() const = 0;
  /// True after it has been at rest for the model's still_time.
  [[nodiscard]] virtual bool is_resting(int body) const = 0;
  /// Weight increases from zero until `end` [s].
  virtual void grow_weight(double end) = 0;
  virtual void lift_bonds() = 0;
  virtual void set_bonds() = 0;
  virtual void drop_step() = 0;
  /// Ends the running stage at the next step border; `why`: for its report.
  virtual void stop(const std::string& why) = 0;

  /// Runs a stage with `listener` wrapped by recording and observing; with `statics` a stage without time, with the
  /// load path `way`.
  virtual StageReport run(const StageOptions& options, const ScriptListener& listener, Host& host,
                          const EquilibriumOptions* statics = nullptr, AnyLoadWay way = {}) = 0;
  /// While the model is paused: further steps of its stage, up to `limit` or its end.
  virtual void run_on(const RunLimit& limit, const ScriptListener& listener, Host& host) = 0;
  /// Runs the stage that rewind() has restored to its end. InputError if there is none.
  virtual StageReport resume(const ScriptListener& listener, Host& host) = 0;
  /// Returns to the checkpoint nearest to `time`, between stages or paused (then within that stage). Later records
  /// remain in the part file, unfinished; the following ones are written to a new file. Returns the new time [s].
  /// InputError if there is no such checkpoint.
  virtual double rewind(double time, Host& host) = 0;
  /// A line for the notes of the results file, if there is one.
  virtual void note(const std::string& text) = 0;
  /// A note that is displayed at once, and stored in the results file if there is one.
  void note_at_once(const std::string& text, Host& host);
  /// Calls `ask` with the model paused: it can be read and changed in its present state.
  void pause(const std::function<void()>& ask);
  /// The run was interrupted: results are left unfinished, unless a later stage succeeds.
  void break_off(const std::string& why) { broken_ = why; }
  /// Stores a call of a handler that changed something; nullptr: queued changes take effect now.
  virtual void keep_change(const HandlerCall* call) = 0;
  /// A signal ends the run: stores the checkpoints in memory.
  virtual void end_by_signal() = 0;
  /// Writes the present instant to one file, which a console can open. Throws InputError if the script does not reach
  /// the instant without the console.
  virtual void save_instant(const std::filesystem::path& file, const ScriptListener& listener) = 0;
  /// True if a signal ends the stage at the step border, after a checkpoint.
  [[nodiscard]] bool finishes_step() const {
    return restart && restart->keeps() && restart->by_steps && !restart->signalled;
  }
  /// Ends the recording, if any; see Host::finish. Returns a text on the file; "" if there is none.
  virtual std::string finish(const std::string& error) = 0;
  /// Verdict on the reliability of the run so far.
  [[nodiscard]] const Verdict& verdict() const { return *verdict_; }

 protected:
  std::shared_ptr<Verdict> verdict_ = std::make_shared<Verdict>();
  bool running_ = false, paused_ = false, recording_begun_ = false;
  int branches_ = 1;                      // number of results files so far
  std::vector<StageOptions> stages_run_;  // one for each event "stage.begun"
  std::size_t notes_shown_ = 0;
  std::string stop_reason_;    // of the running stage, if a script or a signal ends it
  std::string broken_;         // reason for which the last stage was interrupted, if any
  std::size_t additions_ = 0;  // number of announced additions
};

}  // namespace trilith::script
