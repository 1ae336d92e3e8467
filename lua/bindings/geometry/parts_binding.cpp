// Materials, contact laws and bodies of a model; the geometry builders.
#include <algorithm>
#include <set>

#include "bindings/core/bindings.hpp"
#include "bindings/geometry/bridge_book.hpp"
#include "bindings/geometry/mesh_file.hpp"
#include "bindings/geometry/part_makers.hpp"
#include "bindings/geometry/part_reading.hpp"
#include "bindings/geometry/solid_makers.hpp"
#include "bindings/readings/body_reading.hpp"
#include "build/space/gmsh.hpp"

namespace trilith::script {
namespace {

/// The solid of deformable bodies: `solid`, or a linear elastic one from E, nu and beta.
std::optional<Solid> read_solid(Keys& keys) {
  Solid solid;
  const bool elastic = keys.has("E"), given = keys.has("solid");
  if (const auto* value = keys.maybe_handle<SolidLawValue>("solid")) solid.law = value->law;
  if (elastic) {
    ElasticSolid law;
    keys.declared(law);
    if (given) keys.problem("both E and solid are given; keep one");
    solid.law = law;
  }
  solid.plane = keys.choice("plane", {"stress", "strain"}, 0) == 0 ? Plane::stress : Plane::strain;
  solid.form = keys.choice("form", {"assumed", "plain"}, 0) == 0 ? ElementForm::assumed : ElementForm::plain;
  solid.strain_limit = keys.number("strain_limit", "1", usual_strain_limit);
  if (!(solid.strain_limit > 0))
    keys.problem(fmt::format("'strain_limit' is {:g}, must be above 0", solid.strain_limit));
  if (elastic || given) return solid;
  for (const std::string_view key : {"nu", "beta", "plane", "form", "strain_limit"})
    if (keys.has(key)) keys.problem(fmt::format("'{}' is given without E; give E too", key));
  return std::nullopt;
}

/// band_damping = { ratio =, from =, to = }
std::optional<BandDamping> read_band(Keys& keys) {
  std::optional<BandDamping> out;
  const int type = keys.push("band_damping");
  if (type == LUA_TTABLE) {
    Keys own(keys.lua(), -1, keys.owner() + ": band_damping");
    own.declared(out.emplace());
    own.finish();
  } else if (type != LUA_TNIL) {
    keys.wrong("band_damping", "a table { ratio = , from = , to = }");
  }
  lua_pop(keys.lua(), 1);
  return out;
}

/// m:material{ name =, density = | unit_weight =, E =, nu =, beta =, solid =, plane =, form =, strain_limit = }
int add_material(lua_State* L) {
  ScriptModel& m = this_model(L);
  m.adding();
  Keys keys(L, 2, "material");
  Material material;
  material.name = keys.text("name");
  keys.name_owner(material.name);
  const auto density = keys.maybe_number("density", "kg/m3"), weight = keys.maybe_number("unit_weight", "N/m3");
  if (density.has_value() == weight.has_value()) keys.problem("give either density (kg/m3) or unit_weight (N/m3)");
  if (density) check_density(keys, *density);
  if (weight) check_unit_weight(keys, *weight);
  material.solid = read_solid(keys);
  material.band = read_band(keys);
  keys.finish();
  material.density = density ? *density : *weight / standard_gravity;
  m.add_material(material);
  m.materials.push_back(material);
  lua_pushstring(L, material.name.c_str());
  return 1;
}

/// The law under `law`: a value (added to the builder), or a name. "" with a problem noted for other values.
std::string law_name(Keys& keys, ScriptModel& m, const std::string& name) {
  lua_State* L = keys.lua();
  std::string law;
  if (keys.push("law") == LUA_TNIL)
    keys.missing("law", "a contact law such as trilith.frictional{...}, the name of one, or \"none\"");
  else if (const auto* value = test_handle<ContactLawValue>(L, -1)) {
    keys.finish();
    law = require_law(m, *value, name);
  } else if (lua_type(L, -1) == LUA_TSTRING)
    law = text_at(L, -1);
  else
    keys.wrong("law", "a contact law, the name of one, or \"none\"");
  lua_pop(L, 1);
  return law;
}

/// True if `side` names materials, groups or bodies of the model.
bool is_known_side(const ScriptModel& m, const std::string& side) {
  if (side == "*") return true;
  if (std::any_of(m.materials.begin(), m.materials.end(), [&](const Material& known) { return known.name == side; }))
    return true;
  for (int b = 0; b < m.body_count(); ++b) {
    const std::vector<std::string>& groups = m.groups_of(b);
    if (m.body_name(b) == side || std::find(groups.begin(), groups.end(), side) != groups.end()) return true;
  }
  return false;
}

/// Groups and bodies may be added later, so only a name close to a known material or group is rejected here.
void check_side(Keys& keys, const ScriptModel& m, const std::string& side) {
  if (is_known_side(m, side)) return;
  std::set<std::string> names{"*"};
  for (const Material& material : m.materials) names.insert(material.name);
  for (int b = 0; b < m.body_count(); ++b)
    for (const std::string& g : m.groups_of(b)) names.insert(g);
  const std::vector<std::string> known(names.begin(), names.end());
  if (nearest_name(side, known).empty()) return;
  keys.problem(fmt::format("there is no material, group or body '{}'{}", side, name_hint(side, known)));
}

/// m:contact{ between = {"a", "b"}, law =, name = }
int add_contact(lua_State* L) {
  ScriptModel& m = this_model(L);
  m.adding();
  Keys keys(L, 2, "contact");
  const std::vector<std::string> between = keys.names("between");
  const std::string name = keys.text("name", "");
  if (!keys.has("between"))
    keys.missing("between", "two names of materials, groups or bodies, \"*\" for any");
  else if (between.size() != 2)
    keys.problem(fmt::format("'between' holds {} names, must hold two", between.size()));
  for (const std::string& side : between) check_side(keys, m, side);
  const std::string law = law_name(keys, m, name);
  keys.finish();
  m.set_contact(between[0], between[1], law);
  return 0;
}

/// Outline under `outline`, or the outline of the part under `shape` with its groups.
Polygon read_outline(Keys& keys, std::vector<std::string>& groups) {
  lua_State* L = keys.lua();
  if (!keys.has("shape")) return keys.points("outline");
  if (keys.has("outline")) keys.problem("both outline and shape are given; keep one");
  Polygon outline;
  if (keys.push("shape") == LUA_TTABLE) {
    Keys part(L, -1, "shape");
    outline = part.points("outline");
    const auto own = part.names("groups");
    groups.insert(groups.end(), own.begin(), own.end());
    part.text("name", "");
    try {
      part.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else {
    keys.wrong("shape", "a part such as trilith.block{...}");
  }
  lua_pop(L, 1);
  return outline;
}

std::array<int, 4> element_at(lua_State* L, Keys& keys, lua_Integer number) {
  std::array<int, 4> element{-1, -1, -1, -1};
  const auto count = lua_type(L, -1) == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(L, -1)) : 0;
  if (count != 3 && count != 4)
    keys.problem(fmt::format("element {} must be a list of three or four numbers of nodes", number));
  for (lua_Integer i = 1; (count == 3 || count == 4) && i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    const lua_Integer n = lua_tointeger(L, -1);
    if (lua_isinteger(L, -1) == 0 || n < 1 || n > 100000000)
      keys.problem(
          fmt::format("element {}: node {} is {}, must be a whole number from 1 on", number, i, what_is(L, -1)));
    else
      element[static_cast<std::size_t>(i - 1)] = static_cast<int>(n) - 1;
    lua_pop(L, 1);
  }
  return element;
}

/// { file = "x.msh", scale = 1 } or { nodes = {{x, y}, ...}, elements = {{1, 2, 3, 4}, ...} } at the top of the stack.
Mesh mesh_at(lua_State* L) {
  Keys keys(L, -1, "mesh");
  Mesh mesh;
  const std::string file = keys.text("file", "");
  if (!file.empty()) return mesh_of_file(keys, file, read_gmsh);
  mesh.node = keys.points("nodes");
  if (keys.push("elements") != LUA_TTABLE) keys.wrong("elements", "a list { {1, 2, 3, 4}, ... } of numbers of nodes");
  const auto count = lua_type(L, -1) == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(L, -1)) : 0;
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    mesh.element.push_back(element_at(L, keys, i));
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  keys.finish();
  return mesh;
}

/// Mesh under `mesh`, if there is one.
std::optional<Mesh> read_mesh(Keys& keys) {
  lua_State* L = keys.lua();
  std::optional<Mesh> mesh;
  const int type = keys.push("mesh");
  if (type == LUA_TTABLE) {
    try {
      mesh = mesh_at(L);
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (type != LUA_TNIL) {
    keys.wrong("mesh", "{ file = , scale = } or { nodes = , elements = }");
  }
  lua_pop(L, 1);
  return mesh;
}

/// A body of elements; or a rigid body with these as pieces, if the body or the model requests it.
void take_mesh(Mesh mesh, bool says_body, PlaneModel& m, const std::string& name, BodySpec& spec) {
  spec.mesh = std::move(mesh);
  if ((says_body || m.says_body) && spec.kind == BodyKind::rigid) return;
  if (says_body) m.builder.note(own_elements_note(name));
  spec.kind = BodyKind::mesh;
}

/// m:body{ name =, outline = | shape = | mesh =, ... } creates a body; m:body "name" finds one.
int body(lua_State* L) {
  if (lua_type(L, 2) == LUA_TSTRING) {
    push_body(L, 1, this_model(L).require_body(text_at(L, 2), "body"));
    return 1;
  }
  if (this_model(L).dim() == 3) return make_solid_body(L);
  PlaneModel& m = this_plane(L);
  m.adding();
  Keys keys(L, 2, "body");
  const std::string name = keys.text("name");
  keys.name_owner(name);
  std::vector<std::string> groups;
  std::optional<Mesh> mesh = read_mesh(keys);
  const Polygon outline = keys.has("mesh") ? Polygon() : read_outline(keys, groups);
  BodyOptions options = read_body_options(keys, false, m.body_form);
  keys.finish();
  if (mesh) take_mesh(std::move(*mesh), keys.has("body"), m, name, options.spec);
  add_part(m, {name, outline, groups}, options);
  m.catch_up();
  push_body(L, 1, m.body_count() - 1);
  return 1;
}

/// Pushes the bodies added from body `first` on: a body if there can be only one, otherwise a set.
void push_added(lua_State* L, ScriptModel& m, int first, bool single) {
  m.catch_up();
  if (single) {
    push_body(L, 1, first);
    return;
  }
  std::vector<int> added;
  for (int b = first; b < m.body_count(); ++b) added.push_back(b);
  push_set(L, 1, std::move(added));
}

/// m:add(parts, { material =, ... })
int add_parts(lua_State* L) {
  if (this_model(L).dim() == 3) return add_solid_parts(L);
  PlaneModel& m = this_plane(L);
  m.adding();
  if (lua_type(L, 2) != LUA_TTABLE)
    throw InputError(fmt::format("add: takes a list of parts, as from trilith.build; this is {}", what_is(L, 2)));
  if (lua_isnoneornil(L, 3)) {
    lua_settop(L, 2);
    lua_newtable(L);
  }
  Keys keys(L, 3, "add");
  const BodyOptions options = read_body_options(keys, true, m.body_form);
  keys.finish();
  const int first = m.body_count();
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, 2));
  if (count == 0) throw InputError("add: the list of parts is empty; give a list, as from trilith.build");
  std::vector<Part> parts;
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, 2, i);
    Keys part(L, -1, fmt::format("add: part {}", i));
    const std::string name = part.text("name");
    const Polygon outline = part.points("outline");
    const std::vector<std::string> groups = part.names("groups");
    part.finish();
    parts.push_back({name, outline, groups});
    lua_pop(L, 1);
  }
  check_named(options, parts, "add");
  for (const Part& part : parts) add_part(m, part, options);
  push_added(L, m, first, false);
  return 1;
}

