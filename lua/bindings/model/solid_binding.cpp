// Bodies of models in space: keys of their tables except shape, and parts that become bodies.
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "bindings/core/bindings.hpp"
#include "bindings/geometry/mesh_file.hpp"
#include "bindings/geometry/part_reading.hpp"
#include "bindings/geometry/solid_makers.hpp"
#include "bindings/readings/body_reading.hpp"
#include "bindings/readings/crack_reading.hpp"
#include "build/space/gmsh.hpp"
#include "build/space/solid_block.hpp"
#include "model/space_builder/rigid_shape.hpp"

namespace trilith::script {

void read_solid_support(Keys& keys, std::string_view key, std::array<Support, 6>& support) {
  const std::array<std::string_view, 6> names{"x", "y", "z", "rotation_x", "rotation_y", "rotation_z"};
  const auto word = [&](Keys& from, std::string_view of, const std::string& text) {
    if (text != "fixed" && text != "free")
      from.problem(fmt::format("'{}' is '{}', must be \"fixed\" or \"free\"", of, text));
    return text == "fixed" ? Support::fixed : Support::free;
  };
  const int type = keys.push(key);
  if (type == LUA_TSTRING) {
    support.fill(word(keys, key, text_at(keys.lua(), -1)));
  } else if (type == LUA_TTABLE) {
    try {
      Keys own(keys.lua(), -1, std::string(key));
      for (std::size_t i = 0; i < 6; ++i) support[i] = word(own, names[i], own.text(names[i], "free"));
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (type != LUA_TNIL) {
    keys.wrong(key, "\"fixed\", \"free\" or { x =, y =, z =, rotation_x =, rotation_y =, rotation_z = }");
  }
  lua_pop(keys.lua(), 1);
}

namespace {

/// hold = { { from = {x, y, z}, to = {x, y, z}, x = "fixed", y =, z = }, ... }: nodes of a deformable body in a box.
void read_space_holds(Keys& keys, std::vector<SpaceNodeSupport>& holds) {
  read_list(keys, "hold", "hold", [&](Keys& own) {
    SpaceNodeSupport hold;
    hold.low = own.vector("from"), hold.high = own.vector("to");
    constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string text = own.text(names[k], "fixed");
      if (text != "fixed" && text != "free")
        own.problem(fmt::format("'{}' is '{}', must be \"fixed\" or \"free\"", names[k], text));
      hold.support[k] = text == "fixed" ? Support::fixed : Support::free;
    }
    holds.push_back(hold);
  });
}

}  // namespace

SpaceForm read_space_form(Keys& keys, const SpaceForm& preset) {
  constexpr const char* wanted = "\"rigid\", \"brick\" or { mesh = {nx, ny, nz} }";
  SpaceForm form = preset;
  const int type = keys.push("body");
  if (type == LUA_TSTRING) {
    const std::string text = text_at(keys.lua(), -1);
    form = {text == "brick" ? BodyKind::brick : BodyKind::rigid};
    if (text != "rigid" && text != "brick") keys.problem(fmt::format("'body' is '{}', must be {}", text, wanted));
  } else if (type == LUA_TTABLE) {
    try {
      Keys own(keys.lua(), -1, "body");
      form = {BodyKind::mesh};
      read_divisions(own, form.divisions, "three whole numbers {nx, ny, nz}, divisions along the three sides");
      constexpr std::array shapes{ElementShape::brick, ElementShape::tetrahedron, ElementShape::quadratic_tetrahedron,
                                  ElementShape::wedge};
      form.element = shapes[own.choice("element", {"brick", "tet4", "tet10", "wedge"}, 0)];
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (type != LUA_TNIL) {
    keys.wrong("body", wanted);
  }
  lua_pop(keys.lua(), 1);
  return form;
}

namespace {

/// One number about every axis, or three about x, y and z.
void read_inertia(Keys& keys, std::optional<Vec3>& inertia) {
  const int type = keys.push("inertia");
  lua_pop(keys.lua(), 1);
  if (type == LUA_TNIL) return;
  if (type == LUA_TTABLE)
    inertia = keys.vector("inertia");
  else if (const auto one = keys.maybe_number("inertia", "kg m2"))
    inertia = Vec3::Constant(*one);
}

}  // namespace

SolidSpec read_solid_spec(Keys& keys, const SolidSpec& preset) {
  SolidSpec s = preset;
  s.form = read_space_form(keys, preset.form);
  read_space_holds(keys, s.supports);
  s.material = keys.text("material", preset.material);
  const std::vector<std::string> groups = keys.names("groups");
  s.groups.insert(s.groups.end(), groups.begin(), groups.end());
  std::optional<double> density = keys.maybe_number("density", "kg/m3");
  if (density) check_density(keys, *density);
  if (const auto weight = keys.maybe_number("unit_weight", "N/m3")) {
    if (density) keys.problem("both density and unit_weight are given; keep one");
    check_unit_weight(keys, *weight);
    density = *weight / standard_gravity;
  }
  std::optional<double> mass = keys.maybe_number("mass", "kg");
  if (const auto weight = keys.maybe_number("weight", "N")) {
    if (mass) keys.problem("both mass and weight are given; keep one");
    if (!(*weight > 0)) keys.problem(fmt::format("'weight' is {:g} N, must be above 0", *weight));
    mass = *weight / standard_gravity;
  }
  if (density || mass || keys.has("material")) s.density = density, s.mass = mass;
  read_inertia(keys, s.inertia);
  read_solid_support(keys, "support", s.support);
  s.velocity = keys.vector("velocity", preset.velocity);
  s.spin = keys.vector("spin", preset.spin);
  s.load = keys.vector("load", preset.load);
  s.floating = keys.flag("floating", preset.floating);
  read_cracks(keys, s.cracks);
  return s;
}

namespace {

/// All options of a solid except name and shape.
struct SolidOptions {
  SolidSpec spec;
  std::vector<std::string> fixed;                           ///< names or groups of the parts that are fixed
  std::vector<std::pair<std::string, SolidSpec>> by_group;  ///< replacing options for parts of that name or group
};

/// by_group = { floors = { ... }, ... }, sorted by name, because a Lua table has no order.
void read_groups(Keys& keys, SolidOptions& o) {
  lua_State* L = keys.lua();
  const int type = keys.push("by_group");
  if (type != LUA_TNIL && type != LUA_TTABLE) keys.wrong("by_group", "a table such as { floors = { density = 2500 } }");
  if (type == LUA_TTABLE)
    for (const std::string& name : names_in_table(keys, "by_group: its keys must be names of groups or parts")) {
      lua_pushlstring(L, name.data(), name.size());
      lua_rawget(L, -2);
      try {
        Keys own(L, -1, fmt::format("by_group: {}", name));
        o.by_group.emplace_back(name, read_solid_spec(own, o.spec));
        own.finish();
      } catch (const InputError& e) {
        keys.problem(e.what());
      }
      lua_pop(L, 1);
    }
  lua_pop(L, 1);
}

SolidOptions read_solid_options(Keys& keys, bool several, const SpaceForm& preset) {
  SolidOptions o;
  SolidSpec start;
  start.form = preset;
  o.spec = read_solid_spec(keys, start);
  if (!several) return o;
  o.fixed = keys.names("fixed");
  read_groups(keys, o);
  // One plane may cross many parts; only the parts that it meets have it.
  o.spec.cracks.where_met = true;
  for (auto& [group, spec] : o.by_group) spec.cracks.where_met = true;
  return o;
}

bool is_among(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// If several entries of by_group apply to a part, the entry of its name counts, otherwise the entry of its first
/// group.
void add_solid(SpaceModel& m, const SolidPart& part, const SolidOptions& options) {
  std::vector<std::string> own{part.name};
  own.insert(own.end(), part.groups.begin(), part.groups.end());
  SolidSpec spec = options.spec;
  for (auto name = own.rbegin(); name != own.rend(); ++name)
    for (const auto& [entry, other] : options.by_group)
      if (entry == *name) spec = other;
  spec.name = part.name, spec.pieces = part.pieces, spec.spheres = part.spheres;
  spec.groups.insert(spec.groups.begin(), part.groups.begin(), part.groups.end());
  if (std::any_of(own.begin(), own.end(), [&](const std::string& n) { return is_among(n, options.fixed); }))
    spec.support.fill(Support::fixed), spec.cracks = {};
  m.builder.add_body(std::move(spec));
}

/// Pushes the bodies added from body `first` on: a body if there can be only one, otherwise a set.
void push_solids(lua_State* L, SpaceModel& m, int first, bool single) {
  m.catch_up();
  if (single) return push_body(L, 1, first);
  std::vector<int> added;
  for (int b = first; b < m.body_count(); ++b) added.push_back(b);
  push_set(L, 1, std::move(added));
}

/// Names of all solid builders, for messages.
std::string solid_maker_names() {
  std::string names;
  for (const SolidMaker& maker : solid_makers()) names += fmt::format("{}{}", names.empty() ? "" : ", ", maker.name);
  return names;
}

/// A list of four, six, eight or ten numbers of nodes at the top of the stack.
SpaceCell cell_at(lua_State* L, Keys& keys, lua_Integer number) {
  SpaceCell cell;
  const auto count = lua_type(L, -1) == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(L, -1)) : 0;
  bool known = false;
  for (const ElementShape shape :
       {ElementShape::tetrahedron, ElementShape::wedge, ElementShape::brick, ElementShape::quadratic_tetrahedron})
    if (info_of(shape).nodes == count) cell.shape = shape, known = true;
  if (!known)
    keys.problem(fmt::format("element {} must be a list of four, six, eight or ten numbers of nodes", number));
  for (lua_Integer i = 1; known && i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    const lua_Integer n = lua_tointeger(L, -1);
    if (lua_isinteger(L, -1) == 0 || n < 1 || n > 100000000)
      keys.problem(
          fmt::format("element {}: node {} is {}, must be a whole number from 1 on", number, i, what_is(L, -1)));
    else
      cell.node[static_cast<std::size_t>(i - 1)] = static_cast<int>(n) - 1;
    lua_pop(L, 1);
  }
  return cell;
}

/// { file = "x.msh", scale = 1 } or { nodes = {{x, y, z}, ...}, elements = {{1, 2, ...}, ...} } at the top of the
/// stack.
SpaceMesh space_mesh_at(lua_State* L) {
  Keys keys(L, -1, "mesh");
  const std::string file = keys.text("file", "");
  if (!file.empty()) return mesh_of_file(keys, file, read_gmsh_in_space);
  SpaceMesh mesh;
  mesh.node = keys.vectors("nodes");
  if (keys.push("elements") != LUA_TTABLE) keys.wrong("elements", "a list { {1, 2, 3, 4}, ... } of numbers of nodes");
  const auto count = lua_type(L, -1) == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(L, -1)) : 0;
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    mesh.cell.push_back(cell_at(L, keys, i));
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  keys.finish();
  return mesh;
}

/// Mesh under `mesh`, if there is one.
std::optional<SpaceMesh> read_space_mesh(Keys& keys) {
  std::optional<SpaceMesh> mesh;
  const int type = keys.push("mesh");
  if (type == LUA_TTABLE) {
    try {
      mesh = space_mesh_at(keys.lua());
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (type != LUA_TNIL) {
    keys.wrong("mesh", "{ file = , scale = } or { nodes = , elements = }");
  }
  lua_pop(keys.lua(), 1);
  return mesh;
}

/// The plane parts in the list at `index`, extruded with a depth, and the repairs of their outlines.
SolidParts extruded_list(lua_State* L, int index, const PartDepth& depth) {
  SolidParts made;
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, index));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, index, i);
    Keys part(L, -1, fmt::format("add: part {}", i));
    Part flat{part.text("name"), part.points("outline"), part.names("groups")};
    part.finish();
    CheckedPolygon checked = check_polygon(std::move(flat.outline), fmt::format("add: part '{}'", flat.name));
    flat.outline = std::move(checked.outline);
    made.notes.insert(made.notes.end(), checked.notes.begin(), checked.notes.end());
    made.parts.push_back(extrude_part(flat, depth));
    lua_pop(L, 1);
  }
  return made;
}

/// A body of elements; or a rigid body with these as pieces, if the body or the model requests it.
void take_mesh(SpaceMesh mesh, bool says_body, SpaceModel& m, SolidSpec& spec, SolidPart& part) {
  if (!(says_body || m.says_body) || spec.form.kind != BodyKind::rigid) {
    if (says_body) m.builder.note(own_elements_note(part.name));
    spec.mesh = std::move(mesh), spec.form.kind = BodyKind::mesh;
    return;
  }
  const std::string owner = fmt::format("body '{}'", part.name);
  const CheckedSpaceMesh checked = check_space_mesh(std::move(mesh), owner);
  for (const std::string& note : checked.notes) m.builder.note(note);
  RigidShape shape = rigid_shape(checked.mesh);
  if (const std::string note = curved_note(shape, owner); !note.empty()) m.builder.note(note);
  part.pieces = std::move(shape.pieces), spec.moments = shape.moments;
}

}  // namespace

int add_solids_made(lua_State* L, std::string_view name) {
  SpaceModel& m = this_space(L);
  const auto all = solid_makers();
  const auto maker = std::find_if(all.begin(), all.end(), [&](const SolidMaker& s) { return s.name == name; });
  if (maker == all.end())
    throw InputError(
        fmt::format("{}: is for models in the plane, but {} has dim = 3; give its parts a depth with "
                    "m:add(trilith.build.{}{{...}}, {{ depth = }}), or take one of {}",
                    name, m.title(), name, solid_maker_names()));
  m.adding();
  Keys keys(L, 2, std::string(name));
  const MakeSolids make = maker->read(keys);
  SolidOptions options = read_solid_options(keys, !maker->single, m.body_form);
  options.spec.floating = options.spec.floating || maker->falls;
  keys.finish();
  const SolidParts made = make();
  const int first = m.body_count();
  check_named(options, made.parts, keys.owner());
  for (const std::string& note : made.notes) m.builder.note(note);
  for (const SolidPart& part : made.parts) add_solid(m, part, options);
  push_solids(L, m, first, maker->single);
  return 1;
}

/// m:body{ name =, hull = {{x, y, z}, ...} | pieces = { {{x, y, z}, ...}, ... }, ... }
int make_solid_body(lua_State* L) {
  SpaceModel& m = this_space(L);
  m.adding();
  Keys keys(L, 2, "body");
  SolidPart part;
  part.name = read_name(keys, "");
  std::vector<std::vector<Vec3>> clouds;
  std::optional<SpaceMesh> mesh = read_space_mesh(keys);
  if (keys.has("hull") || keys.has("mesh")) {
    if (keys.has("hull")) clouds.push_back(keys.vectors("hull"));
    if (keys.has("pieces") || (keys.has("hull") && keys.has("mesh")))
      keys.problem("of hull, pieces and mesh more than one is given; keep one");
  } else if (const int type = keys.push("pieces"); type != LUA_TNIL) {
    if (type != LUA_TTABLE) keys.wrong("pieces", "a list { { hull = { {x, y, z}, ... } }, ... }");
    if (type == LUA_TTABLE)
      read_list(keys, "pieces", "piece", [&](Keys& own) { clouds.push_back(own.vectors("hull")); });
    lua_pop(L, 1);
  } else {
    keys.missing("hull",
                 "a list of points { {x, y, z}, ... }, or pieces = { { hull = }, ... }, or mesh = { file = }; or use "
                 "m:block, m:hull");
    lua_pop(L, 1);
  }
  SolidOptions options = read_solid_options(keys, false, m.body_form);
  keys.finish();
  if (mesh) take_mesh(std::move(*mesh), keys.has("body"), m, options.spec, part);
  for (std::size_t p = 0; p < clouds.size(); ++p) {
    HullSolid hull;
    hull.name = clouds.size() == 1 ? part.name : fmt::format("{}, piece {}", part.name, p + 1), hull.points = clouds[p];
    NotedSolid made = build_hull(hull);
    for (const std::string& note : made.notes) m.builder.note(note);
    part.pieces.insert(part.pieces.end(), made.part.pieces.begin(), made.part.pieces.end());
  }
  add_solid(m, part, options);
  m.catch_up();
  push_body(L, 1, m.body_count() - 1);
  return 1;
}

/// m:add(parts, { depth =, from =, centred =, material =, ... }): parts of the plane as solids.
int add_solid_parts(lua_State* L) {
  SpaceModel& m = this_space(L);
  m.adding();
  if (lua_type(L, 2) != LUA_TTABLE || lua_rawlen(L, 2) == 0)
    throw InputError(fmt::format("add: takes a list of parts, as from trilith.build; this is {}", what_is(L, 2)));
  Keys keys(L, 3, "add");
  PartDepth depth;
  depth.depth = keys.number("depth", "m");
  depth.from = keys.number("from", "m", depth.from);
  depth.centred = keys.flag("centred", depth.centred);
  const SolidOptions options = read_solid_options(keys, true, m.body_form);
  keys.finish();
  const SolidParts made = extruded_list(L, 2, depth);
  const int first = m.body_count();
  check_named(options, made.parts, "add");
  for (const std::string& note : made.notes) m.builder.note(note);
  for (const SolidPart& part : made.parts) add_solid(m, part, options);
  push_solids(L, m, first, false);
  return 1;
}

}  // namespace trilith::script
