// Heat: thermal properties of bodies, exchange with surroundings, conductance of contacts, temperatures; processes.
#include <algorithm>
#include <array>

#include "base/no_solution.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/fields/heat_reading.hpp"
#include "bindings/fields/seepage_binding.hpp"
#include "bindings/loads/load_reading.hpp"
#include "bindings/loads/side_faces.hpp"
#include "bindings/stages/stage_reading.hpp"
#include "bindings/stages/stage_run.hpp"
#include "field/field_step.hpp"
#include "statics/equilibrium.hpp"

namespace trilith::script {
namespace {

double density_of(const ScriptModel& m, int body) {
  for (const Material& material : m.materials)
    if (material.name == m.material_of(body)) return material.density;
  return 0;
}

/// A copy of the field of heat to change, or an empty one.
template <int D>
Field heat_copy(const Model<D>& model) {
  const auto known = field_of(model.fields, FieldKind::heat);
  return known ? *known : Field{};
}

template <int D>
int declare_heat(lua_State* L, SimulatedModel<D>& m) {
  Keys keys(L, 2, "heat");
  const std::vector<int> bodies = read_loaded_bodies(keys, m);
  HeatSpec spec;
  spec.conductivity = keys.number("conductivity", "W/(m K)"),
  spec.heat_capacity = keys.number("heat_capacity", "J/(kg K)");
  spec.expansion = keys.number("expansion", "1/K", 0);
  spec.temperature = keys.number("temperature", "degC", 0);
  spec.reference = keys.number("reference", "degC", spec.temperature);
  spec.depth = keys.number("depth", "m", 0);
  if (keys.has("depth") && !(spec.depth > 0))
    keys.problem(fmt::format("'depth' is {:g} m, must be above 0", spec.depth));
  finish_between_stages(keys, m, "heat");
  Field field = heat_copy(m.simulation().model());
  for (const int body : bodies) {
    spec.density = density_of(m, body);
    add_heat(field, m.simulation().model(), body, spec);
  }
  m.change([field](Model<D>& changed) { set_field(changed.fields, field); });
  m.follow_more();
  return 0;
}

/// m:heat{ body =, conductivity =, heat_capacity =, expansion =, temperature =, reference =, depth = }.
int heat(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return declare_heat<3>(L, *space);
  return declare_heat<2>(L, this_plane(L));
}

std::string free_surrounding_name(const Field& field) {
  for (int i = 1;; ++i) {
    const std::string name = fmt::format("air {}", i);
    if (std::none_of(field.surroundings.begin(), field.surroundings.end(),
                     [&](const FieldSurrounding& s) { return s.name == name; }))
      return name;
  }
}

/// Frames exchange heat at the lower and the upper face of their sections; other bodies at their outer faces.
template <int D>
void exchange_with(Field& field, const Model<D>& model, const HeatExchangeSpec& spec, const std::vector<int>& bodies,
                   const SideFaces& sides) {
  const std::string owner = fmt::format("heat exchange '{}'", spec.name);
  std::vector<WetFace<D>> faces;
  std::vector<int> frames;
  for (const int body : bodies) {
    const Body& b = model.bodies[static_cast<std::size_t>(body)];
    if (b.kind == BodyKind::frame && field.find(body) != nullptr) {
      if (sides.side != "top" && sides.side != "bottom" && sides.side != "all")
        throw InputError(fmt::format(
            "{}: '{}' is a frame, whose sections exchange heat at \"top\", \"bottom\" or \"all\"", owner, b.name));
      frames.push_back(body);
      continue;
    }
    for (WetFace<D>& face : faces_of(model, body, sides, owner)) faces.push_back(std::move(face));
  }
  if (!faces.empty() || frames.empty()) add_heat_exchange(field, model, spec, faces);
  for (const int body : frames)
    add_frame_exchange(field, beam_lengths(model, body), spec, body, sides.side != "top", sides.side != "bottom");
}

template <int D>
int declare_exchange(lua_State* L, SimulatedModel<D>& m) {
  Keys keys(L, 2, "heat_exchange");
  HeatExchangeSpec spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  const std::vector<int> bodies = read_loaded_bodies(keys, m);
  spec.course = read_course(keys, "temperature", heat_clock(m));
  spec.exchange = keys.maybe_number("exchange", "W/(m2 K)");
  const SideFaces sides = read_sides<D>(keys, "the exchange needs the side of the bodies");
  finish_between_stages(keys, m, "heat");
  Field field = require_heat(m.simulation().model(), "heat_exchange");
  if (spec.name.empty()) spec.name = free_surrounding_name(field);
  exchange_with(field, m.simulation().model(), spec, bodies, sides);
  m.change([field](Model<D>& changed) { set_field(changed.fields, field); });
  return push_load_name(L, spec.name);
}

/// m:heat_exchange{ body =, side = | from =, to =, temperature =, exchange =, name = }: returns its name.
int heat_exchange(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return declare_exchange<3>(L, *space);
  return declare_exchange<2>(L, this_plane(L));
}

template <int D>
int declare_contact(lua_State* L, SimulatedModel<D>& m) {
  Keys keys(L, 2, "heat_contact");
  const double conductance = keys.number("conductance", "W/(m2 K)");
  if (!(conductance >= 0))
    keys.problem(fmt::format("'conductance' is {:g} W/(m2 K), must not be below 0", conductance));
  const bool friction = keys.flag("friction", false);
  std::vector<int> bodies;
  const bool chosen = keys.push("body") != LUA_TNIL;
  lua_pop(L, 1);
  if (chosen) bodies = read_loaded_bodies(keys, m);
  finish_between_stages(keys, m, "heat");
  Field field = require_heat(m.simulation().model(), "heat_contact");
  if (!chosen) field.contacts.push_back({-1, -1, conductance});
  for (const int body : bodies) field.contacts.push_back({body, -1, conductance});
  if (friction) add_friction_heat(field);
  m.change([field](Model<D>& changed) { set_field(changed.fields, field); });
  return 0;
}

/// m:heat_contact{ conductance =, body =, friction = }.
int heat_contact(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return declare_contact<3>(L, *space);
  return declare_contact<2>(L, this_plane(L));
}

/// Sets the temperatures of a body: `gradient` upwards from its centroid at the start, in frames over the depth of
/// their sections.
template <int D>
void set_body(const Field& field, const Model<D>& model, const FieldBody& row, double temperature, double gradient,
              FieldState& state) {
  const Body& b = model.bodies[static_cast<std::size_t>(row.body)];
  double mass = 0, height = 0;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
    const auto i = static_cast<std::size_t>(n);
    mass += model.mass[i], height += model.mass[i] * model.start_position[i][D - 1];
  }
  height /= mass;
  extend_field(field, state);
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
    const auto set = [&](int cell, double t) { state.value[static_cast<std::size_t>(cell)] = t; };
    if (row.layout == CellLayout::sections) {
      for (const int face : {0, 1})
        set(row.cell_of(n, face), temperature + (face == 0 ? -0.5 : 0.5) * row.depth * gradient);
    } else {
      set(row.cell_of(n), temperature + gradient * (model.start_position[static_cast<std::size_t>(n)][D - 1] - height));
    }
  }
}

