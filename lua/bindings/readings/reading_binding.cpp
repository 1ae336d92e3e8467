// Reading a model: sets of bodies, contacts, histories, and options of the results file.
#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/contact/solid_resultants.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/readings/field_history.hpp"
#include "bindings/readings/touching_now.hpp"

namespace trilith::script {
namespace {

bool any_matches(const std::vector<std::string>& patterns, const std::string& name) {
  return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& p) { return matches(p, name); });
}

/// m:bodies{ group =, material =, name = }: bodies that match all given keys, with the wildcards '*' and '?'.
int bodies(lua_State* L) {
  const ScriptModel& m = this_model(L);
  lua_settop(L, 2);
  if (lua_isnil(L, 2)) {
    lua_newtable(L);
    lua_replace(L, 2);
  }
  Keys keys(L, 2, "bodies");
  const auto group = keys.names("group"), material = keys.names("material"), name = keys.names("name");
  keys.finish();
  std::vector<int> found;
  for (int i = 0; i < m.body_count(); ++i) {
    if (m.removed_at(i)) continue;
    const auto& groups = m.groups_of(i);
    const bool in_group = group.empty() || std::any_of(groups.begin(), groups.end(),
                                                       [&](const auto& g) { return any_matches(group, g); });
    if (in_group && (material.empty() || any_matches(material, m.material_of(i))) &&
        (name.empty() || any_matches(name, m.body_name(i))))
      found.push_back(i);
  }
  push_set(L, 1, std::move(found));
  return 1;
}

template <class V>
void set_vector(lua_State* L, const char* key, const V& v) {
  lua_createtable(L, static_cast<int>(v.size()), 0);
  for (int k = 0; k < v.size(); ++k) {
    lua_pushnumber(L, v[k]);
    lua_rawseti(L, -2, k + 1);
  }
  lua_setfield(L, -2, key);
}

/// Common fields of contacts in the plane and in space.
template <int D>
void begin_contact(lua_State* L, const Simulation<D>& s, int row, int a, int b, ContactHold hold) {
  constexpr std::array holds{"bonded", "sticking", "sliding"};
  const auto r = static_cast<std::size_t>(row);
  lua_createtable(L, 0, 11);
  push_body(L, 1, a);
  lua_setfield(L, -2, "a");
  push_body(L, 1, b);
  lua_setfield(L, -2, "b");
  lua_pushstring(L, s.model().law_names[static_cast<std::size_t>(s.work().pairs[r].law)].c_str());
  lua_setfield(L, -2, "law");
  lua_pushstring(L, holds[static_cast<std::size_t>(hold)]);
  lua_setfield(L, -2, "hold");
  lua_pushnumber(L, s.work().contacts.memory[r].slip);
  lua_setfield(L, -2, "slip");
}

void push_contact(lua_State* L, const Simulation<2>& s, const TouchingContact& c) {
  begin_contact(L, s, c.row, c.body_a, c.body_b, c.hold);
  set_number(L, "normal", c.resultant.normal);
  set_number(L, "shear", c.resultant.shear);
  set_vector(L, "point", c.resultant.point);
  set_vector(L, "force", c.resultant.force);
}
void push_contact(lua_State* L, const Simulation<3>& s, const SolidResultant& c) {
  begin_contact(L, s, c.row, c.body_a, c.body_b, c.hold);
  const double normal = c.normal.dot(c.force);
  set_number(L, "normal", normal);
  set_number(L, "shear", (c.force - normal * c.normal).norm());
  set_number(L, "area", c.area);
  set_vector(L, "point", c.point);
  set_vector(L, "direction", c.normal);
  set_vector(L, "force", c.force);
}

/// Pushes a list of the contacts that `wanted` selects.
template <int D, class Wanted>
void push_contacts(lua_State* L, const Simulation<D>& s, Wanted&& wanted) {
  lua_newtable(L);
  lua_Integer count = 0;
  for (const auto& c : touching_now(s)) {
    if (!wanted(c.body_a, c.body_b)) continue;
    push_contact(L, s, c);
    lua_rawseti(L, -2, ++count);
  }
}

