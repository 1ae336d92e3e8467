// Beams and frames as bodies, in the plane and in space: model:beam and model:frame.
#include "bindings/model/frame_binding.hpp"

#include <algorithm>
#include <type_traits>

#include "bindings/core/bindings.hpp"
#include "bindings/geometry/part_reading.hpp"
#include "bindings/geometry/solid_makers.hpp"
#include "bindings/readings/body_reading.hpp"
#include "geometry/space/convex_hull.hpp"

namespace trilith::script {
namespace {

template <int D>
using ModelIn = std::conditional_t<D == 2, PlaneModel, SpaceModel>;

// A position under a key, and at the top of the stack: {x, y} or {x, y, z}.
template <int D>
Vec<D> read_place(Keys& keys, std::string_view key) {
  if constexpr (D == 2)
    return keys.point(key);
  else
    return keys.vector(key);
}
template <int D>
std::optional<Vec<D>> maybe_place(Keys& keys, std::string_view key) {
  if (!keys.has(key)) return std::nullopt;
  return read_place<D>(keys, key);
}
template <int D>
std::optional<Vec<D>> place_on_top(lua_State* L) {
  if constexpr (D == 2)
    return point_at(L, -1);
  else
    return vector_at(L, -1);
}

template <int D>
void read_joint_support(Keys& keys, const std::string& key, FrameJointOf<D>& joint) {
  if constexpr (D == 2)
    read_support(keys, key, joint.support);
  else
    read_solid_support(keys, key, joint.support);
}

/// Options of the body except its name and shape.
template <int D>
auto read_frame_options(Keys& keys) {
  if constexpr (D == 2)
    return read_body_options(keys, false, {BodyKind::frame, {1, 1}}).spec;
  else
    return read_solid_spec(keys, {});
}

void take_section(Keys& /*keys*/, const SectionValue& section, FrameMember& member) {
  member.section = section.numbers;
  if (section.not_in_space.empty()) member.in_space = section.in_space;
}
void take_section(Keys& keys, const SectionValue& section, SpaceMember& member) {
  member.section = section.in_space;
  if (!section.not_in_space.empty()) keys.problem(section.not_in_space);
}

/// Common keys of m:beam and each member of m:frame. Problems are noted in `keys`.
template <int D>
void read_member(Keys& keys, FrameMemberOf<D>& member) {
  const auto* section = keys.maybe_handle<SectionValue>("section");
  if (section != nullptr)
    take_section(keys, *section, member);
  else if (!keys.has("section"))
    keys.missing("section", "a section such as trilith.rectangle_section{width =, depth =}");
  if (auto fibres = read_fibres(keys, section)) member.yields = std::move(*fibres);
  if (const MemberHinges hinges{read_hinges(keys)}; hinges.end[0] || hinges.end[1]) {
    if (std::holds_alternative<MemberFibres>(member.yields))
      keys.problem("it has both a hinge and a section of fibres; keep one");
    member.yields = hinges;
  }
  if constexpr (D == 3) member.orientation = maybe_place<3>(keys, "orientation");
  member.divisions = keys.count("divisions", member.divisions);
  member.shear = keys.flag("shear", false);
  for (const std::string& end : keys.names("pinned")) {
    if (end == "from" || end == "to")
      member.pinned[end == "from" ? 0 : 1] = true;
    else
      keys.problem(fmt::format("'pinned' names '{}', must be \"from\", \"to\" or {{\"from\", \"to\"}}", end));
  }
}

/// The block of a joint: `outline` in the plane, `hull` in space. Its centroid is the default place of the joint.
void read_block(Keys& keys, FrameJoint& joint, const std::string& /*owner*/) {
  joint.block = keys.points("outline");
  if (joint.block.size() >= 3) joint.place = polygon_moments(joint.block).centroid;
  joint.thickness = keys.maybe_number("thickness", "m");
}
void read_block(Keys& keys, SpaceJoint& joint, const std::string& owner) {
  const std::vector<Vec3> points = keys.vectors("hull");
  if (points.empty()) return;
  joint.block = convex_hull(points, owner);
  joint.place = solid_moments(joint.block).centroid;
}

/// A position, or { at =, support =, mass =, inertia = } with or without a block, at the top of the stack.
template <int D>
FrameJointOf<D> joint_at(lua_State* L, const std::string& name) {
  FrameJointOf<D> joint;
  joint.name = name;
  if (const auto place = place_on_top<D>(L)) {
    joint.place = *place;
    return joint;
  }
  if (lua_type(L, -1) != LUA_TTABLE)
    throw InputError(fmt::format("joint '{0}' is {1}, must be {2} or {{ at = {2}, support = \"fixed\" }}", name,
                                 what_is(L, -1), D == 2 ? "{x, y}" : "{x, y, z}"));
  const std::string owner = fmt::format("joint '{}'", name);
  Keys keys(L, -1, owner);
  if (keys.has(D == 2 ? "outline" : "hull")) {
    read_block(keys, joint, owner);
    joint.place = maybe_place<D>(keys, "at").value_or(joint.place);
    joint.density = keys.maybe_number("density", "kg/m3");
  } else {
    joint.place = read_place<D>(keys, "at");
  }
  read_joint_support(keys, "support", joint);
  joint.mass = keys.number("mass", "kg", 0);
  joint.inertia = keys.number("inertia", "kg m2", 0);
  keys.finish();
  return joint;
}

/// joints = { A = position, B = { at = ... }, ... }, sorted by name, because a Lua table has no order.
template <int D>
void read_joints(Keys& keys, FrameSpecOf<D>& frame) {
  lua_State* L = keys.lua();
  const char* const wanted = D == 2 ? "a table such as { A = {0, 0}, B = { at = {0, 4}, support = \"fixed\" } }"
                                    : "a table such as { A = {0, 0, 0}, B = { at = {0, 0, 4}, support = \"fixed\" } }";
  const int type = keys.push("joints");
  if (type == LUA_TNIL) keys.missing("joints", wanted);
  if (type != LUA_TNIL && type != LUA_TTABLE) keys.wrong("joints", wanted);
  if (type == LUA_TTABLE)
    for (const std::string& name : names_in_table(keys, "joints: its keys must be names of joints")) {
      lua_pushlstring(L, name.data(), name.size());
      lua_rawget(L, -2);
      try {
        frame.joints.push_back(joint_at<D>(L, name));
      } catch (const InputError& e) {
        keys.problem(e.what());
      }
      lua_pop(L, 1);
    }
  lua_pop(L, 1);
}

template <int D>
int joint_named(Keys& keys, const FrameSpecOf<D>& frame, const char* key) {
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
template <int D>
void read_members(Keys& keys, FrameSpecOf<D>& frame) {
  if (!keys.has("members"))
    keys.missing("members",
                 "a list such as { { from = \"A\", to = \"B\", section = trilith.rectangle_section{...} } }");
  read_list(keys, "members", "member", [&](Keys& own) {
    FrameMemberOf<D> member;
    member.name = own.text("name", "");
    member.from = joint_named(own, frame, "from"), member.to = joint_named(own, frame, "to");
    member.ends = {maybe_place<D>(own, "from_at"), maybe_place<D>(own, "to_at")};
    member.material = own.text("material", "");
    read_member(own, member);
    frame.members.push_back(std::move(member));
  });
}

/// One member between the joints "from" and "to", with its own name.
template <int D>
FrameSpecOf<D> read_beam(Keys& keys, const std::string& name) {
  FrameSpecOf<D> frame;
  FrameMemberOf<D> member;
  member.name = name, member.from = 0, member.to = 1;
  for (const char* const end : {"from", "to"}) {
    FrameJointOf<D>& joint = frame.joints.emplace_back();
    joint.name = end;
    joint.place = read_place<D>(keys, end);
    read_joint_support(keys, joint.name + "_support", joint);
  }
  read_member(keys, member);
  frame.members = {std::move(member)};
  return frame;
}

template <int D>
FrameSpecOf<D> read_frame(Keys& keys, const std::string& /*name*/) {
  FrameSpecOf<D> frame;
  read_joints(keys, frame);
  read_members(keys, frame);
  return frame;
}

/// Reads the table at argument 2 with `read`, adds the frame as a body and pushes it.
template <int D>
int add_frame(lua_State* L, ModelIn<D>& m, const char* call, FrameSpecOf<D> (*read)(Keys&, const std::string&)) {
  m.adding();
  Keys keys(L, 2, call);
  const std::string name = keys.text("name");
  keys.name_owner(name);
  FrameSpecOf<D> frame = read(keys, name);
  frame.consistent = read_mass_matrix(keys);
  auto spec = read_frame_options<D>(keys);
  keys.finish();
  spec.name = name, spec.frame = std::move(frame);
  m.builder.add_body(std::move(spec));
  m.catch_up();
  push_body(L, 1, m.body_count() - 1);
  return 1;
}

/// m:beam{ name =, from =, to =, section =, ... }
int add_beam(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return add_frame<3>(L, *space, "beam", read_beam<3>);
  return add_frame<2>(L, this_plane(L), "beam", read_beam<2>);
}

/// m:frame{ name =, joints =, members =, ... }
int add_frame_of_members(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return add_frame<3>(L, *space, "frame", read_frame<3>);
  return add_frame<2>(L, this_plane(L), "frame", read_frame<2>);
}

}  // namespace

std::span<const Method> frame_methods() {
  static const std::array methods{
      Method{"beam", guarded<add_beam>},
      Method{"frame", guarded<add_frame_of_members>},
  };
  return methods;
}

}  // namespace trilith::script
