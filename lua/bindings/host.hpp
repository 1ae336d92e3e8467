// What the surroundings of a script give it (command line, folders, listeners) and what it tells them. No Lua here.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "run/stage.hpp"

namespace trilith::script {

class ScriptModel;

/// A parameter that the script declared, and its value in this run.
struct ParameterValue {
  std::string name;
  std::string value;   ///< as text, in `unit`
  std::string unit;    ///< as declared; "" for text and flags
  std::string preset;  ///< declared default, as text in `unit`
  std::string sentence;
};

struct HistoryInfo {
  std::string name, unit, sentence;
};

/// What a recorder is asked for when a model runs for the first time.
struct RecorderOrder {
  std::string file;
  const Model<2>& model;
  const State<2>& state;
  std::vector<HistoryInfo> histories;
  std::vector<ParameterValue> parameters;
  std::vector<std::string> motions;  ///< one line each
  std::string script, script_text, command_line;
  bool with_velocity = false;
};

/// Writes one model's run to a file. The rooms below write; this is what the scripts need of them.
class Recorder {
 public:
  Recorder() = default;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  virtual ~Recorder() = default;
  virtual void stage_begun(const StageOptions& options, double time) = 0;
  virtual void frame(const Instant& now) = 0;
  virtual void history(double time, std::span<const double> values) = 0;
  virtual void energy(const Instant& now, const Energy& energy) = 0;
  virtual void event(const Event& event, const Instant& now) = 0;
  virtual void stage_ended(const StageReport& report) = 0;
  /// Once, at the end. `error`: "" for a script that went through, else why it did not.
  virtual void finish(const std::string& error) = 0;
};

using MakeRecorder = std::function<std::unique_ptr<Recorder>(const RecorderOrder&)>;

/// Who shows a run while it goes on.
class RunObserver {
 public:
  RunObserver() = default;
  RunObserver(const RunObserver&) = delete;
  RunObserver& operator=(const RunObserver&) = delete;
  virtual ~RunObserver() = default;
  virtual void note(const std::string& text) = 0;
  virtual void event(const Event& event, const Instant& now) = 0;
  virtual void step(const Instant& now) = 0;  ///< after every step: be quick
  virtual void stage_ended(const StageReport& report) = 0;
};

struct Host {
  std::string script;  ///< path as given; "" in the module
  std::string script_text, command_line;
  std::vector<std::string> given;              ///< "name=value", from the command line
  bool given_used = false;                     ///< a params call has taken them
  bool list_parameters = false;                ///< show the parameters and end
  std::vector<ParameterValue> parameters;      ///< of this run
  std::vector<std::filesystem::path> records;  ///< folders in which motions are looked for after the script's own
  std::string results_file;                    ///< where given, instead of the script's own; for the first model
  MakeRecorder make_recorder;                  ///< empty: m:results is refused with a word
  RunObserver* observer = nullptr;
  std::vector<std::weak_ptr<ScriptModel>> models;  ///< in the order made

  /// Folder of the script, "." where it has none.
  [[nodiscard]] std::filesystem::path folder() const;
  /// Ends all recorders; `error` as in Recorder::finish.
  void finish(const std::string& error);
};

/// Where the project's own ground motions are: where installed, or in the source tree it was built from.
std::vector<std::filesystem::path> record_folders();

/// Thrown, as a script error, where the parameters were to be listed and now are known.
inline constexpr const char* parameters_listed = "the parameters are listed";

}  // namespace trilith::script
