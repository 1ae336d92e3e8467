#include "results/reading/info.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/quantity_text.hpp"
#include "results/reading/largest_value.hpp"
#include "results/reading/verdict.hpp"

namespace trilith::results {
namespace {

// "3 rigid, 2 beam": counts of each word, in alphabetical order.
template <class Row, class Word>
std::string tally(const std::vector<Row>& rows, Word word) {
  std::map<std::string, int> counts;
  for (const Row& row : rows) ++counts[word(row)];
  std::vector<std::string> parts;
  for (const auto& [name, count] : counts)
    parts.push_back(fmt::format("{} {}", count, name.empty() ? "unnamed" : name));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string line(const char* label, const std::string& text) {
  return text.empty() ? "" : fmt::format("  {:<12}{}\n", label, text);
}

std::string state(const ResultsReader& reader) {
  const std::string path = reader.path().string();
  if (reader.running()) return fmt::format("{}: a run is writing it; this is its content up to its last flush\n", path);
  if (!reader.finished())
    return fmt::format("{}: NOT finished, the run stopped early; this is its content up to its last flush\n", path);
  std::string text = fmt::format("{}: finished\n", path);
  const std::string newer = newer_run_text(reader);
  return newer.empty() ? text : fmt::format("{}  {}\n", text, newer);
}

std::string verdict(const Verdict& found) {
  std::string text = found.sound() ? "" : fmt::format("  {}\n", found.text());
  if (found.left() > 0) text += fmt::format("  bodies that left the bounds: {}\n", found.left());
  return text;
}

std::string provenance(const Provenance& from) {
  const std::string commit = from.git_commit.empty() ? "" : fmt::format(" ({})", from.git_commit);
  std::string text = line("started", from.start_time);
  text +=
      line("program", from.program_version.empty() ? "" : fmt::format("trilith {}{}", from.program_version, commit));
  text += line("built with", from.compiler);
  text += line("platform", from.platform);
  text += line("units", from.units.empty() ? "" : fmt::format("{} in the script; this file is in SI", from.units));
  text += line("command", from.command_line);
  if (!from.script.empty()) {
    const auto lines = std::count(from.script.begin(), from.script.end(), '\n') + (from.script.back() == '\n' ? 0 : 1);
    text += line("script", fmt::format("{}, {} lines", from.script_path, lines));
  }
  for (const ParameterRow& row : from.parameters)
    text +=
        line("parameter", fmt::format("{} = {}{}{} (default {}){}{}", row.name, row.value, row.unit.empty() ? "" : " ",
                                      row.unit, row.fallback, row.text.empty() ? "" : ": ", row.text));
  for (const std::string& motion : from.motions) text += line("motion", motion);
  return text;
}

std::string model(const Header& header) {
  const double mass = std::accumulate(header.node_mass.begin(), header.node_mass.end(), 0.0);
  std::string text = fmt::format("model in {} dimensions\n", header.dim);
  text += line("bodies", fmt::format("{}: {}; {}", header.bodies.size(),
                                     tally(header.bodies, [](const BodyRow& body) { return body.kind; }),
                                     tally(header.bodies, [](const BodyRow& body) { return body.support; })));
  if (header.face_count() > 0)
    text += line("faces", fmt::format("{}, of {} corners", header.face_count(), header.vertex_node.size()));
  if (!header.sphere_vertex.empty()) text += line("spheres", fmt::format("{}", header.sphere_vertex.size()));
  text += line("mass", fmt::format("{:.6g} kg", mass));
  if (!header.bearings.empty()) text += line("bearings", fmt::format("{}", header.bearings.size()));
  if (!header.laws.empty()) text += line("laws", tally(header.laws, [](const LawRow& law) { return law.role; }));
  return text;
}

std::string stages(const std::vector<StageRow>& rows) {
  std::string text = rows.empty() ? "" : "stages\n";
  for (const StageRow& row : rows) {
    const std::string kind = row.kind.empty() ? "" : fmt::format(" ({})", row.kind);
    if (row.ended)
      text += fmt::format("  {}{}: {:g} s to {:g} s, {:g} s long; ended: {}\n", row.name, kind, row.begin, row.end,
                          row.end - row.begin, row.why.empty() ? "no reason given" : row.why);
    else
      text += fmt::format("  {}{}: from {:g} s, not ended\n", row.name, kind, row.begin);
  }
  return text;
}

std::string span_of(const std::vector<double>& times) {
  return times.empty() ? "" : fmt::format(", {:g} s to {:g} s", times.front(), times.back());
}

/// Number of modes, and the frequencies of the modes found last.
std::string modes(const std::vector<ModeRow>& rows) {
  if (rows.empty()) return "";
  std::string text = line("modes", fmt::format("{}, the last ones computed at {:g} s", rows.size(), rows.back().time));
  for (const ModeRow& row : rows)
    if (row.analysis == rows.back().analysis)
      text += fmt::format("    {}: {:.5g} Hz, damping {:.3g} %\n", row.number, row.frequency, 100 * row.damping);
  return text;
}

std::string records(const ResultsReader& reader, const UnitSystem& units) {
  std::string text = "records\n";
  text += line("frames", fmt::format("{}{}", reader.frame_count(), span_of(reader.frame_times())));
  const std::vector<double> times = reader.history_times();
  text += line("histories",
               fmt::format("{} of {} samples{}", reader.header().histories.size(), times.size(), span_of(times)));
  for (const Quantity& quantity : reader.header().histories)
    text += fmt::format("    {} [{}]{}{}\n", quantity.name, units.name(quantity.unit),
                        quantity.description.empty() ? "" : ": ", quantity.description);
  return text + modes(reader.modes());
}

std::string events(const std::vector<EventRow>& rows) {
  std::string text = fmt::format("events: {}\n", rows.size());
  std::map<std::string, std::vector<double>> by_type;
  for (const EventRow& row : rows) by_type[row.type].push_back(row.time);
  for (const auto& [type, times] : by_type)
    text +=
        fmt::format("  {:>6} {}, first at {:g} s, last at {:g} s\n", times.size(), type, times.front(), times.back());
  return text;
}

std::string energy(const EnergyTable& table, const std::vector<Quantity>& terms) {
  if (table.time.empty()) return "";
  std::string text = fmt::format("energy at {:g} s\n", table.time.back());
  double most = 0;
  for (const std::vector<double>& term : table.terms) most = std::max(most, largest_value(term));
  const auto row = [most](std::string_view name, double value) {
    return fmt::format("  {:<18}{:>14.6g} J\n", name, std::abs(value) < 1e-12 * most ? 0 : value);  // rounding noise
  };
  for (std::size_t i = 0; i < terms.size(); ++i) text += row(terms[i].name, table.terms[i].back());
  const double residual = largest_value(table.residual);
  text += row("residual", table.residual.back());
  text += fmt::format("  largest residual {:.3g} J", residual);
  if (most > 0) text += fmt::format(", {} of the largest term", percent_text(residual / most));
  return text + "\n";
}

std::string seal(const std::vector<SealRow>& rows) {
  std::string text = rows.empty() ? "" : "seal\n";
  for (const SealRow& row : rows) text += fmt::format("  {:<9}{}\n", row.state, seal_text(row));
  return text;
}

std::string notes(const std::vector<Note>& rows) {
  std::string text = rows.empty() ? "" : "notes\n";
  for (const Note& row : rows) text += fmt::format("  {:g} s: {}\n", row.time, row.text);
  return text;
}

}  // namespace

std::string newer_run_text(const ResultsReader& reader) {
  if (!reader.finished() || !reader.newer_part()) return "";
  const std::string path = reader.path().string();
  return fmt::format("these are the results of an earlier run; a later run {} {}.part",
                     reader.newer_part_running() ? "is writing" : "stopped early and left", path);
}

std::string info_text(const ResultsReader& reader, const UnitSystem& units) {
  const Header& header = reader.header();
  return state(reader) + units.message(verdict(results_verdict(reader, reader.events())) + seal(reader.seal())) +
         provenance(header.provenance) + units.message(model(header)) + stages(reader.stages()) +
         records(reader, units) + events(reader.events()) +
         units.message(energy(reader.energy(), header.energy_terms) + notes(reader.notes()));
}

}  // namespace trilith::results
