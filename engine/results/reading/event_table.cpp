#include "results/reading/event_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace trilith::results {
namespace {

/// Text without the type; events written by a run contain their numbers in the text.
std::string text_beside_type(const EventRow& e) {
  if (!e.text.empty()) return e.text;
  std::string out;
  for (const std::string& name : {e.body_a_name, e.body_b_name, e.bearing_name})
    if (!name.empty()) out += (out.empty() ? "" : ", ") + name;
  return out;
}

}  // namespace

std::string event_table(const std::vector<EventRow>& events, const TimeOrigin& origin) {
  if (events.empty()) return "no events\n";
  std::map<std::int64_t, std::size_t> row;
  for (std::size_t i = 0; i < events.size(); ++i) row[events[i].id] = i;
  std::vector<std::vector<std::size_t>> effects(events.size());
  std::vector<std::pair<std::size_t, std::size_t>> pending;  // row and depth, the next one last
  for (std::size_t i = events.size(); i-- > 0;) {
    const auto cause = row.find(events[i].cause);
    // A cause comes before its effect; a damaged file could contain a cycle.
    if (cause != row.end() && cause->second < i)
      effects[cause->second].push_back(i);
    else
      pending.emplace_back(i, 0);
  }
  std::size_t widest = 0;
  for (const EventRow& e : events) widest = std::max(widest, e.type.size());
  std::string out = origin.since.empty() ? "" : fmt::format("times count{}\n", origin.text());
  out += fmt::format("{:>12}  {:<{}}  {}\n", "time", "event", widest, "what");
  while (!pending.empty()) {
    const auto [i, depth] = pending.back();
    pending.pop_back();
    const EventRow& e = events[i];
    out += fmt::format("{:>10.4f} s  {:<{}}  {:{}}{}\n", e.time - origin.zero, e.type, widest, "", 2 * depth,
                       text_beside_type(e));
    for (const std::size_t effect : effects[i])
      pending.emplace_back(effect, depth + 1);  // latest first, so that it is
                                                // processed last
  }
  return out;
}

}  // namespace trilith::results
