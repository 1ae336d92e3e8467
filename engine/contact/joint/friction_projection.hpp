// Projection of a force beyond the friction limit to the nearest admissible one (contact/joint/friction_limit.hpp), for
// one contact or four.
//
// Input: a spring's force s along three axes relative to mu N; the distance of the centre of pressure from the spring
// (`lean`) and the spring's radius (`reach`), both relative to the mean distance of the pressure. Output: z on the
// limit m(z) = 1, nearest to L s in the norm of the spring's energy. Newton's method solves both equations:
//
//     z + lambda G v(z) = L s,   m(z) = 1,   v half the gradient of m, G = L L'.
//
// A lane executes the same operations as a single contact, and stops once it has converged.
#pragma once

#include "base/simd/lane_vectors.hpp"
#include "contact/joint/area_limit.hpp"

namespace trilith {

template <class T>
TRILITH_INLINE T largest_size(const Triple<T>& v) {
  return larger<T>(larger<T>(magnitude<T>(v.x), magnitude<T>(v.y)), magnitude<T>(v.z));
}

/// Ratio of (V, T) to the curve along their ray: divided by it the point is on the curve. V has two components. Along a
/// ray m is P u + Q u^2 with u the square of the scale factor.
template <class T>
TRILITH_INLINE T beyond_curve(const Triple<T>& z, const LimitShape<T>& shape) {
  const Pair2<T> v(z.x, z.y), av = shape.a.applied(z.x, z.y), cv = shape.c.applied(z.x, z.y);
  const T v2 = v.dot(v), slide = 2.0 * v.dot(av), t2 = z.z * z.z, p = slide + t2,
          q = v2 * (v2 - slide) + t2 * v.dot(cv);
  return root(0.5 * (p + root(p * p + 4.0 * q)));
}

/// The measure at a point and half its gradient: (2 (1 - V^2) A V + 2 (V^2 - V.AV) V + T^2 C V, T (1 + V.CV)).
template <class T>
struct LimitNormal {
  Pair2<T> v, av, cv;
  T v2, w, u, t, t2, turn;  ///< V^2, 1 - V^2, V^2 - V.AV, T, T^2, 1 + V.CV

  TRILITH_INLINE LimitNormal(const Triple<T>& z, const LimitShape<T>& k)
      : v(z.x, z.y),
        av(k.a.applied(z.x, z.y)),
        cv(k.c.applied(z.x, z.y)),
        v2(v.dot(v)),
        w(1.0 - v2),
        u(v2 - v.dot(av)),
        t(z.z),
        t2(z.z * z.z),
        turn(1.0 + v.dot(cv)) {}
  [[nodiscard]] TRILITH_INLINE Triple<T> vector() const {
    return {2.0 * (w * av.x + u * v.x) + t2 * cv.x, 2.0 * (w * av.y + u * v.y) + t2 * cv.y, turn * t};
  }
  /// V.AV = V^2 - u, so m = 2 V.AV + V^2 (2 u - V^2) + T^2 (1 + V.CV).
  [[nodiscard]] TRILITH_INLINE T measure() const { return 2.0 * (v2 - u) + v2 * (2.0 * u - v2) + t2 * turn; }
  /// In-plane tensor of the ellipsoid with the same gradient.
  [[nodiscard]] TRILITH_INLINE LimitTensor<T> ellipse(const LimitShape<T>& k) const {
    const T round = 2.0 * u;
    return {2.0 * w * k.a.xx + round + t2 * k.c.xx, 2.0 * w * k.a.xy + t2 * k.c.xy,
            2.0 * w * k.a.yy + round + t2 * k.c.yy};
  }
  /// Half the second derivatives in the plane.
  [[nodiscard]] TRILITH_INLINE LimitTensor<T> bend(const LimitShape<T>& k) const {
    const LimitTensor<T> e = ellipse(k);
    return {e.xx + 4.0 * v.x * (v.x - 2.0 * av.x), e.xy + 4.0 * (v.x * v.y - av.x * v.y - v.x * av.y),
            e.yy + 4.0 * v.y * (v.y - 2.0 * av.y)};
  }
};

/// z = L s maps the spring's force to V and T.
template <class T>
struct LimitPlaces {
  T lean, reach;
  LimitShape<T> shape;

