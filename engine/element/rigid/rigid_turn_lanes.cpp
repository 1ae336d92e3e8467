#include "element/rigid/rigid_turn_lanes.hpp"

#include "base/portable.hpp"
#include "base/simd/registers.hpp"

namespace trilith {
namespace {

/// The axes of a body, and transformation of vectors to and from them.
struct AxesInLanes {
  Triple<Lanes> x, y, z;

  TRILITH_INLINE explicit AxesInLanes(const RotationInLanes& q) {
    const Lanes one = Lanes{} + 1.0, xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, xy = q.x * q.y, yz = q.y * q.z,
                zx = q.z * q.x, wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
    x = {one - 2.0 * (yy + zz), 2.0 * (xy + wz), 2.0 * (zx - wy)};
    y = {2.0 * (xy - wz), one - 2.0 * (zz + xx), 2.0 * (yz + wx)};
    z = {2.0 * (zx + wy), 2.0 * (yz - wx), one - 2.0 * (xx + yy)};
  }
  [[nodiscard]] TRILITH_INLINE Triple<Lanes> apply(const Triple<Lanes>& v) const { return x * v.x + y * v.y + z * v.z; }
  [[nodiscard]] TRILITH_INLINE Triple<Lanes> undo(const Triple<Lanes>& v) const {
    return {x.dot(v), y.dot(v), z.dot(v)};
  }
};

struct SineCosineInLanes {
  Lanes sine, cosine;
};

/// Up to this angle the series below are exact to rounding [rad].
constexpr double longest_series = 1.0 / 16;

[[gnu::noinline]] void find_one_by_one(const Lanes& angle, const LaneMask& which, SineCosineInLanes& out) {
  for (int i = 0; i < lane_count; ++i) {
    if (which[i] == 0) continue;
    const portable::SineCosine one = portable::sine_cosine(angle[i]);
    out.sine[i] = one.sine, out.cosine[i] = one.cosine;
  }
}

/// Taylor series to the eleventh order; larger angles one by one.
TRILITH_INLINE SineCosineInLanes sine_cosine(const Lanes& angle) {
  const Lanes one = Lanes{} + 1.0, z = angle * angle;
  SineCosineInLanes out;
  out.sine = angle * (one - z * (1.0 / 6) * (one - z * (1.0 / 20) * (one - z * (1.0 / 42) * (one - z * (1.0 / 72)))));
  out.cosine =
      one - z * 0.5 * (one - z * (1.0 / 12) * (one - z * (1.0 / 30) * (one - z * (1.0 / 56) * (one - z * (1.0 / 90)))));
  const LaneMask far = magnitude(angle) > Lanes{} + longest_series;
  if (any(far)) find_one_by_one(angle, far, out);
  return out;
}

/// Rotation about a body axis: the transverse momentum, `a` and `b`, rotates backwards.
TRILITH_INLINE SineCosineInLanes turn_back(const Lanes& momentum, const Lanes& inertia, double dt, Lanes& a, Lanes& b) {
  const SineCosineInLanes half = sine_cosine(0.5 * dt * momentum / inertia);
  const Lanes c = half.cosine * half.cosine - half.sine * half.sine, s = 2.0 * half.sine * half.cosine, before = a;
  a = c * before + s * b, b = c * b - s * before;
  return half;
}

TRILITH_INLINE void turn_x(TurningInLanes& t, Triple<Lanes>& own, double dt) {
  const SineCosineInLanes h = turn_back(own.x, t.inertia.x, dt, own.y, own.z);
  const RotationInLanes q = t.rotation;
  t.rotation = {q.w * h.cosine - q.x * h.sine, q.w * h.sine + q.x * h.cosine, q.y * h.cosine + q.z * h.sine,
                q.z * h.cosine - q.y * h.sine};
}
TRILITH_INLINE void turn_y(TurningInLanes& t, Triple<Lanes>& own, double dt) {
  const SineCosineInLanes h = turn_back(own.y, t.inertia.y, dt, own.z, own.x);
  const RotationInLanes q = t.rotation;
  t.rotation = {q.w * h.cosine - q.y * h.sine, q.x * h.cosine - q.z * h.sine, q.w * h.sine + q.y * h.cosine,
                q.z * h.cosine + q.x * h.sine};
}
TRILITH_INLINE void turn_z(TurningInLanes& t, Triple<Lanes>& own, double dt) {
  const SineCosineInLanes h = turn_back(own.z, t.inertia.z, dt, own.x, own.y);
  const RotationInLanes q = t.rotation;
  t.rotation = {q.w * h.cosine - q.z * h.sine, q.x * h.cosine + q.y * h.sine, q.y * h.cosine - q.x * h.sine,
                q.w * h.sine + q.z * h.cosine};
}

/// In body axes the momentum is J times the spin plus the moment's impulse; then five rotations in a symmetric order.
TRILITH_INLINE void turn_bodies(TurningInLanes& t, double span, double dt) {
  const Lanes one = Lanes{} + 1.0;
  const Triple<Lanes> per{one / t.inertia.x, one / t.inertia.y, one / t.inertia.z};
  const auto& inertia = t.inertia;
  const AxesInLanes now(t.rotation);
  const Triple<Lanes> spin = now.undo(t.spin), push = now.undo(t.moment);
  Triple<Lanes> own{inertia.x * spin.x + span * push.x, inertia.y * spin.y + span * push.y,
                    inertia.z * spin.z + span * push.z};
  t.next = now.apply({own.x * per.x, own.y * per.y, own.z * per.z});
  turn_x(t, own, 0.5 * dt), turn_y(t, own, 0.5 * dt), turn_z(t, own, dt);
  turn_y(t, own, 0.5 * dt), turn_x(t, own, 0.5 * dt);
  RotationInLanes& q = t.rotation;
  const Lanes scale = 1.5 - 0.5 * (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  q = {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
  t.spin = AxesInLanes(q).apply({own.x * per.x, own.y * per.y, own.z * per.z});
}

// One copy for wide registers and one for any machine: the same operations, so the same bits.

void turn_narrow(TurningInLanes& bodies, double span, double dt) {
  turn_bodies(bodies, span, dt);
}
#ifdef __x86_64__
[[gnu::target("avx2")]] void turn_wide(TurningInLanes& bodies, double span, double dt) {
  turn_bodies(bodies, span, dt);
}
#endif

}  // namespace

void turn_four(TurningInLanes& bodies, double span, double dt) {
#ifdef __x86_64__
  static const bool wide = registers_here() != Registers::narrow;
  if (wide) return turn_wide(bodies, span, dt);
#endif
  turn_narrow(bodies, span, dt);
}

}  // namespace trilith
