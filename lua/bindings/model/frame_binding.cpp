// Beams and frames: sections as values, model:beam, model:frame, and the forces within members.
#include <algorithm>
#include <type_traits>

#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/geometry/part_reading.hpp"
#include "bindings/model/space_frame_binding.hpp"
#include "bindings/readings/body_reading.hpp"
#include "readings/member_forces.hpp"

namespace trilith::script {
namespace {

template <class Shape>
int make_section(lua_State* L) {
  Keys keys(L, 1, std::string(Shape::name));
  Shape shape;
  keys.declared(shape);
  keys.finish();
  if constexpr (requires { shape.check(); }) shape.check();
  SectionValue value{shape.numbers(), describe(shape), std::nullopt, std::nullopt};
  value.in_space = section_in_space(shape);
  if constexpr (std::is_constructible_v<FibreShape, Shape>) value.shape = shape;
  push_handle(L, std::move(value));
  return 1;
}

struct AddSection {
  lua_State* lua;
  template <class Shape>
  void operator()() const {
    set_function(lua, std::string(Shape::name).c_str(), guarded<make_section<Shape>>);
  }
};

/// trilith.polygon_section{ outline = {{x, y}, ...} }
int make_polygon_section(lua_State* L) {
  Keys keys(L, 1, "polygon_section");
  Polygon outline = keys.points("outline");
  keys.finish();
  outline = check_polygon(std::move(outline), "polygon_section").outline;
  SectionValue value{polygon_section(outline), fmt::format("polygon_section of {} corners", outline.size()),
                     SectionOutline{outline}, std::nullopt};
  try {
    value.in_space = polygon_section_in_space(outline);
  } catch (const InputError& e) {
    value.not_in_space = e.what();
  }
  push_handle(L, std::move(value));
  return 1;
}

/// The hinges of a member of the plane.
void take_hinges(Keys& keys, FrameMember& member) {
  const MemberHinges hinges{read_hinges(keys)};
  if (!hinges.end[0] && !hinges.end[1]) return;
  if (std::holds_alternative<MemberFibres>(member.yields))
    keys.problem("it has both a hinge and a section of fibres; keep one");
  member.yields = hinges;
}

/// Common keys of m:beam and each member of m:frame. Problems are noted in `keys`.
void read_member(Keys& keys, FrameMember& member) {
  const auto* section = keys.maybe_handle<SectionValue>("section");
  if (auto fibres = read_fibres(keys, section)) member.yields = std::move(*fibres);
  if (section != nullptr) {
    member.section = section->numbers;
    if (section->not_in_space.empty()) member.in_space = section->in_space;
  } else if (!keys.has("section")) {
    keys.missing("section", "a section such as trilith.rectangle_section{width =, depth =}");
  }
  take_hinges(keys, member);
  member.divisions = keys.count("divisions", member.divisions);
  member.shear = keys.flag("shear", false);
  for (const std::string& end : keys.names("pinned")) {
    if (end == "from" || end == "to")
      member.pinned[end == "from" ? 0 : 1] = true;
    else
      keys.problem(fmt::format("'pinned' names '{}', must be \"from\", \"to\" or {{\"from\", \"to\"}}", end));
  }
}

/// Adds the frame as a body and pushes it.
void add_frame(lua_State* L, PlaneModel& m, const std::string& name, BodyOptions& options, FrameSpec frame) {
  options.spec.name = name;
  options.spec.frame = std::move(frame);
  m.builder.add_body(std::move(options.spec));
  m.catch_up();
  push_body(L, 1, m.body_count() - 1);
}

/// m:beam{ name =, from =, to =, section =, ... }
int add_beam(lua_State* L) {
  if (as_space(this_model(L)) != nullptr) return add_space_beam(L);
  PlaneModel& m = this_plane(L);
  m.adding();
  Keys keys(L, 2, "beam");
  const std::string name = keys.text("name");
  keys.name_owner(name);
  FrameSpec frame;
  frame.joints = {{.name = "from"}, {.name = "to"}};
  FrameMember member;
  member.name = name, member.from = 0, member.to = 1;
  for (FrameJoint& joint : frame.joints) {
    joint.place = keys.point(joint.name);
    read_support(keys, joint.name + "_support", joint.support);
  }
  read_member(keys, member);
  frame.consistent = read_mass_matrix(keys);
  BodyOptions options = read_body_options(keys, false, {BodyKind::frame, {1, 1}});
  keys.finish();
  frame.members = {member};
  add_frame(L, m, name, options, std::move(frame));
  return 1;
}

/// {x, y} or { at = {x, y}, support =, mass =, inertia = } at the top of the stack.
FrameJoint joint_at(lua_State* L, const std::string& name) {
  FrameJoint joint;
  joint.name = name;
  if (const auto place = point_at(L, -1)) {
    joint.place = *place;
    return joint;
  }
  if (lua_type(L, -1) != LUA_TTABLE)
    throw InputError(fmt::format("joint '{}' is {}, must be {{x, y}} or {{ at = {{x, y}}, support = \"fixed\" }}", name,
                                 what_is(L, -1)));
  Keys keys(L, -1, fmt::format("joint '{}'", name));
  if (keys.has("outline")) {
    joint.block = keys.points("outline");
    if (joint.block.size() >= 3) joint.place = polygon_moments(joint.block).centroid;
    if (const auto place = keys.maybe_point("at")) joint.place = *place;
    joint.density = keys.maybe_number("density", "kg/m3");
    joint.thickness = keys.maybe_number("thickness", "m");
  } else {
    joint.place = keys.point("at");
  }
  read_support(keys, "support", joint.support);
  joint.mass = keys.number("mass", "kg", 0);
  joint.inertia = keys.number("inertia", "kg m2", 0);
  keys.finish();
  return joint;
}

/// joints = { A = {x, y}, B = { at = ... }, ... }, sorted by name, because a Lua table has no order.
void read_joints(Keys& keys, FrameSpec& frame) {
  lua_State* L = keys.lua();
  const char* const wanted = "a table such as { A = {0, 0}, B = { at = {0, 4}, support = \"fixed\" } }";
  const int type = keys.push("joints");
  if (type == LUA_TNIL) keys.missing("joints", wanted);
  if (type != LUA_TNIL && type != LUA_TTABLE) keys.wrong("joints", wanted);
  if (type != LUA_TTABLE) {
    lua_pop(L, 1);
    return;
  }
  for (const std::string& name : names_in_table(keys, "joints: its keys must be names of joints")) {
    lua_pushlstring(L, name.data(), name.size());
    lua_rawget(L, -2);
    try {
      frame.joints.push_back(joint_at(L, name));
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
}

int joint_named(Keys& keys, const FrameSpec& frame, const char* key) {
  const std::string name = keys.text(key);
  std::vector<std::string> known;
  for (std::size_t j = 0; j < frame.joints.size(); ++j) {
    if (frame.joints[j].name == name) return static_cast<int>(j);
    known.push_back(frame.joints[j].name);
  }
  if (!name.empty())
    keys.problem(fmt::format("'{}' is '{}', which is not a joint{}", key, name, name_hint(name, known)));
  return 0;
}

/// members = { { from = "A", to = "B", section = , ... }, ... }
void read_members(Keys& keys, FrameSpec& frame) {
  if (!keys.has("members"))
    keys.missing("members",
                 "a list such as { { from = \"A\", to = \"B\", section = trilith.rectangle_section{...} } }");
  read_list(keys, "members", "member", [&](Keys& own) {
    FrameMember member;
    member.name = own.text("name", "");
    member.from = joint_named(own, frame, "from"), member.to = joint_named(own, frame, "to");
    member.ends = {own.maybe_point("from_at"), own.maybe_point("to_at")};
    member.material = own.text("material", "");
    read_member(own, member);
    frame.members.push_back(std::move(member));
  });
}

/// m:frame{ name =, joints =, members =, ... }
int frame(lua_State* L) {
  if (as_space(this_model(L)) != nullptr) return add_frame_in_space(L);
  PlaneModel& m = this_plane(L);
  m.adding();
  Keys keys(L, 2, "frame");
  const std::string name = keys.text("name");
  keys.name_owner(name);
  FrameSpec spec;
  read_joints(keys, spec);
  read_members(keys, spec);
  spec.consistent = read_mass_matrix(keys);
  BodyOptions options = read_body_options(keys, false, {BodyKind::frame, {1, 1}});
  keys.finish();
  add_frame(L, m, name, options, std::move(spec));
  return 1;
}

/// The member for body:forces and body:hinges (`call`): the only one, or the one with the given name.
int member_of(const Model<2>& model, int body, const std::optional<std::string>& name, const char* call) {
  std::vector<std::string> known;
  int only = -1;
  for (int i = 0; i < static_cast<int>(model.members.size()); ++i) {
    if (model.members[i].body != body) continue;
    if (name && model.members[i].name == *name) return i;
    only = i;
    known.push_back(model.members[i].name);
  }
  const std::string& owner = model.bodies[body].name;
  if (known.empty())
    throw InputError(fmt::format("{}: body '{}' is {}, which has no members; use a beam or frame", call, owner,
                                 name_of(model.bodies[body].kind)));
  if (name)
    throw InputError(fmt::format("{}: body '{}' has no member '{}'{}", call, owner, *name, name_hint(*name, known)));
  if (known.size() > 1)
    throw InputError(fmt::format("{}: body '{}' has {} members; name one, such as {} \"{}\"", call, owner, known.size(),
                                 call, known.front()));
  return only;
}

/// Member of a body in argument 2, which is required if there are several.
struct AskedMember {
  const Simulation<2>& run;
  int member;
};
AskedMember asked_member(lua_State* L, const char* call) {
  const auto& b = handle<BodyHandle>(L, 1);
  std::optional<std::string> name;
  if (lua_type(L, 2) == LUA_TSTRING)
    name = text_at(L, 2);
  else if (!lua_isnoneornil(L, 2))
    throw InputError(fmt::format("{}: takes the name of a member; this is {}", call, what_is(L, 2)));
  const Simulation<2>* const built = b.plane().if_built();
  if (built == nullptr)
    throw InputError(fmt::format("{}: nothing has run yet; read it during a stage or after it", call));
  return {*built, member_of(built->model(), b.index, name, call)};
}

}  // namespace

/// body:forces "member": a list of { along, x, y, normal, shear, moment }, two for each beam.
int push_member_forces(lua_State* L) {
  const auto& b = handle<BodyHandle>(L, 1);
  if (SpaceModel* space = as_space(b.model())) return push_space_forces(L, *space, b.index);
  const AskedMember asked = asked_member(L, "forces");
  lua_newtable(L);
  lua_Integer i = 0;
  for (const SectionForces& row : member_forces(asked.run.model(), asked.run.state(), asked.member)) {
    lua_createtable(L, 0, 6);
    set_number(L, "along", row.along);
    set_number(L, "x", row.place.x());
    set_number(L, "y", row.place.y());
    set_number(L, "normal", row.normal);
    set_number(L, "shear", row.shear);
    set_number(L, "moment", row.moment);
    lua_rawseti(L, -2, ++i);
  }
  return 1;
}

/// body:hinges "member": a list of { joint, state, rotation, stretch, moment, normal, dissipated, x, y }.
int push_member_hinges(lua_State* L) {
  const auto& b = handle<BodyHandle>(L, 1);
  if (SpaceModel* space = as_space(b.model())) return push_space_hinges(L, *space, b.index);
  const AskedMember asked = asked_member(L, "hinges");
  const Model<2>& model = asked.run.model();
  const std::vector<HingeReading> hinges = member_hinges(model, asked.run.state(), asked.member);
  if (hinges.empty())
    throw InputError(
        fmt::format("hinges: member '{}' has no hinges; give it some by hinge = trilith.end_hinge{{sagging =}}",
                    model.members[asked.member].name));
  lua_newtable(L);
  lua_Integer i = 0;
  for (const HingeReading& row : hinges) {
    lua_createtable(L, 0, 9);
    set_text(L, "joint", model.members[asked.member].joint[row.end]);
    set_text(L, "state", hinge_state_text(row.status));
    set_number(L, "rotation", row.rotation);
    set_number(L, "stretch", row.stretch);
    set_number(L, "moment", row.moment);
    set_number(L, "normal", row.normal);
    set_number(L, "given_off", row.dissipated);
    set_number(L, "x", row.place.x());
    set_number(L, "y", row.place.y());
    lua_rawseti(L, -2, ++i);
  }
  return 1;
}

/// body:fibres "member": a list of { along, axial, curvature, normal, moment, fibres = { { height, area, strain, stress
/// } } }.
int push_member_fibres(lua_State* L) {
  const auto& b = handle<BodyHandle>(L, 1);
  if (SpaceModel* space = as_space(b.model())) return push_space_fibres(L, *space, b.index);
  const AskedMember asked = asked_member(L, "fibres");
  const Model<2>& model = asked.run.model();
  const std::vector<FibreReading> sections = member_fibres(model, asked.run.state(), asked.member);
  if (sections.empty()) throw InputError(no_fibres_text(model.members[asked.member].name));
  lua_newtable(L);
  lua_Integer i = 0;
  for (const FibreReading& row : sections) {
    lua_createtable(L, 0, 6);
    set_number(L, "along", row.along);
    set_number(L, "axial", row.axial);
    set_number(L, "curvature", row.curvature);
    set_number(L, "normal", row.normal);
    set_number(L, "moment", row.moment);
    lua_createtable(L, static_cast<int>(row.fibres.size()), 0);
    lua_Integer j = 0;
    for (const FibreReading::Fibre& fibre : row.fibres) {
      lua_createtable(L, 0, 4);
      set_number(L, "height", fibre.height);
      set_number(L, "area", fibre.area);
      set_number(L, "strain", fibre.strain);
      set_number(L, "stress", fibre.stress);
      lua_rawseti(L, -2, ++j);
    }
    lua_setfield(L, -2, "fibres");
    lua_rawseti(L, -2, ++i);
  }
  return 1;
}

std::span<const Method> frame_methods() {
  static const std::array methods{
      Method{"beam", guarded<add_beam>},
      Method{"frame", guarded<frame>},
  };
  return methods;
}

void open_sections(lua_State* L) {
  register_kind<SectionValue>(L);
  SectionShapes::for_each(AddSection{L});
  set_function(L, "polygon_section", guarded<make_polygon_section>);
}

namespace {

using SectionProperty = Property<SectionValue>;

const std::array section_properties{
    SectionProperty{"area", "m2", "of the section", [](const SectionValue& v) { return v.numbers.area; }, nullptr},
    SectionProperty{"inertia", "m4", "second moment of area for bending in the plane",
                    [](const SectionValue& v) { return v.numbers.second_moment; }, nullptr},
    SectionProperty{"shear_area", "m2", "area times shear coefficient",
                    [](const SectionValue& v) { return v.numbers.shear_area; }, nullptr},
    SectionProperty{"depth", "m", "in the plane", [](const SectionValue& v) { return v.numbers.depth(); }, nullptr},
    SectionProperty{"above", "m", "from the centroid to the top fibre",
                    [](const SectionValue& v) { return v.numbers.above; }, nullptr},
    SectionProperty{"below", "m", "from the centroid to the bottom fibre",
                    [](const SectionValue& v) { return v.numbers.below; }, nullptr},
};

}  // namespace

std::span<const Property<SectionValue>> Kind<SectionValue>::properties() {
  return section_properties;
}
std::span<const Method> Kind<SectionValue>::methods() {
  return {};
}
std::string Kind<SectionValue>::title(const SectionValue& v) {
  return v.text;
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<SectionValue>::metamethods() {
  return {};
}
bool Kind<SectionValue>::read_item(lua_State*, const SectionValue&) {
  return false;
}

}  // namespace trilith::script
