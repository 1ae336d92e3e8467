// A model as scripts hold it: first a builder, from the first stage on a simulation. No Lua here.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "checkpoints.hpp"
#include "host.hpp"
#include "run/joints.hpp"
#include "run/recording.hpp"
#include "run/simulation.hpp"
#include "run/storeys.hpp"
#include "world/builder.hpp"

namespace trilith::script {

struct BridgeBook;  // bridge_book.hpp

/// A quantity followed over time, kept in memory and recorded.
struct History {
  std::string name, unit, sentence;
  std::function<double()> sample;  ///< empty: a Lua function gives it
  std::vector<double> values;
};

/// What bodies are made as where nothing else is said.
struct BodyForm {
  BodyKind kind = BodyKind::rigid;
  std::array<int, 2> divisions{1, 1};
};

struct ResultsOptions {
  std::string file;
  double frames = 0.05, histories = 0.01, energy = 0.05;  ///< [s]
  bool with_velocity = false, with_joints = true;
};

/// What engineering results are asked of.
struct Findings {
  std::vector<Joint> joints;
  std::vector<Storey> storeys;
  std::vector<int> base;
};

class ScriptModel : public std::enable_shared_from_this<ScriptModel> {
 public:
  explicit ScriptModel(std::string model_name) : name(std::move(model_name)) {}

  std::string name;
  bool closed = false;  ///< for all handles, whoever still holds it
  ModelBuilder builder;
  BodyForm body_form;
  std::vector<std::pair<std::string, ContactLaw>> laws;  ///< as given to the builder
  std::vector<Material> materials;                       ///< as given to the builder
  std::vector<std::string> bearings, seats;              ///< names, in order
  std::shared_ptr<BridgeBook> bridge;                    ///< supports and spans; empty before the first
  std::vector<History> histories;
  std::vector<double> history_times;  ///< [s]
  double history_interval = 0.01;     ///< [s], without results
  std::optional<ResultsOptions> results;
  std::vector<std::string> motions;  ///< one line for each motion used
  std::vector<Event> events;         ///< of all stages
  std::vector<Timer> timers;
  Checkpoints checkpoints;
  bool checkpoints_chosen = false;  ///< the script has said whether there are any; else at a console alone
  std::optional<Branch> undone;     ///< what the last rewind() took back
  double wake_at = unbounded;       ///< a story wants to be woken then [s]
  bool has_step_handler = false;
  std::function<void(const Instant<2>&)> watch;  ///< of the engine's own, after each step; empty: none
  std::uint32_t wanted_events = 0;               ///< bit of each EventType that some handler wants
  std::string pause_reason;                      ///< why the run is to pause at the next step border; "": it is not

  [[nodiscard]] std::string title() const { return name.empty() ? "model" : "model '" + name + "'"; }
  [[nodiscard]] bool built() const { return simulation_ != nullptr; }
  [[nodiscard]] bool running() const { return running_; }
  /// At a step border of a running stage, where a console is open.
  [[nodiscard]] bool paused() const { return paused_; }
  [[nodiscard]] bool recording() const { return recording_ != nullptr; }

  /// Throws InputError where the model was built or is running: bodies, laws and bearings come before.
  void require_open(const std::string& what) const;
  /// Builds where that was not done. Throws InputError as ModelBuilder::build does.
  Simulation<2>& simulation();
  /// The simulation with its forces up to date, for reading.
  const Simulation<2>& evaluated();
  /// Its joints, storeys and base; builds the model.
  const Findings& findings();
  [[nodiscard]] const Simulation<2>* if_built() const { return simulation_.get(); }
  /// Does `change` now, or at the next step border where a stage runs.
  void change(std::function<void(Model<2>&)> what);
  void stop() {
    if (simulation_) simulation_->stop();
  }

  /// Mass and inertia of a body, before and after building.
  [[nodiscard]] double mass_of(int body);
  [[nodiscard]] double inertia_of(int body);
  [[nodiscard]] int body_count() const { return static_cast<int>(builder.bodies().size()); }
  /// Index of the body called `body`, or InputError with the nearest name; `owner` begins it.
  [[nodiscard]] int require_body(const std::string& body, const std::string& owner) const;
  [[nodiscard]] double time() const { return simulation_ ? simulation_->state().time : 0; }

  /// Runs a stage with `listener` wrapped by recording and observing.
  StageReport run(const StageOptions& options, const RunListener<2>& listener, Host& host,
                  const EquilibriumOptions* statics = nullptr);
  /// While the model is paused: further steps of its stage, up to `limit` or its end.
  void run_on(const RunLimit& limit, const RunListener<2>& listener, Host& host);
  /// Runs the stage that rewind() has brought back to its end. InputError where there is none.
  StageReport resume(const RunListener<2>& listener, Host& host);
  /// Goes back to the checkpoint nearest to `time`, between stages or paused (then within that stage). What was
  /// recorded since stays in the part file, unfinished; what follows goes to a file of its own. Gives the time it is
  /// now [s]. InputError where there is no such checkpoint.
  double rewind(double time, Host& host);
  /// A line for the notes of the results file, where there is one.
  void note(const std::string& text);
  /// Calls `ask` with the model paused: it can be read as it is now, and changed at once.
  void pause(const std::function<void()>& ask);
  /// The run did not come to its end: results are left as unfinished, unless a later stage goes through.
  void break_off(const std::string& why) { broken_ = why; }
  /// Ends the recording, if any; see Host::finish. What became of it, in words; "" where there is none.
  std::string finish(const std::string& error);
  /// Whether its run may be trusted so far.
  [[nodiscard]] const Verdict& verdict() const { return *verdict_; }

 private:
  void begin_recording(Host& host);
  void open_recording(Host& host);
  void continue_recording(Host& host, double left, const Recording& before);
  void replay(Recording& recording);
  StageReport guarded_run(const std::function<StageReport()>& go, Host& host);
  [[nodiscard]] Checkpoint checkpoint();
  RunListener<2> listen_with(const RunListener<2>& script, RunObserver* observer);
  void take_histories(double time, Recording* recording);
  bool apply_changes(Model<2>& model);
  Model<2> lone_body(int body) const;

  std::unique_ptr<Simulation<2>> simulation_;
  std::unique_ptr<Recording> recording_;
  std::shared_ptr<Verdict> verdict_ = std::make_shared<Verdict>();
  std::optional<Findings> findings_;
  bool running_ = false, paused_ = false, recording_begun_ = false;
  std::optional<State<2>> recorded_from_;  // where all branches of the results begin
  int branches_ = 1;                       // files of results so far
  std::vector<StageOptions> stages_run_;   // one for each event "stage.begun"
  std::size_t notes_shown_ = 0;
  std::string broken_;                                   // why the last stage broke off, if it did
  std::vector<std::function<void(Model<2>&)>> changes_;  // wait for the step border
};

}  // namespace trilith::script
