// A model as scripts hold it, whatever its dimension: first a builder, from the first stage on a simulation. No Lua
// here.
//
// ScriptModel is what plane and space share; SimulatedModel<D> (simulated_model.hpp) runs and records; PlaneModel and
// SpaceModel know what their bodies are.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bindings/core/host.hpp"
#include "bindings/stages/checkpoints.hpp"
#include "model/builder/builder.hpp"
#include "run/simulation.hpp"

namespace trilith::script {

/// A quantity followed over time, kept in memory and recorded.
struct History {
  std::string name, unit, sentence;
  std::function<double()> sample;  ///< empty: a Lua function gives it
  std::vector<double> values;
};

struct ResultsOptions {
  std::string file;
  double frames = 0.05, histories = 0.01, energy = 0.05;  ///< [s]
  bool with_velocity = false, with_joints = true;
};

/// Who of the script listens to a stage, whatever its dimension; all are there.
struct ScriptListener {
  std::function<void(const Event&)> on_event;
  std::function<void(double time, double last_dt)> on_step;  ///< [s]
  std::function<void()> on_history;                          ///< before samples are taken
  std::function<void()> at_border;                           ///< empty: nobody pauses
};

/// What can be read of a simulation at a glance.
struct StepNumbers {
  double last_dt = 0;  ///< [s]
  std::int64_t steps = 0;
  double speed = 0;  ///< fastest point of all moving bodies [m/s]
  double ratio = 0;  ///< unbalanced force over the largest carried one [1]
};

/// The way that loads have gone in a model of either dimension, or none.
using AnyLoadWay = std::variant<std::monostate, const LoadWay<2>*, const LoadWay<3>*>;

class ScriptModel : public std::enable_shared_from_this<ScriptModel> {
 public:
  explicit ScriptModel(std::string model_name) : name(std::move(model_name)) {}
  ScriptModel(const ScriptModel&) = delete;
  ScriptModel& operator=(const ScriptModel&) = delete;
  virtual ~ScriptModel() = default;

  std::string name;
  bool closed = false;                                   ///< for all handles, whoever still holds it
  std::vector<std::pair<std::string, ContactLaw>> laws;  ///< as given to the builder
  std::map<std::string, int> last_unnamed_law;           ///< [kind] number in the name that a law without one got last
  std::vector<Material> materials;                       ///< as given to the builder
  std::vector<std::string> bearings, seats;              ///< names, in order
  std::vector<History> histories;
  std::vector<double> history_times;  ///< [s]
  double history_interval = 0.01;     ///< [s], without results
  int threads = 0;                    ///< that may share a step; 0: as the surroundings say
  std::optional<ResultsOptions> results;
  std::vector<std::string> motions;  ///< one line for each motion used
  std::vector<Event> events;         ///< of all stages
  std::vector<Timer> timers;
  Checkpoints checkpoints;
  bool checkpoints_chosen = false;  ///< the script has said whether there are any; else at a console alone
  std::optional<Branch> undone;     ///< what the last rewind() took back
  double wake_at = unbounded;       ///< a story wants to be woken then [s]
  bool has_step_handler = false;
  std::uint32_t wanted_events = 0;  ///< bit of each EventType that some handler wants
  bool adds_later = false;          ///< what is added waits: parts of a whole that stand only together
  std::string pause_reason;         ///< why the run is to pause at the next step border; "": it is not

  [[nodiscard]] virtual int dim() const = 0;
  [[nodiscard]] std::string title() const { return name.empty() ? "model" : "model '" + name + "'"; }
  [[nodiscard]] virtual bool built() const = 0;
  [[nodiscard]] bool running() const { return running_; }
  /// At a step border of a running stage, where a console is open.
  [[nodiscard]] bool paused() const { return paused_; }
  [[nodiscard]] virtual bool recording() const = 0;

  /// Something is about to be added: see catch_up.
  void adding() { ++additions_; }
  /// Brings what was added into the model where that is built: now, or at the next step border where a stage runs.
  /// Throws InputError where it cannot stand as the model stands now; then it is forgotten.
  virtual void catch_up() = 0;
  /// Histories were added: the file of results gets columns for them.
  virtual void follow_more() = 0;
  /// Takes bodies and bearings away, or puts them back: now, or at the next step border where a stage runs. Throws
  /// InputError for what is not there, or is there. `place`: of the script, for a message at the border.
  virtual void remove(const std::vector<int>& which, const std::vector<int>& links, const std::string& place) = 0;
  /// `from_start`: the bearings count displacements from where they were placed first, not from where they are now.
  virtual void reactivate(const std::vector<int>& which, const std::vector<int>& links, bool from_start,
                          const std::string& place) = 0;
  /// Whether a part of the model is out of the step: the body was removed or has left the bounds; the bearing was
  /// removed, or one of its bodies is out; one of the seat's bodies is out; all bodies at the top of the storey are.
  [[nodiscard]] virtual bool is_out(int body) const = 0;
  [[nodiscard]] virtual bool is_bearing_out(int bearing) const = 0;
  [[nodiscard]] virtual bool is_seat_out(int seat) const = 0;
  [[nodiscard]] virtual bool is_storey_out(int number) = 0;
  /// Why the body cannot be used: "was removed at 3.2 s", "is added at the next step border"; "" where it can.
  [[nodiscard]] virtual std::string why_absent(int body) const = 0;
  /// When it was removed [s]; nothing where it was not, or is back.
  [[nodiscard]] virtual std::optional<double> removed_at(int body) const = 0;
  /// InputError, begun with `owner`, where it cannot be used.
  void require_present(int body, const std::string& owner) const;

