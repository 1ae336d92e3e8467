// The builders of scripts in the plane whose keys are declared: a new one is its own file and a row here.
// lua/bindings/geometry/part_makers.cpp reads the others.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "base/schema.hpp"
#include "build/builder_keys.hpp"
#include "build/plane/arch.hpp"
#include "build/plane/block.hpp"
#include "build/plane/bridge.hpp"
#include "build/plane/part.hpp"
#include "build/plane/rubble.hpp"
#include "build/plane/running_bond.hpp"
#include "build/plane/stack.hpp"
#include "build/plane/wall.hpp"
#include "build/space/flying_buttress.hpp"

namespace trilith {

using DeclaredBuilders = TypeList<Block, PolygonShape, Stack, HarmonicStack, Arch, FlyingButtress, Wall, Rubble,
                                  RunningBond, BenchWall, Span>;

/// A builder: its name in scripts, a sentence, whether it always makes one part, its keys, and the parts. One with
/// `is_named = false` has no key `name`.
template <class B>
concept DeclaredBuilder = DeclaresKeys<B> && std::default_initializable<B> && requires(const B& builder) {
  { B::kind } -> std::convertible_to<std::string_view>;
  { B::sentence } -> std::convertible_to<std::string_view>;
  { B::is_single } -> std::convertible_to<bool>;
  { builder.name } -> std::convertible_to<std::string>;
  builder.parts();
};
static_assert(DeclaredBuilders::all([]<class B>() { return DeclaredBuilder<B>; }));

}  // namespace trilith
