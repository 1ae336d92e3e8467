// Models: constructors and properties.
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/portable.hpp"
#include "base/team.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/geometry/solid_makers.hpp"
#include "bindings/model/model_binding.hpp"
#include "bindings/readings/body_reading.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "model/io/motion_hash.hpp"

namespace trilith::script {
namespace {

Energy energy_of(ScriptModel& m) {
  return m.energy();
}

/// __index of that table for unknown terms.
int no_such_term(lua_State* L) {
  std::vector<std::string> known;
  for (const EnergyTermInfo& term : energy_term_info) known.emplace_back(term.name);
  known.emplace_back("residual");
  const std::string name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : what_is(L, 2);
  const std::string near = nearest_name(name, known);
  throw InputError(fmt::format("the energy balance has no '{}'{} are {}", name,
                               near.empty() ? "; its terms" : fmt::format("; did you mean '{}'? Its terms", near),
                               fmt::join(known, ", ")));
}

/// All terms of the ledger [J] by name, and their residual.
void push_energy(lua_State* L, const ModelBox& box) {
  const Energy e = energy_of(box.get());
  lua_newtable(L);
  for (int i = 0; i < energy_terms; ++i) {
    lua_pushnumber(L, e.value[static_cast<std::size_t>(i)]);
    lua_setfield(L, -2, std::string(energy_term_info[static_cast<std::size_t>(i)].name).c_str());
  }
  lua_pushnumber(L, box.get().residual());
  lua_setfield(L, -2, "residual");
  if (luaL_newmetatable(L, "trilith.energy") != 0) set_function(L, "__index", guarded<no_such_term>);
  lua_setmetatable(L, -2);
}

void push_notes(lua_State* L, const ModelBox& box) {
  lua_newtable(L);
  lua_Integer i = 0;
  for (const std::string& note : box.get().notes()) {
    push_text(L, note);
    lua_rawseti(L, -2, ++i);
  }
}

void push_events(lua_State* L, const ModelBox& box) {
  lua_newtable(L);
  lua_Integer i = 0;
  for (const Event& e : box.get().events) {
    push_event(L, 1, e);
    lua_rawseti(L, -2, ++i);
  }
}

void push_hash(lua_State* L, const ModelBox& box) {
  push_text(L, fmt::format("{:016x}", box.get().hash()));
}

/// A list that the library made for the model, by name: bearings, seats.
template <const char* const& field>
void push_own(lua_State* L, const ModelBox&) {
  push_own_table(L, 1);
  lua_pushstring(L, field);
  lua_rawget(L, -2);
}
const char* const bearings_field = "bearings";
const char* const seats_field = "seats";
const char* const storeys_field = "storeys";

void push_verdict(lua_State* L, const ModelBox& box) {
  const Verdict& verdict = box.get().verdict();
  lua_createtable(L, 0, 4);
  luaL_setmetatable(L, "trilith.findings");
  lua_pushboolean(L, verdict.sound() ? 1 : 0);
  lua_setfield(L, -2, "sound");
  lua_pushnumber(L, verdict.sound() ? box.get().time() : verdict.sound_until());
  lua_setfield(L, -2, "sound_until");
  lua_pushinteger(L, verdict.left());
  lua_setfield(L, -2, "left");
  push_text(L, verdict.text());
  lua_setfield(L, -2, "text");
}

/// Present gravity, with its growth and tilt; before the model is built, as given.
template <int D>
Vec<D> gravity_now(const SimulatedModel<D>& m, const Vec<D>& given) {
  return m.if_built() == nullptr ? given : m.if_built()->model().gravity.at(m.time());
}

template <int D>
void push_list(lua_State* L, const Vec<D>& v) {
  lua_createtable(L, D, 0);
  for (int k = 0; k < D; ++k) {
    lua_pushnumber(L, v[k]);
    lua_rawseti(L, -2, k + 1);
  }
}

void push_gravity(lua_State* L, const ModelBox& box) {
  const ScriptModel& m = box.get();
  if (const PlaneModel* plane = as_plane(m)) return push_list<2>(L, gravity_now<2>(*plane, plane->builder.gravity));
  const auto& space = static_cast<const SpaceModel&>(m);
  push_list<3>(L, gravity_now<3>(space, space.builder.gravity));
}

/// Counter-clockwise; the present tilt, which may exceed a whole turn, plus the sum of previous ones.
double tilt_in(const PlaneModel& m) {
  const Gravity<2>& g = m.if_built()->model().gravity;
  const Vec2& first = m.builder.gravity;
  return portable::atan2(cross(first, g.field), first.dot(g.field)) + g.angle(m.time());
}
/// The angle between the present and the initial direction of gravity, at most pi.
double tilt_in(const SpaceModel& m) {
  const Vec3 now = m.if_built()->model().gravity.grown(m.time());
  const Vec3& first = m.builder.gravity;
  return portable::atan2(cross(first, now).norm(), first.dot(now));
}
/// Rotation of gravity from its initial direction [rad].
double tilt_now(const ModelBox& box) {
  const ScriptModel& m = box.get();
  if (!m.built()) return 0;
  if (const PlaneModel* plane = as_plane(m)) return tilt_in(*plane);
  return tilt_in(static_cast<const SpaceModel&>(m));
}

using ModelProperty = Property<ModelBox>;
const std::array model_properties{
    ModelProperty{"name", "", "its name", nullptr, [](lua_State* L, const ModelBox& m) { push_text(L, m.get().name); }},
    ModelProperty{"time", "s", "time of the simulation", [](const ModelBox& m) { return m.get().time(); }},
    ModelProperty{"dt", "s", "length of the last step, 0 before the first",
                  [](const ModelBox& m) { return m.get().step_numbers().last_dt; }},
    ModelProperty{"steps", "1", "steps taken",
                  [](const ModelBox& m) { return static_cast<double>(m.get().step_numbers().steps); }},
    ModelProperty{"dim", "", "2 in the plane, 3 in space", nullptr,
                  [](lua_State* L, const ModelBox& m) { lua_pushinteger(L, m.get().dim()); }},
    ModelProperty{"thickness", "m", "out of the plane", [](const ModelBox& m) { return m.plane().builder.thickness; }},
    ModelProperty{"gravity", "", "present gravity [m/s2]: {x, y}, in space {x, y, z}", nullptr, push_gravity},
    ModelProperty{"tilted", "rad", "angle of gravity from its initial direction, see m:tilt", tilt_now},
    ModelProperty{"speed", "m/s", "largest speed of a point",
                  [](const ModelBox& m) { return m.get().step_numbers().speed; }},
    ModelProperty{"ratio", "1", "out-of-balance ratio: unbalanced force over the largest force",
                  [](const ModelBox& m) { return m.get().step_numbers().ratio; }},
    ModelProperty{"residual", "J", "residual of the energy balance",
                  [](const ModelBox& m) { return m.get().residual(); }},
    ModelProperty{"energy", "", "terms of the energy balance [J] and their residual: help \"tables\"", nullptr,
                  push_energy},
    ModelProperty{"bearings", "", "bearings by name: m.bearings[\"S3.left\"]", nullptr, push_own<bearings_field>},
    ModelProperty{"seats", "", "seats by name", nullptr, push_own<seats_field>},
    ModelProperty{"storeys", "", "storeys by number, from groups \"storey 1\", ...", nullptr, push_own<storeys_field>},
    ModelProperty{"events", "", "all events so far", nullptr, push_events},
    ModelProperty{"hash", "", "hash of the bits of motion and energies, sixteen digits", nullptr, push_hash},
    ModelProperty{"verdict", "", "validity of the run: sound, sound_until [s], text, left", nullptr, push_verdict},
    ModelProperty{"notes", "", "notes", nullptr, push_notes},
};

int explain_dt(lua_State* L) {
  ScriptModel& m = handle<ModelBox>(L, 1).get();
  push_text(L, m.step_text());
  return 1;
}

int close_model(lua_State* L) {
  auto& box = handle<ModelBox>(L, 1);
  if (box.get().running()) throw InputError(fmt::format("{}: cannot be closed while a stage runs", box.model->title()));
  const std::shared_ptr<ScriptModel> model = box.model;
  box.close();
  auto& recorded = host(L).recorded;
  recorded.erase(std::remove(recorded.begin(), recorded.end(), model), recorded.end());
  const std::string said = model->finish("");
  if (host(L).observer != nullptr && !said.empty()) host(L).observer->note(said);
  return 0;
}

std::vector<Method> model_methods() {
  std::vector<Method> methods{
      {"explain_dt", guarded<explain_dt>},
      {"close", guarded<close_model>},
  };
  for (const auto part :
       {parts_methods(), bearing_methods(), bridge_methods(), frame_methods(), stage_methods(), load_methods(),
        pressure_methods(), water_methods(), heat_methods(), release_methods(), pushover_methods(), debug_methods(),
        change_methods(), finding_methods(), modes_methods(), reading_methods()})
    methods.insert(methods.end(), part.begin(), part.end());
  return methods;
}

/// A number downwards, or one number for each dimension.
template <int D>
Vec<D> read_gravity(Keys& keys) {
  lua_State* L = keys.lua();
  Vec<D> gravity = -standard_gravity * Vec<D>::Unit(D - 1);
  const int type = keys.push("gravity");
  if (type == LUA_TNUMBER) {
    gravity = -lua_tonumber(L, -1) * Vec<D>::Unit(D - 1);
    if (!gravity.allFinite()) keys.wrong("gravity", "finite");
    if (lua_tonumber(L, -1) < 0)
      keys.wrong("gravity", "not below 0: a number acts downwards; for other directions give a vector");
  } else if (type != LUA_TNIL) {
    std::optional<Vec<D>> given;
    if constexpr (D == 2)
      given = point_at(L, -1);
    else
      given = vector_at(L, -1);
    if (!given)
      keys.wrong("gravity",
                 D == 2 ? "a number (downwards) or {x, y}, in m/s2" : "a number (downwards) or {x, y, z}, in m/s2");
    gravity = given.value_or(gravity);
  }
  lua_pop(L, 1);
  return gravity;
}

void require_above(Keys& keys, std::string_view key, double value, std::string_view unit) {
  if (!(value > 0)) keys.problem(fmt::format("'{}' is {:g} {}, must be above 0", key, value, unit));
}

/// Common keys of models in the plane and in space.
template <class Builder>
void read_common(Keys& keys, Builder& b) {
  b.mass_damping = keys.number("mass_damping", "1/s", b.mass_damping);
  b.impact_speed = keys.number("impact_speed", "m/s", b.impact_speed);
  b.apart_time = keys.number("apart_time", "s", b.apart_time);
  b.still_speed = keys.number("still_speed", "m/s", b.still_speed);
  b.still_time = keys.number("still_time", "s", b.still_time);
  b.overlap_allowed = keys.number("overlap_allowed", "1", b.overlap_allowed);
  require_above(keys, "impact_speed", b.impact_speed, "m/s");
  require_above(keys, "still_speed", b.still_speed, "m/s");
  if (!(b.mass_damping >= 0))
    keys.problem(fmt::format("'mass_damping' is {:g} 1/s, must not be below 0", b.mass_damping));
  if (!(b.apart_time >= 0)) keys.problem(fmt::format("'apart_time' is {:g} s, must not be below 0", b.apart_time));
  if (!(b.still_time >= 0)) keys.problem(fmt::format("'still_time' is {:g} s, must not be below 0", b.still_time));
  if (!(b.overlap_allowed >= 0))
    keys.problem(fmt::format("'overlap_allowed' is {:g}, must not be below 0", b.overlap_allowed));
}

std::shared_ptr<ScriptModel> make_plane_model(Keys& keys, const std::string& name) {
  auto model = std::make_shared<PlaneModel>(name);
  ModelBuilder& b = model->builder;
  b.thickness = keys.number("thickness", "m", b.thickness);
  b.gravity = read_gravity<2>(keys);
  model->body_form = read_body_form(keys, {});
  model->says_body = keys.has("body");
  require_above(keys, "thickness", b.thickness, "m");
  read_common(keys, b);
  return model;
}

std::shared_ptr<ScriptModel> make_space_model(Keys& keys, const std::string& name) {
  auto model = std::make_shared<SpaceModel>(name);
  model->builder.gravity = read_gravity<3>(keys);
  if (keys.has("thickness")) keys.problem("'thickness' is for models in the plane, and dim is 3");
  model->body_form = read_space_form(keys, {});
  model->says_body = keys.has("body");
  read_common(keys, model->builder);
  return model;
}

}  // namespace

int make_model(lua_State* L) {
  lua_settop(L, 1);
  if (lua_isnil(L, 1)) {
    lua_newtable(L);
    lua_replace(L, 1);
  }
  Keys keys(L, 1, "model");
  const std::string name = keys.text("name", "");
  keys.name_owner(name);
  const int dim = keys.count("dim", 2);
  if (dim != 2 && dim != 3) keys.problem(fmt::format("'dim' is {}, must be 2 (in the plane) or 3 (in space)", dim));
  std::shared_ptr<ScriptModel> model = dim == 3 ? make_space_model(keys, name) : make_plane_model(keys, name);
  const int threads = keys.count("threads", 1);
  if (threads < 1 || threads > most_threads)
    keys.problem(fmt::format("'threads' is {}, must be 1 to {}", threads, most_threads));
  if (keys.has("threads")) model->threads = threads;
  keys.finish();
  push_handle(L, ModelBox{std::move(model)}, 1);
  lua_newtable(L);
  lua_setiuservalue(L, -2, 1);
  return 1;
}

std::span<const Property<ModelBox>> Kind<ModelBox>::properties() {
  static const std::vector<ModelProperty> all = [] {
    std::vector<ModelProperty> list(model_properties.begin(), model_properties.end());
    for (ModelProperty& p : list) p.dim = p.name == "thickness" ? 2 : p.dim;
    list.insert(list.end(), finding_properties().begin(), finding_properties().end());
    list.insert(list.end(), pushover_properties().begin(), pushover_properties().end());
    list.insert(list.end(), debug_properties().begin(), debug_properties().end());
    return list;
  }();
  return all;
}
std::span<const Method> Kind<ModelBox>::methods() {
  static const std::vector<Method> methods = model_methods();
  return methods;
}
std::string Kind<ModelBox>::title(const ModelBox& m) {
  return m.open() ? m.model->title() : "closed model";
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<ModelBox>::metamethods() {
  return {};
}
bool Kind<ModelBox>::read_item(lua_State*, const ModelBox&) {
  return false;
}

}  // namespace trilith::script
