// Options of `trilith run` and `trilith resume`.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "bindings/restart/restart_files.hpp"
#include "program/live.hpp"
#include "program/script/room_options.hpp"

namespace trilith::program {

/// Default wall clock between checkpoints [s]. Shorter runs have none.
inline constexpr double usual_checkpoint = 60;

struct RunOptions {
  std::string script, results, folder, since;
  std::vector<std::string> given;
  EventShow events = EventShow::important;
  double least_impact = slow_impact;
  bool quiet = false, list = false, profile = false;
  int only = 0, threads = 0;
  std::string check_step;                ///< "": no; "true": the usual window; or "FROM,TO" [s]
  double checkpoint = usual_checkpoint;  ///< [s]; 0: none
  bool resumes = false;                  ///< continue from the checkpoints
  bool goes_on = false;                  ///< ... in the case's folder, if they belong to this run
  RoomOptions room;
};

/// Runs the script; gives the exit code.
int run_as_asked(const RunOptions& options);

/// Throws InputError if the program or the script differs from `call`, and names the difference.
void require_same(const script::RestartCall& call);

/// Adds --checkpoint; `usual` describes the default.
void add_checkpoint_option(CLI::App& verb, double& seconds, const std::string& usual);

}  // namespace trilith::program
