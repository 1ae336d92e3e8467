// The program: a thin layer over the engine and its bindings.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "base/terminal_text.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

int run_program(int argc, char** argv) {
  CLI::App app{"Structures of separate bodies, through an earthquake to the last stone", "trilith"};
  app.set_version_flag("--version", "trilith " TRILITH_VERSION);
  app.footer(
      "trilith alone opens a console; trilith -i SCRIPT runs a script and stays.\n"
      "Exit codes: 0 all went well, 1 wrong input or an error in a script, 2 wrong words on the command line,\n"
      "3 a run that is not to be trusted (it says why), 130 interrupted.");
  app.require_subcommand(1);
  int code = ended_well;
  try {
    add_console(app, code);
    add_run(app, code);
    add_study(app, code);
    add_draw(app, code);
    add_plot(app, code);
    add_view(app, code);
    add_report(app, code);
    add_motion(app, code);
    add_manual(app, code);
    add_info(app, code);
    add_repair(app, code);
    std::vector<std::string> words(argv + 1, argv + argc);
    // Alone, or with -i, it opens the console.
    if (words.empty()) words = {"console"};
    if (words[0] == "-i" || words[0] == "--interactive") words[0] = "console";
    std::reverse(words.begin(), words.end());
    app.parse(words);
  } catch (const CLI::Success& e) {
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    app.exit(e);
    return wrong_usage;
  }
  return code;
}

/// Opens what of the standard streams is closed to /dev/null, so that no file takes its place: what is printed would
/// go into it.
void keep_standard_descriptors() {
  for (int wanted = STDIN_FILENO; wanted <= STDERR_FILENO; ++wanted)
    if (::fcntl(wanted, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) < 0) std::_Exit(wrong_input);
}

}  // namespace
}  // namespace trilith::program

int main(int argc, char** argv) {
  trilith::program::keep_standard_descriptors();
  try {
    return trilith::program::run_program(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "trilith: %s\n", trilith::terminal_text(e.what()).c_str());
    return trilith::program::wrong_input;
  }
}
