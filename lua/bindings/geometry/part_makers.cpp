#include "bindings/geometry/part_makers.hpp"

#include <algorithm>
#include <array>

#include "bindings/geometry/declared_reading.hpp"
#include "bindings/geometry/part_reading.hpp"
#include "build/plane/bridge.hpp"
#include "build/plane/ground.hpp"

namespace trilith::script {
namespace {

MakeParts read_ground(Keys& k) {
  GroundProfile g;
  g.name = read_name(k, g.name);
  std::vector<GroundStep> steps;
  read_list(k, "steps", "step", [&](Keys& own) {
    steps.push_back({own.number("from", "m"), own.number("level", "m")});
  });
  double end = 0;
  if (k.has("steps")) {
    end = k.number("to", "m");
    if (k.has("surface")) k.problem("both surface and steps are given; keep one");
  } else {
    g.surface = k.points("surface");
  }
  g.base_level = k.number("base_level", "m");
  return [g, steps, end]() mutable {
    if (!steps.empty()) g.surface = stepped_surface(steps, end);
    PolygonPart made = build_ground_profile(g);
    return MadeParts{{std::move(made.part)}, std::move(made.notes)};
  };
}

MakeParts read_pier(Keys& k) {
  Pier p;
  p.name = read_name(k, p.name);
  p.x = k.number("station", "m");
  p.ground_level = k.number("ground_level", "m", p.ground_level);
  p.height = k.number("height", "m");
  p.stem_width = k.has("seat") ? k.number("stem_width", "m", 0) : k.number("stem_width", "m");
  p.top_width = k.number("top_width", "m", p.top_width);
  p.cap_thickness = k.number("cap_thickness", "m", p.cap_thickness);
  p.footing_width = k.number("footing_width", "m", p.footing_width);
  p.footing_thickness = k.number("footing_thickness", "m", p.footing_thickness);
  p.seat = k.number("seat", "m", p.seat);
  p.gap = k.maybe_number("gap", "m");
  return [p] { return MadeParts{.parts = {build_pier(p)}, .tops = {top_of(p)}}; };
}

MakeParts read_abutment(Keys& k) {
  Abutment a;
  a.name = read_name(k, a.name);
  a.side = k.choice("side", {"left", "right"}, 0) == 0 ? AbutmentSide::left : AbutmentSide::right;
  a.axis = k.maybe_number("station", "m");
  if (a.axis && k.has("x"))
    k.problem("both x and station are given; keep one: the edge of the seat, or the position of the axis");
  a.x = a.axis ? 0 : k.number("x", "m");
  a.ground_level = k.number("ground_level", "m", a.ground_level);
  a.height = k.number("height", "m");
  a.width = k.number("width", "m");
  a.back_wall_height = k.number("back_wall_height", "m", a.back_wall_height);
  a.back_wall_width = k.number("back_wall_width", "m", a.back_wall_width);
  a.seat = k.number("seat", "m", a.seat);
  a.gap = k.maybe_number("gap", "m");
  return [a] { return MadeParts{.parts = {build_abutment(a)}, .tops = {top_of(a)}}; };
}

/// Whether scripts give the builder a name.
template <class B>
constexpr bool is_named() {
  if constexpr (requires { B::is_named; })
    return B::is_named;
  else
    return true;
}

/// Of a builder whose keys are declared.
template <DeclaredBuilder B>
MakeParts read_declared(Keys& k) {
  B builder;
  if (is_named<B>()) builder.name = read_name(k, builder.name);
  read_declared_keys(k, builder);
  return [builder] {
    if constexpr (std::is_same_v<decltype(builder.parts()), BuiltParts>) {
      BuiltParts made = builder.parts();
      return MadeParts{std::move(made.parts), std::move(made.notes)};
    } else {
      return MadeParts{builder.parts()};
    }
  };
}

constexpr std::array read_by_hand{
    PartMaker{"ground", true, read_ground},
    PartMaker{"pier", true, read_pier},
    PartMaker{"abutment", true, read_abutment},
};

/// All rows, in the order of their functions.
constexpr auto all_part_makers = [] {
  std::array<PartMaker, part_maker_count> all{};
  auto* next = std::copy(read_by_hand.begin(), read_by_hand.end(), all.begin());
  DeclaredBuilders::for_each([&]<class B>() { *next++ = PartMaker{B::kind, B::is_single, read_declared<B>}; });
  return all;
}();
static_assert(read_by_hand.size() + DeclaredBuilders::size == part_maker_count);

}  // namespace

std::span<const PartMaker, part_maker_count> part_makers() {
  return all_part_makers;
}

void push_part(lua_State* L, const Part& part) {
  lua_createtable(L, 0, 3);
  lua_pushstring(L, part.name.c_str());
  lua_setfield(L, -2, "name");
  lua_createtable(L, static_cast<int>(part.outline.size()), 0);
  lua_Integer i = 0;
  for (const Vec2& p : part.outline) {
    lua_createtable(L, 2, 0);
    lua_pushnumber(L, p.x());
    lua_rawseti(L, -2, 1);
    lua_pushnumber(L, p.y());
    lua_rawseti(L, -2, 2);
    lua_rawseti(L, -2, ++i);
  }
  lua_setfield(L, -2, "outline");
  lua_newtable(L);
  i = 0;
  for (const std::string& g : part.groups) {
    lua_pushstring(L, g.c_str());
    lua_rawseti(L, -2, ++i);
  }
  lua_setfield(L, -2, "groups");
}

}  // namespace trilith::script
