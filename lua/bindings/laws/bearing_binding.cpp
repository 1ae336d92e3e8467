// Bearings.
#include <algorithm>
#include <cmath>

#include "assembly/bearing_motion.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/geometry/declared_reading.hpp"
#include "bindings/laws/bearing_reading.hpp"
#include "build/space/solid_part.hpp"
#include "model/pose.hpp"

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

/// Parts that a handler adds enter the model at the next step border.
void require_there(std::size_t count, std::size_t row, const std::string& title) {
  if (row >= count) throw InputError(title + " is added at the next step border");
}

/// A bearing in its present state, in a model of D dimensions.
template <int D>
struct LiveBearing {
  const Model<D>& model;
  const State<D>& state;
  const Work<D>& work;
  std::size_t row;

  [[nodiscard]] const Bearing<D>& bearing() const { return model.bearings[row]; }
  [[nodiscard]] bool carries() const { return is_live(state.bearing[row].status); }
  [[nodiscard]] double force(std::size_t k) const {
    const DirectionMemory& memory = work.bearing[row].direction[k];
    return carries() ? memory.force + memory.damping : 0;
  }
};

template <int D>
LiveBearing<D> live_in(SimulatedModel<D>& m, const BearingHandle& b) {
  const Simulation<D>& s = m.evaluated();
  require_there(s.model().bearings.size(), static_cast<std::size_t>(b.index), Kind<BearingHandle>::title(b));
  return {s.model(), s.state(), s.work(), static_cast<std::size_t>(b.index)};
}

/// f(LiveBearing) for the dimension of its model.
template <class F>
auto with_live(const BearingHandle& b, F&& f) {
  if (SpaceModel* space = as_space(b.model())) return f(live_in<3>(*space, b));
  return f(live_in<2>(b.plane(), b));
}

std::array<double, 3> displacements(const LiveBearing<2>& l) {
  const Bearing<2>& b = l.bearing();
  const Pose p = pose_at(l.model, l.state, b.end_a), q = pose_at(l.model, l.state, b.end_b);
  const Vec2 d = Turn(p.rotation + b.angle).undo(Vec2(q.place - p.place)) - b.rest;
  return {d.x(), d.y(), q.rotation - p.rotation - b.rest_angle};
}
std::array<double, 6> displacements(const LiveBearing<3>& l) {
  return bearing_motion(l.model, l.state, l.row).displacement;
}

/// Largest displacement over its limit, of all directions.
double share_of(const BearingHandle& b) {
  return with_live(b, []<int D>(const LiveBearing<D>& l) {
    const auto d = bearing_motion(l.model, l.state, l.row).counted(l.state.bearing[l.row]);
    const auto share = [](double size, double limit) { return std::isfinite(limit) ? std::abs(size) / limit : 0.0; };
    double most = 0;
    for (std::size_t k = 0; k < d.size(); ++k) most = std::max(most, share(d[k], l.bearing().limit[k]));
    if constexpr (D == 3) most = std::max(most, share(portable::hypot(d[0], d[1]), l.bearing().horizontal_limit));
    return most;
  });
}

bool is_limited(const BearingHandle& b) {
  return with_live(b, []<int D>(const LiveBearing<D>& l) {
    const auto& limit = l.bearing().limit;
    bool any = std::any_of(limit.begin(), limit.end(), [](double v) { return std::isfinite(v); });
    if constexpr (D == 3) any = any || std::isfinite(l.bearing().horizontal_limit);
    return any;
  });
}

// Directions by their index in the plane and in space.

/// The index in D dimensions.
template <int D, std::size_t in_plane, std::size_t in_space>
constexpr std::size_t direction_in() {
  if constexpr (D == 2)
    return in_plane;
  else
    return in_space;
}

template <std::size_t in_plane, std::size_t in_space>
double force(const BearingHandle& b) {
  return with_live(b, []<int D>(const LiveBearing<D>& l) { return l.force(direction_in<D, in_plane, in_space>()); });
}
template <std::size_t in_plane, std::size_t in_space>
double displacement(const BearingHandle& b) {
  return with_live(
      b, []<int D>(const LiveBearing<D>& l) { return displacements(l)[direction_in<D, in_plane, in_space>()]; });
}
/// Value of a direction that only models in space have.
template <std::size_t k>
double force_in_space(const BearingHandle& b) {
  return force<0, k>(b);
}
template <std::size_t k>
double displacement_in_space(const BearingHandle& b) {
  return displacement<0, k>(b);
}
double resultant_force(const BearingHandle& b) {
  return portable::hypot(force_in_space<0>(b), force_in_space<1>(b));
}
double resultant_displacement(const BearingHandle& b) {
  return portable::hypot(displacement_in_space<0>(b), displacement_in_space<1>(b));
}

