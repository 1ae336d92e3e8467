// Register width of this processor, for kernels with a copy for each width.
//
// All copies execute the same operations, none of them contracted, so the bits are the same.
#pragma once

namespace trilith {

enum class Registers {
  narrow,  ///< any machine
  wide,    ///< AVX2
  widest   ///< x86-64-v4: mask registers and twice as many registers
};

/// Narrow where TRILITH_ONE_WIDTH is defined, as in builds with sanitizers, where all copies are alike.
inline Registers registers_here() {
#if defined(__x86_64__) && !defined(TRILITH_ONE_WIDTH)
  if (!__builtin_cpu_supports("avx2")) return Registers::narrow;
  const bool v4 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                  __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512cd");
  return v4 ? Registers::widest : Registers::wide;
#else
  return Registers::narrow;
#endif
}

}  // namespace trilith
