// Bodies and their properties.
#include <algorithm>
#include <cmath>

#include "assembly/element/element_stress.hpp"
#include "assembly/whole_body.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/handles.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/geometry/bridge_book.hpp"
#include "bindings/model/body_motion.hpp"
#include "bindings/model/frame_binding.hpp"
#include "bindings/model/model_binding.hpp"
#include "bindings/readings/body_reading.hpp"
#include "bindings/readings/reaction_binding.hpp"
#include "model/contact/skin_places.hpp"
#include "model/element/element_place.hpp"
#include "model/pose.hpp"

namespace trilith::script {
namespace {

const std::string& name_of_body(const BodyHandle& b) {
  return b.model().body_name(b.index);
}
const BodySpec& spec(const BodyHandle& b) {
  return b.plane().spec(b.index);
}

Vec2 start_place(const BodyHandle& b) {
  return moments_of(spec(b)).centroid;
}
Vec2 place(const BodyHandle& b) {
  return motion_of(b).place.head<2>();
}
double rotation(const BodyHandle& b) {
  return motion_of(b).turned.z();
}
double spin(const BodyHandle& b) {
  return motion_of(b).spin.z();
}

template <Vec3 BodyMotion::*vector, int axis>
double along_axis(const BodyHandle& b) {
  return (motion_of(b).*vector)[axis];
}

void push_outline(lua_State* L, const BodyHandle& b) {
  const Simulation<2>* s = b.plane().if_built();
  const bool deforms = s != nullptr && !s->model().bodies[b.index].is_rigid();
  const Vec2 start = start_place(b), now = place(b);
  const Turn turn(rotation(b));
  lua_newtable(L);
  lua_Integer i = 0;
  for (const Vec2& p : spec(b).outline) {
    const Vec2 at = deforms
                        ? skin_now(s->model(), s->state(), s->model().bodies[b.index].first_skin + static_cast<int>(i))
                        : Vec2(now + turn.apply(Vec2(p - start)));
    lua_createtable(L, 2, 0);
    for (int k = 0; k < 2; ++k) {
      lua_pushnumber(L, at[k]);
      lua_rawseti(L, -2, k + 1);
    }
    lua_rawseti(L, -2, ++i);
  }
}

/// Of the built model, where a mesh of one element is a quad or a brick, and a part of a mesh remains a mesh.
BodyKind kind_of(const BodyHandle& b) {
  const auto built = [&](const auto& model, BodyKind given) {
    return model.has_body(b.index) ? model.if_built()->model().bodies[static_cast<std::size_t>(b.index)].kind : given;
  };
  const SpaceModel* space = as_space(b.model());
  return space != nullptr ? built(*space, space->spec(b.index).kind()) : built(b.plane(), spec(b).kind);
}

void push_groups(lua_State* L, const BodyHandle& b) {
  lua_newtable(L);
  lua_Integer i = 0;
  for (const std::string& g : b.model().groups_of(b.index)) {
    push_text(L, g);
    lua_rawseti(L, -2, ++i);
  }
}

/// The body itself, or the part at its centroid once it has cracked.
int present_part(const BodyHandle& b) {
  const int part = b.model().heir_of(b.index);
  return part < 0 ? b.index : part;
}

/// A mean over the area of a deformable body; 0 before the first stage.
template <class Value>
double mean_stress(const BodyHandle& b, Value&& value) {
  const Simulation<2>* s = b.plane().if_built();
  if (s == nullptr) return 0;
  const int body = present_part(b);
  double sum = 0, area = 0;
  for (std::size_t e = 0; e < s->model().elements.size(); ++e) {
    if (s->model().elements[e].body != body) continue;
    const ElementStress stress = element_stress(s->model(), s->state(), static_cast<int>(e));
    sum += stress.area * value(stress);
    area += stress.area;
  }
  return area > 0 ? sum / area : 0;
}

/// A mean over the volume of a body in space.
template <class Value>
double mean_in_space(const BodyHandle& b, Value&& value) {
  const Simulation<3>* s = as_space(b.model())->if_built();
  if (s == nullptr) return 0;
  const int body = present_part(b);
  double sum = 0, volume = 0;
  for (std::size_t e = 0; e < s->model().space_elements.size(); ++e) {
    if (s->model().space_elements[e].body != body) continue;
    const SpaceElementStress stress = element_stress(s->model(), s->state(), static_cast<int>(e));
    sum += stress.volume * value(stress), volume += stress.volume;
  }
  return volume > 0 ? sum / volume : 0;
}

/// Component `row` of the stress in space.
template <int row>
double space_stress(const BodyHandle& b) {
  return mean_in_space(b, [](const SpaceElementStress& e) { return in_world(e)[row]; });
}

/// A stress component of both dimensions: a member of the plane stress, or `row` of the stress in space.
template <double Stress::*member, int row>
double stress_along(const BodyHandle& b) {
  if (as_space(b.model()) != nullptr) return space_stress<row>(b);
  return mean_stress(b, [](const ElementStress& e) { return in_world(e).*member; });
}

/// Pushes { left =, right = } with the entries of `names` at the ends of the span; nil for any other body.
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
        "present", "", "false if removed, or if added at the end of the step", nullptr,
        [](lua_State* L, const BodyHandle& b) { lua_pushboolean(L, b.model().why_absent(b.index).empty() ? 1 : 0); }},
    BodyProperty{"removed_at", "", "time of its removal [s]; nil if present", nullptr,
                 [](lua_State* L, const BodyHandle& b) {
                   if (const auto when = b.model().removed_at(b.index))
                     lua_pushnumber(L, *when);
                   else
                     lua_pushnil(L);
                 }},
    in_plane(BodyProperty{"outline", "", "present corners {x, y} [m]", nullptr, push_outline}),
    BodyProperty{"x", "m", "place of the centroid", along_axis<&BodyMotion::place, 0>},
    BodyProperty{"y", "m", "height of the centroid; in space its place along y", along_axis<&BodyMotion::place, 1>},
    in_space(BodyProperty{"z", "m", "height of the centroid in space", along_axis<&BodyMotion::place, 2>}),
    in_plane(BodyProperty{"rotation", "rad", "counter-clockwise turn since the start, in the plane", rotation}),
    in_space(BodyProperty{
        "rotation_x", "rad",
        "rotation from the start in space: rotation vector along x, up to 2 pi long, for a driven body with all turns; "
        "for a frame, rotation of its first joint by name",
        along_axis<&BodyMotion::turned, 0>}),
    in_space(BodyProperty{"rotation_y", "rad", "... along y", along_axis<&BodyMotion::turned, 1>}),
    in_space(BodyProperty{"rotation_z", "rad", "... along z", along_axis<&BodyMotion::turned, 2>}),
    BodyProperty{"vx", "m/s", "velocity of the centroid along x", along_axis<&BodyMotion::velocity, 0>},
    BodyProperty{"vy", "m/s", "velocity of the centroid along y", along_axis<&BodyMotion::velocity, 1>},
    in_space(
        BodyProperty{"vz", "m/s", "velocity of the centroid along z, in space", along_axis<&BodyMotion::velocity, 2>}),
    in_plane(BodyProperty{"spin", "rad/s", "rate of rotation, in the plane", spin}),
    in_space(BodyProperty{"spin_x", "rad/s",
                          "rate of rotation about x, in space; for a frame, rate of its first joint by name",
                          along_axis<&BodyMotion::spin, 0>}),
    in_space(BodyProperty{"spin_y", "rad/s", "rate of rotation about y, in space", along_axis<&BodyMotion::spin, 1>}),
    in_space(BodyProperty{"spin_z", "rad/s", "rate of rotation about z, in space", along_axis<&BodyMotion::spin, 2>}),
    BodyProperty{"ux", "m", "displacement along x since the start", along_axis<&BodyMotion::moved, 0>},
    BodyProperty{"uy", "m", "displacement along y since the start", along_axis<&BodyMotion::moved, 1>},
    in_space(
        BodyProperty{"uz", "m", "displacement along z since the start, in space", along_axis<&BodyMotion::moved, 2>}),
    BodyProperty{"speed", "m/s", "speed of the centroid",
                 [](const BodyHandle& b) { return motion_of(b).velocity.norm(); }},
    BodyProperty{"mass", "kg", "mass", [](const BodyHandle& b) { return b.model().mass_of(b.index); }},
    in_plane(BodyProperty{"inertia", "kg m2", "moment of inertia about the centroid",
                          [](const BodyHandle& b) { return b.plane().inertia_of(b.index); }}),
    in_plane(BodyProperty{"area", "m2", "area of the outline",
                          [](const BodyHandle& b) { return moments_of(spec(b)).area; }}),
    BodyProperty{"kind", "", "\"rigid\", \"quad\", \"mesh\", \"frame\", or in space \"brick\"", nullptr,
                 [](lua_State* L, const BodyHandle& b) { push_text(L, std::string(name_of(kind_of(b)))); }},
    BodyProperty{"sxx", "Pa", "mean stress along x of a deformable body", stress_along<&Stress::xx, 0>},
    BodyProperty{"syy", "Pa", "mean stress along y of a deformable body", stress_along<&Stress::yy, 1>},
    in_space(BodyProperty{"szz", "Pa", "mean stress along z of a deformable body, in space", space_stress<2>}),
    BodyProperty{"sxy", "Pa", "mean shear stress of a deformable body", stress_along<&Stress::xy, 3>},
    in_space(BodyProperty{"syz", "Pa", "mean shear stress of y and z of a deformable body, in space", space_stress<4>}),
    in_space(BodyProperty{"szx", "Pa", "mean shear stress of z and x of a deformable body, in space", space_stress<5>}),
    BodyProperty{"reaction_x", "N", "reaction of its supports along x",
                 [](const BodyHandle& b) { return reaction_along(b, 0); }},
    BodyProperty{"reaction_y", "N", "reaction of its supports along y",
                 [](const BodyHandle& b) { return reaction_along(b, 1); }},
    in_space(BodyProperty{"reaction_z", "N", "reaction of its supports along z",
                          [](const BodyHandle& b) { return reaction_along(b, 2); }}),
    BodyProperty{"plastic", "1", "mean plastic measure of a deformable body",
                 [](const BodyHandle& b) {
                   if (as_space(b.model()) != nullptr)
                     return mean_in_space(b, [](const SpaceElementStress& e) { return e.plastic; });
                   return mean_stress(b, [](const ElementStress& e) { return e.plastic; });
                 }},
    in_plane(BodyProperty{
        "bearings", "", "of a span made with from and to: { left, right }; a side without a bearing is nil", nullptr,
        [](lua_State* L, const BodyHandle& b) { push_ends<push_bearing>(L, b, b.model().bearings); }}),
    in_plane(BodyProperty{"seats", "", "of a span made with from and to: { left, right }", nullptr,
                          [](lua_State* L, const BodyHandle& b) { push_ends<push_seat>(L, b, b.model().seats); }}),
    BodyProperty{"resting", "", "true after the still_time of the model at rest", nullptr,
                 [](lua_State* L, const BodyHandle& b) { lua_pushboolean(L, b.model().is_resting(b.index) ? 1 : 0); }},
};

