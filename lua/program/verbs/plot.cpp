// trilith plot RESULT [HISTORY ...] [-o FILE]
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "base/error.hpp"
#include "base/terminal_text.hpp"
#include "draw/chart/study_chart.hpp"
#include "draw/results/results_picture.hpp"
#include "program/newer_run.hpp"
#include "program/output_folder.hpp"
#include "program/since_option.hpp"
#include "program/units_option.hpp"
#include "program/verbs.hpp"

namespace trilith::program {
namespace {

struct PlotOptions {
  std::string result, out, over, against, fragility, ida, units;
  std::vector<std::string> more, names;
  draw::PlotWindow window;
  bool list = false, events = false, lines = false;
};

constexpr const char* ledger = "energy";

bool has_history(const results::ResultsReader& reader, const std::string& name) {
  const auto& all = reader.header().histories;
  return std::any_of(all.begin(), all.end(), [&](const results::Quantity& q) { return q.name == name; });
}

void list(const results::ResultsReader& reader) {
  std::size_t widest = std::string(ledger).size();
  for (const results::Quantity& q : reader.header().histories) widest = std::max(widest, q.name.size());
  for (const results::Quantity& q : reader.header().histories)
    fmt::print("{:<{}}  {:<8} {}\n", q.name, widest, q.unit, q.description);
  fmt::print("{:<{}}  {:<8} the energy balance: {} terms\n", ledger, widest, "J", reader.header().energy_terms.size());
}

/// File stems, or whole paths if two stems are equal.
std::vector<std::string> short_names(const std::vector<std::string>& paths) {
  if (paths.size() == 1) return {""};
  std::vector<std::string> stems;
  for (const std::string& p : paths) stems.push_back(std::filesystem::path(p).stem().string());
  return std::set(stems.begin(), stems.end()).size() == stems.size() ? stems : paths;
}

std::vector<draw::Chart> charts_of(const std::vector<draw::NamedResults>& results, const PlotOptions& options) {
  std::vector<std::string> names = options.names;
  const auto wants_ledger = std::find(names.begin(), names.end(), ledger);
  if (!options.against.empty() && wants_ledger != names.end())
    throw InputError("--against is for histories; the energy is drawn over time");
  const bool energy = (wants_ledger != names.end() && !has_history(*results[0].reader, ledger)) ||
                      (names.empty() && results[0].reader->header().histories.empty());
  if (energy && wants_ledger != names.end()) names.erase(wants_ledger);
  std::vector<draw::Chart> charts;
  if (!names.empty() || !energy) charts.push_back(draw::history_chart(results, names, options.window, options.against));
  for (const draw::NamedResults& r : results)
    if (energy)
      charts.push_back(draw::results_energy_chart(
          r, options.lines ? draw::EnergyView::lines : draw::EnergyView::stacked, options.window));
  if (results.size() == 1 && charts.size() == 2) {  // one time axis, one set of marks
    charts[0].panels.push_back(std::move(charts[1].panels[0]));
    charts.pop_back();
  }
  return charts;
}

/// The parameter of the intensity: the given one, otherwise the only numeric one that varies.
std::string intensity_of(const PlotOptions& options, const std::vector<results::StudyColumn>& columns) {
  if (!options.over.empty()) return options.over;
  throw InputError(
      fmt::format("give the parameter: --over {}", fmt::join(results::study_names(columns).parameters, " or ")));
}

draw::Chart chart_of_study(const PlotOptions& options, const std::vector<results::StudyColumn>& columns) {
  if (!options.ida.empty())
    return draw::ida_chart(columns, options.ida, intensity_of(options, columns), options.fragility);
  if (options.fragility.empty()) return draw::study_chart(columns, options.over, options.names);
  const results::StudyFragility f =
      results::study_fragility(columns, options.fragility, intensity_of(options, columns));
  fmt::print("{}\n", terminal_text(fmt::format("{} over {}: {}", options.fragility, f.intensity, fragility_text(f))));
  return draw::fragility_chart(f, options.fragility);
}

/// Plots the table of a study.
int plot_study(const PlotOptions& options, const std::filesystem::path& out) {
  const std::vector<results::StudyColumn> columns = results::read_study_table(options.result);
  if (options.list) {
    const results::StudyNames names = results::study_names(columns);
    fmt::print("over: {}\nfigures: {}\n", fmt::join(names.parameters, ", "), fmt::join(names.figures, ", "));
    return ended_well;
  }
  if (!options.against.empty())
    throw InputError("--against is for a run; figures of a study are drawn --over a parameter");
  if (!options.units.empty()) throw InputError("--units is for a run; figures of a study are in their own units");
  draw::Chart chart = chart_of_study(options, columns);
  chart.title = std::filesystem::path(options.result).stem().string();
  make_folder_for(out);
  draw::draw_chart(chart, out);
  fmt::print("{}\n", out.string());
  return ended_well;
}

int plot(const PlotOptions& options) {
  const std::filesystem::path out = options.out.empty()
                                        ? std::filesystem::path(options.result).replace_extension(".plot.png")
                                        : std::filesystem::path(options.out);
  draw::picture_format(out);
  if (results::is_study_table(options.result)) return plot_study(options, out);
  if (!options.fragility.empty() || !options.ida.empty())
    throw InputError("--fragility and --ida are for the table of a study; this file is a run");
  if (!options.over.empty())
    throw InputError("--over is for the table of a study; this file is a run, drawn over time");
  std::vector<std::string> paths{options.result};
  paths.insert(paths.end(), options.more.begin(), options.more.end());
  std::vector<results::ResultsReader> readers;
  for (const std::string& path : paths) readers.emplace_back(path);
  if (options.list) {
    list(readers[0]);
    return ended_well;
  }
  const std::vector<std::string> names = short_names(paths);
  std::vector<draw::NamedResults> results;
  for (std::size_t i = 0; i < readers.size(); ++i) results.push_back({&readers[i], names[i]});
  std::vector<draw::Chart> charts = charts_of(results, options);
  for (draw::Chart& chart : charts) chart.units = shown_units(options.units, readers[0]);
  if (charts[0].title.empty() && results.size() == 1) charts[0].title = readers[0].title();
  if (options.events && !options.against.empty()) throw InputError("--events needs a time axis, not --against");
  if (options.events)
    for (draw::Chart& chart : charts) chart.marks = draw::event_marks(readers[0], options.window, chart.units);
  make_folder_for(out);
  draw::draw_charts(charts, draw::Arrangement::below, out);
  fmt::print("{}\n", out.string());
  for (const results::ResultsReader& reader : readers) tell_of_newer_run(reader);
  return ended_well;
}

}  // namespace

void add_plot(CLI::App& app, int& code) {
  auto o = std::make_shared<PlotOptions>();
  CLI::App* verb = app.add_subcommand(
      "plot", "Plot histories or the energy of one or more runs over time, or figures of a study over a parameter");
  verb->add_option("result", o->result, "results file, or table of a study")->required()->type_name("RESULT");
  verb->add_option("histories", o->names,
                   "names of histories, or 'energy' for the energy balance; of a study, its figures; default all")
      ->type_name("HISTORY");
  verb->add_option("-r,--result", o->more, "another results file, drawn over the first; can be repeated")
      ->type_name("RESULT")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  verb->add_option("-o,--output", o->out, "picture, .svg, .pdf or .png; default RESULT with .plot.png")
      ->type_name("FILE");
  verb->add_option("--over", o->over, "parameter of a study; default the first that takes several values")
      ->type_name("PARAMETER");
  verb->add_option(
          "--fragility", o->fragility,
          "of a study: lognormal fragility curve of a condition, as in collapsed or \"drift > 0.02\", over --over")
      ->type_name("CONDITION");
  verb->add_option("--ida", o->ida,
                   "of a study: --over drawn over this figure, a line for each record; with --fragility the lines end "
                   "where the condition holds")
      ->type_name("FIGURE");
  verb->add_option("--against", o->against, "draw over this history instead of over time: loops, capacity curves")
      ->type_name("HISTORY");
  verb->add_option("--stage", o->window.stage, "only this stage, with time counted from its beginning")
      ->type_name("NAME");
  add_since(*verb, o->window.since);
  verb->add_option("--from", o->window.from, "start of the drawn time [s]")->type_name("T");
  verb->add_option("--to", o->window.to, "end of the drawn time [s]")->type_name("T");
  add_units(*verb, o->units);
  verb->add_flag("--events", o->events, "mark stages and events of the first run");
  verb->add_flag("--lines", o->lines, "terms of the energy as lines, not stacked");
  verb->add_flag("--list", o->list, "list the histories and exit");
  verb->callback([o, &code] { code = plot(*o); });
}

}  // namespace trilith::program
