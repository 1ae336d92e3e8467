#include "bindings/geometry/masonry_makers.hpp"

#include <algorithm>

#include "bindings/geometry/part_reading.hpp"
#include "build/plane/arch.hpp"
#include "build/plane/rubble.hpp"
#include "build/plane/running_bond.hpp"
#include "build/plane/stack.hpp"
#include "build/plane/wall.hpp"
#include "build/space/flying_buttress.hpp"

namespace trilith::script {

MakeParts read_stack(Keys& k) {
  Stack s;
  s.name = read_name(k, "");
  s.at = k.point("at", s.at);
  read_list(k, "blocks", "block", [&](Keys& own) {
    s.blocks.push_back({own.number("width", "m"), own.number("height", "m"), own.number("offset", "m", 0)});
  });
  return [s] { return MadeParts{build_stack(s)}; };
}

MakeParts read_harmonic_stack(Keys& k) {
  HarmonicStack s;
  s.name = read_name(k, "");
  s.count = k.count("count", s.count);
  s.length = k.number("length", "m", s.length);
  s.height = k.number("height", "m", s.height);
  s.factor = k.number("factor", "1", s.factor);
  s.at = k.point("at", s.at);
  s.table_height = k.number("table_height", "m", s.table_height);
  return [s] { return MadeParts{build_harmonic_stack(s)}; };
}

MakeParts read_arch(Keys& k) {
  Arch a;
  a.name = read_name(k, "");
  a.voussoirs = k.count("voussoirs", a.voussoirs);
  a.radius = k.number("radius", "m", a.radius);
  a.thickness = k.number("thickness", "m", a.thickness);
  a.half_angle = k.number("half_angle", "rad", a.half_angle);
  a.offset = k.number("offset", "m", a.offset);
  const auto span = k.maybe_number("span", "m"), rise = k.maybe_number("rise", "m");
  if (span.has_value() != rise.has_value()) k.problem("span and rise go together; give both or neither");
  if (span && (k.has("radius") || k.has("half_angle") || k.has("offset")))
    k.problem("span and rise say what radius, half_angle and offset say; keep one of the two");
  a.key = k.number("key", "1", a.key);
  a.sub_edges = k.count("sub_edges", a.sub_edges);
  a.centre = k.point("centre", a.centre);
  a.abutments = k.flag("abutments", a.abutments);
  a.abutment_depth = k.number("abutment_depth", "m", a.abutment_depth);
  a.abutment_margin = k.number("abutment_margin", "m", a.abutment_margin);
  a.jitter = k.number("jitter", "m", a.jitter);
  a.seed = k.count("seed", a.seed);
  return [a, span, rise]() mutable {
    if (span && rise) set_span_and_rise(a, *span, *rise);
    return MadeParts{build_arch(a)};
  };
}

MakeParts read_flying_buttress(Keys& k) {
  FlyingButtress f;
  f.name = read_name(k, "");
  f.voussoirs = k.count("voussoirs", f.voussoirs);
  f.span = k.number("span", "m", f.span);
  f.rise = k.number("rise", "m", f.rise);
  f.radius = k.number("radius", "m", f.radius);
  f.thickness = k.number("thickness", "m", f.thickness);
  f.slope = k.number("slope", "rad", f.slope);
  f.sub_edges = k.count("sub_edges", f.sub_edges);
  f.springing = k.point("springing", f.springing);
  f.pier_width = k.number("pier_width", "m", f.pier_width);
  f.pier_height = k.number("pier_height", "m", f.pier_height);
  f.wall_width = k.number("wall_width", "m", f.wall_width);
  f.wall_height = k.number("wall_height", "m", f.wall_height);
  return [f] { return MadeParts{build_flying_buttress(f)}; };
}

namespace {

PanelField read_field(Keys& own) {
  PanelField f;
  f.from = own.number("from", "m");
  f.to = own.number("to", "m");
  f.first_course = own.count("first_course", f.first_course);
  f.last_course = own.count("last_course", f.first_course);
  return f;
}

std::vector<WallStorey> read_storeys(Keys& k) {
  const WallStorey one{.courses = k.count("courses", 0), .height = k.number("storey_height", "m", 0)};
  const int type = k.push("storeys");
  lua_pop(k.lua(), 1);
  std::vector<WallStorey> storeys;
  if (type != LUA_TTABLE) {
    const int count = k.count("storeys", 1);
    if (count < 1 || count > 1000) k.problem(fmt::format("'storeys' is {}, must be from 1 to 1000, or a list", count));
    storeys.assign(static_cast<std::size_t>(std::clamp(count, 1, 1000)), one);
    return storeys;
  }
  read_list(k, "storeys", "storey", [&](Keys& own) {
    WallStorey s = one;
    if (own.has("courses") || own.has("height")) s = {};
    s.courses = own.count("courses", s.courses);
    s.height = own.number("height", "m", s.height);
    s.slab_height = own.number("slab_height", "m", s.slab_height);
    storeys.push_back(s);
  });
  return storeys;
}

void read_openings(Keys& k, std::vector<WallOpening>& openings) {
  read_list(k, "openings", "opening", [&](Keys& own) {
    WallOpening o;
    const std::vector<int> storeys = read_counts(own, "storey", 1);
    o.x = own.number("x", "m");
    o.sill = own.number("sill", "m", o.sill);
    o.width = own.number("width", "m");
    o.height = own.number("height", "m");
    o.lintel = own.flag("lintel", o.lintel);
    o.lintel_height = own.number("lintel_height", "m", o.lintel_height);
    o.lintel_bearing = own.number("lintel_bearing", "m", o.lintel_bearing);
    o.sill_height = own.number("sill_height", "m", o.sill_height);
    o.sill_bearing = own.number("sill_bearing", "m", o.sill_bearing);
    for (const int storey : storeys) {
      o.storey = storey;
      openings.push_back(o);
    }
  });
}

void read_wall_units(Keys& k, Wall& w) {
  w.units = k.count("units", w.units);
  w.unit_length = k.number("unit_length", "m", w.unit_length);
  w.unit_height = k.number("unit_height", "m", w.unit_height);
  w.header_length = k.number("header_length", "m", w.header_length);
  w.head_joint = k.number("head_joint", "m", w.head_joint);
  w.bed_joint = k.number("bed_joint", "m", w.bed_joint);
  w.bond = k.text("bond", w.bond);
  w.first_row = k.count("first_row", w.first_row);
  w.least_length = k.number("least_length", "m", w.least_length);
  w.short_pieces = k.choice("short_pieces", {"merge", "refuse"}, 0) == 0 ? ShortPieces::merge : ShortPieces::refuse;
  w.jitter = k.number("jitter", "m", w.jitter);
  w.seed = k.count("seed", w.seed);
}

}  // namespace

MakeParts read_wall(Keys& k) {
  Wall w;
  w.name = read_name(k, "");
  w.at = k.point("at", w.at);
  w.length = k.number("length", "m", w.length);
  read_wall_units(k, w);
  w.storeys = read_storeys(k);
  w.slab_height = k.number("slab_height", "m", w.slab_height);
  w.slab_overhang = k.number("slab_overhang", "m", w.slab_overhang);
  w.base_height = k.number("base_height", "m", w.base_height);
  w.base_margin = k.number("base_margin", "m", w.base_margin);
  w.lintel_height = k.number("lintel_height", "m", w.lintel_height);
  w.lintel_bearing = k.number("lintel_bearing", "m", w.lintel_bearing);
  w.snap = k.flag("snap", w.snap);
  read_openings(k, w.openings);
  return [w] {
    WallParts made = build_wall(w);
    return MadeParts{std::move(made.parts), std::move(made.notes)};
  };
}

MakeParts read_running_bond(Keys& k) {
  RunningBond w;
  w.name = read_name(k, "");
  w.columns = k.count("columns", w.columns);
  w.courses = k.count("courses", w.courses);
  w.unit_width = k.number("unit_width", "m", w.unit_width);
  w.unit_height = k.number("unit_height", "m", w.unit_height);
  w.half_courses = k.choice("half_courses", {"odd", "even"}, 1) == 0 ? HalfCourses::odd : HalfCourses::even;
  w.at = k.point("at", w.at);
  w.base_height = k.number("base_height", "m", w.base_height);
  w.base_margin = k.number("base_margin", "m", w.base_margin);
  read_list(k, "openings", "opening", [&](Keys& own) { w.openings.push_back(read_field(own)); });
  read_list(k, "lintels", "lintel", [&](Keys& own) { w.lintels.push_back(read_field(own)); });
  return [w] { return MadeParts{build_running_bond(w)}; };
}

MakeParts read_rubble(Keys& k) {
  Rubble r;
  r.name = read_name(k, "");
  r.outline = k.points("outline");
  r.stones = k.count("stones", r.stones);
  r.relaxations = k.count("relaxations", r.relaxations);
  r.aspect = k.number("aspect", "1", r.aspect);
  r.least_edge = k.number("least_edge", "m", r.least_edge);
  r.joint = k.number("joint", "m", r.joint);
  r.jitter = k.number("jitter", "m", r.jitter);
  r.seed = k.count("seed", r.seed);
  return [r] { return MadeParts{build_rubble(r)}; };
}

MakeParts read_bench_wall(Keys& k) {
  const int courses = k.count("courses", 24);
  return [courses] { return MadeParts{build_bench_wall(courses)}; };
}

}  // namespace trilith::script