void push_place(lua_State* L, const Vec3& at) {
  for (int k = 0; k < 3; ++k) lua_pushnumber(L, at[k]);
}

/// body:point "joint" or body:point{x, y, z}: present x, y and z of the point that was there at the start.
int push_space_point(lua_State* L, SpaceModel& m, int body) {
  const auto at = vector_at(L, 2);
  const bool named = lua_type(L, 2) == LUA_TSTRING;
  if (!named && !at)
    throw InputError(fmt::format("point: takes {{x, y, z}} or the name of a joint; this is {}", what_is(L, 2)));
  const Vec3 start = named ? joint_start(m.spec(body), text_at(L, 2)) : *at;
  const Simulation<3>* const run = m.if_built();
  if (run == nullptr || !m.has_body(body)) return push_place(L, start), 3;
  const Model<3>& model = run->model();
  if (is_of_elements(model.bodies[static_cast<std::size_t>(body)]))
    return push_place(L, element_place(model, run->state(), body, start)), 3;
  const Attachment<3> attachment = tie_point(model, m.part_with(body, start), start);
  const trilith::BodyMotion now = trilith::motion_of(model, run->state(), attachment.node[0]);
  push_place(L, now.place + turn_of(now.rotation).apply(attachment.arm[0]));
  return 3;
}

