// A Lua state for one script: libraries, module, strict globals, interrupt.
#pragma once

#include <string>

#include "bindings/core/host.hpp"

namespace trilith::program {

/// Runs host.script to its end. Returns the program's exit code; messages go to stderr.
int run_script(script::Host& host);

/// If a signal ends the program: leaves the results unfinished, reports the reason and the kept files, and returns the
/// exit code.
int close_by_signal(script::Host& host);
/// As above, and ends the program.
[[noreturn]] void end_by_signal(script::Host& host);

/// This program's file.
std::string program_path();

}  // namespace trilith::program
