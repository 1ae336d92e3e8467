// The verbs of the program: each adds itself to the command line, in a separate file.
#pragma once

#include <CLI/CLI.hpp>

namespace trilith::program {

/// Exit codes of the program.
enum ExitCode : int {
  ended_well = 0,
  wrong_input = 1,
  wrong_usage = 2,
  not_trusted = 3,  ///< a run has a verdict (model/verdict.hpp) or its model has no solution (base/no_solution.hpp)
  interrupted = 130
};

/// A verb sets `code` after it has run.
void add_console(CLI::App& app, int& code);
void add_run(CLI::App& app, int& code);
void add_resume(CLI::App& app, int& code);
void add_study(CLI::App& app, int& code);
void add_verify(CLI::App& app, int& code);
void add_draw(CLI::App& app, int& code);
void add_movie(CLI::App& app, int& code);
void add_new(CLI::App& app, int& code);
void add_plot(CLI::App& app, int& code);
void add_manual(CLI::App& app, int& code);
void add_motion(CLI::App& app, int& code);
void add_info(CLI::App& app, int& code);
void add_view(CLI::App& app, int& code);
void add_live(CLI::App& app, int& code);
void add_report(CLI::App& app, int& code);
void add_export(CLI::App& app, int& code);
void add_repair(CLI::App& app, int& code);
void add_doctor(CLI::App& app, int& code);
void add_completion(CLI::App& app, int& code);

}  // namespace trilith::program
