#include "bindings/fields/seepage_binding.hpp"

#include <algorithm>

#include "assembly/field/joint_water.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/fields/heat_reading.hpp"
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
  keys.refuse("heel", "is the first end of a joint between bodies; a fissure has none");
}

void read_joint(Keys& keys, const ScriptModel& m, SeepageSpec& spec) {
  spec.upper = read_one_body(keys, "upper", m), spec.lower = read_one_body(keys, "lower", m);
  if (spec.upper >= 0 && spec.upper == spec.lower) keys.problem("'upper' and 'lower' are the same body");
  if (m.dim() == 2)
    spec.heel = keys.maybe_point("heel");
  else
    keys.know({"heel"});
  for (const char* key : {"length", "width", "elevation", "stiffness"})
    keys.refuse(key, "follows from the bodies of the joint; leave it out");
}

template <int D>
void require_whole_bodies(SimulatedModel<D>& m, const SeepageSpec& spec) {
  for (const CrackingBody<D>& c : m.simulation().cracking().bodies)
    if (c.body == spec.upper || c.body == spec.lower)
      throw InputError(fmt::format(
          "seepage '{}': body '{}' has crack planes: give it cracks = false, or model its parts as bodies with a bond "
          "between them",
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
const FieldState* seepage_values(const SimulatedModel<D>& m, const Model<D>& model) {
  const int row = row_of(model.fields, FieldKind::seepage);
  const Simulation<D>* s = m.if_built();
  if (s == nullptr || row < 0 || static_cast<std::size_t>(row) >= s->state().fields.size()) return nullptr;
  return &s->state().fields[static_cast<std::size_t>(row)];
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
    keys.problem("give upper and lower, the bodies of a joint, or length, of a fissure [m]");
  keys.know({"upper", "lower", "heel", "length", "width", "elevation", "stiffness"});
  spec.aperture = read_ends(keys, "aperture", "m", true);
  spec.divisions = keys.count("divisions", 32);
  spec.from = keys.text("from", spec.name + ".from"), spec.to = keys.text("to", spec.name + ".to");
  spec.filled = keys.flag("filled", true);
  spec.density = keys.number("density", "kg/m3", 1000), spec.viscosity = keys.number("viscosity", "Pa s", 1e-3);
  spec.bulk_modulus = keys.number("bulk_modulus", "Pa", 2.2e9);
  finish_between_stages(keys, m, "seepage");
  const Model<D>& model = m.simulation().model();
  Field field = seepage_copy(model);
  if (spec.name.empty()) spec.name = free_seepage_name(field);
  require_whole_bodies(m, spec);
  if (const FieldState* values = seepage_values(m, model); values != nullptr && !values->value.empty())
    throw InputError(
        fmt::format("seepage '{}': water flows already; declare all joints before the first process", spec.name));
  add_seepage(field, model, spec);
  m.change([field](Model<D>& changed) { set_field(changed.fields, field); });
  return push_load_name(L, spec.name);
}

template <int D>
const Field& require_seepage(const Model<D>& model, const std::string& owner) {
  const int row = row_of(model.fields, FieldKind::seepage);
  if (row < 0) throw InputError(owner + ": there is no joint with seepage; declare m:seepage first");
  return *model.fields[static_cast<std::size_t>(row)];
}

template <int D>
int declare_head(lua_State* L, SimulatedModel<D>& m) {
  Keys keys(L, 2, "seepage_head");
  FieldSurrounding head;
  const std::string node = keys.text("node");
  const Simulation<D>* built = m.if_built();
  const FieldState* values = built == nullptr ? nullptr : seepage_values(m, built->model());
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

void set_list(lua_State* L, const char* key, const std::vector<double>& values) {
  lua_createtable(L, static_cast<int>(values.size()), 0);
  for (std::size_t i = 0; i < values.size(); ++i)
    lua_pushnumber(L, values[i]), lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  lua_setfield(L, -2, key);
}

/// Instantaneous flows: the heads of nodes follow from the balance of their links.
struct FlowPicture {
  std::vector<double> node_head;  ///< [node] [m]
  std::vector<double> into;       ///< [node] flow from the node into its joints [m3/s]
};
struct NodeSum {
  double conductance = 0, drive = 0;
};
double half_conductance(const FlowJoint& j, double a0, double a1) {
  const double length = 0.5 * j.cell_length();
  return j.width * j.weight * 2 * a0 * a0 * a1 * a1 / (12 * j.viscosity * length * (a0 + a1));
}

template <class F>
void for_joint_ends(const JointFlow& flow, const Apertures& apertures, const FieldState& state, F&& f) {
  for (const FlowJoint& j : flow.joints)
    for (const bool first : {true, false}) {
      const int i = first ? 0 : j.cells - 1;
      const auto cell = static_cast<std::size_t>(j.first_cell + i);
      const auto [a0, a1] = apertures[cell];
      const double middle = 0.5 * (a0 + a1),
                   k = first ? half_conductance(j, a0, middle) : half_conductance(j, middle, a1);
      const bool wet = state.value[static_cast<std::size_t>(flow.cells()) + cell] > 0;
      f(j, first ? j.from : j.to, k, j.elevation_at((i + 0.5) / j.cells) + state.value[cell], wet);
    }
}

FlowPicture picture_of(const JointFlow& flow, const Apertures& apertures, const FieldState& state,
                       const std::vector<double>& heads) {
  std::vector<NodeSum> sums(flow.nodes.size());
  for_joint_ends(flow, apertures, state, [&](const FlowJoint&, int node, double k, double head, bool wet) {
    if (wet)
      sums[static_cast<std::size_t>(node)].conductance += k, sums[static_cast<std::size_t>(node)].drive += k * head;
  });
  FlowPicture out;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const FlowNode& node = flow.nodes[i];
    const bool given = node.surrounding >= 0;
    out.node_head.push_back(given ? std::max(heads[static_cast<std::size_t>(node.surrounding)], node.elevation)
                            : sums[i].conductance > 0 ? sums[i].drive / sums[i].conductance
                                                      : node.elevation);
  }
  out.into.assign(sums.size(), 0);
  for_joint_ends(flow, apertures, state, [&](const FlowJoint&, int node, double k, double head, bool wet) {
    const auto n = static_cast<std::size_t>(node);
    const bool air = flow.nodes[n].surrounding >= 0 && out.node_head[n] <= flow.nodes[n].elevation;
    if (air && (!wet || head <= out.node_head[n])) return;
    out.into[n] += k * (out.node_head[n] - head);
  });
  return out;
}

void push_joint(lua_State* L, const JointFlow& flow, const FlowJoint& j, const Apertures& apertures,
                const FieldState& state, const FlowPicture& now) {
  std::vector<double> head, pressure, aperture, fill;
  double volume = 0, front = 0;
  for (int i = 0; i < j.cells; ++i) {
    const auto cell = static_cast<std::size_t>(j.first_cell + i);
    const double psi = state.value[cell], water = state.value[static_cast<std::size_t>(flow.cells()) + cell];
    const double a = 0.5 * (apertures[cell][0] + apertures[cell][1]), room = j.width * j.cell_length() * a;
    head.push_back(j.elevation_at((i + 0.5) / j.cells) + psi), pressure.push_back(j.weight * psi);
    aperture.push_back(a), fill.push_back(std::min(1.0, water / room));
    volume += water, front += fill.back() * j.cell_length();
  }
  lua_createtable(L, 0, 12);
  set_list(L, "head", head), set_list(L, "pressure", pressure);
  set_list(L, "aperture", aperture), set_list(L, "fill", fill);
  set_number(L, "volume", volume), set_number(L, "wet_length", front), set_number(L, "length", j.length);
  const auto from = static_cast<std::size_t>(j.from), to = static_cast<std::size_t>(j.to);
  set_number(L, "head_from", now.node_head[from]), set_number(L, "head_to", now.node_head[to]);
  double inflow = 0, outflow = 0;
  for_joint_ends(flow, apertures, state, [&](const FlowJoint& one, int node, double k, double h, bool /*wet*/) {
    if (&one != &j) return;
    const double q = k * (now.node_head[static_cast<std::size_t>(node)] - h);
    if (node == j.from) inflow = q;
    if (node == j.to) outflow = -q;
  });
  set_number(L, "inflow", inflow), set_number(L, "outflow", outflow);
}

void set_thrust(lua_State* L, const Simulation<2>& s, const FlowJoint& j) {
  const JointThrust thrust = thrust_on_upper(j, s.model(), s.state());
  set_list(L, "force", {thrust.force.x(), thrust.force.y()}), set_number(L, "moment", thrust.moment);
}
void set_thrust(lua_State* /*L*/, const Simulation<3>& /*s*/, const FlowJoint& /*j*/) {}

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
  FieldState state;
  if (const FieldState* values = seepage_values(m, model)) state = *values;
  extend_field(field, state);
  const Apertures apertures = joint_apertures(*field.flow, state, model, s.state());
  const FlowPicture now =
      picture_of(*field.flow, apertures, state, seepage_heads(field, model, state.clock, s.state().time));
  if (lua_isnoneornil(L, 2)) {
    push_network(L, field, state, now);
    return 1;
  }
  if (lua_type(L, 2) != LUA_TSTRING)
    throw InputError(fmt::format("seepage_state: the name is {}, must be the name of a joint", what_is(L, 2)));
  const std::string name = text_at(L, 2);
  const FlowJoint* joint = field.flow->find(name);
  if (joint == nullptr) {
    std::vector<std::string> names;
    for (const FlowJoint& j : field.flow->joints) names.push_back(j.name);
    throw InputError(fmt::format("seepage_state: there is no joint '{}'{}", name, name_hint(name, names)));
  }
  push_joint(L, *field.flow, *joint, apertures, state, now);
  if (joint->has_bodies()) set_thrust(L, s, *joint);
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

int seepage_state(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return read_seepage<3>(L, *space);
  return read_seepage<2>(L, this_plane(L));
}

}  // namespace trilith::script
