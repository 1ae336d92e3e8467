#include "bindings/geometry/solid_makers.hpp"

#include "bindings/core/bindings.hpp"
#include "bindings/geometry/part_reading.hpp"
#include "build/plane/drum.hpp"
#include "build/space/solid_block.hpp"
#include "build/space/solid_file.hpp"

namespace trilith::script {

SolidTurn read_turn(Keys& k) {
  SolidTurn turn;
  const int type = k.push("turn");
  if (type == LUA_TTABLE) {
    try {
      Keys own(k.lua(), -1, "turn");
      turn.axis = own.vector("axis", turn.axis);
      turn.angle = own.number("angle", "rad");
      own.finish();
    } catch (const InputError& e) {
      k.problem(e.what());
    }
  } else if (type != LUA_TNIL) {
    k.wrong("turn", "a table { axis = {x, y, z}, angle = }");
  }
  lua_pop(k.lua(), 1);
  return turn;
}

namespace {

SolidParts one_part(SolidPart part) {
  SolidParts made;
  made.parts.push_back(std::move(part));
  return made;
}
SolidParts one_part(NotedSolid solid) {
  SolidParts made = one_part(std::move(solid.part));
  made.notes = std::move(solid.notes);
  return made;
}

MakeSolids read_box(Keys& k) {
  SolidBox b;
  b.name = read_name(k, "");
  for (const char* key : {"width", "height"})
    k.refuse(key, fmt::format("'{}' is for blocks in the plane; in space give size = {{x, y, z}}", key));
  b.size = k.vector("size");
  b.at = k.vector("at", b.at);
  b.anchor = k.choice("anchor", {"lower_corner", "centre"}, 0) == 0 ? BoxAnchor::lower_corner : BoxAnchor::centre;
  b.turn = read_turn(k);
  return [b] { return one_part(build_box(b)); };
}

MakeSolids read_extrusion(Keys& k) {
  Extrusion e;
  e.name = read_name(k, "");
  e.outline = k.points("outline");
  e.plane = k.choice("plane", {"upright", "level"}, 0) == 0 ? OutlinePlane::upright : OutlinePlane::level;
  e.from = k.number("from", "m", e.from);
  e.depth = k.number("depth", "m");
  e.centred = k.flag("centred", e.centred);
  e.at = k.vector("at", e.at);
  e.turn = read_turn(k);
  return [e] { return one_part(build_extrusion(e)); };
}

MakeSolids read_hull(Keys& k) {
  HullSolid h;
  h.name = read_name(k, "");
  h.points = k.vectors("points");
  h.flat = k.number("flat", "1", h.flat);
  return [h] { return one_part(build_hull(h)); };
}

MakeSolids read_prism(Keys& k) {
  RegularPrism p;
  p.name = read_name(k, "");
  p.sides = k.count("sides", p.sides);
  p.radius = k.number("radius", "m");
  p.height = k.number("height", "m");
  p.phase = k.number("phase", "rad", p.phase);
  p.at = k.vector("at", p.at);
  p.turn = read_turn(k);
  return [p] { return one_part(build_prism(p)); };
}

/// base = { width =, height = }, and the capital likewise.
ColumnBlock read_column_block(Keys& k, std::string_view key) {
  ColumnBlock block;
  const int type = k.push(key);
  if (type == LUA_TTABLE) {
    try {
      Keys own(k.lua(), -1, std::string(key));
      block.width = own.number("width", "m"), block.height = own.number("height", "m");
      own.finish();
    } catch (const InputError& e) {
      k.problem(e.what());
    }
  } else if (type != LUA_TNIL) {
    k.wrong(key, "a table { width =, height = }");
  }
  lua_pop(k.lua(), 1);
  return block;
}

MakeSolids read_column(Keys& k) {
  Column c;
  c.name = read_name(k, "");
  c.drums = k.count("drums", c.drums);
  c.height = k.number("height", "m");
  c.sides = k.count("sides", c.sides);
  c.radius = k.number("radius", "m");
  c.top_radius = k.number("top_radius", "m", c.top_radius);
  constexpr std::array kinds{DrumRadius::area, DrumRadius::corners, DrumRadius::sides};
  c.of = kinds[k.choice("of", {"area", "corners", "sides"}, 0)];
  c.phase = k.number("phase", "rad", c.phase);
  c.base = read_column_block(k, "base"), c.capital = read_column_block(k, "capital");
  c.at = k.vector("at", c.at);
  return [c] { return SolidParts{build_column(c), {}}; };
}

/// The file is searched in the folder of the script.
MakeSolids read_file(Keys& k) {
  SolidFile f;
  f.name = read_name(k, "");
  const std::string file = k.text("file");
  f.scale = k.number("scale", "1", f.scale);
  f.y_up = k.flag("y_up", f.y_up);
  f.shells_are_bodies = k.flag("shells_are_bodies", f.shells_are_bodies);
  f.weld = k.number("weld", "1", f.weld);
  f.flat = k.number("flat", "1", f.flat);
  const std::filesystem::path path = file, beside = host(k.lua()).folder();
  return [f, path, beside] { return read_solids(path.is_absolute() ? path : beside / path, f); };
}

constexpr std::size_t maker_count = 15;
template <std::size_t row>
int add_row(lua_State* L);

template <std::size_t... row>
constexpr std::array<lua_CFunction, maker_count> adders(std::index_sequence<row...>) {
  return {guarded<add_row<row>>...};
}
constexpr auto add = adders(std::make_index_sequence<maker_count>{});

constexpr std::array<SolidMaker, maker_count> makers{
    SolidMaker{"block", true, read_box, add[0]},
    SolidMaker{"extrusion", true, read_extrusion, add[1]},
    SolidMaker{"hull", true, read_hull, add[2]},
    SolidMaker{"prism", true, read_prism, add[3]},
    SolidMaker{"column", false, read_column, add[4]},
    SolidMaker{"wall", false, read_solid_wall, add[5]},
    SolidMaker{"building", false, read_building, add[6]},
    SolidMaker{"vault", false, read_vault, add[7]},
    SolidMaker{"cross_vault", false, read_cross_vault, add[8]},
    SolidMaker{"dome", false, read_dome, add[9]},
    SolidMaker{"rubble", false, read_solid_rubble, add[10]},
    SolidMaker{"solids", false, read_file, add[11]},
    SolidMaker{"sphere", true, read_sphere, add[12]},
    SolidMaker{"clump", true, read_clump, add[13]},
    SolidMaker{"pour", false, read_pour, add[14], true},
};

template <std::size_t row>
int add_row(lua_State* L) {
  this_space(L);
  return add_solids_made(L, makers[row].name);
}

}  // namespace

std::span<const SolidMaker> solid_makers() {
  return makers;
}

}  // namespace trilith::script
