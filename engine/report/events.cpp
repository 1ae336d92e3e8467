// The chain of events in a report: counts, and the tree of causes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/quantity_text.hpp"
#include "model/event/event_list.hpp"
#include "report/sections.hpp"
#include "results/reading/event_tree.hpp"
#include "results/reading/event_units.hpp"

namespace trilith::report {
namespace {

constexpr std::size_t open_lines = 60;    ///< lines of the tree that are open at first
constexpr std::size_t most_lines = 3000;  ///< in total; further impacts are only counted
constexpr int most_depth = 7;             ///< of nested lists

std::string heading_of(const std::string& type) {
  const EventTypeInfo* const known = event_info(type);
  return known == nullptr ? type : std::string(known->heading);
}

void write_counts(const ReportSource& source, HtmlText& html) {
  std::map<std::string, std::vector<const results::EventRow*>> by_type;
  for (const results::EventRow& e : source.events)
    if (!e.type.starts_with("stage.")) by_type[e.type].push_back(&e);
  std::vector<std::vector<std::string>> rows;
  for (const auto& [type, all] : by_type) {
    const results::Figure* most = nullptr;
    for (const results::EventRow* e : all)
      if (!e->first.name.empty() && (most == nullptr || std::abs(e->first.value) > std::abs(most->value)))
        most = &e->first;
    rows.push_back(
        {heading_of(type),
         most == nullptr ? "–" : fmt::format("{} {}", most->name, quantity_text(most->value, most->unit, source.units)),
         fmt::format("{}", all.size()), source.clock(all.front()->time), source.clock(all.back()->time)});
  }
  if (!rows.empty()) html.table({"Event", "Largest", "Count", "First", "Last"}, rows, 2);
}

/// "bonds broken" from "bond broken".
std::string several(const std::string& heading) {
  const std::size_t end = std::min(heading.find(' '), heading.size());
  const std::string first = heading.substr(0, end), rest = heading.substr(end);
  return first.ends_with('y') ? fmt::format("{}ies{}", first.substr(0, end - 1), rest)
                              : fmt::format("{}s{}", first, rest);
}

/// Text of a line; events written by a run contain their numbers in the text.
std::string text_of(const results::EventRow& e, const UnitSystem& units) {
  if (!e.text.empty()) return results::text_in(e, units);
  std::string out = heading_of(e.type);
  for (const std::string& name : {e.body_a_name, e.body_b_name, e.bearing_name})
    if (!name.empty()) out += ", " + name;
  return out;
}

/// Writes trees of rows. Effects are a list within the line of their cause. A single effect is the next line with an
/// arrow, so that a long chain does not move to the right.
class TreeWriter {
 public:
  TreeWriter(const ReportSource& source, const results::EventTree& tree, HtmlText& html)
      : source_(source), tree_(tree), html_(html) {}

  /// `all`: includes the rows that are not shown; otherwise they are folded.
  void list(const std::vector<std::size_t>& rows, bool all, int depth) {
    html_.open("ul");
    siblings(rows, all, depth, "");
    html_.close();
  }

 private:
  void siblings(const std::vector<std::size_t>& rows, bool all, int depth, const char* sign) {
    std::vector<std::size_t> folded;
    for (const std::size_t i : rows) {
      if (all || tree_.shown[i])
        line(i, all, depth, sign);
      else
        folded.push_back(i);
    }
    if (folded.size() == 1 && tree_.effects[folded[0]].empty())
      line(folded[0], all, depth, sign);  // no shorter when folded
    else if (!folded.empty())
      fold(folded, depth);
  }

  void line(std::size_t i, bool all, int depth, const char* sign) {
    const results::EventRow& e = tree_.rows[i];
    html_.open("li", fmt::format(R"(class="{}")", name_of(severity_of(e.type)))).element("time", source_.clock(e.time));
    html_.text(fmt::format(" {}{}", sign, text_of(e, source_.units)));
    const std::vector<std::size_t>& effects = tree_.effects[i];
    if (effects.size() > 1 && depth < most_depth) {
      list(effects, all, depth + 1);
      html_.close();
      return;
    }
    html_.close();
    if (effects.empty()) return;
    siblings(effects, all, depth,
             effects.size() == 1 ? "→ " : fmt::format("(from {}) ", source_.clock(e.time)).c_str());
  }

