// trilith info RESULT [--events]
#include <fmt/format.h>

#include <memory>

#include "base/error.hpp"
#include "base/terminal_text.hpp"
#include "draw/results/results_picture.hpp"
#include "program/newer_run.hpp"
#include "program/since_option.hpp"
#include "program/units_option.hpp"
#include "program/verbs.hpp"
#include "results/reading/event_table.hpp"
#include "results/reading/event_units.hpp"
#include "results/reading/info.hpp"
#include "results/study/study_info.hpp"

namespace trilith::program {
namespace {

struct InfoOptions {
  std::string result, probability, over, since, units;
  bool events = false, of_note = false;
};

/// Prints the table of a study.
int show_study(const InfoOptions& options) {
  const std::vector<results::StudyColumn> columns = results::read_study_table(options.result);
  const std::string text = options.probability.empty()
                               ? results::study_info_text(columns)
                               : results::study_probability_text(columns, options.probability, options.over);
  fmt::print("{}", terminal_text(text));
  return ended_well;
}

int show_info(const InfoOptions& options) {
  if (results::is_study_table(options.result)) return show_study(options);
  if (!options.probability.empty() || !options.over.empty())
    throw InputError("--probability and --over are for the table of a study; this file is a run");
  const results::ResultsReader reader(options.result);
  const UnitSystem units = shown_units(options.units, reader);
  if (!options.events && !options.of_note) {
    if (!options.since.empty()) throw InputError("--since is for times of events; use it with --events or --of-note");
    fmt::print("{}", terminal_text(results::info_text(reader, units)));
    return ended_well;
  }
  tell_of_newer_run(reader);
  std::vector<results::EventRow> events = options.of_note ? draw::events_of_note(reader) : reader.events();
  for (results::EventRow& e : events) e.text = results::text_in(e, units);
  fmt::print("{}",
             terminal_text(units.message(results::event_table(events, results::time_origin(reader, options.since)))));
  return ended_well;
}

}  // namespace

void add_info(CLI::App& app, int& code) {
  auto o = std::make_shared<InfoOptions>();
  CLI::App* verb = app.add_subcommand("info", "Summarise a results file, finished or not, or the table of a study");
  verb->add_option("result", o->result, "results file, or table of a study")->required()->type_name("RESULT");
  verb->add_flag("--events", o->events, "all events, each below its cause");
  verb->add_flag("--of-note", o->of_note, "the same without contacts made and lost and bodies at rest");
  add_since(*verb, o->since);
  add_units(*verb, o->units);
  verb->add_option(
          "--probability", o->probability,
          "of a study: how many cases meet this condition, as in collapsed or \"drift > 0.02\", with an interval")
      ->type_name("CONDITION");
  verb->add_option("--over", o->over, "with --probability: for each value of this parameter")->type_name("PARAMETER");
  verb->callback([o, &code] { code = show_info(*o); });
}

}  // namespace trilith::program
