// Memory that will be used shortly and that the processor cannot see coming, as rows point to it: asked for early.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/simd/lanes.hpp"

namespace trilith {

/// How it is used.
enum class Asked : std::uint8_t { read, write };

/// Of `size` bytes all lines of the cache that they lie in; of few bytes the first.
template <Asked use, std::size_t size>
TRILITH_INLINE void ask_for(const void* from) {
  constexpr std::size_t line = 64;
  const char* const first = static_cast<const char*>(from);
  for (std::size_t i = 0; i < size; i += line) __builtin_prefetch(first + i, use == Asked::write ? 1 : 0);
  if constexpr (size > line / 2) __builtin_prefetch(first + size - 1, use == Asked::write ? 1 : 0);
}

}  // namespace trilith
