// The program: a thin layer over the engine and its door.
#include <exception>

#include <fmt/format.h>

#include "verbs.hpp"

int main(int argc, char** argv) {
  using namespace trilith::program;
  CLI::App app{"Structures of separate bodies, through an earthquake to the last stone", "trilith"};
  app.set_version_flag("--version", "trilith " TRILITH_VERSION);
  app.require_subcommand(1);
  int code = ended_well;
  try {
    add_run(app, code);
    add_draw(app, code);
    add_plot(app, code);
    add_motion(app, code);
    add_info(app, code);
    add_repair(app, code);
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    app.exit(e);
    return wrong_usage;
  } catch (const std::exception& e) {
    fmt::print(stderr, "trilith: {}\n", e.what());
    return wrong_input;
  }
  return code;
}
