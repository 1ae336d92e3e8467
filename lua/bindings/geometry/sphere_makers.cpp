// Spheres, clumps of spheres and random packings, read from one table each.
#include "bindings/geometry/part_reading.hpp"
#include "bindings/geometry/solid_makers.hpp"
#include "build/plane/grains.hpp"

namespace trilith::script {
namespace {

/// Spheres of the list under `key`: { { x, y, z, radius = }, ... }.
std::vector<Sphere> read_spheres(Keys& k, std::string_view key) {
  std::vector<Sphere> spheres;
  read_list(k, key, fmt::format("{}: sphere", key), [&](Keys& own) {
    Sphere s;
    s.centre = own.vector("at");
    s.radius = own.number("radius", "m");
    spheres.push_back(s);
  });
  return spheres;
}

/// radius = 0.02, or { least, most }.
void read_radius(Keys& k, Pour& pour) {
  lua_State* L = k.lua();
  if (k.push("radius") == LUA_TTABLE) {
    const std::optional<Vec2> range = point_at(L, -1);
    if (!range) k.wrong("radius", "a number [m], or { least, most }");
    const Vec2 found = range.value_or(Vec2(1, 1));
    pour.least = found.x(), pour.most = found.y();
    lua_pop(L, 1);
    return;
  }
  lua_pop(L, 1);
  pour.least = pour.most = k.number("radius", "m");
}

}  // namespace

MakeSolids read_sphere(Keys& k) {
  Clump c;
  c.name = read_name(k, "");
  Sphere s;
  s.radius = k.number("radius", "m");
  s.centre = k.vector("at", Vec3::Zero());
  return [c, s] {
    check_sphere(s, builder_title("sphere", c.name));
    SolidParts made;
    made.parts.push_back({c.name, {}, {}, {s}});
    return made;
  };
}

MakeSolids read_clump(Keys& k) {
  Clump c;
  c.name = read_name(k, "");
  if (!k.has("spheres")) k.missing("spheres", "a list { { at = {x, y, z}, radius = }, ... }");
  c.spheres = read_spheres(k, "spheres");
  c.at = k.vector("at", c.at);
  c.turn = read_turn(k);
  return [c] {
    SolidParts made;
    made.parts.push_back(build_clump(c));
    return made;
  };
}

MakeSolids read_pour(Keys& k) {
  Pour p;
  p.name = read_name(k, "");
  p.low = k.vector("low"), p.high = k.vector("high");
  p.count = k.count("count", p.count);
  read_radius(k, p);
  p.grading = k.choice("grading", {"number", "mass"}, 0) == 0 ? Grading::number : Grading::mass;
  p.shape = read_spheres(k, "clump");
  p.share = k.number("share", "1", p.share);
  p.seed = k.count("seed", p.seed);
  return [p] { return SolidParts{build_pour(p), {}}; };
}

}  // namespace trilith::script
