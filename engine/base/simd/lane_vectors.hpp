// Vectors of two and three components of type double or Lanes, for kernels that are written once for both.
#pragma once

#include "base/simd/lanes.hpp"
#include "base/space.hpp"

namespace trilith {

// Copied component by component: a copy as bytes, in halves of a register, would stall the loads that follow.

template <class T>
struct Pair2 {
  T x, y;

  Pair2() = default;
  TRILITH_INLINE Pair2(const T& along, const T& aside) : x(along), y(aside) {}
  TRILITH_INLINE Pair2(const Pair2& o) : x(o.x), y(o.y) {}
  TRILITH_INLINE Pair2& operator=(const Pair2& o) {
    x = o.x, y = o.y;
    return *this;
  }
  TRILITH_INLINE Pair2 operator+(const Pair2& o) const { return {x + o.x, y + o.y}; }
  TRILITH_INLINE Pair2 operator-(const Pair2& o) const { return {x - o.x, y - o.y}; }
  TRILITH_INLINE Pair2 operator*(const T& by) const { return {x * by, y * by}; }
  [[nodiscard]] TRILITH_INLINE T dot(const Pair2& o) const { return x * o.x + y * o.y; }
};

template <class T>
struct Triple {
  T x, y, z;

  Triple() = default;
  TRILITH_INLINE Triple(const T& first, const T& second, const T& third) : x(first), y(second), z(third) {}
  TRILITH_INLINE Triple(const Triple& o) : x(o.x), y(o.y), z(o.z) {}
  TRILITH_INLINE Triple& operator=(const Triple& o) {
    x = o.x, y = o.y, z = o.z;
    return *this;
  }
  TRILITH_INLINE Triple operator+(const Triple& o) const { return {x + o.x, y + o.y, z + o.z}; }
  TRILITH_INLINE Triple operator-(const Triple& o) const { return {x - o.x, y - o.y, z - o.z}; }
  TRILITH_INLINE Triple operator*(const T& by) const { return {x * by, y * by, z * by}; }
  [[nodiscard]] TRILITH_INLINE T dot(const Triple& o) const { return x * o.x + y * o.y + z * o.z; }
  [[nodiscard]] TRILITH_INLINE T square() const { return dot(*this); }
};

template <class T>
TRILITH_INLINE Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
TRILITH_INLINE Pair2<T> select(const Mask<T>& m, const Pair2<T>& a, const Pair2<T>& b) {
  return {select(m, a.x, b.x), select(m, a.y, b.y)};
}
template <class T>
TRILITH_INLINE Triple<T> select(const Mask<T>& m, const Triple<T>& a, const Triple<T>& b) {
  return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}

inline Triple<double> triple_of(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}
inline Vec3 vector_of(const Triple<double>& v) {
  return {v.x, v.y, v.z};
}

/// One lane of four vectors, and back.
TRILITH_INLINE Vec3 lane_of(const Triple<Lanes>& v, int lane) {
  return {v.x[lane], v.y[lane], v.z[lane]};
}
TRILITH_INLINE Triple<Lanes> four_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return {Lanes{a.x(), b.x(), c.x(), d.x()}, Lanes{a.y(), b.y(), c.y(), d.y()}, Lanes{a.z(), b.z(), c.z(), d.z()}};
}

}  // namespace trilith