/// trilith.build.NAME{...}: a list of parts. trilith.NAME{...} for single parts: the part.
template <std::size_t row>
int make_parts(lua_State* L) {
  const PartMaker& maker = part_makers()[row];
  Keys keys(L, 1, std::string(maker.name));
  const MakeParts make = maker.read(keys);
  keys.finish();
  const MadeParts made = make();
  lua_newtable(L);
  lua_Integer i = 0;
  for (const Part& part : made.parts) {
    push_part(L, part);
    lua_rawseti(L, -2, ++i);
  }
  return 1;
}
template <std::size_t row>
int make_part(lua_State* L) {
  make_parts<row>(L);
  lua_rawgeti(L, -1, 1);
  return 1;
}

/// m:NAME{...}: makes the parts and adds them in one call.
template <std::size_t row>
int add_made(lua_State* L) {
  const PartMaker& maker = part_makers()[row];
  if (this_model(L).dim() == 3) return add_solids_made(L, maker.name);
  PlaneModel& m = this_plane(L);
  m.adding();
  Keys keys(L, 2, std::string(maker.name));
  const MakeParts make = maker.read(keys);
  const BodyOptions options = read_body_options(keys, !maker.single, m.body_form);
  keys.finish();
  const MadeParts made = make();
  const int first = m.body_count();
  check_named(options, made.parts, keys.owner());
  for (const std::string& note : made.notes) m.builder.note(note);
  for (const Part& part : made.parts) add_part(m, part, options);
  for (const SupportTop& top : made.tops) book_of(m).layout.add_support(top);
  push_added(L, m, first, maker.single);
  return 1;
}

