// Pairs of faces with random pose and motion, for tests of the contact kernels.
#pragma once

#include "base/space.hpp"
#include "contact/plane/face_pair.hpp"
#include "geometry/plane/random_convex.hpp"
#include "law/contact/list.hpp"

namespace trilith::testing {

/// Two facing faces.
struct Faces {
  FaceEnds<double> a, b;
};

inline Vec2 start_of(const FaceEnds<double>& f) {
  return {f.x0, f.y0};
}
inline Vec2 end_of(const FaceEnds<double>& f) {
  return {f.x1, f.y1};
}
inline Vec2 start_speed(const FaceEnds<double>& f) {
  return {f.u0, f.v0};
}
inline Vec2 end_speed(const FaceEnds<double>& f) {
  return {f.u1, f.v1};
}
inline FaceEnds<double> face(const Vec2& p, const Vec2& q, const Vec2& vp, const Vec2& vq) {
  return {p.x(), p.y(), q.x(), q.y(), vp.x(), vp.y(), vq.x(), vq.y()};
}

/// A face from `p` to `q` of a body that moves with `velocity` at the origin and rotates with `spin`.
inline FaceEnds<double> rigid_face(const Vec2& p, const Vec2& q, const Vec2& velocity, double spin) {
  return face(p, q, velocity + cross(spin, p), velocity + cross(spin, q));
}

/// All positions and velocities rotated by `turn`.
inline Faces turned(const Faces& f, const Turn& turn) {
  const auto each = [&](const FaceEnds<double>& e) {
    return face(turn.apply(start_of(e)), turn.apply(end_of(e)), turn.apply(start_speed(e)), turn.apply(end_speed(e)));
  };
  return {each(f.a), each(f.b)};
}

/// Two faces some metres long, A's along x below B's. They share some length at a mean gap in [low, high] [m] and are
/// tilted by up to `tilt`, with random velocities and a random common rotation.
inline Faces random_faces(std::mt19937_64& bits, double low, double high, double tilt) {
  const double la = random_between(bits, 0.5, 2), lb = random_between(bits, 0.5, 2);
  const double shift = random_between(bits, -0.8 * lb, 0.8 * la), slope = random_between(bits, -tilt, tilt);
  const double gap = random_between(bits, low, high);
  const auto speed = [&] { return Vec2(random_between(bits, -0.2, 0.2), random_between(bits, -0.2, 0.2)); };
  const Vec2 middle(shift + 0.5 * lb, gap), half(0.5 * lb, 0.5 * lb * slope);
  // A's outside is to the right of its direction, so B above it has a's direction reversed.
  const Faces flat{rigid_face({la, 0}, {0, 0}, speed(), random_between(bits, -0.3, 0.3)),
                   rigid_face(middle - half, middle + half, speed(), random_between(bits, -0.3, 0.3))};
  return turned(flat, Turn(random_between(bits, -M_PI, M_PI)));
}

/// One step of two faces under a law without history, or before any history.
template <class K>
FaceResponse<double, LawMemory<K>> respond_fresh(const Faces& f, const FaceMemory<double>& before, const K& law) {
  return respond_face_pair<K>(f.a, f.b, 1.0, before, LawMemory<K>{}, law);
}

inline FaceMemory<double> no_memory(bool bonded = false) {
  return {{0, 0}, {0, 0}, {0, 0}, {0, 0}, 0, {bonded, bonded}};
}

/// A history of shear and damping as during a run.
inline FaceMemory<double> random_memory(std::mt19937_64& bits, double force) {
  FaceMemory<double> m = no_memory();
  for (const int h : {0, 1}) {
    m.shear_elastic[h] = random_between(bits, -force, force);
    m.shear_total[h] = random_between(bits, -force, force);
    m.damping_force[h] = random_between(bits, -force, force);
    m.active[h] = random_between(bits, 0, 0.5);
    m.bonds[h] = random_count(bits, 0, 1) == 1;
  }
  m.slip = random_between(bits, 0, 1);
  return m;
}

template <class M>
Vec2 on_a0(const FaceResponse<double, M>& r) {
  return {r.ax0, r.ay0};
}
template <class M>
Vec2 on_a1(const FaceResponse<double, M>& r) {
  return {r.ax1, r.ay1};
}
template <class M>
Vec2 on_b0(const FaceResponse<double, M>& r) {
  return {r.bx0, r.by0};
}
template <class M>
Vec2 on_b1(const FaceResponse<double, M>& r) {
  return {r.bx1, r.by1};
}

}  // namespace trilith::testing
