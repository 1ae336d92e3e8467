// SIMD lanes: several doubles at once, with the operations that let a kernel be written once for scalar and vector
// code.
//
// Every operation is exact to IEEE 754 and none is contracted, so a lane has the same bits as the scalar double.
#pragma once

#include <cmath>
#include <cstdint>

namespace trilith {

inline constexpr int lane_count = 4;
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));
using LanePair = double __attribute__((vector_size(2 * sizeof(double))));  ///< one register on any machine
using LaneMask = std::int64_t __attribute__((vector_size(lane_count * sizeof(std::int64_t))));

/// The result of comparing two T.
template <class T>
struct MaskOf {
  using type = bool;
};
template <>
struct MaskOf<Lanes> {
  using type = LaneMask;
};
template <class T>
using Mask = typename MaskOf<T>::type;

// A kernel is one inlined function for each register width. With sanitizers, which check each access, the compiler
// needs minutes for such a function; there the functions are plain and have one width.
//
// Lanes by value are in a wide register in code for AVX and in memory in other code. A caller for wide registers would
// misread them wherever the compiler does not inline the callee. So a function or lambda that takes or returns lanes by
// value is always inlined. tests/rooms/vectors_by_value checks this.
#ifdef TRILITH_ONE_WIDTH
#define TRILITH_INLINE inline
#define TRILITH_INLINE_LAMBDA
#else
#define TRILITH_INLINE [[gnu::always_inline]] inline
#define TRILITH_INLINE_LAMBDA __attribute__((always_inline))
#endif

/// Two neighbouring numbers at an address that is a multiple of 16.
TRILITH_INLINE LanePair load_pair(const double* two) {
  LanePair v;
  __builtin_memcpy(&v, __builtin_assume_aligned(two, 16), sizeof v);
  return v;
}
TRILITH_INLINE void store_pair(double* two, const LanePair& v) {
  __builtin_memcpy(__builtin_assume_aligned(two, 16), &v, sizeof v);
}

TRILITH_INLINE double select(bool m, double a, double b) {
  return m ? a : b;
}
TRILITH_INLINE Lanes select(LaneMask m, Lanes a, Lanes b) {
  return m ? a : b;
}
TRILITH_INLINE double root(double x) {
  return std::sqrt(x);
}
TRILITH_INLINE LanePair root(LanePair x) {
  LanePair r;
  for (int i = 0; i < 2; ++i) r[i] = __builtin_sqrt(x[i]);
  return r;
}
TRILITH_INLINE Lanes root(Lanes x) {
  Lanes r;
  for (int i = 0; i < lane_count; ++i) r[i] = __builtin_sqrt(x[i]);
  return r;
}
template <class T>
TRILITH_INLINE T larger(T a, T b) {
  return select(a > b, a, b);
}
template <class T>
TRILITH_INLINE T smaller(T a, T b) {
  return select(a < b, a, b);
}
template <class T>
TRILITH_INLINE T magnitude(T a) {
  return select(a < T{}, -a, a);
}
/// A mask that is true where `m` is false.
TRILITH_INLINE bool flip(bool m) {
  return !m;
}
TRILITH_INLINE LaneMask flip(LaneMask m) {
  return ~m;
}
/// True where `m` is true in some lane.
TRILITH_INLINE bool any(bool m) {
  return m;
}
TRILITH_INLINE bool any(LaneMask m) {
  const LaneMask pairs = m | __builtin_shufflevector(m, m, 2, 3, 0, 1);
  return (pairs[0] | pairs[1]) != 0;
}
#pragma GCC diagnostic pop

}  // namespace trilith
