// The force nearest to one beyond the limit of friction that friction holds (contact/friction_limit.hpp), of one
// contact or of four.
//
// Comes in: a spring's force in shares of mu N along three axes (s), how far the centre of pressure is from it (`lean`)
// and the radius at which it sits (`reach`), over the mean distance of the pressure. Goes out: z on the limit
// m(z) = V^2 + T^2 + k V^2 T^2 = 1, nearest to L s in the spring's energy, by Newton's rule on both of
//
//     z + lambda G v(z) = L s,   m(z) = 1,   v half the gradient of m, G = L L'.
//
// A lane goes through the operations that it would go through alone, and stands still once it has settled.
#pragma once

#include "base/lane_vectors.hpp"
#include "contact/friction_limit.hpp"

namespace trilith {

template <class T>
TRILITH_INLINE T largest_size(const Triple<T>& v) {
  return larger<T>(larger<T>(magnitude<T>(v.x), magnitude<T>(v.y)), magnitude<T>(v.z));
}

/// By how much (V, T) is beyond the curve: over this it lies on it. V has two parts.
template <class T>
TRILITH_INLINE T beyond_curve(const Triple<T>& z) {
  const T x2 = z.x * z.x + z.y * z.y, y2 = z.z * z.z, sum = x2 + y2;
  return root(0.5 * (sum + root(sum * sum + 4 * friction_roundness * x2 * y2)));
}

/// Half the gradient of the measure: (a V, b T).
template <class T>
struct LimitNormal {
  T a, b;

  TRILITH_INLINE explicit LimitNormal(const Triple<T>& z)
      : a(1.0 + friction_roundness * z.z * z.z), b(1.0 + friction_roundness * (z.x * z.x + z.y * z.y)) {}
  [[nodiscard]] TRILITH_INLINE Triple<T> at(const Triple<T>& z) const { return {a * z.x, a * z.y, b * z.z}; }
  [[nodiscard]] TRILITH_INLINE T along(const Triple<T>& z) const { return at(z).dot(z); }
};

/// z = L s takes the spring's force to V and T.
template <class T>
struct LimitPlaces {
  T lean, reach;

  [[nodiscard]] TRILITH_INLINE Triple<T> from_spring(const Triple<T>& s) const {
    return {s.x, s.y, reach * s.z - lean * s.y};
  }
  [[nodiscard]] TRILITH_INLINE Triple<T> to_spring(const Triple<T>& z) const {
    return {z.x, z.y, (z.z + lean * z.y) / reach};
  }
  /// G = L L' applied.
  [[nodiscard]] TRILITH_INLINE Triple<T> applied(const Triple<T>& v) const {
    return {v.x, v.y - lean * v.z, (lean * lean + reach * reach) * v.z - lean * v.y};
  }
};

/// The unknowns as they stand, and what is asked of both again and again.
template <class T>
struct NewtonOnLimit {
  Triple<T> z, v, g;
  T lambda;

