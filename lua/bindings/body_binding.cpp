// Bodies: their properties, and sets of them.
#include <algorithm>
#include <cmath>

#include "bindings.hpp"
#include "body_reading.hpp"
#include "bridge_book.hpp"
#include "handles.hpp"
#include "run/storey_damage.hpp"
#include "step/element_stress.hpp"
#include "table_fields.hpp"
#include "world/pose.hpp"
#include "world/space_builder.hpp"

namespace trilith::script {
namespace {

const std::string& name_of_body(const BodyHandle& b) {
  return b.model().body_name(b.index);
}
const BodySpec& spec(const BodyHandle& b) {
  return b.plane().spec(b.index);
}

/// Where a body is and how it moves, in the plane with z = 0 and turning about z.
struct BodyMotion {
  Vec3 place = Vec3::Zero(), moved = Vec3::Zero();  ///< of its centroid, and since the start [m]
  Vec3 turned = Vec3::Zero();                       ///< rotation vector since the start [rad]
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};

Vec3 lifted(const Vec2& v) {
  return {v.x(), v.y(), 0};
}

BodyMotion motion_in_plane(const PlaneModel& m, int body) {
  const BodySpec& spec = m.spec(body);
  const Simulation<2>* s = m.has_body(body) ? m.if_built() : nullptr;
  const Pose pose = s != nullptr ? body_pose(s->model(), s->state(), body)
                                 : Pose{polygon_moments(spec.outline).centroid, 0, spec.velocity, spec.spin};
  const Vec2 moved = s != nullptr ? Vec2(pose.place - body_start(s->model(), body)) : Vec2(Vec2::Zero());
  return {lifted(pose.place), lifted(moved), {0, 0, pose.rotation}, lifted(pose.velocity), {0, 0, pose.spin}};
}

BodyMotion motion_in_space(const SpaceModel& m, int body) {
  const Simulation<3>* s = m.has_body(body) ? m.if_built() : nullptr;
  if (s == nullptr) {
    const SolidSpec& spec = m.spec(body);
    return {mass_of(spec.pieces, 1, spec.spheres).centroid, Vec3::Zero(), Vec3::Zero(), spec.velocity, spec.spin};
  }
  const auto n = static_cast<std::size_t>(s->model().bodies[static_cast<std::size_t>(body)].first_node);
  const State<3>& state = s->state();
  return {state.position[n], state.position[n] - s->model().start_position[n],
          angle_of(state.rotation[n] * inverse(s->model().start_rotation[n])), state.velocity[n], state.spin[n]};
}

BodyMotion motion(const BodyHandle& b) {
  if (const PlaneModel* plane = as_plane(b.model())) return motion_in_plane(*plane, b.index);
  return motion_in_space(static_cast<const SpaceModel&>(b.model()), b.index);
}
Vec2 start_place(const BodyHandle& b) {
  return polygon_moments(spec(b).outline).centroid;
}
Vec2 place(const BodyHandle& b) {
  return motion(b).place.head<2>();
}
double rotation(const BodyHandle& b) {
  return motion_in_plane(b.plane(), b.index).turned.z();
}
double spin(const BodyHandle& b) {
  return motion_in_plane(b.plane(), b.index).spin.z();
}

template <Vec3 BodyMotion::*vector, int axis>
double along_axis(const BodyHandle& b) {
  return (motion(b).*vector)[axis];
}

void push_text(lua_State* L, const std::string& text) {
  lua_pushlstring(L, text.data(), text.size());
}

void push_outline(lua_State* L, const BodyHandle& b) {
  const Simulation<2>* s = b.plane().if_built();
  const bool deforms = s != nullptr && !s->model().bodies[b.index].is_rigid();
  const Vec2 start = start_place(b), now = place(b);
  const Turn turn(rotation(b));
  lua_newtable(L);
  lua_Integer i = 0;
  for (const Vec2& p : spec(b).outline) {
    const Vec2 at =
        deforms ? skin_place(s->model(), s->state(), s->model().bodies[b.index].first_skin + static_cast<int>(i))
                : Vec2(now + turn.apply(Vec2(p - start)));
    lua_createtable(L, 2, 0);
    for (int k = 0; k < 2; ++k) {
      lua_pushnumber(L, at[k]);
      lua_rawseti(L, -2, k + 1);
    }
    lua_rawseti(L, -2, ++i);
  }
}

void push_groups(lua_State* L, const BodyHandle& b) {
  lua_newtable(L);
  lua_Integer i = 0;
  for (const std::string& g : b.model().groups_of(b.index)) {
    push_text(L, g);
    lua_rawseti(L, -2, ++i);
  }
}

/// A mean over the area of a deformable body; 0 for a rigid one and before the first stage.
template <class Value>
double mean_stress(const BodyHandle& b, Value&& value) {
  const Simulation<2>* s = b.plane().if_built();
  if (s == nullptr) return 0;
  double sum = 0, area = 0;
  for (std::size_t e = 0; e < s->model().elements.size(); ++e) {
    if (s->model().elements[e].body != b.index) continue;
    const ElementStress stress = element_stress(s->model(), s->state(), static_cast<int>(e));
    sum += stress.area * value(stress);
    area += stress.area;
  }
  return area > 0 ? sum / area : 0;
}

/// Pushes { left =, right = } with those of `names` that are at the ends of the span; nil for any other body.
template <void (*push)(lua_State*, int, int)>
void push_ends(lua_State* L, const BodyHandle& b, const std::vector<std::string>& names) {
  const std::string& span = spec(b).name;
  const auto is_span = [&](const LaidSpan& laid) { return laid.deck.name == span; };
  const auto& book = b.plane().bridge;
  if (!book || std::none_of(book->layout.spans().begin(), book->layout.spans().end(), is_span)) {
    lua_pushnil(L);
    return;
  }
  lua_getiuservalue(L, 1, 1);
  lua_createtable(L, 0, 2);
  for (const std::size_t side : {0, 1}) {
    const auto found = std::find(names.begin(), names.end(), span_end_name(span, side));
    if (found == names.end()) continue;
    push(L, -2, static_cast<int>(found - names.begin()));
    lua_setfield(L, -2, side == 0 ? "left" : "right");
  }
}

using BodyProperty = Property<BodyHandle>;
BodyProperty in_plane(BodyProperty p) {
  p.dim = 2;
  return p;
}
BodyProperty in_space(BodyProperty p) {
  p.dim = 3;
  return p;
}

const std::array body_properties{
    BodyProperty{"name", "", "its name", nullptr,
                 [](lua_State* L, const BodyHandle& b) { push_text(L, name_of_body(b)); }},
    BodyProperty{"material", "", "name of its material", nullptr,
                 [](lua_State* L, const BodyHandle& b) { push_text(L, b.model().material_of(b.index)); }},
    BodyProperty{"groups", "", "names of its groups", nullptr, push_groups},
    BodyProperty{
        "present", "", "false where it was removed, or is added at the next step border", nullptr,
        [](lua_State* L, const BodyHandle& b) { lua_pushboolean(L, b.model().why_absent(b.index).empty() ? 1 : 0); }},
    BodyProperty{"removed_at", "", "when it was removed [s]; nil where it was not, or is back", nullptr,
                 [](lua_State* L, const BodyHandle& b) {
                   if (const auto when = b.model().removed_at(b.index))
                     lua_pushnumber(L, *when);
                   else
                     lua_pushnil(L);
                 }},
    in_plane(BodyProperty{"outline", "", "its corners {x, y} where they are now [m]", nullptr, push_outline}),
    BodyProperty{"x", "m", "place of the centroid", along_axis<&BodyMotion::place, 0>},
    BodyProperty{"y", "m", "height of the centroid; in space its place along y", along_axis<&BodyMotion::place, 1>},
    in_space(BodyProperty{"z", "m", "height of the centroid in space", along_axis<&BodyMotion::place, 2>}),
    in_plane(BodyProperty{"rotation", "rad", "counter-clockwise turn since the start, in the plane", rotation}),
    in_space(BodyProperty{"turn_x", "rad", "turn since the start in space: rotation vector along x",
                          along_axis<&BodyMotion::turned, 0>}),
    in_space(BodyProperty{"turn_y", "rad", "... along y", along_axis<&BodyMotion::turned, 1>}),
    in_space(BodyProperty{"turn_z", "rad", "... along z", along_axis<&BodyMotion::turned, 2>}),
    BodyProperty{"vx", "m/s", "velocity of the centroid along x", along_axis<&BodyMotion::velocity, 0>},
    BodyProperty{"vy", "m/s", "velocity of the centroid along y", along_axis<&BodyMotion::velocity, 1>},
    in_space(
        BodyProperty{"vz", "m/s", "velocity of the centroid along z, in space", along_axis<&BodyMotion::velocity, 2>}),
    in_plane(BodyProperty{"spin", "rad/s", "rate of rotation, in the plane", spin}),
    in_space(BodyProperty{"spin_x", "rad/s", "rate of rotation about x, in space", along_axis<&BodyMotion::spin, 0>}),
    in_space(BodyProperty{"spin_y", "rad/s", "rate of rotation about y, in space", along_axis<&BodyMotion::spin, 1>}),
    in_space(BodyProperty{"spin_z", "rad/s", "rate of rotation about z, in space", along_axis<&BodyMotion::spin, 2>}),
    BodyProperty{"ux", "m", "displacement along x since the start", along_axis<&BodyMotion::moved, 0>},
    BodyProperty{"uy", "m", "displacement along y since the start", along_axis<&BodyMotion::moved, 1>},
    in_space(
        BodyProperty{"uz", "m", "displacement along z since the start, in space", along_axis<&BodyMotion::moved, 2>}),
    BodyProperty{"speed", "m/s", "speed of the centroid",
                 [](const BodyHandle& b) { return motion(b).velocity.norm(); }},
    BodyProperty{"mass", "kg", "mass", [](const BodyHandle& b) { return b.model().mass_of(b.index); }},
    in_plane(BodyProperty{"inertia", "kg m2", "moment of inertia about the centroid",
                          [](const BodyHandle& b) { return b.plane().inertia_of(b.index); }}),
    in_plane(BodyProperty{"area", "m2", "area of the outline",
                          [](const BodyHandle& b) { return polygon_moments(spec(b).outline).area; }}),
    BodyProperty{"kind", "", "\"rigid\", \"quad\" or \"mesh\"", nullptr,
                 [](lua_State* L, const BodyHandle& b) {
                   const PlaneModel* plane = as_plane(b.model());
                   push_text(L, std::string(name_of(plane != nullptr ? plane->spec(b.index).kind : BodyKind::rigid)));
                 }},
    in_plane(BodyProperty{
        "sxx", "Pa", "mean stress along x of a deformable body",
        [](const BodyHandle& b) { return mean_stress(b, [](const ElementStress& e) { return in_world(e).xx; }); }}),
    in_plane(BodyProperty{
        "syy", "Pa", "mean stress along y of a deformable body",
        [](const BodyHandle& b) { return mean_stress(b, [](const ElementStress& e) { return in_world(e).yy; }); }}),
    in_plane(BodyProperty{
        "sxy", "Pa", "mean shear stress of a deformable body",
        [](const BodyHandle& b) { return mean_stress(b, [](const ElementStress& e) { return in_world(e).xy; }); }}),
    in_plane(BodyProperty{
        "plastic", "1", "mean plastic measure of a deformable body",
        [](const BodyHandle& b) { return mean_stress(b, [](const ElementStress& e) { return e.plastic; }); }}),
    in_plane(BodyProperty{
        "bearings", "", "of a span made with from and to: { left, right }; a side without a bearing is nil", nullptr,
        [](lua_State* L, const BodyHandle& b) { push_ends<push_bearing>(L, b, b.model().bearings); }}),
    in_plane(BodyProperty{"seats", "", "of a span made with from and to: { left, right }", nullptr,
                          [](lua_State* L, const BodyHandle& b) { push_ends<push_seat>(L, b, b.model().seats); }}),
    BodyProperty{"resting", "", "true while it has been still for the model's still_time", nullptr,
                 [](lua_State* L, const BodyHandle& b) { lua_pushboolean(L, b.model().is_resting(b.index) ? 1 : 0); }},
};

/// body:point{x, y}: where a point that was there at the start is now.
int body_point(lua_State* L) {
  const auto& b = handle<BodyHandle>(L, 1);
  b.model().require_present(b.index, "point");
  const PlaneModel& plane = b.plane();  // in space that is what is wrong first
  const auto at = point_at(L, 2);
  if (!at) throw InputError(fmt::format("point: takes {{x, y}}, two finite numbers; this is {}", what_is(L, 2)));
  const Simulation<2>* s = plane.if_built();
  Vec2 now = *at;
  if (s != nullptr) {
    const Tie<2> tied = tie_point(s->model(), b.index, *at, fmt::format("point of body '{}'", spec(b).name));
    now = pose_at(s->model(), s->state(), tied).place;
  }
  lua_pushnumber(L, now.x());
  lua_pushnumber(L, now.y());
  return 2;
}

const std::array body_methods{
    Method{"point", guarded<body_point>, "point{x, y}: x and y now of the point that was there at the start"},
    Method{"hinges", guarded<push_member_hinges>, "hinges(member): plastic hinges at the ends of a member of a frame"},
    Method{"fibres", guarded<push_member_fibres>, "fibres(member): strains and stresses of a member of fibres"},
    Method{"forces", guarded<push_member_forces>,
           "forces \"member\": normal force, shear and moment along a member of a beam or frame"},
};

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
    push_text(L, name_of_body(member(set, i)));
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
        [](const BodySet& s) { return largest(s, [](const BodyHandle& b) { return motion(b).velocity.norm(); }); }},
    SetProperty{
        "drift", "m", "largest displacement since the start",
        [](const BodySet& s) { return largest(s, [](const BodyHandle& b) { return motion(b).moved.norm(); }); }},
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
/// Called by a generic for: `for body in set do`. The control value is the body before.
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
  DamageLimits limits;
  limits.apart = keys.number("apart", "m", limits.apart);
  limits.out_of_place = keys.number("out_of_place", "m", limits.out_of_place);
  for (const auto& [key, value] : {std::pair{"apart", limits.apart}, {"out_of_place", limits.out_of_place}})
    if (!(value >= 0)) keys.problem(fmt::format("'{}' is {:g} m, must not be below 0", key, value));
  keys.finish();
  const Simulation<2>& sim = set.plane().evaluated();
  const Findings& findings = set.plane().findings();
  const std::vector<StoreyDamage> rows = damage_by_storey(sim.model(), sim.state(), sim.work(), set.bodies,
                                                          findings.storeys, findings.base, findings.joints, limits);
  if (rows.empty())
    throw InputError(
        fmt::format("damage_by_storey: none of these {} bodies is in a group \"storey 1\", \"storey 2\", "
                    "...; ask it of what m:wall gives, or give the bodies such groups",
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
    Method{"has", guarded<set_has>, "has(body or set): true where all of it is in this set"},
    Method{"damage_by_storey", guarded<set_damage>,
           "damage_by_storey{apart=, out_of_place=}: joints apart and units out of place, storey by storey"},
};

using NamedFunction = std::pair<const char*, lua_CFunction>;
constexpr std::array set_operators{
    NamedFunction{"__add", guarded<join_sets>},      NamedFunction{"__sub", guarded<subtract_sets>},
    NamedFunction{"__mul", guarded<intersect_sets>}, NamedFunction{"__len", guarded<set_length>},
    NamedFunction{"__eq", guarded<sets_equal>},      NamedFunction{"__call", guarded<next_of_set>},
};
constexpr std::array body_operators{NamedFunction{"__add", guarded<join_sets>}};

}  // namespace

/// What a body is stays known for good; how it stands and moves does while it is there.
void require_readable(const BodyHandle& b, std::string_view property) {
  constexpr std::array known{"name",    "material", "groups", "present",  "removed_at", "mass",
                             "inertia", "area",     "kind",   "bearings", "seats"};
  if (std::none_of(known.begin(), known.end(), [&](const char* name) { return property == name; }))
    b.model().require_present(b.index, "");
}

std::span<const Property<BodyHandle>> Kind<BodyHandle>::properties() {
  return body_properties;
}
std::span<const Method> Kind<BodyHandle>::methods() {
  return body_methods;
}
std::string Kind<BodyHandle>::title(const BodyHandle& b) {
  return b.open() ? fmt::format("body '{}'", name_of_body(b)) : "body of a closed model";
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<BodyHandle>::metamethods() {
  return body_operators;
}
bool Kind<BodyHandle>::read_item(lua_State*, const BodyHandle&) {
  return false;
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
    lua_pushnil(L);  // so that ipairs ends
    return true;
  }
  lua_getiuservalue(L, 1, 1);
  push_body(L, -1, s.bodies[static_cast<std::size_t>(i - 1)]);
  return true;
}

}  // namespace trilith::script