template <bool forces>
void push_directions(lua_State* L, const BearingHandle& b) {
  with_live(b, [&]<int D>(const LiveBearing<D>& l) {
    const auto d = displacements(l);
    lua_createtable(L, 0, static_cast<int>(d.size()));
    for (std::size_t k = 0; k < d.size(); ++k) {
      lua_pushnumber(L, forces ? l.force(k) : d[k]);
      lua_setfield(L, -2, Directions<D>::names[k]);
    }
  });
}

const std::string& name_of_row(const BearingHandle& b) {
  return b.model().bearings[static_cast<std::size_t>(b.index)];
}

void push_bodies(lua_State* L, const BearingHandle& b) {
  const auto [first, second] =
      with_live(b, [](const auto& l) { return std::pair(l.bearing().body_a, l.bearing().body_b); });
  lua_getiuservalue(L, 1, 1);
  const int model = lua_gettop(L);
  lua_createtable(L, 2, 0);
  push_body(L, model, first);
  lua_rawseti(L, -2, 1);
  push_body(L, model, second);
  lua_rawseti(L, -2, 2);
}

void push_status(lua_State* L, const BearingHandle& b) {
  lua_pushstring(L, name_of(with_live(b, [](const auto& l) { return l.state.bearing[l.row].status; })));
}

using BearingProperty = Property<BearingHandle>;
constexpr BearingProperty in_dimension(int dim, BearingProperty p) {
  p.dim = dim;
  return p;
}
const std::array bearing_properties{
    BearingProperty{"name", "", "its name", nullptr,
                    [](lua_State* L, const BearingHandle& b) { lua_pushstring(L, name_of_row(b).c_str()); }},
    BearingProperty{"status", "", "waiting, intact, yielded, failed, changed or removed", nullptr, push_status},
    BearingProperty{"bodies", "", "the two bodies it links", nullptr, push_bodies},
    BearingProperty{"force", "",
                    "forces and moments of its laws [N, N m]: { along, axial, turning }, in space { along, across, "
                    "axial, turning_along, turning_across, turning_axial }",
                    nullptr, push_directions<true>},
    BearingProperty{"displacement", "", "displacements and rotations since it was placed [m, rad], likewise", nullptr,
                    push_directions<false>},
    BearingProperty{"force_along", "N", "force of the law along", force<along, 0>},
    in_dimension(3, {"force_across", "N", "force of the law across", force_in_space<1>}),
    BearingProperty{"force_axial", "N", "force of the axial law", force<axial, 2>},
    in_dimension(3, {"force_horizontal", "N", "resultant of the forces along and across", resultant_force}),
    in_dimension(2, {"moment", "N m", "moment of the law of turning", force<turning, 0>}),
    in_dimension(3, {"moment_along", "N m", "moment of the law of turning about along", force_in_space<3>}),
    in_dimension(3, {"moment_across", "N m", "moment of the law of turning about across", force_in_space<4>}),
    in_dimension(3, {"moment_axial", "N m", "moment of the law of turning about axial", force_in_space<5>}),
    BearingProperty{"displacement_along", "m", "displacement along", displacement<along, 0>},
    in_dimension(3, {"displacement_across", "m", "displacement across", displacement_in_space<1>}),
    BearingProperty{"displacement_axial", "m", "axial displacement", displacement<axial, 2>},
    in_dimension(
        3, {"displacement_horizontal", "m", "resultant of the displacements along and across", resultant_displacement}),
    in_dimension(2, {"turning", "rad", "rotation of the second body against the first", displacement<turning, 0>}),
    in_dimension(
        3, {"turning_along", "rad", "turn of the second body against the first about along", displacement_in_space<3>}),
    in_dimension(3, {"turning_across", "rad", "... about across", displacement_in_space<4>}),
    in_dimension(3, {"turning_axial", "rad", "... about axial", displacement_in_space<5>}),
    BearingProperty{"limited", "", "true if a displacement has a limit", nullptr,
                    [](lua_State* L, const BearingHandle& b) { lua_pushboolean(L, is_limited(b) ? 1 : 0); }},
    BearingProperty{"share", "1", "largest displacement over its limit", share_of},
};

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

}  // namespace trilith::script
