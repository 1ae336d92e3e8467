// Builders that are described by declared numbers alone. A new builder is a file and a row here. Builders that need
// outlines, lists or choices are read in lua/bindings/geometry/part_makers.cpp.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "base/schema.hpp"
#include "build/plane/bridge.hpp"
#include "build/plane/part.hpp"

namespace trilith {

using DeclaredBuilders = TypeList<Span>;

/// Requirements of a builder: its name in scripts, whether it always makes one part, its numbers, and the parts.
template <class B>
concept DeclaredBuilder = Declared<B> && std::default_initializable<B> && requires(const B& builder) {
  { B::kind } -> std::convertible_to<std::string_view>;
  { B::is_single } -> std::convertible_to<bool>;
  { builder.name } -> std::convertible_to<std::string>;
  { builder.parts() } -> std::same_as<std::vector<Part>>;
};
static_assert(DeclaredBuilders::all([]<class B>() { return DeclaredBuilder<B>; }));

}  // namespace trilith
