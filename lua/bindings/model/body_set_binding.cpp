// Sets of bodies: properties, union, intersection, difference and search.
#include <algorithm>
#include <array>

#include "bindings/core/bindings.hpp"
#include "bindings/core/handles.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/model/body_motion.hpp"
#include "run/record/storey_damage.hpp"

namespace trilith::script {
namespace {

BodyHandle member(const BodySet& set, std::size_t i) {
  BodyHandle b;
  b.owner = set.owner;
  b.index = set.bodies[i];
  return b;
}

template <class Value>
double largest(const BodySet& set, Value&& value) {
  double most = 0;
  for (std::size_t i = 0; i < set.bodies.size(); ++i) most = std::max(most, value(member(set, i)));
  return most;
}

void push_names(lua_State* L, const BodySet& set) {
  lua_newtable(L);
  for (std::size_t i = 0; i < set.bodies.size(); ++i) {
    const std::string& name = set.model().body_name(set.bodies[i]);
    lua_pushlstring(L, name.data(), name.size());
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
}

using SetProperty = Property<BodySet>;
const std::array set_properties{
    SetProperty{"count", "1", "number of bodies",
                [](const BodySet& s) { return static_cast<double>(s.bodies.size()); }},
    SetProperty{"names", "", "their names", nullptr, push_names},
    SetProperty{"mass", "kg", "sum of the masses",
                [](const BodySet& s) {
                  double sum = 0;
                  for (const int b : s.bodies) sum += s.model().mass_of(b);
                  return sum;
                }},
    SetProperty{
        "speed", "m/s", "of the fastest centroid",
        [](const BodySet& s) { return largest(s, [](const BodyHandle& b) { return motion_of(b).velocity.norm(); }); }},
    SetProperty{
        "drift", "m", "largest displacement since the start",
        [](const BodySet& s) { return largest(s, [](const BodyHandle& b) { return motion_of(b).moved.norm(); }); }},
};

std::vector<int> other_side(lua_State* L, const BodySet& set) {
  return bodies_at(L, 2, set.model(), "set");
}

/// The two operands of an operator as lists of one model; leaves the model on the stack.
std::pair<std::vector<int>, std::vector<int>> operands(lua_State* L) {
  const int owner = test_handle<BodySet>(L, 1) != nullptr || test_handle<BodyHandle>(L, 1) != nullptr ? 1 : 2;
  push_model_of(L, owner);
  const ScriptModel& model = handle<ModelBox>(L, -1).get();
  return {bodies_at(L, 1, model, "set"), bodies_at(L, 2, model, "set")};
}

int join_sets(lua_State* L) {
  auto [a, b] = operands(L);
  a.insert(a.end(), b.begin(), b.end());
  push_set(L, -1, std::move(a));
  return 1;
}
int subtract_sets(lua_State* L) {
  const auto [a, b] = operands(L);
  std::vector<int> rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  push_set(L, -1, std::move(rest));
  return 1;
}
int intersect_sets(lua_State* L) {
  const auto [a, b] = operands(L);
  std::vector<int> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  push_set(L, -1, std::move(both));
  return 1;
}
int set_length(lua_State* L) {
  const auto& set = handle<BodySet>(L, 1);
  require_open(set);
  lua_pushinteger(L, static_cast<lua_Integer>(set.bodies.size()));
  return 1;
}
int sets_equal(lua_State* L) {
  const auto *a = test_handle<BodySet>(L, 1), *b = test_handle<BodySet>(L, 2);
  lua_pushboolean(L, a != nullptr && b != nullptr && a->owner.same(b->owner) && a->bodies == b->bodies ? 1 : 0);
  return 1;
}
/// Called by a generic for: `for body in set do`. The control value is the previous body.
int next_of_set(lua_State* L) {
  const auto& set = handle<BodySet>(L, 1);
  const auto* before = test_handle<BodyHandle>(L, 3);
  const auto it = before == nullptr ? set.bodies.begin()
                                    : std::upper_bound(set.bodies.begin(), set.bodies.end(),
                                                       require_own(*before, set.model(), "set").index);
  if (it == set.bodies.end()) return 0;
  lua_getiuservalue(L, 1, 1);
  push_body(L, -1, *it);
  return 1;
}
/// set:has(body)
int set_has(lua_State* L) {
  const auto& set = handle<BodySet>(L, 1);
  const std::vector<int> other = other_side(L, set);
  lua_pushboolean(L, std::includes(set.bodies.begin(), set.bodies.end(), other.begin(), other.end()) ? 1 : 0);
  return 1;
}

template <int D>
std::vector<StoreyDamage> damage_now(SimulatedModel<D>& m, const std::vector<int>& bodies, const DamageLimits& limits) {
  const Simulation<D>& sim = m.evaluated();
  return damage_by_storey(sim.model(), sim.state(), sim.work(), bodies, m.findings(), limits);
}

DamageLimits read_limits(Keys& keys) {
  DamageLimits limits;
  limits.apart = keys.number("apart", "m", limits.apart);
  limits.out_of_place = keys.number("out_of_place", "m", limits.out_of_place);
  for (const auto& [key, value] : {std::pair{"apart", limits.apart}, {"out_of_place", limits.out_of_place}})
    if (!(value >= 0)) keys.problem(fmt::format("'{}' is {:g} m, must not be below 0", key, value));
  keys.finish();
  return limits;
}

/// wall:damage_by_storey{ apart =, out_of_place = }: a row for each storey the set belongs to, lowest first.
int set_damage(lua_State* L) {
  const auto& set = handle<BodySet>(L, 1);
  require_open(set);
  lua_settop(L, 2);
  if (lua_isnil(L, 2)) {
    lua_newtable(L);
    lua_replace(L, 2);
  }
  Keys keys(L, 2, "damage_by_storey");
  const DamageLimits limits = read_limits(keys);
  SpaceModel* space = as_space(set.model());
  const std::vector<StoreyDamage> rows =
      space != nullptr ? damage_now(*space, set.bodies, limits)
                       : damage_now(require_plane(set.model(), "damage_by_storey"), set.bodies, limits);
  if (rows.empty())
    throw InputError(
        fmt::format("damage_by_storey: none of these {} bodies is in a group \"storey 1\", \"storey 2\", "
                    "...; use the result of m:wall, or give the bodies such groups",
                    set.bodies.size()));
  lua_createtable(L, static_cast<int>(rows.size()), 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    lua_createtable(L, 0, 5);
    set_integer(L, "storey", rows[i].storey);
    set_integer(L, "joints", rows[i].joints);
    set_integer(L, "joints_apart", rows[i].joints_apart);
    set_integer(L, "units", rows[i].units);
    set_integer(L, "units_out_of_place", rows[i].units_out_of_place);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

const std::array set_methods{
    Method{"has", guarded<set_has>},
    Method{"damage_by_storey", guarded<set_damage>},
};

using NamedFunction = std::pair<const char*, lua_CFunction>;
constexpr std::array set_operators{
    NamedFunction{"__add", guarded<join_sets>},      NamedFunction{"__sub", guarded<subtract_sets>},
    NamedFunction{"__mul", guarded<intersect_sets>}, NamedFunction{"__len", guarded<set_length>},
    NamedFunction{"__eq", guarded<sets_equal>},      NamedFunction{"__call", guarded<next_of_set>},
};
constexpr std::array body_operators{NamedFunction{"__add", guarded<join_sets>}};

}  // namespace

/// A body can be used in place of a set of one body.
std::span<const std::pair<const char*, lua_CFunction>> Kind<BodyHandle>::metamethods() {
  return body_operators;
}
std::span<const Property<BodySet>> Kind<BodySet>::properties() {
  return set_properties;
}
std::span<const Method> Kind<BodySet>::methods() {
  return set_methods;
}
std::string Kind<BodySet>::title(const BodySet& s) {
  return s.open() ? fmt::format("set of {} bodies", s.bodies.size()) : "set of bodies of a closed model";
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<BodySet>::metamethods() {
  return set_operators;
}
bool Kind<BodySet>::read_item(lua_State* L, const BodySet& s) {
  if (lua_isinteger(L, 2) == 0) return false;
  const lua_Integer i = lua_tointeger(L, 2);
  if (i < 1 || i > static_cast<lua_Integer>(s.bodies.size())) {
    lua_pushnil(L);  // ends ipairs
    return true;
  }
  lua_getiuservalue(L, 1, 1);
  push_body(L, -1, s.bodies[static_cast<std::size_t>(i - 1)]);
  return true;
}

}  // namespace trilith::script
