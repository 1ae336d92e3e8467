// A study: the cases of a plan, each run in a separate process, and one table of their results.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "results/file/results.hpp"
#include "run/study/study_figures.hpp"
#include "run/study/study_plan.hpp"

namespace trilith {

/// An incremental analysis. Cases that differ in the parameter `over` alone are run from its lowest value up. When one
/// of them has the flag `stop`, the higher ones are skipped.
struct StudyRise {
  std::string over, stop;
};

struct StudyOrder {
  StudyPlan plan;
  std::filesystem::path file;           ///< the table; the folders of cases are in `<file without .h5>.cases`
  std::vector<StudyHistory> histories;  ///< figures taken from the cases' results
  /// Program and arguments that run a case and leave its results, and figures_file, in `folder`.
  std::function<std::vector<std::string>(std::size_t index, const std::filesystem::path& folder)> command;
  /// If not empty, runs a case in a forked process instead of a command, from the state in memory. Returns the exit
  /// code.
  std::function<int(std::size_t index, const std::filesystem::path& folder)> run_here;
  /// If not empty, called once before the first case; it may prepare the state that run_here starts from.
  std::function<void()> prepare;
  std::optional<StudyRise> rise;
  std::string source;              ///< scripts and version that determine the result of a case, in addition to its
                                   ///< parameters
  results::Provenance provenance;  ///< for the table
  int jobs = 0;                    ///< cases at a time; 0: number of processors
  bool fresh = false;              ///< run finished cases again
  /// Cases, from 0, that are run without a table, while other tasks of a cluster run other cases. Empty: all.
  std::vector<std::size_t> only;
  /// If not empty, Slurm runs the cases: program and arguments of this study, to which `--cases` is added.
  std::vector<std::string> on_slurm;
  int per_task = 0;  ///< cases of a Slurm task; 0: enough for some minutes
};

/// `passed_over`: a case of lower intensity has already reached the stop criterion.
enum class StudyStatus { not_run, finished, failed, passed_over };
constexpr const char* name_of(StudyStatus s) {
  constexpr const char* names[] = {"not run", "finished", "failed", "passed over"};
  return names[static_cast<int>(s)];
}

struct StudyOutcome {
  StudyStatus status = StudyStatus::not_run;
  bool earlier = false;  ///< finished before this call
  int exit = 0;          ///< exit code of its process; -1 if a signal ended it
  double seconds = 0;    ///< wall clock
  std::string message;   ///< reason of a failure
  std::filesystem::path folder;
  std::vector<StudyFigure> figures;
};

/// Output of the progress of a study. Successful cases appear in the status alone.
struct StudyWatch {
  std::function<void(const std::string& text, bool strong)> line;
  std::function<void(const std::string& text)> status;  ///< one line, updated repeatedly
  std::function<bool()> goes_on;                        ///< false: end now, with the results so far
};

/// Runs the cases that are not finished and writes the table, also after a stop. A case is finished if its process
/// ended with 0 and gave all figures; it remains so while its parameters and `source` are unchanged. A failed case is
/// reported, kept in the table, and run again by the next call. Throws InputError and ResultsError for an invalid
/// order; errors of a case are in its outcome.
std::vector<StudyOutcome> run_study(const StudyOrder& order, const StudyWatch& watch);

/// True if a case has failed.
bool any_failed(const std::vector<StudyOutcome>& outcomes);

/// The folder of a case.
std::filesystem::path case_folder(const StudyOrder& order, std::size_t index);

}  // namespace trilith
