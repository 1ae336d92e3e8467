// Declares bearings: m:bearing and m:seat. The properties that a script reads later are in bearing_handle.cpp.
#include <algorithm>

#include "bindings/core/bindings.hpp"
#include "bindings/geometry/declared_reading.hpp"
#include "bindings/laws/bearing_reading.hpp"
#include "build/space/solid_part.hpp"

namespace trilith::script {
namespace {

// The table of m:bearing in either dimension.

std::optional<Vec2> maybe_place(Keys& keys, std::string_view key, const BearingSpecOf<2>& /*spec*/) {
  return keys.maybe_point(key);
}
std::optional<Vec3> maybe_place(Keys& keys, std::string_view key, const BearingSpecOf<3>& /*spec*/) {
  return keys.has(key) ? std::optional(keys.vector(key)) : std::nullopt;
}

template <int D>
void read_points(Keys& keys, BearingSpecOf<D>& spec) {
  const auto at = maybe_place(keys, "at", spec), from = maybe_place(keys, "from", spec),
             to = maybe_place(keys, "to", spec);
  const std::string place = D == 2 ? "{x, y}" : "{x, y, z}";
  if (at && (from || to)) keys.problem("both at and from, to are given; at is for zero length");
  if (!at && !(from && to))
    keys.problem(fmt::format("its place is missing; give at = {0}, or from = {0} and to = {0}", place));
  spec.point_a = at ? *at : from.value_or(Vec<D>::Zero());
  spec.point_b = at ? *at : to.value_or(Vec<D>::Zero());
  spec.arm = keys.number("arm", "m", 0);
  if (!(spec.arm >= 0)) keys.problem(fmt::format("'arm' is {:g} m, must not be below 0", spec.arm));
}

void read_axes(Keys& keys, BearingSpecOf<2>& spec) {
  spec.angle = keys.number("angle", "rad", 0);
}
/// Azimuth of the direction along, counted from x to y, or any rotation.
void read_axes(Keys& keys, BearingSpecOf<3>& spec) {
  const double azimuth = keys.number("angle", "rad", 0);
  const bool turned = keys.has("turn");
  SolidTurn turn;
  read_table<TurnKeys>(keys, "turn", turn_wanted, turn);
  if (turned && azimuth != 0) keys.problem("both angle and turn are given; angle is for a turn about z");
  if (turned && !(turn.axis.norm() > 0)) return keys.problem("'turn': axis has no length");
  spec.angle = turned ? checked_turn(turn, keys.owner()) : rotation_by(Vec3(0, 0, azimuth));
}

template <int D>
void read_successor(Keys& keys, ScriptModel& m, BearingSpecOf<D>& spec) {
  lua_State* L = keys.lua();
  const int type = keys.push("becomes");
  if (type == LUA_TSTRING) {
    const std::string name = text_at(L, -1);
    const auto laws = m.law_names();
    (std::find(laws.begin(), laws.end(), name) != laws.end() ? spec.contact_after : spec.becomes_bearing) = name;
  } else if (const auto* law = type == LUA_TNIL ? nullptr : test_handle<ContactLawValue>(L, -1)) {
    keys.finish();
    spec.contact_after = require_law(m, *law, "");
  } else if (const auto* bearing = type == LUA_TNIL ? nullptr : test_handle<BearingHandle>(L, -1)) {
    try {
      spec.becomes_bearing = m.bearings[static_cast<std::size_t>(require_own(*bearing, m, "").index)];
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (type != LUA_TNIL) {
    keys.wrong("becomes", "a contact law, or the name of one or of another bearing");
  }
  lua_pop(L, 1);
}

/// The two bodies under `between`: handles or names.
void read_between(Keys& keys, const ScriptModel& m, std::string& body_a, std::string& body_b) {
  lua_State* L = keys.lua();
  const int type = keys.push("between");
  if (type == LUA_TTABLE && lua_rawlen(L, -1) == 2) {
    for (int i = 1; i <= 2; ++i) {
      lua_rawgeti(L, -1, i);
      std::string& body = i == 1 ? body_a : body_b;
      if (lua_type(L, -1) != LUA_TSTRING && test_handle<BodyHandle>(L, -1) == nullptr) {
        keys.problem(fmt::format("entry {} of 'between' is {}, must be a body or its name", i, what_is(L, -1)));
      } else {
        try {
          body = m.body_name(row_at<BodyHandle>(L, -1, m, ""));
        } catch (const InputError& e) {
          keys.problem(e.what());
        }
      }
      lua_pop(L, 1);
    }
  } else if (type == LUA_TNIL) {
    keys.missing("between", "two bodies or their names");
  } else {
    keys.wrong("between", "two bodies or their names");
  }
  lua_pop(L, 1);
}

template <int D, class M>
void add_bearing_to(lua_State* L, M& m) {
  m.adding();
  Keys keys(L, 2, "bearing");
  BearingSpecOf<D> spec;
  spec.name = keys.text("name");
  keys.name_owner(spec.name);
  read_between(keys, m, spec.body_a, spec.body_b);
  read_points(keys, spec);
  read_axes(keys, spec);
  read_directions(keys, spec);
  spec.starts_waiting = keys.flag("waiting", false);
  spec.replaces_contact = keys.flag("replaces_contact", false);
  read_successor(keys, m, spec);
  read_becomes_from<D>(keys, spec.next_from_here);
  keys.finish();
  m.builder.add_bearing(spec);
  m.bearings.push_back(spec.name);
  m.catch_up();
}

int add_bearing(lua_State* L) {
  ScriptModel& m = this_model(L);
  if (SpaceModel* space = as_space(m))
    add_bearing_to<3>(L, *space);
  else
    add_bearing_to<2>(L, *as_plane(m));
  push_bearing(L, 1, static_cast<int>(m.bearings.size()) - 1);
  return 1;
}

const std::array bearing_method_list{
    Method{"bearing", guarded<add_bearing>},
    Method{"seat", guarded<add_seat>},
};

/// The table on top of the stack: displacement limits by direction. Missing directions keep their limit, or have none.
template <int D>
void read_limit_table(Keys& keys, BearingSpecOf<D>& spec, OtherLimits others) {
  Keys own(keys.lua(), -1, "limit");
  bool any = false;
  const auto read = [&](const char* key, std::string_view unit, double& limit) {
    any = any || own.has(key);
    limit = own.number(key, unit, others == OtherLimits::kept ? limit : unbounded);
  };
  const auto& names = Directions<D>::names;
  for (std::size_t k = 0; k < names.size(); ++k)
    read(names[k], unit_of_direction<D>(static_cast<int>(k)), spec.limit[k]);
  if constexpr (D == 3) read("horizontal", "m", spec.horizontal_limit);
  if (!any) own.problem("no direction is named; give the displacement of one, as in limit = { along = 0.1 }");
  try {
    own.finish();
  } catch (const InputError& e) {
    keys.problem(e.what());
  }
}

}  // namespace

template <int D>
void read_directions(Keys& keys, BearingSpecOf<D>& spec, OtherLimits others) {
  const auto& names = Directions<D>::names;
  const auto read_law = [&](const char* key, DirectionLaw& law) {
    if (const auto* given = keys.maybe_handle<DirectionLawValue>(key)) law = given->law;
  };
  for (std::size_t k = 0; k < names.size(); ++k) read_law(names[k], spec.law[k]);
  if constexpr (D == 3) read_law("horizontal", spec.horizontal);
  const int type = keys.push("limit");
  if (type == LUA_TTABLE)
    read_limit_table(keys, spec, others);
  else if (type != LUA_TNIL)
    keys.wrong("limit", D == 2 ? "a table { along = , axial = , turning = }"
                               : "a table { along = , across = , horizontal = , axial = , turning_along = , ... }");
  lua_pop(keys.lua(), 1);
}
template void read_directions(Keys&, BearingSpecOf<2>&, OtherLimits);
template void read_directions(Keys&, BearingSpecOf<3>&, OtherLimits);

template <int D>
void read_becomes_from(Keys& keys, std::array<bool, Space<D>::dofs>& from_here) {
  const auto is_here = [](Keys& own, const char* key, bool preset) {
    return own.choice(key, {"start", "here"}, preset ? 1 : 0) == 1;
  };
  lua_State* L = keys.lua();
  const int type = keys.push("becomes_from");
  if (type == LUA_TTABLE) {
    Keys own(L, -1, "becomes_from");
    if constexpr (D == 3)
      if (own.has("horizontal")) from_here[0] = from_here[1] = is_here(own, "horizontal", false);
    for (std::size_t k = 0; k < from_here.size(); ++k)
      from_here[k] = is_here(own, Directions<D>::names[k], from_here[k]);
    try {
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (type == LUA_TSTRING) {
    from_here.fill(is_here(keys, "becomes_from", false));
  } else if (type != LUA_TNIL) {
    keys.problem(fmt::format(
        "'becomes_from' is {}, must be \"start\", \"here\", or a table as in {{ along = \"here\" }}", what_is(L, -1)));
  }
  lua_pop(L, 1);
}
template void read_becomes_from<2>(Keys&, std::array<bool, 3>&);
template void read_becomes_from<3>(Keys&, std::array<bool, 6>&);

std::span<const Method> bearing_methods() {
  return bearing_method_list;
}

}  // namespace trilith::script
