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
#include "command_line.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

int run_program(int argc, char** argv) {
  int code = ended_well;
  CLI::App app;
  try {
    describe_command_line(app, code);
    std::vector<std::string> words = words_with_verb(app, {argv + 1, argv + argc});
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

/// Opens closed standard streams to /dev/null, so that no file takes their descriptors and receives printed text.
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