template <int D>
int change_temperature(lua_State* L, SimulatedModel<D>& m) {
  Keys keys(L, 2, "set_temperature");
  const std::vector<int> bodies = read_loaded_bodies(keys, m);
  const double temperature = keys.number("temperature", "degC"), gradient = keys.number("gradient", "K/m", 0);
  finish_between_stages(keys, m, "heat");
  const Model<D>& model = m.simulation().model();
  const Field& field = require_heat(model, "set_temperature");
  for (const int body : bodies) {
    const FieldBody* row = field.find(body);
    if (row == nullptr)
      throw InputError(
          fmt::format("set_temperature: body '{}' has no thermal properties; give them by m:heat", m.body_name(body)));
    if (row->layout == CellLayout::one && gradient != 0)
      throw InputError(fmt::format("set_temperature: body '{}' is rigid and has one temperature; leave out gradient",
                                   m.body_name(body)));
  }
  m.simulation().change_fields([&](State<D>& state) {
    for (const int body : bodies)
      set_body(field, model, *field.find(body), temperature, gradient,
               state.fields[static_cast<std::size_t>(row_of(model.fields, FieldKind::heat))]);
  });
  return 0;
}

/// m:set_temperature{ body =, temperature =, gradient = }.
int set_temperature(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return change_temperature<3>(L, *space);
  return change_temperature<2>(L, this_plane(L));
}

std::optional<Vec2> point_argument(lua_State* L, const PlaneModel& /*m*/) {
  return point_at(L, 3);
}
std::optional<Vec3> point_argument(lua_State* L, const SpaceModel& /*m*/) {
  return vector_at(L, 3);
}