struct MakerFunctions {
  lua_CFunction parts, part, add;
};
template <std::size_t... row>
constexpr std::array<MakerFunctions, part_maker_count> functions_of(std::index_sequence<row...>) {
  return {MakerFunctions{guarded<make_parts<row>>, guarded<make_part<row>>, guarded<add_made<row>>}...};
}
constexpr auto maker_functions = functions_of(std::make_index_sequence<part_maker_count>{});

std::vector<Method> part_methods() {
  std::vector<Method> methods{
      {"material", guarded<add_material>},
      {"contact", guarded<add_contact>},
      {"body", guarded<body>},
      {"add", guarded<add_parts>},
  };
  const auto is_there = [&](std::string_view name) {
    return std::any_of(methods.begin(), methods.end(), [&](const Method& m) { return m.name == name; });
  };
  const auto makes_solids = [](std::string_view name) {
    return std::any_of(solid_makers().begin(), solid_makers().end(), [&](const auto& s) { return s.name == name; });
  };
  for (std::size_t i = 0; i < part_maker_count; ++i) {
    const PartMaker& maker = part_makers()[i];
    if (maker.name != span_maker)
      methods.push_back({maker.name, maker_functions[i].add, makes_solids(maker.name) ? 0 : 2});
  }
  for (const SolidMaker& maker : solid_makers())
    if (!is_there(maker.name)) methods.push_back({maker.name, maker.add, 3});
  return methods;
}

}  // namespace

std::span<const Method> parts_methods() {
  static const std::vector<Method> methods = part_methods();
  return methods;
}

void open_build(lua_State* L) {
  lua_newtable(L);
  for (std::size_t i = 0; i < part_maker_count; ++i)
    set_function(L, std::string(part_makers()[i].name).c_str(), maker_functions[i].parts);
  lua_setfield(L, -2, "build");
  for (std::size_t i = 0; i < part_maker_count; ++i)
    if (part_makers()[i].single) set_function(L, std::string(part_makers()[i].name).c_str(), maker_functions[i].part);
}

}  // namespace trilith::script
