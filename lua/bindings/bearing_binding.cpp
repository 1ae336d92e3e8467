// Bearings and seats.
#include <algorithm>
#include <cmath>

#include "bearing_reading.hpp"
#include "bindings.hpp"
#include "step/find_events.hpp"
#include "world/pose.hpp"

namespace trilith::script {
namespace {

constexpr std::array<const char*, 3> direction_names{"along", "axial", "turning"};

void read_points(Keys& keys, BearingSpec& spec) {
  const auto at = keys.maybe_point("at"), from = keys.maybe_point("from"), to = keys.maybe_point("to");
  if (at && (from || to)) keys.problem("both at and from, to are given; at is for zero length");
  if (!at && !(from && to)) keys.problem("its place is missing; give at = {x, y}, or from = {x, y} and to = {x, y}");
  spec.point_a = at ? *at : from.value_or(Vec2::Zero());
  spec.point_b = at ? *at : to.value_or(Vec2::Zero());
}

void read_successor(Keys& keys, PlaneModel& m, BearingSpec& spec) {
  lua_State* L = keys.lua();
  const int type = keys.push("becomes");
  if (type == LUA_TSTRING) {
    const std::string name = text_at(L, -1);
    const auto laws = m.builder.law_names();
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
void read_between(Keys& keys, const PlaneModel& m, BearingSpec& spec) {
  lua_State* L = keys.lua();
  const int type = keys.push("between");
  if (type == LUA_TTABLE && lua_rawlen(L, -1) == 2) {
    for (int i = 1; i <= 2; ++i) {
      lua_rawgeti(L, -1, i);
      std::string& body = i == 1 ? spec.body_a : spec.body_b;
      if (lua_type(L, -1) != LUA_TSTRING && test_handle<BodyHandle>(L, -1) == nullptr) {
        keys.problem(fmt::format("entry {} of 'between' is {}, must be a body or its name", i, what_is(L, -1)));
      } else {
        try {
          body = m.builder.bodies()[static_cast<std::size_t>(row_at<BodyHandle>(L, -1, m, ""))].name;
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

int add_bearing(lua_State* L) {
  PlaneModel& m = this_plane(L);
  m.adding();
  Keys keys(L, 2, "bearing");
  BearingSpec spec;
  spec.name = keys.text("name");
  keys.name_owner(spec.name);
  read_between(keys, m, spec);
  read_points(keys, spec);
  spec.angle = keys.number("angle", "rad", 0);
  read_directions(keys, spec);
  spec.starts_waiting = keys.flag("waiting", false);
  spec.replaces_contact = keys.flag("replaces_contact", false);
  read_successor(keys, m, spec);
  keys.finish();
  m.builder.add_bearing(spec);
  m.bearings.push_back(spec.name);
  m.catch_up();
  push_bearing(L, 1, static_cast<int>(m.bearings.size()) - 1);
  return 1;
}

int add_seat(lua_State* L) {
  PlaneModel& m = this_plane(L);
  m.adding();
  Keys keys(L, 2, "seat");
  SeatSpec spec;
  spec.name = keys.text("name");
  keys.name_owner(spec.name);
  spec.body = body_name(keys, "body", m);
  spec.support = body_name(keys, "support", m);
  spec.end = keys.point("at_end");
  spec.edge = keys.point("edge");
  spec.inward = keys.point("inward", spec.inward);
  keys.finish();
  m.builder.add_seat(spec);
  m.seats.push_back(spec.name);
  m.catch_up();
  push_seat(L, 1, static_cast<int>(m.seats.size()) - 1);
  return 1;
}

/// What a handler adds is in the model from the next step border on.
void require_there(std::size_t count, std::size_t row, const std::string& title) {
  if (row >= count) throw InputError(title + " is added at the next step border");
}

struct LiveBearing {
  const Model<2>& model;
  const State<2>& state;
  const Work<2>& work;
  const Bearing<2>& bearing;
  const BearingMemory& memory;
  std::size_t row;
};

LiveBearing live(const BearingHandle& b) {
  const Simulation<2>& s = b.plane().evaluated();
  const auto row = static_cast<std::size_t>(b.index);
  require_there(s.model().bearings.size(), row, Kind<BearingHandle>::title(b));
  return {s.model(), s.state(), s.work(), s.model().bearings[row], s.work().bearing[row], row};
}

double force_of(const BearingHandle& b, std::size_t k) {
  const LiveBearing l = live(b);
  if (!is_live(l.state.bearing[l.row].status)) return 0;
  return l.memory.direction[k].force + l.memory.direction[k].damping;
}

double displacement_of(const BearingHandle& b, std::size_t k) {
  const LiveBearing l = live(b);
  const Pose a = pose_at(l.model, l.state, l.bearing.end_a), b_end = pose_at(l.model, l.state, l.bearing.end_b);
  if (k == turning) return b_end.rotation - a.rotation - l.bearing.rest_angle;
  const Vec2 d = Turn(a.rotation + l.bearing.angle).undo(Vec2(b_end.place - a.place)) - l.bearing.rest;
  return d[static_cast<Eigen::Index>(k)];
}

/// Largest displacement over its limit, of the three directions.
double share_of(const BearingHandle& b) {
  const LiveBearing l = live(b);
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (std::isfinite(l.bearing.limit[k])) most = std::max(most, std::abs(displacement_of(b, k)) / l.bearing.limit[k]);
  return most;
}

template <std::size_t k>
double force(const BearingHandle& b) {
  return force_of(b, k);
}
template <std::size_t k>
double displacement(const BearingHandle& b) {
  return displacement_of(b, k);
}

template <double (*of)(const BearingHandle&, std::size_t)>
void push_directions(lua_State* L, const BearingHandle& b) {
  lua_createtable(L, 0, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    lua_pushnumber(L, of(b, k));
    lua_setfield(L, -2, direction_names[k]);
  }
}

const std::string& name_of_row(const BearingHandle& b) {
  return b.model().bearings[static_cast<std::size_t>(b.index)];
}

void push_bodies(lua_State* L, const BearingHandle& b) {
  const LiveBearing l = live(b);
  lua_getiuservalue(L, 1, 1);
  const int model = lua_gettop(L);
  lua_createtable(L, 2, 0);
  push_body(L, model, l.bearing.body_a);
  lua_rawseti(L, -2, 1);
  push_body(L, model, l.bearing.body_b);
  lua_rawseti(L, -2, 2);
}

using BearingProperty = Property<BearingHandle>;
const std::array bearing_properties{
    BearingProperty{"name", "", "its name", nullptr,
                    [](lua_State* L, const BearingHandle& b) { lua_pushstring(L, name_of_row(b).c_str()); }},
    BearingProperty{"status", "", "waiting, intact, yielded, failed, changed or removed", nullptr,
                    [](lua_State* L, const BearingHandle& b) {
                      const LiveBearing l = live(b);
                      lua_pushstring(L, name_of(l.state.bearing[l.row].status));
                    }},
    BearingProperty{"bodies", "", "the two bodies it links", nullptr, push_bodies},
    BearingProperty{"force", "", "forces of its laws { along, axial, turning } [N, N, N m]", nullptr,
                    push_directions<force_of>},
    BearingProperty{"displacement", "", "{ along, axial, turning } since it was placed [m, m, rad]", nullptr,
                    push_directions<displacement_of>},
    BearingProperty{"force_along", "N", "force of the law along", force<along>},
    BearingProperty{"force_axial", "N", "force of the axial law", force<axial>},
    BearingProperty{"moment", "N m", "moment of the law of turning", force<turning>},
    BearingProperty{"displacement_along", "m", "displacement along", displacement<along>},
    BearingProperty{"displacement_axial", "m", "axial displacement", displacement<axial>},
    BearingProperty{"turning", "rad", "rotation of the second body against the first", displacement<turning>},
    BearingProperty{"limited", "", "true where some displacement ends it", nullptr,
                    [](lua_State* L, const BearingHandle& b) {
                      const auto& limit = live(b).bearing.limit;
                      lua_pushboolean(
                          L, std::any_of(limit.begin(), limit.end(), [](double l) { return std::isfinite(l); }));
                    }},
    BearingProperty{"share", "1", "largest displacement over its limit", share_of},
};

const std::string& name_of_seat(const SeatHandle& s) {
  return s.model().seats[static_cast<std::size_t>(s.index)];
}

using SeatProperty = Property<SeatHandle>;
const std::array seat_properties{
    SeatProperty{"name", "", "its name", nullptr,
                 [](lua_State* L, const SeatHandle& s) { lua_pushstring(L, name_of_seat(s).c_str()); }},
    SeatProperty{"length", "m", "how far the end still reaches over the edge",
                 [](const SeatHandle& s) {
                   const Simulation<2>& sim = s.plane().simulation();
                   return seat_length(sim.model(), sim.state(), sim.model().seats[static_cast<std::size_t>(s.index)]);
                 }},
    SeatProperty{"lost", "", "true once the end has left its seat", nullptr,
                 [](lua_State* L, const SeatHandle& s) {
                   lua_pushboolean(L, s.plane().simulation().state().seat_lost[static_cast<std::size_t>(s.index)]);
                 }},
};

const std::array bearing_method_list{
    Method{"bearing", guarded<add_bearing>,
           "bearing{name=, between=, at= | from=, to=, along=, axial=, turning=, limit=, becomes=, waiting=}"},
    Method{"seat", guarded<add_seat>, "seat{name=, body=, support=, at_end=, edge=, inward=}"},
};

}  // namespace

void read_directions(Keys& keys, BearingSpec& spec) {
  for (std::size_t k = 0; k < 3; ++k)
    if (const auto* law = keys.maybe_handle<DirectionLawValue>(direction_names[k])) spec.law[k] = law->law;
  lua_State* L = keys.lua();
  const int type = keys.push("limit");
  if (type == LUA_TTABLE) {
    Keys own(L, -1, "limit");
    for (std::size_t k = 0; k < 3; ++k)
      spec.limit[k] = own.number(direction_names[k], k == turning ? "rad" : "m", unbounded);
    try {
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (type != LUA_TNIL) {
    keys.wrong("limit", "a table { along = , axial = , turning = }");
  }
  lua_pop(L, 1);
}

std::span<const Method> bearing_methods() {
  return bearing_method_list;
}

std::span<const Property<BearingHandle>> Kind<BearingHandle>::properties() {
  return bearing_properties;
}
std::span<const Method> Kind<BearingHandle>::methods() {
  return {};
}
std::string Kind<BearingHandle>::title(const BearingHandle& b) {
  return b.open() ? fmt::format("bearing '{}'", name_of_row(b)) : "bearing of a closed model";
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<BearingHandle>::metamethods() {
  return {};
}
bool Kind<BearingHandle>::read_item(lua_State*, const BearingHandle&) {
  return false;
}

std::span<const Property<SeatHandle>> Kind<SeatHandle>::properties() {
  return seat_properties;
}
std::span<const Method> Kind<SeatHandle>::methods() {
  return {};
}
std::string Kind<SeatHandle>::title(const SeatHandle& s) {
  return s.open() ? fmt::format("seat '{}'", name_of_seat(s)) : "seat of a closed model";
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<SeatHandle>::metamethods() {
  return {};
}
bool Kind<SeatHandle>::read_item(lua_State*, const SeatHandle&) {
  return false;
}

}  // namespace trilith::script