template <int D, class M>
int read_temperature(lua_State* L, M& m) {
  const std::vector<int> bodies = some_bodies_at(L, 2, m, "temperature");
  if (bodies.size() != 1) throw InputError(fmt::format("temperature: {} bodies are given, must be one", bodies.size()));
  const auto at = point_argument(L, m);
  if (!lua_isnoneornil(L, 3) && !at)
    throw InputError(
        fmt::format("temperature: the point is {}, must be {}", what_is(L, 3), D == 2 ? "{x, y}" : "{x, y, z}"));
  const Model<D>& model = m.simulation().model();
  require_heat(model, "temperature");
  const FieldValues heat = values_of(model.fields, m.simulation().state().fields, FieldKind::heat);
  const int body = bodies.front();
  const std::string owner = fmt::format("temperature of '{}'", m.body_name(body));
  const BodyTemperature t = at ? temperature_of(model, heat, body, *at, owner) : temperature_of(heat, {body}, owner);
  lua_pushnumber(L, t.value), lua_pushnumber(L, t.difference);
  return 2;
}

/// m:temperature(body, point): the mean of a body, or its temperature at a point at the start [degC]; and the
/// difference over the depth of a frame.
int temperature(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return read_temperature<3>(L, *space);
  return read_temperature<2>(L, this_plane(L));
}

template <int D>
int read_heat(lua_State* L, SimulatedModel<D>& m) {
  const Field& field = require_heat(m.simulation().model(), "heat_state");
  FieldState state;
  if (const FieldState* known = heat_values(m)) state = *known;
  extend_field(field, state);
  lua_createtable(L, 0, 5);
  if (field.friction >= 0) set_number(L, "friction", state.supplied[static_cast<std::size_t>(field.friction)]);
  set_number(L, "clock", state.clock), set_number(L, "content", content_of(field, state));
  set_integer(L, "cells", field.cells());
  lua_createtable(L, 0, static_cast<int>(field.surroundings.size()));
  for (std::size_t i = 0; i < field.surroundings.size(); ++i) {
    if (static_cast<int>(i) == field.friction) continue;
    lua_createtable(L, 0, 2);
    set_number(L, "temperature", field.surroundings[i].course.at(state.clock));
    set_number(L, "supplied", state.supplied[i]);
    lua_setfield(L, -2, field.surroundings[i].name.c_str());
  }
  lua_setfield(L, -2, "surroundings");
  return 1;
}

/// m:heat_state(): clock, content, cells, and temperature and supplied heat of each surrounding.
int heat_state(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return read_heat<3>(L, *space);
  return read_heat<2>(L, this_plane(L));
}

/// m:process{ duration =, step =, mechanics =, within =, tolerance =, or_go_on =, name = }: pushes a report.
int process(lua_State* L) {
  ScriptModel& m = this_model(L);
  Keys keys(L, 2, "process");
  StageOptions o;
  EquilibriumOptions how;
  o.name = keys.text("name", "process");
  FieldProcess process;
  process.duration = keys.number("duration", "s"), process.step = keys.number("step", "s");
  process.mechanics = keys.flag("mechanics", true);
  how.within = keys.number("within", "1", usual_travel), how.tolerance = keys.number("tolerance", "1", how.tolerance);
  if (!(how.within > 0))
    keys.problem(fmt::format("'within' is {:g}, must be above 0: a share of each body's size", how.within));
  if (!(how.tolerance > 0 && how.tolerance <= 0.01))
    keys.problem(fmt::format("'tolerance' is {:g}, must be above 0 and at most 0.01", how.tolerance));
  const bool goes_on = keys.flag("or_go_on", false);
  if (m.running()) keys.problem("a stage runs already; a process is a stage of its own");
  keys.finish();
  o.duration = 1, o.within = static_cast<float>(how.within), o.process = process;
  m.build();
  const StageReport report = settle_stage(L, m, o, how);
  const bool rests = report.end == StageEnd::rest || report.end == StageEnd::stopped;
  if (!rests && !goes_on)
    throw NoSolution(
        fmt::format("{} found no equilibrium {}; or_go_on = true continues anyway", o.name, report.reason));
  push_report(L, report);
  return 1;
}

const std::array heat_method_list{
    Method{"heat", guarded<heat>},
    Method{"heat_exchange", guarded<heat_exchange>},
    Method{"heat_contact", guarded<heat_contact>},
    Method{"set_temperature", guarded<set_temperature>},
    Method{"temperature", guarded<temperature>},
    Method{"heat_state", guarded<heat_state>},
    Method{"process", guarded<process>},
    Method{"seepage", guarded<seepage>},
    Method{"seepage_head", guarded<seepage_head>},
    Method{"seepage_motion", guarded<seepage_motion>},
    Method{"seepage_state", guarded<seepage_state>},
};

}  // namespace

std::span<const Method> heat_methods() {
  return heat_method_list;
}

}  // namespace trilith::script
