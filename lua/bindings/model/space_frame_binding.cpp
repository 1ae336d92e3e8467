// Beams and frames of models in space: m:beam and m:frame with dim = 3, forces in their members, points of bodies.
#include "bindings/model/space_frame_binding.hpp"
#include "assembly/whole_body.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/geometry/part_reading.hpp"
#include "bindings/geometry/solid_makers.hpp"
#include "geometry/space/convex_hull.hpp"
#include "model/element_place.hpp"
#include "model/pose.hpp"
#include "readings/member_forces.hpp"

namespace trilith::script {
namespace {

/// Common keys of m:beam and each member of m:frame. Problems are noted in `keys`.
void read_space_member(Keys& keys, SpaceMember& member) {
  const auto* section = keys.maybe_handle<SectionValue>("section");
  member.fibres = read_fibres(keys, section);
  member.hinge = read_hinges(keys);
  if (member.fibres && (member.hinge[0] || member.hinge[1]))
    keys.problem("it has both a hinge and a section of fibres; keep one");
  if (section != nullptr) {
    member.section = section->in_space;
    if (!section->not_in_space.empty()) keys.problem(section->not_in_space);
  } else if (!keys.has("section")) {
    keys.missing("section", "a section such as trilith.rectangle_section{width =, depth =}");
  }
  if (keys.has("orientation")) member.orientation = keys.vector("orientation");
  member.divisions = keys.count("divisions", member.divisions);
  member.shear = keys.flag("shear", false);
  for (const std::string& end : keys.names("pinned")) {
    if (end == "from" || end == "to")
      member.pinned[end == "from" ? 0 : 1] = true;
    else
      keys.problem(fmt::format("'pinned' names '{}', must be \"from\", \"to\" or {{\"from\", \"to\"}}", end));
  }
}

void add_space_frame(lua_State* L, SpaceModel& m, const std::string& name, SolidSpec spec, SpaceFrameSpec frame) {
  spec.name = name;
  spec.frame = std::move(frame);
  m.builder.add_body(std::move(spec));
  m.catch_up();
  push_body(L, 1, m.body_count() - 1);
}

/// {x, y, z} or { at = {x, y, z}, support =, mass =, inertia = } at the top of the stack.
SpaceJoint space_joint_at(lua_State* L, const std::string& name) {
  SpaceJoint joint;
  joint.name = name;
  if (const auto place = vector_at(L, -1)) {
    joint.place = *place;
    return joint;
  }
  if (lua_type(L, -1) != LUA_TTABLE)
    throw InputError(fmt::format("joint '{}' is {}, must be {{x, y, z}} or {{ at = {{x, y, z}}, support = \"fixed\" }}",
                                 name, what_is(L, -1)));
  const std::string owner = fmt::format("joint '{}'", name);
  Keys keys(L, -1, owner);
  if (keys.has("hull")) {
    if (const std::vector<Vec3> points = keys.vectors("hull"); !points.empty()) {
      joint.block = convex_hull(points, owner);
      joint.place = solid_moments(joint.block).centroid;
    }
    joint.place = keys.vector("at", joint.place);
    joint.density = keys.maybe_number("density", "kg/m3");
  } else {
    joint.place = keys.vector("at");
  }
  read_solid_support(keys, "support", joint.support);
  joint.mass = keys.number("mass", "kg", 0);
  joint.inertia = keys.number("inertia", "kg m2", 0);
  keys.finish();
  return joint;
}

/// joints = { A = {x, y, z}, B = { at = ... }, ... }, sorted by name, because a Lua table has no order.
void read_space_joints(Keys& keys, SpaceFrameSpec& frame) {
  lua_State* L = keys.lua();
  const char* const wanted = "a table such as { A = {0, 0, 0}, B = { at = {0, 0, 4}, support = \"fixed\" } }";
  const int type = keys.push("joints");
  if (type == LUA_TNIL) keys.missing("joints", wanted);
  if (type != LUA_TNIL && type != LUA_TTABLE) keys.wrong("joints", wanted);
  if (type == LUA_TTABLE)
    for (const std::string& name : names_in_table(keys, "joints: its keys must be names of joints")) {
      lua_pushlstring(L, name.data(), name.size());
      lua_rawget(L, -2);
      try {
        frame.joints.push_back(space_joint_at(L, name));
      } catch (const InputError& e) {
        keys.problem(e.what());
      }
      lua_pop(L, 1);
    }
  lua_pop(L, 1);
}

int space_joint_named(Keys& keys, const SpaceFrameSpec& frame, const char* key) {
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

void read_space_members(Keys& keys, SpaceFrameSpec& frame) {
  if (!keys.has("members"))
    keys.missing("members",
                 "a list such as { { from = \"A\", to = \"B\", section = trilith.rectangle_section{...} } }");
  read_list(keys, "members", "member", [&](Keys& own) {
    SpaceMember member;
    member.name = own.text("name", "");
    member.from = space_joint_named(own, frame, "from"), member.to = space_joint_named(own, frame, "to");
    if (own.has("from_at")) member.ends[0] = own.vector("from_at");
    if (own.has("to_at")) member.ends[1] = own.vector("to_at");
    member.material = own.text("material", "");
    read_space_member(own, member);
    frame.members.push_back(std::move(member));
  });
}

/// The member in argument 2: the only one, or the one with the given name.
int space_member_asked(lua_State* L, const Model<3>& model, int body, std::string_view what) {
  if (lua_type(L, 2) != LUA_TSTRING && !lua_isnoneornil(L, 2))
    throw InputError(fmt::format("{}: takes the name of a member; this is {}", what, what_is(L, 2)));
  const std::string name = lua_type(L, 2) == LUA_TSTRING ? text_at(L, 2) : "";
  std::vector<std::string> known;
  int only = -1;
  for (int i = 0; i < static_cast<int>(model.members.size()); ++i) {
    if (model.members[i].body != body) continue;
    if (!name.empty() && model.members[i].name == name) return i;
    only = i;
    known.push_back(model.members[i].name);
  }
  const std::string& owner = model.bodies[body].name;
  if (known.empty())
    throw InputError(fmt::format("{}: body '{}' is {}, which has no members; use a beam or frame", what, owner,
                                 name_of(model.bodies[body].kind)));
  if (!name.empty())
    throw InputError(fmt::format("{}: body '{}' has no member '{}'{}", what, owner, name, name_hint(name, known)));
  if (known.size() > 1)
    throw InputError(fmt::format("{}: body '{}' has {} members; name one, such as {} \"{}\"", what, owner, known.size(),
                                 what, known.front()));
  return only;
}

/// Member of a model that has run.
struct AskedSpaceMember {
  const Simulation<3>& run;
  int member;
};
AskedSpaceMember asked_space_member(lua_State* L, const SpaceModel& m, int body, std::string_view what) {
  const Simulation<3>* const run = m.if_built();
  if (run == nullptr)
    throw InputError(fmt::format("{}: nothing has run yet; read it during a stage or after it", what));
  return {*run, space_member_asked(L, run->model(), body, what)};
}

void push_place(lua_State* L, const Vec3& at) {
  for (int k = 0; k < 3; ++k) lua_pushnumber(L, at[k]);
}

}  // namespace

/// m:beam{ name =, from =, to =, section =, orientation =, ... }
int add_space_beam(lua_State* L) {
  SpaceModel& m = this_space(L);
  m.adding();
  Keys keys(L, 2, "beam");
  const std::string name = read_name(keys, "");
  SpaceFrameSpec frame;
  frame.joints = {{.name = "from"}, {.name = "to"}};
  SpaceMember member;
  member.name = name, member.from = 0, member.to = 1;
  for (SpaceJoint& joint : frame.joints) {
    joint.place = keys.vector(joint.name);
    read_solid_support(keys, joint.name + "_support", joint.support);
  }
  read_space_member(keys, member);
  frame.consistent = read_mass_matrix(keys);
  SolidSpec spec = read_solid_spec(keys, {});
  keys.finish();
  frame.members = {member};
  add_space_frame(L, m, name, std::move(spec), std::move(frame));
  return 1;
}

/// m:frame{ name =, joints =, members =, ... }
int add_frame_in_space(lua_State* L) {
  SpaceModel& m = this_space(L);
  m.adding();
  Keys keys(L, 2, "frame");
  const std::string name = read_name(keys, "");
  SpaceFrameSpec frame;
  read_space_joints(keys, frame);
  read_space_members(keys, frame);
  frame.consistent = read_mass_matrix(keys);
  SolidSpec spec = read_solid_spec(keys, {});
  keys.finish();
  add_space_frame(L, m, name, std::move(spec), std::move(frame));
  return 1;
}

/// body:forces "member": a list of { along, x, y, z, normal, shear_y, shear_z, torque, moment_y, moment_z }.
int push_space_forces(lua_State* L, SpaceModel& m, int body) {
  const AskedSpaceMember asked = asked_space_member(L, m, body, "forces");
  lua_newtable(L);
  lua_Integer i = 0;
  for (const SectionForces3& row : member_forces(asked.run.model(), asked.run.state(), asked.member)) {
    lua_createtable(L, 0, 10);
    set_number(L, "along", row.along);
    set_number(L, "x", row.place.x()), set_number(L, "y", row.place.y()), set_number(L, "z", row.place.z());
    set_number(L, "normal", row.normal);
    set_number(L, "shear_y", row.shear[0]), set_number(L, "shear_z", row.shear[1]);
    set_number(L, "torque", row.torque);
    set_number(L, "moment_y", row.moment[0]), set_number(L, "moment_z", row.moment[1]);
    lua_rawseti(L, -2, ++i);
  }
  return 1;
}

/// body:fibres "member": a list of { along, axial, curvature_y, curvature_z, normal, moment_y, moment_z, fibres = { {
/// up, across, area, strain, stress } } }.
int push_space_fibres(lua_State* L, SpaceModel& m, int body) {
  const AskedSpaceMember asked = asked_space_member(L, m, body, "fibres");
  const Model<3>& model = asked.run.model();
  const std::vector<FibreReading3> sections = member_fibres(model, asked.run.state(), asked.member);
  if (sections.empty()) throw InputError(no_fibres_text(model.members[static_cast<std::size_t>(asked.member)].name));
  lua_newtable(L);
  lua_Integer i = 0;
  for (const FibreReading3& row : sections) {
    lua_createtable(L, 0, 8);
    set_number(L, "along", row.along), set_number(L, "axial", row.axial), set_number(L, "normal", row.normal);
    set_number(L, "curvature_y", row.curvature[0]), set_number(L, "curvature_z", row.curvature[1]);
    set_number(L, "moment_y", row.moment[0]), set_number(L, "moment_z", row.moment[1]);
    lua_createtable(L, static_cast<int>(row.fibres.size()), 0);
    lua_Integer j = 0;
    for (const FibreReading3::Fibre& fibre : row.fibres) {
      lua_createtable(L, 0, 5);
      set_number(L, "up", fibre.up), set_number(L, "across", fibre.across), set_number(L, "area", fibre.area);
      set_number(L, "strain", fibre.strain), set_number(L, "stress", fibre.stress);
      lua_rawseti(L, -2, ++j);
    }
    lua_setfield(L, -2, "fibres");
    lua_rawseti(L, -2, ++i);
  }
  return 1;
}

/// body:hinges "member": a list of { joint, state, rotation_y, rotation_z, stretch, moment_y, moment_z, normal,
/// dissipated, x, y, z }.
int push_space_hinges(lua_State* L, SpaceModel& m, int body) {
  const AskedSpaceMember asked = asked_space_member(L, m, body, "hinges");
  const Member& member = asked.run.model().members[static_cast<std::size_t>(asked.member)];
  const std::vector<HingeReading3> hinges = member_hinges(asked.run.model(), asked.run.state(), asked.member);
  if (hinges.empty())
    throw InputError(fmt::format(
        "hinges: member '{}' has no hinges; give it some by hinge = trilith.end_hinge{{sagging =, across =}}",
        member.name));
  lua_newtable(L);
  lua_Integer i = 0;
  for (const HingeReading3& row : hinges) {
    lua_createtable(L, 0, 12);
    set_text(L, "joint", member.joint[static_cast<std::size_t>(row.end)]);
    set_text(L, "state", hinge_state_text(row.status));
    set_number(L, "rotation_y", row.rotation[0]), set_number(L, "rotation_z", row.rotation[1]);
    set_number(L, "moment_y", row.moment[0]), set_number(L, "moment_z", row.moment[1]);
    set_number(L, "stretch", row.stretch), set_number(L, "normal", row.normal);
    set_number(L, "given_off", row.dissipated);
    set_number(L, "x", row.place.x()), set_number(L, "y", row.place.y()), set_number(L, "z", row.place.z());
    lua_rawseti(L, -2, ++i);
  }
  return 1;
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
  const Attachment<3> attachment = tie_point(model, body, start);
  const trilith::BodyMotion now = trilith::motion_of(model, run->state(), attachment.node[0]);
  push_place(L, now.place + turn_of(now.rotation).apply(attachment.arm[0]));
  return 3;
}

}  // namespace trilith::script
