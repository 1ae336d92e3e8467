// trilith info RESULT [--events]
#include <fmt/format.h>

#include <memory>

#include "base/terminal_text.hpp"
#include "draw/results_picture.hpp"
#include "newer_run.hpp"
#include "results/event_table.hpp"
#include "results/info.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

struct InfoOptions {
  std::string result;
  bool events = false, of_note = false;
};

int show_info(const InfoOptions& options) {
  const results::ResultsReader reader(options.result);
  if (!options.events && !options.of_note) {
    fmt::print("{}", terminal_text(results::info_text(reader)));
    return ended_well;
  }
  tell_of_newer_run(reader);
  fmt::print("{}",
             terminal_text(results::event_table(options.of_note ? draw::events_of_note(reader) : reader.events())));
  return ended_well;
}

}  // namespace

void add_info(CLI::App& app, int& code) {
  auto o = std::make_shared<InfoOptions>();
  CLI::App* verb = app.add_subcommand("info", "Tell what a results file holds, finished or not");
  verb->add_option("result", o->result, "results file")->required()->type_name("RESULT");
  verb->add_flag("--events", o->events, "all events, each below the one that led to it");
  verb->add_flag("--of-note", o->of_note, "the same without contacts made and lost and bodies at rest");
  verb->callback([o, &code] { code = show_info(*o); });
}

}  // namespace trilith::program
