#include "bindings/geometry/part_makers.hpp"

#include <array>
#include <type_traits>

#include "bindings/geometry/declared_reading.hpp"
#include "bindings/geometry/part_reading.hpp"

namespace trilith::script {
namespace {

/// Whether scripts give the builder a name.
template <class B>
constexpr bool is_named() {
  if constexpr (requires { B::is_named; })
    return B::is_named;
  else
    return true;
}

template <DeclaredBuilder B>
MakeParts read_builder(Keys& k) {
  B builder;
  if (is_named<B>()) builder.name = read_name(k, builder.name);
  read_keys_of<B>(k, builder);
  return [builder] {
    MadeParts made;
    if constexpr (std::is_same_v<decltype(builder.parts()), BuiltParts>) {
      BuiltParts built = builder.parts();
      made.parts = std::move(built.parts), made.notes = std::move(built.notes);
    } else {
      made.parts = builder.parts();
    }
    if constexpr (requires { top_of(builder); }) made.tops = {top_of(builder)};
    return made;
  };
}

constexpr auto all_part_makers = [] {
  std::array<PartMaker, part_maker_count> all{};
  auto* next = all.begin();
  PlaneBuilders::for_each([&]<class B>() { *next++ = PartMaker{B::kind, B::is_single, read_builder<B>}; });
  return all;
}();

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