/// m:contacts{ between = {a, b} }: contacts that carry force, with the force on b.
int contacts(lua_State* L) {
  ScriptModel& m = this_model(L);
  lua_settop(L, 2);
  if (lua_isnil(L, 2)) {
    lua_newtable(L);
    lua_replace(L, 2);
  }
  Keys keys(L, 2, "contacts");
  std::array<std::vector<int>, 2> side;
  if (keys.push("between") == LUA_TTABLE && lua_rawlen(L, -1) == 2) {
    for (int i = 0; i < 2; ++i) {
      lua_rawgeti(L, -1, i + 1);
      side[static_cast<std::size_t>(i)] = bodies_at(L, -1, m, "contacts");
      lua_pop(L, 1);
    }
  } else if (!lua_isnil(L, -1)) {
    keys.wrong("between", "two bodies, sets, or names of bodies or groups");
  }
  const bool given = !lua_isnil(L, -1);
  lua_pop(L, 1);
  keys.finish();
  const auto has = [](const std::vector<int>& list, int b) { return std::binary_search(list.begin(), list.end(), b); };
  const auto wanted = [&](int a, int b) {
    return !given || (has(side[0], a) && has(side[1], b)) || (has(side[0], b) && has(side[1], a));
  };
  if (SpaceModel* space = as_space(m))
    push_contacts(L, space->evaluated(), wanted);
  else
    push_contacts(L, require_plane(m, "contacts").evaluated(), wanted);
  return 1;
}

template <class H>
std::vector<std::string> number_names(const H& h) {
  std::vector<std::string> names;
  for (const Property<H>& p : Kind<H>::properties())
    if (p.number != nullptr && has_property(p, h)) names.emplace_back(p.name);
  return names;
}

/// True if the body is inactive, so that its numbers are undefined. A cracked body is read at its centroid.
bool is_out(const BodyHandle& h) {
  const int part = h.model().heir_of(h.index);
  return h.model().is_out(part < 0 ? h.index : part);
}
bool is_out(const BearingHandle& h) {
  return h.model().is_bearing_out(h.index);
}
bool is_out(const SeatHandle& h) {
  return h.model().is_seat_out(h.index);
}
bool is_out(const StoreyHandle& h) {
  return h.model().is_storey_out(h.index + 1);
}

/// Records the number `what` of a handle; NaN while it is inactive.
template <class H>
void follow(Keys& keys, History& history, const std::string& what, const H& h) {
  const Property<H>* p = find_property<H>(what);
  if (p == nullptr || p->number == nullptr || !has_property(*p, h)) {
    keys.problem(fmt::format("'what' is '{}', which is not a reading of a {}{}", what, Kind<H>::name,
                             name_hint(what, number_names(h))));
    return;
  }
  if constexpr (requires { require_stress(h, what); }) require_stress(h, what);
  history.sample = [h, p, name = history.name] {
    if (is_out(h)) return std::numeric_limits<double>::quiet_NaN();
    const double value = p->number(h);
    if (!std::isnan(value) || !h.model().recording()) return value;
    throw InputError(fmt::format("history '{}' at t = {:g} s is nan", name, h.model().time()));
  };
  history.unit = p->unit;
  history.sentence = fmt::format("{} of {}", p->doc, Kind<H>::title(h));
}

