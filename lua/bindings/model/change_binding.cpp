// Changes of a built model: numbers of laws, bearings, and removed or reactivated parts.
#include <algorithm>

#include "base/terminal_text.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/law_values.hpp"
#include "bindings/laws/bearing_reading.hpp"
#include "bindings/loads/load_reading.hpp"
#include "model/builder/bearing_spec.hpp"
#include "model/loads.hpp"
#include "model/plausible_ranges.hpp"
#include "run/record/recorded_texts.hpp"

namespace trilith::script {
namespace {

template <class L>
void note_failed_check(Keys& keys, const L& law) {
  try {
    law.check();
  } catch (const InputError& e) {
    keys.problem(e.what());
  }
}

/// The law with the given numbers replaced; a problem is noted if one is out of range, or if they contradict each
/// other.
ContactLaw changed_law(Keys& keys, ContactLaw law) {
  std::visit(
      [&](auto& l) {
        using T = std::decay_t<decltype(l)>;
        bool any = false;
        for (const Parameter<T>& p : T::parameters()) {
          const auto given = keys.maybe_number(p.name, p.unit);
          if (!given) continue;
          any = true;
          l.*(p.member) = *given;
          if (!p.allows(*given))
            keys.problem(fmt::format("'{}' is {:g}{}{}, must be {}", p.name, *given, p.unit == "1" ? "" : " ",
                                     p.unit == "1" ? "" : p.unit, p.range()));
        }
        if (!any) keys.problem("no number is given; give a parameter of the law, such as mu");
        check_ways(keys, l);
        if constexpr (requires { l.check(); }) note_failed_check(keys, l);
      },
      law);
  return law;
}

template <int D>
std::string change_law(Keys& keys, SimulatedModel<D>& m, const std::string& name) {
  const auto& names = m.simulation().model().law_names;
  const auto it = std::find(names.begin(), names.end(), name);
  if (it == names.end()) throw InputError(fmt::format("change: there is no law '{}'{}", name, name_hint(name, names)));
  const auto row = static_cast<std::size_t>(it - names.begin());
  const ContactLaw law = changed_law(keys, m.simulation().model().laws[row]);
  keys.finish();
  m.modify([row, law](Model<D>& model) { model.laws[row] = law; }, {});
  for (auto& [known, value] : m.laws)
    if (known == name) value = law;
  return fmt::format("law '{}' is now {}", name, law_text(law));
}

/// True if the law changes to another kind, which cannot use the previous memory.
template <int D>
bool begins_anew(const Bearing<D>& before, const Bearing<D>& after) {
  for (std::size_t k = 0; k < before.law.size(); ++k)
    if (before.law[k].index() != after.law[k].index()) return true;
  if constexpr (D == 3) return before.horizontal.index() != after.horizontal.index();
  return false;
}

/// The successor of a bearing under `becomes`: a contact law by its name, a waiting bearing, or false for none.
template <int D>
void change_successor(Keys& keys, const ScriptModel& m, const Model<D>& model, Bearing<D>& changed) {
  lua_State* L = keys.lua();
  const int type = keys.push("becomes");
  const auto* handle = type == LUA_TUSERDATA ? test_handle<BearingHandle>(L, -1) : nullptr;
  const std::string name = type == LUA_TSTRING ? text_at(L, -1)
                           : handle != nullptr
                               ? m.bearings[static_cast<std::size_t>(require_own(*handle, m, "change: becomes").index)]
                               : "";
  if (type == LUA_TBOOLEAN && lua_toboolean(L, -1) == 0) {
    changed.contact_after = changed.becomes_bearing = -1;
    changed.next_from_here = {};
  } else if (!name.empty()) {
    const auto law = std::find(model.law_names.begin(), model.law_names.end(), name);
    const auto next =
        std::find_if(model.bearings.begin(), model.bearings.end(), [&](const auto& b) { return b.name == name; });
    changed.contact_after = law == model.law_names.end() ? -1 : static_cast<int>(law - model.law_names.begin());
    changed.becomes_bearing = changed.contact_after >= 0 || next == model.bearings.end()
                                  ? -1
                                  : static_cast<int>(next - model.bearings.begin());
    if (changed.contact_after < 0 && changed.becomes_bearing < 0)
      keys.problem(fmt::format("'becomes': there is no contact law and no bearing '{}'{}", name,
                               name_hint(name, model.law_names)));
    else if (changed.becomes_bearing >= 0 && !next->starts_waiting)
      keys.problem(fmt::format("'becomes': bearing '{}' does not wait; it was made without waiting = true", name));
  } else if (type != LUA_TNIL) {
    keys.wrong("becomes", "the name of a contact law, a bearing that waits, or false");
  }
  lua_pop(L, 1);
}

/// Reads laws and limits, with the present ones as defaults; the rules of m:bearing apply.
template <int D>
void change_directions(Keys& keys, const std::string& owner, Bearing<D>& changed) {
  BearingSpecOf<D> spec;
  spec.law = changed.law, spec.limit = changed.limit;
  if constexpr (D == 3) spec.horizontal = changed.horizontal, spec.horizontal_limit = changed.horizontal_limit;
  read_directions<D>(keys, spec, OtherLimits::kept);
  if constexpr (D == 2) changed.angle = keys.number("angle", "rad", changed.angle);
  changed.replaces_contact = keys.flag("replaces_contact", changed.replaces_contact);
  check_bearing(spec, owner);
  changed.law = spec.law, changed.limit = spec.limit;
  if constexpr (D == 3) changed.horizontal = spec.horizontal, changed.horizontal_limit = spec.horizontal_limit;
}

template <int D>
std::string change_bearing(Keys& keys, SimulatedModel<D>& m, const std::string& name) {
  const auto& bearings = m.simulation().model().bearings;
  const auto it = std::find_if(bearings.begin(), bearings.end(), [&](const auto& b) { return b.name == name; });
  if (it == bearings.end())
    throw InputError(fmt::format("change: there is no bearing '{}'{}", name, name_hint(name, m.bearings)));
  const auto row = static_cast<std::size_t>(it - bearings.begin());
  if (m.simulation().state().bearing[row].status == BearingStatus::removed)
    throw InputError(fmt::format("change: bearing '{}' was removed", name));
  Bearing<D> changed = *it;
  change_successor<D>(keys, m, m.simulation().model(), changed);
  read_becomes_from<D>(keys, changed.next_from_here);
  if (changed.becomes_bearing < 0 && changed.next_counts_from_here())
    keys.problem("'becomes_from' is \"here\", but it becomes no bearing; name one under becomes");
  change_directions<D>(keys, fmt::format("change: bearing '{}'", name), changed);
  keys.finish();
  std::vector<Bearing<D>> all = bearings;
  all[row] = changed;
  check_successor(all, row);
  const std::vector<int> begun = begins_anew(*it, changed) ? std::vector{static_cast<int>(row)} : std::vector<int>{};
  m.modify([row, changed](Model<D>& model) { model.bearings[row] = changed; }, begun);
  return fmt::format("bearing '{}' is now {}", name, bearing_text(m.simulation().model(), changed));
}

std::string change_named(Keys& keys, ScriptModel& m, const std::string& law, const std::string& bearing) {
  if (SpaceModel* space = as_space(m))
    return law.empty() ? change_bearing<3>(keys, *space, bearing) : change_law<3>(keys, *space, law);
  PlaneModel& plane = require_plane(m, "change");
  return law.empty() ? change_bearing<2>(keys, plane, bearing) : change_law<2>(keys, plane, law);
}

/// m:change{ law = "name", mu = 0.4 } or m:change{ bearing = "name", along = , limit = { along = 0.3 } }
int change(lua_State* L) {
  ScriptModel& m = this_model(L);
  Keys keys(L, 2, "change");
  const std::string law = keys.text("law", ""), bearing = keys.text("bearing", "");
  if (law.empty() == bearing.empty()) {
    keys.problem("give either law or bearing, the name of one");
    keys.know({"limit"});
    keys.finish();
  }
  const std::string said = change_named(keys, m, law, bearing);
  std::vector<std::string> plausibility_notes;
  for (const auto& [name, value] : m.laws)
    if (name == law)
      std::visit([&](const auto& l) { add_plausibility_notes(plausibility_notes, "change: law '" + law + "'", l); },
                 value);
  for (const std::string& plausibility_note : plausibility_notes)
    if (host(L).observer != nullptr) host(L).observer->note(plausibility_note);
  m.note(fmt::format("changed at {:.6g} s: {}", m.time(), said));
  if (host(L).observer != nullptr) host(L).observer->note(said);
  return 0;
}

/// Arguments of `remove` and `reactivate`.
struct Chosen {
  std::vector<int> bodies, bearings;
  std::vector<std::string> loads;
};

/// A bearing, by handle or name.
std::optional<int> bearing_at(lua_State* L, int index, const ScriptModel& m, const std::string& owner) {
  if (const auto* h = test_handle<BearingHandle>(L, index)) return require_own(*h, m, owner).index;
  if (lua_type(L, index) != LUA_TSTRING) return std::nullopt;
  const auto it = std::find(m.bearings.begin(), m.bearings.end(), text_at(L, index));
  if (it == m.bearings.end()) return std::nullopt;
  return static_cast<int>(it - m.bearings.begin());
}

bool is_load(lua_State* L, int index, ScriptModel& m) {
  if (lua_type(L, index) != LUA_TSTRING) return false;
  const std::vector<std::string> names = names_of_loads(m);
  return std::find(names.begin(), names.end(), text_at(L, index)) != names.end();
}

/// InputError if the text at `index` is not a known name; names of bearings and loads were checked before.
void require_named(lua_State* L, int index, ScriptModel& m, const std::string& owner) {
  if (lua_type(L, index) != LUA_TSTRING) return;
  const std::string name = text_at(L, index);
  std::vector<std::string> known = m.body_names();
  const auto add = [&](const std::vector<std::string>& names) {
    for (const std::string& n : names)
      if (std::find(known.begin(), known.end(), n) == known.end()) known.push_back(n);
  };
  for (int b = 0; b < m.body_count(); ++b) add(m.groups_of(b));
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  add(m.bearings), add(names_of_loads(m));
  throw InputError(fmt::format("{}: there is no body or group '{}', and no bearing or load{}", owner, one_line(name),
                               name_hint(name, known)));
}

/// InputError if no load has the name: it was removed, or is a push.
template <int D>
void drop_named(Model<D>& model, const std::string& name) {
  if (drop_loads(model, name) > 0) return;
  for (const Push<D>& push : model.pushes)
    if (push.name == name)
      throw InputError(fmt::format("remove: '{}' is a push; use m:release {{ push = \"{}\" }}", name, name));
  throw InputError(fmt::format("remove: load '{}' was removed already", name));
}

/// A body, a set, a bearing, a name of a body, group, bearing or load, or a list of these.
void choose(lua_State* L, int index, ScriptModel& m, const std::string& owner, Chosen& chosen) {
  if (lua_type(L, index) == LUA_TTABLE) {
    const int list = lua_absindex(L, index);
    lua_checkstack(L, 8);
    for (lua_Integer i = 1; i <= static_cast<lua_Integer>(lua_rawlen(L, list)); ++i) {
      lua_rawgeti(L, list, i);
      if (lua_type(L, -1) == LUA_TTABLE) throw InputError(owner + ": a list holds another list");
      choose(L, -1, m, owner, chosen);
      lua_pop(L, 1);
    }
  } else if (const auto bearing = bearing_at(L, index, m, owner)) {
    chosen.bearings.push_back(*bearing);
  } else if (is_load(L, index, m)) {
    chosen.loads.push_back(text_at(L, index));
  } else {
    require_named(L, index, m, owner);
    const std::vector<int> bodies = bodies_at(L, index, m, owner);
    chosen.bodies.insert(chosen.bodies.end(), bodies.begin(), bodies.end());
  }
}

template <class T>
void keep_each_once(std::vector<T>& rows) {
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
}

Chosen chosen_at(lua_State* L, ScriptModel& m, const std::string& owner) {
  Chosen chosen;
  m.build();
  choose(L, 2, m, owner, chosen);
  keep_each_once(chosen.bodies);
  keep_each_once(chosen.bearings);
  keep_each_once(chosen.loads);
  if (chosen.bodies.empty() && chosen.bearings.empty() && chosen.loads.empty())
    throw InputError(owner + ": nothing is given; give a body, a set, a bearing, a load's name, or a list");
  return chosen;
}

/// `m:remove(what)`: removes parts now, or at the next step border.
int remove_parts(lua_State* L) {
  ScriptModel& m = this_model(L);
  const Chosen chosen = chosen_at(L, m, "remove");
  const std::string place = user_place(L);
  if (!m.running() || m.paused())
    for (const int b : chosen.bodies) m.require_present(b, "remove");
  if (!chosen.bodies.empty() || !chosen.bearings.empty()) m.remove(chosen.bodies, chosen.bearings, place);
  for (const std::string& name : chosen.loads) {
    const auto drop = [name](auto& model) { drop_named(model, name); };
    if (SpaceModel* space = as_space(m))
      space->change(drop);
    else
      require_plane(m, "remove").change(drop);
  }
  return 0;
}

/// `m:reactivate(what, { from = "here" | "start" })`: origin of the displacements of the bearings.
bool read_from_start(lua_State* L) {
  if (lua_isnoneornil(L, 3)) return false;
  Keys keys(L, 3, "put_back");
  const bool from_start = keys.choice("from", {"here", "start"}, 0) == 1;
  keys.finish();
  return from_start;
}

/// `m:reactivate(what, how)`: reactivates removed bodies and bearings.
int put_back_parts(lua_State* L) {
  ScriptModel& m = this_model(L);
  const Chosen chosen = chosen_at(L, m, "put_back");
  if (!chosen.loads.empty())
    throw InputError(fmt::format("put_back: load '{}' is a load; apply a new one", chosen.loads.front()));
  const bool from_start = read_from_start(L);
  if (from_start && chosen.bearings.empty())
    throw InputError("put_back: 'from' is for bearings, and none is put back; leave it out");
  m.reactivate(chosen.bodies, chosen.bearings, from_start, user_place(L));
  return 0;
}

const std::array change_method_list{
    Method{"change", guarded<change>},
    Method{"remove", guarded<remove_parts>},
    Method{"put_back", guarded<put_back_parts>},
};

/// core.contact_laws(model): a list of the model's laws, with their names.
int contact_laws(lua_State* L) {
  const ScriptModel& m = handle<ModelBox>(L, 1).get();
  lua_newtable(L);
  lua_Integer i = 0;
  for (const auto& [name, law] : m.laws) {
    push_handle(L, ContactLawValue{law, name});
    lua_rawseti(L, -2, ++i);
  }
  return 1;
}

template <int D>
void set_number_of_law(SimulatedModel<D>& m, const std::string& name, const std::string& key, double value) {
  const auto& names = m.simulation().model().law_names;
  const auto row = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  if (row == names.size()) throw InputError(fmt::format("there is no law '{}'", name));
  ContactLaw law = m.simulation().model().laws[row];
  std::visit(
      [&](auto& l) {
        for (const auto& p : std::decay_t<decltype(l)>::parameters())
          if (p.name == key) l.*(p.member) = value;
      },
      law);
  m.change([row, law](Model<D>& model) { model.laws[row] = law; });
  m.simulation().drop_step();
}

/// core.set_law_number(model, law, key, value): as m:change, without a note.
int set_law_number(lua_State* L) {
  ScriptModel& m = handle<ModelBox>(L, 1).get();
  const std::string name = text_at(L, 2), key = text_at(L, 3);
  const double value = lua_tonumber(L, 4);
  if (PlaneModel* plane = as_plane(m))
    set_number_of_law<2>(*plane, name, key, value);
  else
    set_number_of_law<3>(*as_space(m), name, key, value);
  return 0;
}

}  // namespace

std::span<const Method> change_methods() {
  return change_method_list;
}

void open_change(lua_State* L) {
  set_function(L, "contact_laws", guarded<contact_laws>);
  set_function(L, "set_law_number", guarded<set_law_number>);
}

}  // namespace trilith::script