/// body:point{x, y} or body:point "joint": present position of the point that was there at the start.
int body_point(lua_State* L) {
  const auto& b = handle<BodyHandle>(L, 1);
  const int own = b.model().heir_of(b.index);
  b.model().require_present(own < 0 ? b.index : own, "point");
  if (SpaceModel* space = as_space(b.model())) return push_space_point(L, *space, b.index);
  const PlaneModel& plane = b.plane();
  std::optional<Vec2> at = point_at(L, 2);
  if (lua_type(L, 2) == LUA_TSTRING) at = joint_start(spec(b), text_at(L, 2));
  if (!at)
    throw InputError(
        fmt::format("point: takes {{x, y}}, two finite numbers, or the name of a joint; this is {}", what_is(L, 2)));
  const Simulation<2>* s = plane.if_built();
  Vec2 now = *at;
  if (s != nullptr) {
    const Attachment<2> tied =
        tie_point(s->model(), plane.part_with(b.index, *at), *at, fmt::format("point of body '{}'", spec(b).name));
    now = pose_at(s->model(), s->state(), tied).place;
  }
  lua_pushnumber(L, now.x());
  lua_pushnumber(L, now.y());
  return 2;
}

const std::array body_methods{
    Method{"reactions", guarded<push_body_reactions>}, Method{"point", guarded<body_point>},
    Method{"hinges", guarded<push_member_hinges>, 2},  Method{"fibres", guarded<push_member_fibres>, 2},
    Method{"forces", guarded<push_member_forces>},
};

}  // namespace

