#include "results/reading/event_tree.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "model/event/event_list.hpp"

namespace trilith::results {
namespace {

using RowOf = std::map<std::int64_t, std::size_t>;

RowOf rows_by_id(const std::vector<EventRow>& events) {
  RowOf out;
  for (std::size_t i = 0; i < events.size(); ++i) out[events[i].id] = i;
  return out;
}

/// Row in `chosen` of the nearest present cause, or -1. A cause comes before its effect; a damaged file could contain a
/// cycle.
std::ptrdiff_t nearest_cause(const std::vector<EventRow>& all, const RowOf& in_all, const RowOf& in_chosen,
                             const EventRow& event) {
  const EventRow* at = &event;
  while (at->cause >= 0 && at->cause < at->id) {
    if (const auto found = in_chosen.find(at->cause); found != in_chosen.end())
      return static_cast<std::ptrdiff_t>(found->second);
    const auto next = in_all.find(at->cause);
    if (next == in_all.end()) return -1;
    at = &all[next->second];
  }
  return -1;
}

/// 0 for failures of the structure; the last rank for their consequences.
int rank_of(const EventRow& event, bool first_failure) {
  if (first_failure || severity_of(event.type) == Severity::loss) return 0;
  return event.type == "impact" ? 2 : 1;
}

void choose(EventTree& tree, const std::vector<std::ptrdiff_t>& cause, std::size_t room) {
  std::vector<std::size_t> order(tree.rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto first = std::find_if(tree.rows.begin(), tree.rows.end(), is_failure) - tree.rows.begin();
  const auto key = [&](std::size_t i) {
    const EventRow& e = tree.rows[i];
    const double speed = e.type == "impact" ? e.first.value : 0;
    const auto led_to = e.type == "impact" ? 0 : -static_cast<std::ptrdiff_t>(tree.offspring[i]);
    return std::tuple(rank_of(e, static_cast<std::ptrdiff_t>(i) == first), led_to, -speed, i);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::size_t count = 0, impacts = 0;
  for (const std::size_t i : order) {
    if (count >= room || (tree.rows[i].type == "impact" && ++impacts > room / 6)) return;
    for (auto at = static_cast<std::ptrdiff_t>(i); at >= 0 && !tree.shown[at]; at = cause[at])
      tree.shown[at] = true, ++count;
  }
}

}  // namespace

bool is_failure(const EventRow& event) {
  const Severity severity = severity_of(event.type);
  return severity == Severity::failure || severity == Severity::loss;
}

EventTree event_tree(const std::vector<EventRow>& all, std::vector<EventRow> chosen, std::size_t room) {
  EventTree tree;
  tree.rows = std::move(chosen);
  const std::size_t count = tree.rows.size();
  tree.effects.resize(count);
  tree.offspring.assign(count, 0);
  tree.shown.assign(count, false);
  const RowOf in_all = rows_by_id(all), in_chosen = rows_by_id(tree.rows);
  std::vector<std::ptrdiff_t> cause(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    cause[i] = nearest_cause(all, in_all, in_chosen, tree.rows[i]);
    if (cause[i] >= static_cast<std::ptrdiff_t>(i)) cause[i] = -1;  // rows are sorted by time
    if (cause[i] >= 0)
      tree.effects[cause[i]].push_back(i);
    else
      tree.roots.push_back(i);
  }
  for (std::size_t i = count; i-- > 0;)
    if (cause[i] >= 0) tree.offspring[cause[i]] += 1 + tree.offspring[i];
  choose(tree, cause, room);
  return tree;
}

}  // namespace trilith::results
