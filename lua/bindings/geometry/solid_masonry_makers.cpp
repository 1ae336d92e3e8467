// Walls, buildings, vaults, domes and rubble in space, read from one table each.
#include <algorithm>

#include "bindings/geometry/part_reading.hpp"
#include "bindings/geometry/solid_makers.hpp"
#include "build/space/barrel_vault.hpp"
#include "build/space/building.hpp"
#include "build/space/cross_vault.hpp"
#include "build/space/dome.hpp"
#include "build/space/solid_rubble.hpp"

namespace trilith::script {
namespace {

Masonry read_masonry(Keys& k) {
  Masonry m;
  m.unit_length = k.number("unit_length", "m", m.unit_length);
  m.unit_height = k.number("unit_height", "m", m.unit_height);
  m.header_length = k.number("header_length", "m", m.header_length);
  m.bond = k.text("bond", m.bond);
  m.lintel_height = k.number("lintel_height", "m", m.lintel_height);
  m.lintel_bearing = k.number("lintel_bearing", "m", m.lintel_bearing);
  m.least_length = k.number("least_length", "m", m.least_length);
  m.snap = k.flag("snap", m.snap);
  m.slab_height = k.number("slab_height", "m", m.slab_height);
  m.slab_overhang = k.number("slab_overhang", "m", m.slab_overhang);
  m.base_height = k.number("base_height", "m", m.base_height);
  m.base_margin = k.number("base_margin", "m", m.base_margin);
  return m;
}

BeamRow read_beam_row(Keys& own) {
  BeamRow row;
  if (!own.has("along")) own.missing("along", "\"x\" or \"y\", the direction of their span");
  row.along_y = own.choice("along", {"x", "y"}, 0) == 1;
  row.count = own.count("count", row.count);
  if (own.has("count") && row.count == 0) own.problem("'count' is 0, must be at least 1");
  row.spacing = own.number("spacing", "m", row.spacing);
  row.width = own.number("width", "m");
  row.height = own.number("height", "m", row.height);
  row.bearing = own.maybe_number("bearing", "m");
  row.from = own.maybe_point("from"), row.to = own.maybe_point("to");
  return row;
}

/// beams = { along = , ... }, a list of such rows, or false; none if not given.
std::optional<std::vector<BeamRow>> read_beams(Keys& k) {
  lua_State* L = k.lua();
  const int type = k.push("beams");
  std::optional<std::vector<BeamRow>> rows;
  if (type != LUA_TNIL) rows.emplace();
  const bool one = type == LUA_TTABLE && lua_rawlen(L, -1) == 0;
  if (type != LUA_TNIL && type != LUA_TTABLE && (type != LUA_TBOOLEAN || lua_toboolean(L, -1) != 0))
    k.wrong("beams", "a table { along = , spacing = , width = }, a list of such tables, or false for none");
  if (one) try {
      Keys own(L, -1, "beams");
      rows->push_back(read_beam_row(own));
      own.finish();
    } catch (const InputError& e) {
      k.problem(e.what());
    }
  lua_pop(L, 1);
  if (type == LUA_TTABLE && !one)
    read_list(k, "beams", "beams, row", [&](Keys& own) { rows->push_back(read_beam_row(own)); });
  return rows;
}

/// storeys = 2 with courses or storey_height, or a list of tables; for a building they may have beams.
std::vector<MasonryStorey> read_storeys(Keys& k, bool beams) {
  const MasonryStorey one{.courses = k.count("courses", 0), .height = k.number("storey_height", "m", 0)};
  const int type = k.push("storeys");
  lua_pop(k.lua(), 1);
  std::vector<MasonryStorey> storeys;
  if (type != LUA_TTABLE) {
    const int count = k.count("storeys", 1);
    if (count < 1 || count > 1000) k.problem(fmt::format("'storeys' is {}, must be from 1 to 1000, or a list", count));
    storeys.assign(static_cast<std::size_t>(std::clamp(count, 1, 1000)), one);
    return storeys;
  }
  read_list(k, "storeys", "storey", [&](Keys& own) {
    MasonryStorey s = one;
    if (own.has("courses") || own.has("height")) s = {};
    s.courses = own.count("courses", s.courses);
    s.height = own.number("height", "m", s.height);
    s.slab_height = own.number("slab_height", "m", s.slab_height);
    if (beams) s.beams = read_beams(own);
    storeys.push_back(s);
  });
  return storeys;
}

std::vector<MasonryOpening> read_openings(Keys& k) {
  std::vector<MasonryOpening> openings;
  read_list(k, "openings", "opening", [&](Keys& own) {
    MasonryOpening o;
    const std::vector<int> storeys = read_counts(own, "storey", 1);
    o.from = own.number("from", "m");
    o.sill = own.number("sill", "m", o.sill);
    o.width = own.number("width", "m");
    o.height = own.number("height", "m");
    o.lintel = own.flag("lintel", o.lintel);
    o.lintel_height = own.number("lintel_height", "m", o.lintel_height);
    o.lintel_bearing = own.number("lintel_bearing", "m", o.lintel_bearing);
    for (const int storey : storeys) {
      o.storey = storey;
      openings.push_back(o);
    }
  });
  return openings;
}

/// The profile of a vault in a separate table: the keys of m:arch in the plane, without a name.
Arch read_profile(Keys& k) {
  Arch a;
  a.voussoirs = k.count("voussoirs", a.voussoirs);
  a.thickness = k.number("thickness", "m", a.thickness);
  const auto span = k.maybe_number("span", "m"), rise = k.maybe_number("rise", "m");
  a.radius = k.number("radius", "m", a.radius);
  a.half_angle = k.number("half_angle", "rad", a.half_angle);
  a.offset = k.number("offset", "m", a.offset);
  if (span.has_value() != rise.has_value()) k.problem("span and rise are given together; give both or neither");
  if (span && (k.has("radius") || k.has("half_angle") || k.has("offset")))
    k.problem("span and rise define the same shape as radius, half_angle and offset; keep one of the two");
  a.abutments = k.flag("abutments", a.abutments);
  a.abutment_depth = k.number("abutment_depth", "m", a.abutment_depth);
  a.abutment_margin = k.number("abutment_margin", "m", a.abutment_margin);
  if (span && rise && a.thickness > 0 && *span > 0 && *rise > 0) set_span_and_rise(a, *span, *rise);
  return a;
}

}  // namespace

MakeSolids read_solid_wall(Keys& k) {
  SolidWall w;
  w.name = read_name(k, "");
  w.length = k.number("length", "m");
  w.thickness = k.number("thickness", "m", w.thickness);
  w.storeys = read_storeys(k, false);
  w.masonry = read_masonry(k);
  w.openings = read_openings(k);
  w.at = k.vector("at", w.at);
  w.angle = k.number("angle", "rad", w.angle);
  return [w] { return build_solid_wall(w); };
}

MakeSolids read_building(Keys& k) {
  Building b;
  b.name = read_name(k, "");
  read_list(k, "walls", "wall", [&](Keys& own) {
    PlanWall w;
    w.name = own.text("name", "");
    w.start = own.point("from"), w.end = own.point("to");
    w.thickness = own.number("thickness", "m", w.thickness);
    w.bond = own.text("bond", "");
    w.openings = read_openings(own);
    b.walls.push_back(std::move(w));
  });
  b.storeys = read_storeys(k, true);
  b.beams = read_beams(k).value_or(std::vector<BeamRow>{});
  b.masonry = read_masonry(k);
  b.first_along_y = k.flag("first_along_y", b.first_along_y);
  if (k.has("slab_outline")) b.slab_outline = k.points("slab_outline");
  b.at = k.vector("at", b.at);
  b.angle = k.number("angle", "rad", b.angle);
  return [b] { return build_building(b); };
}

MakeSolids read_vault(Keys& k) {
  BarrelVault v;
  v.name = read_name(k, "");
  v.arch = read_profile(k);
  v.stone_length = k.number("stone_length", "m");
  v.stones = k.count("stones", v.stones);
  v.bond = k.flag("bond", v.bond);
  v.half_first = k.flag("half_first", v.half_first);
  v.from = k.number("from", "m", v.from);
  v.at = k.vector("at", v.at);
  return [v] { return SolidParts{build_barrel_vault(v), {}}; };
}

MakeSolids read_cross_vault(Keys& k) {
  CrossVault v;
  v.name = read_name(k, "");
  v.arch = read_profile(k);
  v.half_bay = k.number("half_bay", "m", v.half_bay);
  v.stone_length = k.number("stone_length", "m");
  v.bond = k.flag("bond", v.bond);
  v.at = k.vector("at", v.at);
  v.angle = k.number("angle", "rad", v.angle);
  return [v] { return SolidParts{build_cross_vault(v), {}}; };
}

MakeSolids read_dome(Keys& k) {
  Dome d;
  d.name = read_name(k, "");
  d.radius = k.number("radius", "m", d.radius);
  d.thickness = k.number("thickness", "m", d.thickness);
  d.rings = k.count("rings", d.rings);
  d.sectors = k.count("sectors", d.sectors);
  d.springing = k.number("springing", "rad", d.springing);
  d.crown = k.number("crown", "rad", d.crown);
  d.top = k.choice("top", {"key", "oculus"}, 0) == 0 ? DomeTop::key : DomeTop::oculus;
  d.phase = k.number("phase", "rad", d.phase);
  d.centre = k.vector("centre", d.centre);
  return [d] { return SolidParts{build_dome(d), {}}; };
}

MakeSolids read_solid_rubble(Keys& k) {
  SolidRubble r;
  r.name = read_name(k, "");
  r.low = k.vector("low"), r.high = k.vector("high");
  r.stones = k.count("stones", r.stones);
  r.relaxations = k.count("relaxations", r.relaxations);
  r.aspect = k.number("aspect", "1", r.aspect);
  r.joint = k.number("joint", "m", r.joint);
  r.jitter = k.number("jitter", "m", r.jitter);
  r.seed = k.count("seed", r.seed);
  return [r] { return SolidParts{build_solid_rubble(r), {}}; };
}

}  // namespace trilith::script
