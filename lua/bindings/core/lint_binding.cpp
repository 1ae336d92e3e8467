// Checks of a model for m:lint(): its faults, implausible numbers, contacts with little damping.
#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "build/space/check_solids.hpp"
#include "model/check/missing_laws.hpp"
#include "model/plausible_ranges.hpp"
#include "run/contact_damping.hpp"

namespace trilith::script {
namespace {

void push_texts(lua_State* L, const std::vector<std::string>& texts) {
  lua_createtable(L, static_cast<int>(texts.size()), 0);
  lua_Integer i = 0;
  for (const std::string& text : texts) {
    lua_pushlstring(L, text.data(), text.size());
    lua_rawseti(L, -2, ++i);
  }
}

template <int D>
std::vector<std::string> missing_laws_of(SimulatedModel<D>& m) {
  return missing_laws(m.simulation().model());
}

/// core.faults(model): reasons for which it cannot be built or, after that, cannot begin its next stage.
int faults(lua_State* L) {
  ScriptModel& m = handle<ModelBox>(L, 1).get();
  std::vector<std::string> all = m.faults();
  if (all.empty() && m.body_count() > 0)
    all = m.dim() == 2 ? missing_laws_of(static_cast<PlaneModel&>(m)) : missing_laws_of(static_cast<SpaceModel&>(m));
  push_texts(L, all);
  return 1;
}

template <class Law>
void add_plausibility_notes_of(std::vector<std::string>& list, const std::string& owner, const Law& law) {
  std::visit(
      [&](const auto& l) {
        if constexpr (Declared<std::decay_t<decltype(l)>>) add_plausibility_notes(list, owner, l);
      },
      law);
}

template <int D>
void add_bearing_plausibility_notes_of(std::vector<std::string>& list, const std::vector<BearingSpecOf<D>>& bearings) {
  for (const BearingSpecOf<D>& b : bearings)
    add_bearing_plausibility_notes(b, fmt::format("bearing '{}'", b.name), list);
}

/// Notes on bodies, bearings and the tilt of models in the plane.
void add_plane_plausibility_notes(std::vector<std::string>& list, const PlaneModel& m) {
  for (const BodySpec& body : m.builder.bodies())
    if (body.density)
      add_plausibility_note(list, fmt::format("body '{}'", body.name), "density", "kg/m3", *body.density);
  add_bearing_plausibility_notes_of(list, m.builder.bearings());
  if (m.if_built() != nullptr)
    add_plausibility_note(list, "tilt", "rate", "rad/s", m.if_built()->model().gravity.tilt_rate);
}

/// `core.doubts(model)`: notes on numbers that are allowed but implausible, at present.
int plausibility_notes_of_model(lua_State* L) {
  const ScriptModel& m = handle<ModelBox>(L, 1).get();
  std::vector<std::string> list;
  for (const Material& material : m.materials) {
    const std::string owner = fmt::format("material '{}'", material.name);
    add_plausibility_note(list, owner, "density", "kg/m3", material.density);
    if (material.solid) add_plausibility_notes_of(list, owner, material.solid->law);
  }
  if (const PlaneModel* plane = as_plane(m))
    add_plane_plausibility_notes(list, *plane);
  else
    add_bearing_plausibility_notes_of(list, static_cast<const SpaceModel&>(m).builder.bearings());
  for (const auto& [name, law] : m.laws) add_plausibility_notes_of(list, fmt::format("contact law '{}'", name), law);
  push_texts(L, list);
  return 1;
}

/// A row for each law of some joint.
template <int D>
void push_damping(lua_State* L, SimulatedModel<D>& m) {
  const double share = lua_tonumber(L, 2);
  const Model<D>& model = m.simulation().model();
  const std::vector<ContactDamping> all = contact_damping<D>(model, m.findings().joints);
  lua_newtable(L);
  for (std::size_t law = 0; law < model.laws.size(); ++law) {
    const ContactDamping* least = nullptr;
    int count = 0, less = 0;
    for (const ContactDamping& c : all) {
      if (c.law != static_cast<int>(law)) continue;
      ++count;
      less += c.share < share ? 1 : 0;
      if (least == nullptr || c.frequency < least->frequency) least = &c;
    }
    if (least == nullptr) continue;
    lua_createtable(L, 0, 6);
    set_number(L, "share", least->share);
    set_number(L, "frequency", least->frequency);
    lua_pushinteger(L, count);
    lua_setfield(L, -2, "all");
    lua_pushinteger(L, less);
    lua_setfield(L, -2, "less");
    push_body(L, 1, least->body_a);
    lua_setfield(L, -2, "a");
    push_body(L, 1, least->body_b);
    lua_setfield(L, -2, "b");
    lua_setfield(L, -2, model.law_names[law].c_str());
  }
}
/// core.damping(model, share): by law { share, frequency, a, b } of its least damped contact, `all` its number of
/// contacts, and `less` the number below the given share of critical damping.
int damping(lua_State* L) {
  ScriptModel& m = this_model(L);
  if (SpaceModel* space = as_space(m))
    push_damping(L, *space);
  else
    push_damping(L, require_plane(m, "lint"));
  return 1;
}

template <int D>
bool holds(SimulatedModel<D>& m, int body) {
  const Model<D>& model = m.simulation().model();
  if (!m.has_body(body)) return false;
  const auto& support = model.support[model.bodies[static_cast<std::size_t>(body)].first_node];
  return std::none_of(support.begin(), support.begin() + D, [](Support s) { return s == Support::free; });
}

/// core.is_held(body): true if all its displacements are fixed or prescribed; builds the model.
int is_held(lua_State* L) {
  const auto& b = handle<BodyHandle>(L, 1);
  ScriptModel& m = b.model();
  PlaneModel* plane = as_plane(m);
  lua_pushboolean(L, (plane != nullptr ? holds<2>(*plane, b.index) : holds<3>(*as_space(m), b.index)) ? 1 : 0);
  return 1;
}

/// core.solid_faults(model): defects of polyhedra that may disturb a run in space, one line each; {} in the plane.
/// Spheres, elements, frames and overlaps are checked when they are added.
int solid_faults(lua_State* L) {
  const SpaceModel* m = as_space(this_model(L));
  std::vector<std::string> list;
  if (m != nullptr) {
    std::vector<SolidPart> parts;
    for (const SolidSpec& spec : m->builder.bodies())
      if (!spec.mesh && !spec.frame && !spec.pieces.empty()) parts.push_back({spec.name, spec.pieces, {}});
    for (const SolidFinding& found : check_solids(parts, {.repair = false, .touching = false}))
      if (found.fault != SolidFault::overlapping && found.fault != SolidFault::unchecked) list.push_back(found.text);
  }
  push_texts(L, list);
  return 1;
}

/// core.usual(name, unit): the plausible range of such a number, in words; "" if there is none.
int usual(lua_State* L) {
  const std::string name = lua_type(L, 1) == LUA_TSTRING ? lua_tostring(L, 1) : "",
                    unit = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
  lua_pushstring(L, plausible_range_text(name, unit.empty() ? "1" : unit).c_str());
  return 1;
}

}  // namespace

void open_lint(lua_State* L) {
  set_function(L, "faults", guarded<faults>);
  set_function(L, "doubts", guarded<plausibility_notes_of_model>);
  set_function(L, "damping", guarded<damping>);
  set_function(L, "usual", guarded<usual>);
  set_function(L, "is_held", guarded<is_held>);
  set_function(L, "solid_faults", guarded<solid_faults>);
}

}  // namespace trilith::script