  void count(std::size_t i, std::map<std::string, std::size_t>& counts, double& last) const {
    ++counts[heading_of(tree_.rows[i].type)];
    last = std::max(last, tree_.rows[i].time);
    for (const std::size_t effect : tree_.effects[i]) count(effect, counts, last);
  }

  void fold(const std::vector<std::size_t>& rows, int depth) {
    std::map<std::string, std::size_t> counts;
    double last = 0;
    for (const std::size_t i : rows) count(i, counts, last);
    std::vector<std::string> parts;
    for (const auto& [what, n] : counts) parts.push_back(fmt::format("{} {}", n, n == 1 ? what : several(what)));
    html_.open("li", R"(class="fold")").open("details");
    html_.element("summary", fmt::format("and {}, {} to {}", fmt::join(parts, ", "),
                                         source_.clock(tree_.rows[rows.front()].time), source_.clock(last)));
    list(rows, true, depth + 1);
    html_.close().close();
  }

  const ReportSource& source_;
  const results::EventTree& tree_;
  HtmlText& html_;
};

/// The rows without stages, and only the fastest impacts up to the limit.
std::vector<results::EventRow> tree_rows(const std::vector<results::EventRow>& of_note, std::size_t& left_out) {
  std::vector<results::EventRow> rows;
  std::vector<double> speeds;
  for (const results::EventRow& e : of_note) {
    if (e.type.starts_with("stage.")) continue;
    rows.push_back(e);
    if (e.type == "impact") speeds.push_back(e.first.value);
  }
  left_out = 0;
  if (rows.size() <= most_lines) return rows;
  left_out = std::min(speeds.size(), rows.size() - most_lines);
  if (left_out == 0) return rows;
  std::sort(speeds.begin(), speeds.end());
  const double least = speeds[left_out - 1];
  const std::size_t before = rows.size();
  std::erase_if(rows, [&](const results::EventRow& e) { return e.type == "impact" && e.first.value <= least; });
  left_out = before - rows.size();
  return rows;
}

}  // namespace

void write_events(const ReportSource& source, HtmlText& html) {
  html.element("h2", "Chain of events");
  std::size_t left_out = 0;
  const results::EventTree tree = results::event_tree(source.events, tree_rows(source.of_note, left_out), open_lines);
  write_counts(source, html);
  if (tree.rows.empty()) {
    html.element("p", "No bearing, seat or bond was lost, and no strong impact occurred.");
    return;
  }
  std::string note =
      "Each event is listed below its cause, or after it with an arrow if it is the only effect. "
      "Contacts "
      "made and lost, bodies at rest and impacts below " +
      fmt::format("{:g} m/s are left out", slow_impact);
  if (left_out > 0) note += fmt::format(", and {} of the slower impacts", left_out);
  html.element("p", note + "; lines that begin with “and” summarise branches that unfold on a screen.",
               R"(class="note")");
  std::map<std::int32_t, std::vector<std::size_t>> by_stage;
  for (const std::size_t i : tree.roots) by_stage[tree.rows[i].stage].push_back(i);
  TreeWriter writer(source, tree, html);
  for (const auto& [stage, roots] : by_stage) {
    if (stage >= 0 && static_cast<std::size_t>(stage) < source.stages.size()) {
      const results::StageRow& row = source.stages[static_cast<std::size_t>(stage)];
      html.element("h3", fmt::format("{}, from {}", row.name, source.clock(row.begin)));
    }
    html.open("div", R"(class="tree")");
    writer.list(roots, false, 0);
    html.close();
  }
}

}  // namespace trilith::report