  TRILITH_INLINE NewtonOnLimit(const LimitPlaces<T>& places, const Triple<T>& beyond) {
    const T curve = beyond_curve(beyond);
    z = {beyond.x / curve, beyond.y / curve, beyond.z / curve};
    v = LimitNormal<T>(z).at(z), g = places.applied(v);
    lambda = v.dot(beyond - z) / v.dot(g);
  }
  /// What is to be taken from z, and added to lambda.
  TRILITH_INLINE void step(const LimitPlaces<T>& places, const Triple<T>& beyond, Triple<T>& less, T& more) const {
    const T none{}, one = none + 1.0, bend = 2 * friction_roundness * z.z;
    const LimitNormal<T> normal(z);
    const Triple<T> rest = z + g * lambda - beyond;
    const auto column = [&](const Triple<T>& unit, const Triple<T>& of) { return unit + places.applied(of) * lambda; };
    const Triple<T> c0 = column({one, none, none}, {normal.a, none, bend * z.x}),
                    c1 = column({none, one, none}, {none, normal.a, bend * z.y}),
                    c2 = column({none, none, one}, {bend * z.x, bend * z.y, normal.b}), yz = cross(c1, c2),
                    zx = cross(c2, c0), xy = cross(c0, c1);
    const T share = 1.0 / c0.dot(yz);
    const auto solved = [&](const Triple<T>& of) {
      return Triple<T>{share * yz.dot(of), share * zx.dot(of), share * xy.dot(of)};
    };
    const Triple<T> by_rest = solved(rest), by_lambda = solved(g);
    const T length = root(z.x * z.x + z.y * z.y),
            off = 0.5 * (length * length + z.z * z.z + friction_roundness * length * length * z.z * z.z - 1.0);
    more = (off - v.dot(by_rest)) / v.dot(by_lambda);
    less = by_rest + by_lambda * more;
  }
};

/// z of those that are `asked`; of the others anything. Returns which of them did not settle in a few rounds on the
/// near side.
template <class T>
TRILITH_INLINE Mask<T> nearest_by_newton(const LimitPlaces<T>& places, const Triple<T>& beyond, const Mask<T>& asked,
                                         Triple<T>& out) {
  NewtonOnLimit<T> now(places, beyond);
  Mask<T> open = asked, failed{};
  const T none{};
  for (int i = 0; i < 10 && any(open); ++i) {
    Triple<T> less;
    T more;
    now.step(places, beyond, less, more);
    now.z = select<T>(open, now.z - less, now.z), now.lambda = select(open, now.lambda + more, now.lambda);
    const Mask<T> sane = (now.z.dot(now.z) < none + 4.0) & (now.lambda > none);
    failed |= open & flip(sane);
    now.v = LimitNormal<T>(now.z).at(now.z), now.g = places.applied(now.v);
    open &= sane & flip(largest_size(less) < none + 1e-9);
  }
  out = now.z;
  return failed | open;
}

/// Brought to the curve along its ray, as a spring's force.
template <class T>
TRILITH_INLINE Triple<T> spring_on_limit(const LimitPlaces<T>& places, const Triple<T>& z) {
  const T curve = beyond_curve(z);
  return places.to_spring({z.x / curve, z.y / curve, z.z / curve});
}

/// Beyond this many times what friction holds only the direction counts, to the same share; squares stay in range where
/// a pressure of nothing but rounding holds next to nothing.
inline constexpr double far_beyond = 1e9;

/// A spring's force as nearest_on_limit takes it.
template <class T>
struct LimitFrame {
  Triple<T> normal, x, y;  ///< x along the offset of the centre of pressure, else of the force
  T off;                   ///< that offset's length [m]
  Mask<T> known;           ///< false where neither has a direction in the plane, and x and y have none

  TRILITH_INLINE LimitFrame(const Triple<T>& across, const Triple<T>& offset, const Triple<T>& spring)
      : normal(across), off(root(offset.dot(offset))) {
    const T none{};
    x = select<T>(off > none, {offset.x / off, offset.y / off, offset.z / off}, spring - normal * normal.dot(spring));
    x = x - normal * normal.dot(x);
    const T square = x.dot(x), length = root(square);
    known = square > none;
    turn({x.x / length, x.y / length, x.z / length});
  }
  TRILITH_INLINE void turn(const Triple<T>& along) { x = along, y = cross(normal, x); }
  /// In shares of `force`.
  [[nodiscard]] TRILITH_INLINE Triple<T> shares(const T& force, const Triple<T>& spring) const {
    const T largest = largest_size(spring);
    const Triple<T> by_size{spring.x / largest, spring.y / largest, spring.z / largest},
        by_force{spring.x / force, spring.y / force, spring.z / force};
    const Triple<T> of = select<T>(largest > far_beyond * force, by_size * (T{} + far_beyond), by_force);
    return {x.dot(of), y.dot(of), normal.dot(of)};
  }
  /// And back [N].
  [[nodiscard]] TRILITH_INLINE Triple<T> force_of(const T& force, const Triple<T>& held) const {
    return (x * held.x + y * held.y + normal * held.z) * force;
  }
};

}  // namespace trilith
