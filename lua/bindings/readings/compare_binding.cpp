// Differences between the branch that rewind removed and the present one. For the library.
#include <algorithm>
#include <cmath>
#include <span>

#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "model/pose.hpp"

namespace trilith::script {
namespace {

/// Two states at nearly the same time, the latest available.
template <int D>
struct Pair {
  const State<D>*before, *now;
};

/// Checkpoints of the removed run. After the present one has passed its end, the first checkpoint is of the present run
/// at that time.
std::span<const Checkpoint> own_checkpoints(const Branch& branch) {
  return std::span(branch.checkpoints).subspan(branch.passed ? 1 : 0);
}

template <int D>
Pair<D> latest_pair(const Branch& branch, const SimulatedModel<D>& m) {
  std::vector<const State<D>*> now{&m.if_built()->state()};
  const auto& kept = m.checkpoints.list();
  for (auto c = kept.rbegin(); c != kept.rend() && c->time() > branch.from; ++c)
    now.push_back(&c->template snapshot_in<D>().state);
  if (branch.passed) now.push_back(&branch.checkpoints.front().template snapshot_in<D>().state);
  std::stable_sort(now.begin(), now.end(), [](const State<D>* a, const State<D>* b) { return a->time > b->time; });
  for (const State<D>* n : now) {
    const State<D>* nearest = nullptr;
    for (const Checkpoint& c : own_checkpoints(branch)) {
      const State<D>& s = c.template snapshot_in<D>().state;
      if (nearest == nullptr || std::abs(s.time - n->time) < std::abs(nearest->time - n->time)) nearest = &s;
    }
    if (nearest != nullptr && std::abs(nearest->time - n->time) <= 1.5 * std::max(n->last_dt, nearest->last_dt))
      return {nearest, n};
  }
  return {nullptr, nullptr};
}

struct Moved {
  int body;
  double distance, turn;
};

/// Difference of a body's rotation between the branches [rad]; in space without sign.
double turn_between(const Pose& before, const Pose& now) {
  return now.rotation - before.rotation;
}
double turn_between(const Pose3& before, const Pose3& now) {
  return angle_of(now.turned * inverse(before.turned)).norm();
}

template <int D>
std::vector<Moved> moved_most(const Model<D>& model, const Pair<D>& pair) {
  std::vector<Moved> moved;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    const auto before = body_pose(model, *pair.before, b), now = body_pose(model, *pair.now, b);
    moved.push_back({b, (now.place - before.place).norm(), turn_between(before, now)});
  }
  std::stable_sort(moved.begin(), moved.end(), [](const Moved& a, const Moved& b) { return a.distance > b.distance; });
  return moved;
}

void push_moved(lua_State* L, const std::vector<Moved>& moved) {
  constexpr std::size_t most = 8;
  lua_newtable(L);
  for (std::size_t i = 0; i < std::min(most, moved.size()); ++i) {
    if (moved[i].distance == 0 && moved[i].turn == 0) break;
    lua_createtable(L, 0, 3);
    push_body(L, 1, moved[i].body);
    lua_setfield(L, -2, "body");
    set_number(L, "distance", moved[i].distance);
    set_number(L, "turn", moved[i].turn);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
}

/// Events after `from` and up to `to`, except events of stages.
void push_events(lua_State* L, const std::vector<Event>& events, double from, double to) {
  lua_newtable(L);
  lua_Integer count = 0;
  for (const Event& e : events) {
    if (e.time <= from || e.time > to || e.type == EventType::stage_begun || e.type == EventType::stage_ended) continue;
    push_event(L, 1, e);
    lua_rawseti(L, -2, ++count);
  }
}

/// Largest difference of each history at its common samples.
void push_histories(lua_State* L, const Branch& branch, const ScriptModel& m) {
  lua_newtable(L);
  for (std::size_t k = 0; k < m.histories.size() && k < branch.samples.size(); ++k) {
    const auto &before = branch.samples[k], &now = m.histories[k].values;
    const std::size_t common = std::min({before.size(), now.size(), branch.times.size(), m.history_times.size()});
    double most = 0, at = 0;
    for (std::size_t i = 0; i < common; ++i) {
      if (!(std::abs(now[i] - before[i]) > most)) continue;  // NaN in either: nothing to compare
      most = std::abs(now[i] - before[i]);
      at = m.history_times[i];
    }
    lua_createtable(L, 0, 3);
    set_number(L, "difference", most);
    set_number(L, "at", at);
    lua_pushstring(L, m.histories[k].unit.c_str());
    lua_setfield(L, -2, "unit");
    lua_setfield(L, -2, m.histories[k].name.c_str());
  }
}

/// Leaves a table of the differences from `branch`.
template <int D>
void push_changes(lua_State* L, const Branch& branch, const SimulatedModel<D>& m) {
  lua_createtable(L, 0, 10);
  set_number(L, "from", branch.from);
  set_number(L, "kept_from", own_checkpoints(branch).front().time());
  set_number(L, "kept_to", branch.checkpoints.back().time());
  const Pair<D> pair = latest_pair(branch, m);
  if (pair.now == nullptr) return;
  set_number(L, "before", pair.before->time);
  set_number(L, "now", pair.now->time);
  lua_pushboolean(L, state_hash(*pair.before) == state_hash(*pair.now) ? 1 : 0);
  lua_setfield(L, -2, "same");
  push_moved(L, moved_most(m.if_built()->model(), pair));
  lua_setfield(L, -2, "moved");
  push_events(L, branch.events, branch.from, pair.now->time);
  lua_setfield(L, -2, "events_before");
  push_events(L, m.events, branch.from, pair.now->time);
  lua_setfield(L, -2, "events_now");
  push_histories(L, branch, m);
  lua_setfield(L, -2, "histories");
}

/// core.compare(model): { from, before, now, same, moved, events_before, events_now, histories }; nothing if no run was
/// removed; without the times if the branches have no common time.
int compare(lua_State* L) {
  ScriptModel& m = this_model(L);
  if (!m.undone) return 0;
  if (const SpaceModel* space = as_space(m))
    push_changes<3>(L, *m.undone, *space);
  else
    push_changes<2>(L, *m.undone, require_plane(m, "compare"));
  return 1;
}

}  // namespace

void open_compare(lua_State* L) {
  set_function(L, "compare", guarded<compare>);
}

}  // namespace trilith::script
