// A study: the cases of a plan, each run in a process of its own, and what they came to in one table.
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

/// An incremental analysis: cases that differ in parameter `over` alone are run from its lowest value up, and once one
/// of them gives the flag `stop` as true, those above it are passed over.
struct StudyRise {
  std::string over, stop;
};

struct StudyOrder {
  StudyPlan plan;
  std::filesystem::path file;           ///< the table; the cases' folders are in `<file without .h5>.cases`
  std::vector<StudyHistory> histories;  ///< figures taken from the cases' results
  /// Program and arguments that run a case and leave its results, and figures_file, in `folder`.
  std::function<std::vector<std::string>(std::size_t index, const std::filesystem::path& folder)> command;
  /// Where not empty, a case is run by this in a process that has parted from the present one, instead of by a command:
  /// it goes on from whatever state is in memory. Gives the exit code.
  std::function<int(std::size_t index, const std::filesystem::path& folder)> run_here;
  /// Called once before the first case that is run, where there is one: it may make the state that run_here goes on
  /// from.
  std::function<void()> prepare;
  std::optional<StudyRise> rise;
  std::string source;              ///< what decides, with its parameters, what a case comes to: scripts and version
  results::Provenance provenance;  ///< for the table
  int jobs = 0;                    ///< cases at a time; 0: as many as there are processors
  bool fresh = false;              ///< run also those again that are finished
  /// Cases, from 0, that are run alone, without a table, while others may run others: a task of a cluster. Empty: all.
  std::vector<std::size_t> only;
  /// Where not empty, the cases are run by Slurm: program and arguments of this study, to which `--cases` is added.
  std::vector<std::string> on_slurm;
  int per_task = 0;  ///< cases of a task of Slurm; 0: as many as take some minutes
};

/// `passed_over`: a case of lower intensity has already given what the study rises to.
enum class StudyStatus { not_run, finished, failed, passed_over };
constexpr const char* name_of(StudyStatus s) {
  constexpr const char* names[] = {"not run", "finished", "failed", "passed over"};
  return names[static_cast<int>(s)];
}

struct StudyOutcome {
  StudyStatus status = StudyStatus::not_run;
  bool earlier = false;  ///< finished before this call
  int exit = 0;          ///< exit code of its process; -1 where a signal ended it
  double seconds = 0;    ///< wall clock
  std::string message;   ///< why it failed
  std::filesystem::path folder;
  std::vector<StudyFigure> figures;
};

/// Who is told how a study goes on. Cases that finish well are in the status alone.
struct StudyWatch {
  std::function<void(const std::string& text, bool strong)> line;
  std::function<void(const std::string& text)> status;  ///< one line, told again and again
  std::function<bool()> goes_on;                        ///< false: end now, with what there is
};

/// Runs the cases that are not finished, and writes the table, also where it was stopped. A case is finished where its
/// process ended with 0 and gave all figures; it stays so as long as its parameters and `source` stay the same. One
/// that failed is told, kept in the table, and run again by the next call. Throws InputError and ResultsError for an
/// order that cannot be carried out; a case's own trouble is in its outcome.
std::vector<StudyOutcome> run_study(const StudyOrder& order, const StudyWatch& watch);

/// Whether a case has failed.
bool any_failed(const std::vector<StudyOutcome>& outcomes);

/// The folder of a case.
std::filesystem::path case_folder(const StudyOrder& order, std::size_t index);

}  // namespace trilith
