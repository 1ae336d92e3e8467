// What the surroundings of a script give it (command line, folders, listeners) and what it tells them. No Lua here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assembly/step_times.hpp"
#include "bindings/core/room.hpp"
#include "model/verdict.hpp"
#include "results/file/results.hpp"
#include "run/stage.hpp"
#include "run/study/study.hpp"
#include "run/thread_choice.hpp"

struct lua_State;

namespace trilith::script {

class ScriptModel;

// Limits of a script in a closed room, where none are given.
inline constexpr double default_script_memory = 4.0 * (std::uint64_t{1} << 30);  ///< [bytes]
inline constexpr double default_script_seconds = 600;                            ///< [s]

inline constexpr std::size_t largest_script = std::size_t{64} << 20;  ///< [bytes]; more is no script

/// Who shows a run while it goes on.
class RunObserver {
 public:
  RunObserver() = default;
  RunObserver(const RunObserver&) = delete;
  RunObserver& operator=(const RunObserver&) = delete;
  virtual ~RunObserver() = default;
  virtual void note(const std::string& text) = 0;
  virtual void event(const Event& event, const Instant<2>& now) = 0;
  virtual void event(const Event& event, const Instant<3>& now) = 0;
  virtual void step(const Instant<2>& now) = 0;  ///< after every step: be quick
  virtual void step(const Instant<3>& now) = 0;
  virtual void stage_ended(const StageReport& report) = 0;
  /// Others are about to write where this one shows the run.
  virtual void clear() = 0;
  // How a study goes on: lines, and one that is told again and again.
  virtual void line(const std::string& text, bool strong) = 0;
  virtual void status(const std::string& text) = 0;
};

/// Who is asked where a run pauses.
class Console {
 public:
  Console() = default;
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;
  virtual ~Console() = default;
  /// True where the person at the keyboard asked for a pause; forgets it.
  virtual bool was_interrupted() = 0;
  /// Lets the person look and change; returns when the run is to go on. The handle of the model that pauses, or nil, is
  /// on top of the stack, and is taken off. May throw ScriptError.
  virtual void open(lua_State* L, const std::string& why) = 0;
};

/// What the command line says of a script's study.
struct StudyChoice {
  std::string program;                ///< runs the cases; "": there is none, so that no study can be begun
  int jobs = 0;                       ///< cases at a time; 0: as the script says
  int only = 0;                       ///< run this case alone, here; 0: run the study
  bool fresh = false;                 ///< run finished cases again
  bool list = false;                  ///< list the cases and end
  bool begun = false;                 ///< the script has called trilith.study
  bool failed = false;                ///< a case of it has
  std::optional<StudyRise> rise;      ///< an incremental analysis; else as the script says
  std::vector<int> some;              ///< run these cases alone, from 1, as a task of a cluster does; empty: all
  std::vector<std::string> on_slurm;  ///< where Slurm runs the cases: the command of this study, without where it runs
  int per_task = 0;                   ///< cases of a task of Slurm; 0: as many as take some minutes
};

/// What a Lua callback cost.
struct CallbackTime {
  std::string what;  ///< "on_step at wall.lua:12"
  std::int64_t calls = 0;
  double seconds = 0;
};

/// Where the time of a run goes, where that was asked for.
struct Profile {
  bool wanted = false;
  StepTimes times;
  std::vector<std::string> laws;  ///< names of the contact laws
  std::vector<CallbackTime> callbacks;
};

struct Host {
  std::string script;  ///< path as given; "" in the module
  std::string script_text, command_line;
  std::vector<std::string> given;                 ///< "name=value", from the command line
  bool given_used = false;                        ///< a params call has taken them
  bool list_parameters = false;                   ///< show the parameters and end
  std::vector<results::ParameterRow> parameters;  ///< that the script declared, with their values in this run
  std::vector<std::filesystem::path> records;     ///< folders in which motions are looked for after the script's own
  std::string results_file;                       ///< where given, instead of the script's own; for the first model
  Room room;                                      ///< files that the script may use
  double script_memory = 0;                       ///< that Lua may hold [bytes]; 0: no limit
  double script_seconds = 0;                      ///< of Lua code between two calls into the engine [s]; 0: no limit
  RunObserver* observer = nullptr;
  Console* console = nullptr;  ///< nullptr: nothing pauses
  int running = 0;             ///< stages that run
  int threads = 0;             ///< that may share a step, from the command line; 0: as model or surroundings say
  /// Whether Ctrl-C was pressed and nobody took it. nullptr: under stock lua, see InterruptWatch.
  bool (*interrupted)() = nullptr;
  Profile profile;
  std::vector<std::string> arguments;  ///< `given`, kept whole
  std::filesystem::path case_folder;   ///< "" or where all results go, under the last part of the script's own names
  StudyChoice study;
  std::vector<StudyFigure> figures;                    ///< that the script came to: what it returned
  std::vector<std::shared_ptr<ScriptModel>> recorded;  ///< models that write results; they live until finish()
  /// Of all models that ran, by their titles; they outlive the models.
  std::vector<std::pair<std::string, std::shared_ptr<const Verdict>>> verdicts;

  /// Folder of the script, "." where it has none.
  [[nodiscard]] std::filesystem::path folder() const;
  /// How many threads share a step of a model that asks for `wanted` (0: it does not): those of the command line, else
  /// these, else of the variable TRILITH_THREADS, else as many of the machine's as pay. Throws InputError where the
  /// variable is no such number.
  [[nodiscard]] ThreadChoice threads_for(int wanted) const;
  [[nodiscard]] results::Provenance provenance(const std::vector<std::string>& motions) const;
  /// Completes all results files or, where `error` is not "", leaves them as unfinished, with that reason. Tells the
  /// observer what became of them.
  void finish(const std::string& error);
  /// The same; what became of them comes back, a line for each.
  std::vector<std::string> close(const std::string& error);
  /// A line for each model whose run is not to be trusted.
  [[nodiscard]] std::vector<std::string> untrusted_runs() const;
};

/// Where the project's own ground motions are: beside the program or module that runs, where it was to be installed, or
/// in the source tree it was built from.
std::vector<std::filesystem::path> record_folders();
/// The folder that holds bin/ and lib/ of the program or module that runs; "" where it lies in neither, as in the build
/// tree. A package may be unpacked anywhere.
std::filesystem::path installed_under();

/// Thrown, as a script error, where the script has done what was asked for: a list of cases, or one of them.
inline constexpr const char* script_is_done = "the script has done what it was asked for";
/// Thrown, as a script error, where the parameters were to be listed and now are known.
inline constexpr const char* parameters_listed = "the parameters are listed";

}  // namespace trilith::script