  [[nodiscard]] TRILITH_INLINE Triple<T> from_spring(const Triple<T>& s) const {
    return {s.x, s.y, reach * s.z - lean * s.y};
  }
  [[nodiscard]] TRILITH_INLINE Triple<T> to_spring(const Triple<T>& z) const {
    return {z.x, z.y, (z.z + lean * z.y) / reach};
  }
  /// G = L L' applied to a vector.
  [[nodiscard]] TRILITH_INLINE Triple<T> applied(const Triple<T>& v) const {
    return {v.x, v.y - lean * v.z, (lean * lean + reach * reach) * v.z - lean * v.y};
  }
};

/// The current unknowns and the quantities derived from them.
template <class T>
struct NewtonOnLimit {
  Triple<T> z, v, g;
  T lambda;

  TRILITH_INLINE NewtonOnLimit(const LimitPlaces<T>& places, const Triple<T>& beyond) {
    const T curve = beyond_curve(beyond, places.shape);
    z = {beyond.x / curve, beyond.y / curve, beyond.z / curve};
    v = LimitNormal<T>(z, places.shape).vector(), g = places.applied(v);
    lambda = v.dot(beyond - z) / v.dot(g);
  }
  /// Newton step: to be subtracted from z and added to lambda.
  TRILITH_INLINE void step(const LimitPlaces<T>& places, const Triple<T>& beyond, Triple<T>& less, T& more) const {
    const T none{}, one = none + 1.0;
    const LimitNormal<T> normal(z, places.shape);
    const LimitTensor<T> bend = normal.bend(places.shape);
    const T bx = 2.0 * z.z * normal.cv.x, by = 2.0 * z.z * normal.cv.y;
    const Triple<T> rest = z + g * lambda - beyond;
    const auto column = [&](const Triple<T>& unit, const Triple<T>& of) { return unit + places.applied(of) * lambda; };
    const Triple<T> c0 = column({one, none, none}, {bend.xx, bend.xy, bx}),
                    c1 = column({none, one, none}, {bend.xy, bend.yy, by}),
                    c2 = column({none, none, one}, {bx, by, normal.turn}), yz = cross(c1, c2), zx = cross(c2, c0),
                    xy = cross(c0, c1);
    const T share = 1.0 / c0.dot(yz);
    const auto solved = [&](const Triple<T>& of) {
      return Triple<T>{share * yz.dot(of), share * zx.dot(of), share * xy.dot(of)};
    };
    const Triple<T> by_rest = solved(rest), by_lambda = solved(g);
    const T off = 0.5 * (normal.measure() - 1.0);
    more = (off - v.dot(by_rest)) / v.dot(by_lambda);
    less = by_rest + by_lambda * more;
  }
};

/// z of the lanes in `asked`; undefined in the others. Returns the lanes that did not converge in a few rounds on the
/// near branch.
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
    now.v = LimitNormal<T>(now.z, places.shape).vector(), now.g = places.applied(now.v);
    open &= sane & flip(largest_size(less) < none + 1e-9);
  }
  // Farther out m equals 1 again, which is not the limit.
  const T across = now.z.x * now.z.x + now.z.y * now.z.y;
  failed |= asked & flip(across <= none + (1.0 + 1e-9));
  out = now.z;
  return failed | open;
}

/// Scaled to the curve along its ray, as a spring's force.
template <class T>
TRILITH_INLINE Triple<T> spring_on_limit(const LimitPlaces<T>& places, const Triple<T>& z) {
  const T curve = beyond_curve(z, places.shape);
  return places.to_spring({z.x / curve, z.y / curve, z.z / curve});
}

/// Beyond this multiple of the limit only the direction matters. Forces are scaled down to it, which keeps squares in
/// range where the pressure is rounding error alone and the limit is close to 0.
inline constexpr double far_beyond = 1e9;

/// Axes of nearest_on_limit for a spring's force.
template <class T>
struct LimitFrame {
  Triple<T> normal, x, y;  ///< x along the offset of the centre of pressure, else along the force
  T off;                   ///< length of this offset [m]
  Mask<T> known;           ///< false: neither has an in-plane direction, and x and y are undefined

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
  /// Relative to `force`.
  [[nodiscard]] TRILITH_INLINE Triple<T> shares(const T& force, const Triple<T>& spring) const {
    const T largest = largest_size(spring);
    const Triple<T> by_size{spring.x / largest, spring.y / largest, spring.z / largest},
        by_force{spring.x / force, spring.y / force, spring.z / force};
    const Triple<T> of = select<T>(largest > far_beyond * force, by_size * (T{} + far_beyond), by_force);
    return {x.dot(of), y.dot(of), normal.dot(of)};
  }
  /// The inverse [N].
  [[nodiscard]] TRILITH_INLINE Triple<T> force_of(const T& force, const Triple<T>& held) const {
    return (x * held.x + y * held.y + normal * held.z) * force;
  }
};

}  // namespace trilith
