// Software prefetch of memory that the processor cannot predict because indices point to it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/simd/lanes.hpp"

namespace trilith {

/// The access that follows the prefetch.
enum class Asked : std::uint8_t { read, write };

/// Prefetches `size` bytes: all cache lines that they touch, or the first one alone where `size` is small.
template <Asked use, std::size_t size>
TRILITH_INLINE void ask_for(const void* from) {
  constexpr std::size_t line = 64;
  const char* const first = static_cast<const char*>(from);
  for (std::size_t i = 0; i < size; i += line) __builtin_prefetch(first + i, use == Asked::write ? 1 : 0);
  if constexpr (size > line / 2) __builtin_prefetch(first + size - 1, use == Asked::write ? 1 : 0);
}

}  // namespace trilith
