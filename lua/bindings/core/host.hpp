// Environment of a script: command line, folders, listeners. No Lua here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assembly/step_times.hpp"
#include "base/unit_system.hpp"
#include "bindings/core/room.hpp"
#include "bindings/restart/restart_files.hpp"
#include "model/verdict.hpp"
#include "results/file/results.hpp"
#include "run/stage.hpp"
#include "run/step_window.hpp"
#include "run/study/study.hpp"
#include "run/thread_choice.hpp"

struct lua_State;

namespace trilith::script {

class ScriptModel;

// Default limits of a script in a sandbox.
inline constexpr double default_script_memory = 4.0 * (std::uint64_t{1} << 30);  ///< [bytes]
inline constexpr double default_script_seconds = 600;                            ///< [s]

inline constexpr std::size_t largest_script = std::size_t{64} << 20;  ///< [bytes]; larger files are rejected

/// Observer that displays a run.
class RunObserver {
 public:
  RunObserver() = default;
  RunObserver(const RunObserver&) = delete;
  RunObserver& operator=(const RunObserver&) = delete;
  virtual ~RunObserver() = default;
  virtual void note(const std::string& text) = 0;
  virtual void event(const Event& event, const Instant<2>& now) = 0;
  virtual void event(const Event& event, const Instant<3>& now) = 0;
  virtual void step(const Instant<2>& now) = 0;  ///< called after every step: must be fast
  virtual void step(const Instant<3>& now) = 0;
  virtual void stage_ended(const StageReport& report) = 0;
  /// Called before other output is written to the display.
  virtual void clear() = 0;
  /// Texts show numbers in these units from now on.
  virtual void show_in(const UnitSystem& units) = 0;
  // Progress of a study: lines, and a status that is updated repeatedly.
  virtual void line(const std::string& text, bool strong) = 0;
  virtual void status(const std::string& text) = 0;
};

/// Console that opens when a run pauses.
class Console {
 public:
  Console() = default;
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;
  virtual ~Console() = default;
  /// True if the user has requested a pause; clears the request.
  virtual bool was_interrupted() = 0;
  /// Opens the console; returns when the run continues. The handle of the paused model, or nil, is on top of the stack,
  /// and is removed. May throw ScriptError.
  virtual void open(lua_State* L, const std::string& why) = 0;
};

/// Options of the command line for a script's study.
struct StudyChoice {
  std::string program;                ///< program that runs the cases; "": none, so that no study can start
  int jobs = 0;                       ///< cases at a time; 0: from the script
  int only = 0;                       ///< run only this case, in this process; 0: run the study
  bool fresh = false;                 ///< run finished cases again
  bool list = false;                  ///< list the cases and end
  bool begun = false;                 ///< the script has called trilith.study
  bool failed = false;                ///< a case of it has failed
  std::optional<StudyRise> rise;      ///< an incremental analysis; none: from the script
  std::vector<int> some;              ///< run only these cases, from 1, as a task of a cluster; empty: all
  std::vector<std::string> on_slurm;  ///< for Slurm: the command of this study, without the options of where it runs
  double checkpoint = -1;             ///< wall clock between checkpoints of a case [s]; below 0: default
  int per_task = 0;                   ///< cases of a Slurm task; 0: enough for some minutes
};

/// Run time of a Lua callback.
struct CallbackTime {
  std::string what;  ///< "on_step at wall.lua:12"
  std::int64_t calls = 0;
  double seconds = 0;
};

/// Run times of the parts of a run, if requested.
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
  std::vector<results::ParameterRow> parameters;  ///< declared by the script, with their values in this run
  UnitSystem units;                               ///< of the script's models; results are shown in them
  std::vector<std::filesystem::path> records;     ///< folders searched for motions after the script's own
  std::string results_file;                       ///< if given, used instead of the script's own; for the first model
  Room room;                                      ///< files that the script may use
  double script_memory = 0;                       ///< limit of Lua memory [bytes]; 0: no limit
  double script_seconds = 0;                      ///< limit of Lua code between two calls into the engine [s]; 0: no
                                                  ///< limit
  RestartChoice restart;                          ///< checkpoints of runs
  bool silent = false;                            ///< output of the script was printed before
  RunObserver* observer = nullptr;
  Console* console = nullptr;  ///< nullptr: no pauses
  int running = 0;             ///< number of running stages
  int threads = 0;             ///< threads that may share a step, from the command line; 0: from the model or the
                               ///< environment
  /// True if Ctrl-C was pressed and is not yet handled. nullptr: under stock lua, see InterruptWatch.
  bool (*interrupted)() = nullptr;
  Profile profile;
  std::vector<std::string> arguments;  ///< copy of `given`
  std::filesystem::path case_folder;   ///< "", or the folder of all results, under the last part of the script's own
                                       ///< names
  StudyChoice study;
  std::vector<StudyFigure> figures;                    ///< figures that the script returned
  std::vector<std::shared_ptr<ScriptModel>> recorded;  ///< models that write results; they live until finish()
  /// Verdicts of all models that ran, by title; they outlive the models.
  std::vector<std::pair<std::string, std::shared_ptr<const Verdict>>> verdicts;
  std::optional<StepWindow> check_step;  ///< repeat this window with half the step

  /// Folder of the script, "." if it has none.
  [[nodiscard]] std::filesystem::path folder() const;
  /// Number of threads that share a step of a model that requests `wanted` (0: no request). The command line takes
  /// precedence, then this request, then the variable TRILITH_THREADS, then an automatic choice. Throws InputError if
  /// the variable is not a valid number.
  [[nodiscard]] ThreadChoice threads_for(int wanted) const;
  [[nodiscard]] results::Provenance provenance(const std::vector<std::string>& motions) const;
  /// Completes all results files or, unless `error` is "", leaves them unfinished, with that reason. Reports the
  /// results to the observer.
  void finish(const std::string& error);
  /// As above; returns one line of text for each file.
  std::vector<std::string> close(const std::string& error);
  /// One line for each model whose run is not reliable.
  [[nodiscard]] std::vector<std::string> untrusted_runs() const;
};

/// Folders of the project's own ground motions: next to the running program or module, at its installation path, or in
/// its source tree.
std::vector<std::filesystem::path> record_folders();
/// The folder that contains bin/ and lib/ of the running program or module; "" if it lies in neither, as in the build
/// tree. A package may be unpacked anywhere.
std::filesystem::path installed_under();

/// Thrown, as a script error, when the script has completed the request: a list of cases, or one of them.
inline constexpr const char* script_is_done = "the script has finished its task";
/// Thrown, as a script error, when the parameters to be listed are known.
inline constexpr const char* parameters_listed = "the parameters are listed";

}  // namespace trilith::script