void require_stress(const BodyHandle& b, std::string_view property) {
  constexpr std::array of_elements{"sxx", "syy", "szz", "sxy", "syz", "szx", "plastic"};
  if (std::none_of(of_elements.begin(), of_elements.end(), [&](const char* name) { return property == name; })) return;
  const BodyKind kind = kind_of(b);
  const Resistance resistance = info_of(kind).resistance;
  if (resistance == Resistance::elements) return;
  throw InputError(
      fmt::format("'{}': body '{}' is of kind '{}' and has no stress; {}", property, name_of_body(b), name_of(kind),
                  resistance == Resistance::none
                      ? "give it elements with the key body, or read the forces of its contacts with m:contacts"
                      : "read its section forces with body:forces"));
}

/// The properties of a body remain known; its position and motion only while it is in the model.
void require_readable(const BodyHandle& b, std::string_view property) {
  constexpr std::array known{"name",    "material", "groups", "present",  "removed_at", "mass",
                             "inertia", "area",     "kind",   "bearings", "seats"};
  if (std::none_of(known.begin(), known.end(), [&](const char* name) { return property == name; }))
    b.model().require_present(present_part(b), "");  // a cracked body is read at its centroid
  require_stress(b, property);
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
bool Kind<BodyHandle>::read_item(lua_State*, const BodyHandle&) {
  return false;
}

}  // namespace trilith::script
