#include "bindings/geometry/solid_makers.hpp"

#include <array>
#include <utility>

#include "bindings/core/bindings.hpp"
#include "bindings/geometry/declared_reading.hpp"
#include "build/list.hpp"

namespace trilith::script {
namespace {

template <DeclaredBuilder B>
MakeSolids read_builder_in_space(Keys& k) {
  B builder;
  builder.name = read_name(k, builder.name);
  read_keys_of<B>(k, builder);
  return [builder] { return builder.parts(); };
}

/// Whether parts of the builder may start without support.
template <class B>
constexpr bool may_fall() {
  if constexpr (requires { B::falls; })
    return B::falls;
  else
    return false;
}

template <std::size_t row>
int add_row(lua_State* L);

template <std::size_t... row>
constexpr std::array<lua_CFunction, SpaceBuilders::size> adders(std::index_sequence<row...>) {
  return {guarded<add_row<row>>...};
}

constexpr auto makers = [] {
  constexpr auto add = adders(std::make_index_sequence<SpaceBuilders::size>{});
  std::array<SolidMaker, SpaceBuilders::size> all{};
  std::size_t row = 0;
  SpaceBuilders::for_each([&]<class B>() {
    all[row] = SolidMaker{B::kind, B::is_single, read_builder_in_space<B>, add[row], may_fall<B>()};
    ++row;
  });
  return all;
}();

/// m:NAME{...}
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
