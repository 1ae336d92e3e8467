#include "bindings/fields/seepage_binding.hpp"

#include <algorithm>

#include "assembly/field/joint_water.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/fields/heat_reading.hpp"
#include "bindings/fields/seepage_reading.hpp"
#include "bindings/loads/load_reading.hpp"
#include "field/field_step.hpp"
#include "model/field/seepage.hpp"
#include "model/names.hpp"

namespace trilith::script {
namespace {

/// A number, or {number, number} for both ends.
std::array<double, 2> read_ends(Keys& keys, const char* key, const char* unit, bool must_be_given) {
  lua_State* L = keys.lua();
  std::array<double, 2> out{};
  const int type = keys.push(key);
  if (type == LUA_TNUMBER) {
    out[0] = out[1] = lua_tonumber(L, -1);
  } else if (const auto ends = type == LUA_TTABLE ? point_at(L, -1) : std::nullopt; ends) {
    out = {ends->x(), ends->y()};
  } else if (type != LUA_TNIL) {
    keys.wrong(key, fmt::format("a number [{}], or {{number, number}} for both ends", unit));
  } else if (must_be_given) {
    keys.missing(key, fmt::format("a number [{}], or {{number, number}} for both ends", unit));
  }
  lua_pop(L, 1);
  return out;
}

void read_fissure(Keys& keys, SeepageSpec& spec) {
  spec.length = keys.number("length", "m"), spec.width = keys.number("width", "m", 1);
  spec.elevation = read_ends(keys, "elevation", "m", false);
  spec.stiffness = keys.number("stiffness", "Pa/m", 0);
  keys.refuse("heel", "'heel' is the first end of a joint between bodies; a fissure has none");
}

void read_joint(Keys& keys, const ScriptModel& m, SeepageSpec& spec) {
  // A body that is given is checked before the lack of the other one is reported.
  const bool lower_first = !keys.has("upper");
  if (lower_first) spec.lower = read_one_body(keys, "lower", m);
  spec.upper = read_one_body(keys, "upper", m);
  if (!lower_first) spec.lower = read_one_body(keys, "lower", m);
  if (spec.upper >= 0 && spec.upper == spec.lower) keys.problem("'upper' and 'lower' are the same body");
  if (m.dim() == 2)
    spec.heel = keys.maybe_point("heel");
  else if (keys.has("heel"))
    spec.heel_in_space = keys.vector("heel");
  for (const char* key : {"length", "width", "elevation", "stiffness"})
    keys.refuse(key, fmt::format("'{}' follows from the bodies of the joint; leave it out", key));
}

void require_whole_bodies(SimulatedModel<3>& m, const SeepageSpec& spec) {
  for (const CrackingBody<3>& c : m.simulation().cracking().bodies)
    if (c.body == spec.upper || c.body == spec.lower)
      throw InputError(
          fmt::format("seepage '{}': body '{}' has crack planes, and in space water does not follow a crack; give it "
                      "cracks = false, join two bodies by a bond, or model a section in the plane",
                      spec.name, m.body_name(c.body)));
}

std::string free_seepage_name(const Field& field) {
  for (int i = 1;; ++i) {
    const std::string name = fmt::format("seepage {}", i);
    if (!field.flow || field.flow->find(name) == nullptr) return name;
  }
}

template <int D>
Field seepage_copy(const Model<D>& model) {
  const auto known = field_of(model.fields, FieldKind::seepage);
  return known ? *known : Field{};
}

template <int D>
int declare_seepage(lua_State* L, SimulatedModel<D>& m) {
  Keys keys(L, 2, "seepage");
  SeepageSpec spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  if (keys.has("upper") || keys.has("lower"))
    read_joint(keys, m, spec);
  else if (keys.has("length"))
    read_fissure(keys, spec);
  else
    keys.problem(
        "give upper and lower, the bodies of a joint, or length, of a "
        "fissure [m]");
  keys.know({"upper", "lower", "heel", "length", "width", "elevation", "stiffness"});
  spec.aperture = read_ends(keys, "aperture", "m", true);
  if (spec.upper >= 0 || spec.lower >= 0)
    spec.crack_aperture = keys.number("crack_aperture", "m", 0);
  else
    keys.refuse("crack_aperture", "'crack_aperture' is of cracks of the bodies of a joint; a fissure has none");
  if (keys.has("crack_aperture") && !(spec.crack_aperture > 0))
    keys.problem(fmt::format("'crack_aperture' is {:g} m, must be above 0", spec.crack_aperture));
  spec.divisions = keys.count("divisions", 32);
  spec.from = keys.text("from", spec.name + ".from"), spec.to = keys.text("to", spec.name + ".to");
  spec.filled = keys.flag("filled", true);
  spec.density = keys.number("density", "kg/m3", 1000), spec.viscosity = keys.number("viscosity", "Pa s", 1e-3);
  spec.bulk_modulus = keys.number("bulk_modulus", "Pa", 2.2e9);
  finish_between_stages(keys, m, "seepage");
  const Model<D>& model = m.simulation().model();
  Field field = seepage_copy(model);
  if (spec.name.empty()) spec.name = free_seepage_name(field);
  if constexpr (D == 3) require_whole_bodies(m, spec);
  if (const FieldState* values = seepage_values(m); values != nullptr && !values->value.empty())
    throw InputError(
        fmt::format("seepage '{}': water flows already; declare "
                    "all joints before the first process",
                    spec.name));
  add_seepage(field, model, spec);
  m.change([field](Model<D>& changed) { set_field(changed.fields, field); });
  m.follow_more();
  return push_load_name(L, spec.name);
}

template <int D>
int declare_head(lua_State* L, SimulatedModel<D>& m) {
  Keys keys(L, 2, "seepage_head");
  FieldSurrounding head;
  const std::string node = keys.text("node");
  const FieldState* values = seepage_values(m);
  if (keys.has("water") == keys.has("head")) keys.problem("give either head, a course, or water, the name of a water");
  if (keys.has("water"))
    head.name = keys.text("water");
  else
    head.name = node, head.course = read_course(keys, "head", values == nullptr ? 0 : values->clock);
  finish_between_stages(keys, m, "seepage");
  const Model<D>& model = m.simulation().model();
  Field field = require_seepage(model, "seepage_head");
  add_seepage_head(field, model, node, head);
  m.change([field](Model<D>& changed) { set_field(changed.fields, field); });
  return 0;
}

template <int D>
int choose_motion(lua_State* L, SimulatedModel<D>& m) {
  Keys keys(L, 2, "seepage_motion");
  const bool flows = keys.flag("flows", true);
  finish_between_stages(keys, m, "seepage");
  Field field = require_seepage(m.simulation().model(), "seepage_motion");
  JointFlow flow = *field.flow;
  flow.in_motion = flows, flow.is_chosen = true;
  field.flow = std::make_shared<const JointFlow>(std::move(flow));
  m.change([field](Model<D>& changed) { set_field(changed.fields, field); });
  return 0;
}

/// Why the water of a model with seepage is held in a stage of motion with
/// these options; empty if it flows.
template <int D>
std::string held_reason(const SimulatedModel<D>& m, const StageOptions& o) {
  const auto field = m.if_built() == nullptr ? nullptr : field_of(m.if_built()->model().fields, FieldKind::seepage);
  if (!field) return {};
  const JointFlow& flow = *field->flow;
  if (!flow.in_motion)
    return flow.is_chosen ? ""
                          : "m:seepage_motion { flows = true } lets it flow in "
                            "stages of motion, flows = false ends this note";
  if (o.rest_share > 0)
    return "local damping brings bodies to rest in a time without meaning; "
           "leave out local_damping";
  if (D == 3 && flow.has_bodies()) return "in space water flows between bodies in processes alone";
  if (!flow.has_bodies() || bound_of(o.integrator) == StepBound::stability) return {};
  return fmt::format(
      "{} steps are longer than the water between two bodies "
      "needs; leave out integrator, for explicit steps",
      o.may_change ? "implicit" : "these");
}

void set_list(lua_State* L, const char* key, const std::vector<double>& values) {
  lua_createtable(L, static_cast<int>(values.size()), 0);
  for (std::size_t i = 0; i < values.size(); ++i)
    lua_pushnumber(L, values[i]), lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  lua_setfield(L, -2, key);
}

void push_joint(lua_State* L, const JointReading& now) {
  lua_createtable(L, 0, 14);
  set_list(L, "head", now.head), set_list(L, "pressure", now.pressure);
  set_list(L, "aperture", now.aperture), set_list(L, "fill", now.fill);
  set_number(L, "volume", now.volume), set_number(L, "wet_length", now.wet_length);
  set_number(L, "length", now.length);
  set_number(L, "head_from", now.head_from), set_number(L, "head_to", now.head_to);
  set_number(L, "inflow", now.inflow), set_number(L, "outflow", now.outflow);
}

/// Of all parts of a joint.
template <class Thrust, int D>
Thrust thrust_of(const Simulation<D>& s, const JointFlow& flow, const FlowJoint& joint) {
  Thrust out;
  for (const FlowJoint& j : flow.joints) {
    if (j.name != joint.name) continue;
    const Thrust one = thrust_on_upper(j, s.model(), s.state());
    out.force += one.force, out.moment += one.moment;
  }
  return out;
}
void set_thrust(lua_State* L, const Simulation<2>& s, const JointFlow& flow, const FlowJoint& j) {
  const auto thrust = thrust_of<JointThrust>(s, flow, j);
  set_list(L, "force", {thrust.force.x(), thrust.force.y()}), set_number(L, "moment", thrust.moment);
}
void set_thrust(lua_State* L, const Simulation<3>& s, const JointFlow& flow, const FlowJoint& j) {
  const auto thrust = thrust_of<SpaceThrust>(s, flow, j);
  set_list(L, "force", {thrust.force.x(), thrust.force.y(), thrust.force.z()});
  set_list(L, "moment", {thrust.moment.x(), thrust.moment.y(), thrust.moment.z()});
}

void push_network(lua_State* L, const Field& field, const FieldState& state, const FlowPicture& now) {
  lua_createtable(L, 0, 4);
  set_number(L, "clock", state.clock), set_number(L, "volume", volume_of(*field.flow, state));
  set_integer(L, "cells", field.flow->cells());
  lua_createtable(L, 0, static_cast<int>(field.flow->nodes.size()));
  for (std::size_t i = 0; i < field.flow->nodes.size(); ++i) {
    const FlowNode& node = field.flow->nodes[i];
    lua_createtable(L, 0, 4);
    set_number(L, "head", now.node_head[i]), set_number(L, "elevation", node.elevation);
    set_number(L, "inflow", now.into[i]);
    if (node.surrounding >= 0) set_number(L, "supplied", state.supplied[static_cast<std::size_t>(node.surrounding)]);
    lua_setfield(L, -2, node.name.c_str());
  }
  lua_setfield(L, -2, "nodes");
}

template <int D>
int read_seepage(lua_State* L, SimulatedModel<D>& m) {
  const Simulation<D>& s = m.simulation();
  const Model<D>& model = s.model();
  const Field& field = require_seepage(model, "seepage_state");
  const SeepageNow<D> now(s);
  if (lua_isnoneornil(L, 2)) {
    push_network(L, field, now.state, now.flows);
    return 1;
  }
  if (lua_type(L, 2) != LUA_TSTRING)
    throw InputError(fmt::format("seepage_state: the name is {}, must be the name of a joint", what_is(L, 2)));
  const FlowJoint& joint = require_flow_joint(field, text_at(L, 2), "seepage_state");
  push_joint(L, now.joint(joint));
  if (joint.has_bodies()) set_thrust(L, s, *field.flow, joint);
  return 1;
}

}  // namespace

int seepage(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return declare_seepage<3>(L, *space);
  return declare_seepage<2>(L, this_plane(L));
}

int seepage_head(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return declare_head<3>(L, *space);
  return declare_head<2>(L, this_plane(L));
}

int seepage_motion(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return choose_motion<3>(L, *space);
  return choose_motion<2>(L, this_plane(L));
}

std::string held_water_note(ScriptModel& m, const StageOptions& o) {
  const std::string why = as_space(m) != nullptr ? held_reason<3>(*as_space(m), o) : held_reason<2>(*as_plane(m), o);
  if (why.empty()) return why;
  return fmt::format("{}: the pressures of the water in joints are held{}: {}", o.name,
                     o.may_change ? " in implicit steps" : "", why);
}

int seepage_state(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return read_seepage<3>(L, *space);
  return read_seepage<2>(L, this_plane(L));
}

}  // namespace trilith::script