/// Records the object under `key`, a handle or a name; false if not given.
template <class H>
bool follow_key(Keys& keys, std::string_view key, History& history, const std::string& what, ScriptModel& m) {
  lua_State* L = keys.lua();
  const int type = keys.push(key);
  if (type != LUA_TNIL && type != LUA_TSTRING && test_handle<H>(L, -1) == nullptr) {
    keys.wrong(key, fmt::format("a {} or its name", Kind<H>::name));
  } else if (type != LUA_TNIL) {
    try {
      follow(keys, history, what, row_of<H>(m, row_at<H>(L, -1, m, "")));
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  }
  lua_pop(L, 1);
  return type != LUA_TNIL;
}

/// Records a number of the model itself.
void follow_model(Keys& keys, History& h, const std::string& what, ScriptModel& m) {
  const Property<ModelBox>* p = find_property<ModelBox>(what);
  const ModelBox box{m.shared_from_this()};
  if (p == nullptr || p->number == nullptr || !has_property(*p, box)) {
    if (keys.push("what") == LUA_TSTRING)  // other cases have been reported
      keys.problem(
          fmt::format("'what' is '{}', which is not a reading of the model (for others give body, bearing, seat, "
                      "storey or seepage){}",
                      what, name_hint(what, number_names(box))));
    lua_pop(keys.lua(), 1);
    return;
  }
  h.sample = [owner = Owner(m.shared_from_this()), p, name = h.name] {
    const double value = p->number(ModelBox{owner.get().shared_from_this()});
    if (!std::isnan(value) || !owner.get().recording()) return value;
    throw InputError(fmt::format("history '{}' at t = {:g} s is nan", name, owner.get().time()));
  };
  h.unit = p->unit;
  h.sentence = p->doc;
}

/// Records the storey under `storey`; false if not given.
bool follow_storey(Keys& keys, History& h, const std::string& what, ScriptModel& m) {
  if (!keys.has("storey")) return false;
  const int storey = keys.count("storey", 0), storeys = storey_count(m);
  if (storey < 1 || storey > storeys)
    keys.problem(fmt::format("there is no storey {}; there are {}", storey, storeys));
  else
    follow(keys, h, what, row_of<StoreyHandle>(m, storey - 1));
  return true;
}

void read_followed(Keys& keys, History& h, ScriptModel& m) {
  const std::string what = keys.text("what");
  const bool owned = follow_storey(keys, h, what, m) || follow_seepage(keys, h, what, m) ||
                     follow_temperature(keys, h, what, m) || follow_key<BodyHandle>(keys, "body", h, what, m) ||
                     follow_key<BearingHandle>(keys, "bearing", h, what, m) ||
                     follow_key<SeatHandle>(keys, "seat", h, what, m);
  if (!owned) follow_model(keys, h, what, m);
  if (!keys.has("seepage"))
    keys.refuse("at", keys.has("body") ? "'at' is a place along a joint of seepage; for a point of a body give of = "
                                         "function() return (body:point { x, y }) end"
                                       : "'at' is a place along a joint; give seepage, the name of the joint");
  if (what != "temperature" || !keys.has("body"))
    keys.refuse("point", "'point' is of a body's temperature; give body and what = \"temperature\", or leave it out");
  keys.know({"body", "bearing", "seat", "storey", "seepage", "at", "point", "every"});
}

/// `m:history{ name =, body = | bearing = | seat = , what = }` or `{ name =, unit =, of = function }`; without an owner
/// `what` is a number of the model. The library keeps the function, if any.
int history(lua_State* L) {
  ScriptModel& m = this_model(L);
  if (m.running() && !m.paused())
    throw InputError("history: cannot be added while a stage runs; add it between stages or in a pause");
  Keys keys(L, 2, "history");
  History h;
  h.name = keys.text("name");
  keys.name_owner(h.name);
  for (const History& other : m.histories)
    if (other.name == h.name) keys.problem("exists already; give each its own name");
  const bool function = keys.push("of") == LUA_TFUNCTION;
  if (!function && !lua_isnil(L, -1)) keys.wrong("of", "a function");
  lua_pop(L, 1);
  if (function) {
    h.unit = keys.text("unit", "1");
    h.sentence = keys.text("doc", "computed by the script");
    for (const char* const key : {"what", "body", "bearing", "seat", "storey", "seepage", "at", "point"})
      keys.refuse(key, fmt::format("'{}' cannot be given with 'of', whose function gives the number; keep one", key));
  } else {
    read_followed(keys, h, m);
  }
  if (const auto every = keys.maybe_number("every", "s")) {
    if (!(*every > 0)) keys.problem(fmt::format("'every' is {:g} s, must be above 0", *every));
    m.history_interval = *every;
  }
  keys.finish();
  // A history added later has no values before.
  h.values.assign(m.history_times.size(), std::numeric_limits<double>::quiet_NaN());
  m.histories.push_back(std::move(h));
  m.follow_more();
  push_history(L, 1, static_cast<int>(m.histories.size()) - 1);
  return 1;
}

/// m:results{ file =, frames =, histories =, energy =, velocities =, joints = }
int results(lua_State* L) {
  ScriptModel& m = this_model(L);
  if (m.running()) throw InputError("results: can only be set between stages; a stage is running");
  if (m.results)
    throw InputError(fmt::format("results: already set, to '{}'; a model has one file, so give everything in one call",
                                 m.results->file));
  Keys keys(L, 2, "results");
  ResultsOptions r;
  r.file = keys.text("file");
  r.frames = keys.number("frames", "s", r.frames);
  r.histories = keys.number("histories", "s", r.histories);
  r.energy = keys.number("energy", "s", r.energy);
  r.with_velocity = keys.flag("velocities", r.with_velocity);
  r.with_joints = keys.flag("joints", r.with_joints);
  for (const auto& [key, value] : {std::pair{"frames", r.frames}, {"histories", r.histories}, {"energy", r.energy}})
    if (!(value > 0)) keys.problem(fmt::format("'{}' is {:g} s, must be above 0", key, value));
  keys.finish();
  const Host& h = host(L);
  if (h.case_folder.empty() && h.results_file.empty()) static_cast<void>(h.room.writable(r.file, "results"));
  m.results = r;
  return 0;
}

const std::array reading_method_list{
    Method{"bodies", guarded<bodies>},
    Method{"contacts", guarded<contacts>},
    Method{"history", guarded<history>},
    Method{"results", guarded<results>},
};

const History& row(const HistoryHandle& h) {
  return h.model().histories[static_cast<std::size_t>(h.index)];
}

void push_array(lua_State* L, const std::vector<double>& values) {
  lua_createtable(L, static_cast<int>(values.size()), 0);
  lua_Integer i = 0;
  for (const double v : values) {
    lua_pushnumber(L, v);
    lua_rawseti(L, -2, ++i);
  }
}

double extreme(const HistoryHandle& h, double sign) {
  double most = -unbounded;
  for (const double v : row(h).values) most = std::max(most, sign * v);
  if (row(h).values.empty()) return 0;
  return std::isfinite(most) ? sign * most : std::numeric_limits<double>::quiet_NaN();
}

using HistoryProperty = Property<HistoryHandle>;
const std::array history_properties{
    HistoryProperty{"name", "", "its name", nullptr,
                    [](lua_State* L, const HistoryHandle& h) { lua_pushstring(L, row(h).name.c_str()); }},
    HistoryProperty{"unit", "", "SI unit of its values", nullptr,
                    [](lua_State* L, const HistoryHandle& h) { lua_pushstring(L, row(h).unit.c_str()); }},
    HistoryProperty{"t", "", "times [s]", nullptr,
                    [](lua_State* L, const HistoryHandle& h) { push_array(L, h.model().history_times); }},
    HistoryProperty{"values", "", "values, one for each time", nullptr,
                    [](lua_State* L, const HistoryHandle& h) { push_array(L, row(h).values); }},
    HistoryProperty{"last", "", "latest value, 0 before the first; NaN while its owner is not in the model",
                    [](const HistoryHandle& h) { return row(h).values.empty() ? 0 : row(h).values.back(); }},
    HistoryProperty{"max", "", "largest value", [](const HistoryHandle& h) { return extreme(h, 1); }},
    HistoryProperty{"min", "", "smallest value", [](const HistoryHandle& h) { return extreme(h, -1); }},
};

int history_length(lua_State* L) {
  lua_pushinteger(L, static_cast<lua_Integer>(row(handle<HistoryHandle>(L, 1)).values.size()));
  return 1;
}

constexpr std::array history_operators{std::pair<const char*, lua_CFunction>{"__len", guarded<history_length>}};

}  // namespace

std::span<const Method> reading_methods() {
  return reading_method_list;
}

std::span<const Property<HistoryHandle>> Kind<HistoryHandle>::properties() {
  return history_properties;
}
std::span<const Method> Kind<HistoryHandle>::methods() {
  return {};
}
std::string Kind<HistoryHandle>::title(const HistoryHandle& h) {
  return h.open() ? fmt::format("history '{}'", row(h).name) : "history of a closed model";
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<HistoryHandle>::metamethods() {
  return history_operators;
}
bool Kind<HistoryHandle>::read_item(lua_State* L, const HistoryHandle& h) {
  if (lua_isinteger(L, 2) == 0) return false;
  const lua_Integer i = lua_tointeger(L, 2);
  if (i < 1 || i > static_cast<lua_Integer>(row(h).values.size()))
    lua_pushnil(L);
  else
    lua_pushnumber(L, row(h).values[static_cast<std::size_t>(i - 1)]);
  return true;
}

}  // namespace trilith::script