  // What the builder knows. Those that add throw InputError as it does.
  virtual void add_material(const Material& material) = 0;
  virtual void add_law(const std::string& law_name, const ContactLaw& law) = 0;
  virtual void set_contact(const std::string& a, const std::string& b, const std::string& law) = 0;
  [[nodiscard]] virtual std::vector<std::string> law_names() const = 0;
  [[nodiscard]] virtual int body_count() const = 0;
  [[nodiscard]] virtual const std::string& body_name(int body) const = 0;
  [[nodiscard]] virtual const std::string& material_of(int body) const = 0;
  [[nodiscard]] virtual const std::vector<std::string>& groups_of(int body) const = 0;
  [[nodiscard]] std::vector<std::string> body_names() const;
  /// Index of the body called `body`, or InputError with the nearest name; `owner` begins it.
  [[nodiscard]] int require_body(const std::string& body, const std::string& owner) const;
  /// What was repaired or is worth knowing; complete once the model is built.
  [[nodiscard]] virtual const std::vector<std::string>& notes() const = 0;
  virtual void add_note(const std::string& line) = 0;
  /// What keeps it from being built, or once it is from its first stage, a line for each.
  [[nodiscard]] virtual std::vector<std::string> faults() const = 0;

  /// Builds where that was not done. Throws InputError as the builder does.
  virtual void build() = 0;
  [[nodiscard]] virtual double time() const = 0;  ///< [s]
  /// Of the present instant; all 0 before the model is built.
  [[nodiscard]] virtual StepNumbers step_numbers() = 0;
  /// The ledger now; builds the model.
  [[nodiscard]] virtual Energy energy() = 0;
  /// What the ledger has gained or lost since the first stage began that no force has done [J].
  [[nodiscard]] virtual double residual() = 0;
  [[nodiscard]] virtual std::uint64_t hash() = 0;
  [[nodiscard]] virtual std::string step_text() = 0;  ///< what governs the step
  [[nodiscard]] virtual std::string text_of(const Event& event) const = 0;
  /// Mass of a body [kg], before and after building.
  [[nodiscard]] virtual double mass_of(int body) = 0;
  /// [body] of the first node [m]; no number for what is held, gone or not there yet. Of a model that is built.
  [[nodiscard]] virtual std::vector<double> heights() const = 0;
  /// True while it has been still for the model's still_time.
  [[nodiscard]] virtual bool is_resting(int body) const = 0;
  /// Weight grows from nothing until `end` [s].
  virtual void grow_weight(double end) = 0;
  virtual void lift_bonds() = 0;
  virtual void set_bonds() = 0;
  virtual void drop_step() = 0;
  virtual void stop() = 0;

  /// Runs a stage with `listener` wrapped by recording and observing; by `statics` one that takes no time, with the
  /// `way` that led to it.
  virtual StageReport run(const StageOptions& options, const ScriptListener& listener, Host& host,
                          const EquilibriumOptions* statics = nullptr, AnyLoadWay way = {}) = 0;
  /// While the model is paused: further steps of its stage, up to `limit` or its end.
  virtual void run_on(const RunLimit& limit, const ScriptListener& listener, Host& host) = 0;
  /// Runs the stage that rewind() has brought back to its end. InputError where there is none.
  virtual StageReport resume(const ScriptListener& listener, Host& host) = 0;
  /// Goes back to the checkpoint nearest to `time`, between stages or paused (then within that stage). What was
  /// recorded since stays in the part file, unfinished; what follows goes to a file of its own. Gives the time it is
  /// now [s]. InputError where there is no such checkpoint.
  virtual double rewind(double time, Host& host) = 0;
  /// A line for the notes of the results file, where there is one.
  virtual void note(const std::string& text) = 0;
  /// A note that is shown at once, and kept in the results file where there is one.
  void note_at_once(const std::string& text, Host& host);
  /// Calls `ask` with the model paused: it can be read as it is now, and changed at once.
  void pause(const std::function<void()>& ask);
  /// The run did not come to its end: results are left as unfinished, unless a later stage goes through.
  void break_off(const std::string& why) { broken_ = why; }
  /// Ends the recording, if any; see Host::finish. What became of it, in words; "" where there is none.
  virtual std::string finish(const std::string& error) = 0;
  /// Whether its run may be trusted so far.
  [[nodiscard]] const Verdict& verdict() const { return *verdict_; }

 protected:
  std::shared_ptr<Verdict> verdict_ = std::make_shared<Verdict>();
  bool running_ = false, paused_ = false, recording_begun_ = false;
  int branches_ = 1;                      // files of results so far
  std::vector<StageOptions> stages_run_;  // one for each event "stage.begun"
  std::size_t notes_shown_ = 0;
  std::string broken_;         // why the last stage broke off, if it did
  std::size_t additions_ = 0;  // so many things were to be added
};

}  // namespace trilith::script
