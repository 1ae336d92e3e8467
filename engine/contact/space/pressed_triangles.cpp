#include "contact/space/pressed_triangles.hpp"

#include "base/simd/lane_sums.hpp"
#include "base/simd/registers.hpp"

namespace trilith {
namespace {

/// Integrals over four triangles of a pressure f: of f itself, and of its products with the barycentric coordinates l
/// of the corners. All other integrals follow from these.
struct alignas(32) PressureMoments {
  Lanes whole;
  std::array<Lanes, 3> first;    // f l_i
  std::array<Lanes, 3> square;   // f l_i l_i
  std::array<Lanes, 3> product;  // f l_j l_k of the two corners other than i

  PressureMoments() = default;
  /// Of a pressure that is linear over each triangle; `at` the corners.
  TRILITH_INLINE PressureMoments(const std::array<Lanes, 3>& at, const Lanes& area) {
    const Lanes sum = at[0] + at[1] + at[2], twelfth = area * (1.0 / 12), thirtieth = area * (1.0 / 30),
                sixtieth = area * (1.0 / 60);
    whole = 4.0 * twelfth * sum;
    for (std::size_t i = 0; i < 3; ++i) {
      const Lanes with_sum = sum + at[i];
      first[i] = twelfth * with_sum, square[i] = thirtieth * (with_sum + at[i]);
      product[i] = sixtieth * (sum + sum - at[i]);
    }
  }
};

/// Force, first moment and power of a pressure.
struct LinearPressure : TrianglePressure {
  TRILITH_INLINE LinearPressure(const FourTriangles& in, const std::array<Lanes, 3>& closing,
                                const PressureMoments& of) {
    force = of.whole;
    first = in.arm[0] * of.first[0] + in.arm[1] * of.first[1] + in.arm[2] * of.first[2];
    power = of.first[0] * closing[0] + of.first[1] * closing[1] + of.first[2] * closing[2];
  }
};

/// Adds the second moments of a pressure.
TRILITH_INLINE void add_second(const FourTriangles& in, const PressureMoments& of, std::array<Lanes, 6>& sums) {
  const auto& [p, q, r] = in.arm;
  const Triple<Lanes> of_p = p * of.square[0] + q * of.product[2] + r * of.product[1],
                      of_q = p * of.product[2] + q * of.square[1] + r * of.product[0],
                      of_r = p * of.product[1] + q * of.product[0] + r * of.square[2];
  const ArmProducts pp(p, of_p), qq(q, of_q), rr(r, of_r);
  for (std::size_t k = 0; k < 6; ++k) sums[k] += pp.of[k] + qq.of[k] + rr.of[k];
}

/// The positive part of a linear pressure that is p > 0 at the corner P and not above 0 at the others:
///
///            P              T = P + t (Q - P), t = p / (p - q)
///           / \             S = P + s (R - P), s = p / (p - r)
///       T  /___\  S
///         /     \           The part is P T S with the pressure p at P and 0 along T S. With its area A t s, and
///        Q-------R          coordinates m of its corners, l_Q = t m_T and l_R = s m_S.
///
/// The moments with l_P follow from l_P + l_Q + l_R = 1.
struct MomentsInside {
  Lanes whole, q, r, qq, rr, qr;

  TRILITH_INLINE MomentsInside(const Lanes& area, const Lanes& p, const Lanes& t, const Lanes& s) {
    const Lanes unit = area * t * s * p * (1.0 / 60), twice = unit + unit;
    whole = 20.0 * unit, q = 5.0 * t * unit, r = 5.0 * s * unit;
    qq = t * t * twice, rr = s * s * twice, qr = t * s * unit;
  }
};

/// The positive part where the pressure is negative at P only: Q R S with the pressures q, r, 0, of area A (1 - s), and
/// Q S T with q, 0, 0, of area A s (1 - t). All terms are positive; the whole triangle less its negative part would
/// lose digits. The moments with l_Q follow.
struct MomentsOutside {
  Lanes whole, p, r, pp, rr, pr;

  TRILITH_INLINE MomentsOutside(const Lanes& area, const Lanes& at_q, const Lanes& at_r, const Lanes& t,
                                const Lanes& s) {
    const Lanes one = Lanes{} + 1.0, beside_t = one - t, beside_s = one - s, sixtieth = area * (1.0 / 60);
    const Lanes wide = beside_s * sixtieth, sum = at_q + at_r, end = wide * sum, own = wide * (sum + at_r),
                narrow = s * beside_t * sixtieth * at_q, both = beside_s + beside_t, ends = end + narrow;
    whole = 20.0 * (end + narrow);
    p = 5.0 * (beside_s * end + both * narrow), r = 5.0 * (own + s * ends);
    const Lanes rest = own + (s + s) * ends;
    pp = 2.0 * (beside_s * beside_s * end + (both * both - beside_s * beside_t) * narrow);
    pr = beside_s * rest + s * beside_t * narrow;
    rr = 2.0 * (own + wide * at_r) + (s + s) * (own + s * ends);
  }
};

/// Restricts the moments of a linear pressure to its positive part, in the lanes of `mixed`, where it is positive at
/// some corners and negative at others.
TRILITH_INLINE void keep_positive(const std::array<Lanes, 3>& at, const Lanes& area, const LaneMask& mixed,
                                  PressureMoments& of) {
  const Lanes zero{};
  const LaneMask on0 = at[0] > 0.0, on1 = at[1] > 0.0, on2 = at[2] > 0.0;
  const LaneMask alone0 = ~(on1 ^ on2), alone1 = ~(on0 ^ on2);  // P is corner 0, 1, or else 2
  const auto turned = [&](const Lanes& a, const Lanes& b, const Lanes& c)
                          TRILITH_INLINE_LAMBDA { return select(alone0, a, select(alone1, b, c)); };
  const Lanes p = turned(at[0], at[1], at[2]), q = turned(at[1], at[2], at[0]), r = turned(at[2], at[0], at[1]);
  const Lanes t = select(mixed, p / (p - q), zero), s = select(mixed, p / (p - r), zero);
  const LaneMask is_in = p > 0.0;
  const MomentsInside in(area, p, t, s);
  const MomentsOutside out(area, q, r, t, s);
  // The corner whose moments follow from the others: P or Q. With X the other one of both:
  const Lanes whole = select(is_in, in.whole, out.whole), of_x = select(is_in, in.q, out.p),
              of_r = select(is_in, in.r, out.r), xx = select(is_in, in.qq, out.pp), rr = select(is_in, in.rr, out.rr),
              xr = select(is_in, in.qr, out.pr);
  const Lanes of_y = whole - of_x - of_r, xy = of_x - xx - xr, ry = of_r - rr - xr, yy = of_y - xy - ry;
  const Lanes of_p = select(is_in, of_y, of_x), of_q = select(is_in, of_x, of_y), pp = select(is_in, yy, xx),
              qq = select(is_in, xx, yy), pr = select(is_in, ry, xr), qr = select(is_in, xr, ry);
  const auto put = [&](Lanes& to, const Lanes& first, const Lanes& second, const Lanes& third)
                       TRILITH_INLINE_LAMBDA { to = select(mixed, turned(first, second, third), to); };
  of.whole = select(mixed, whole, of.whole);
  put(of.first[0], of_p, of_r, of_q), put(of.first[1], of_q, of_p, of_r), put(of.first[2], of_r, of_q, of_p);
  put(of.square[0], pp, rr, qq), put(of.square[1], qq, pp, rr), put(of.square[2], rr, qq, pp);
  put(of.product[0], qr, xy, pr), put(of.product[1], pr, qr, xy), put(of.product[2], xy, pr, qr);
}

/// keep_positive for one width of registers. It stays outside of the loop over all triangles: triangles are pressed in
/// part where bodies separate.
struct NarrowParts {
  [[gnu::noinline]] static void keep(const std::array<Lanes, 3>& at, const Lanes& area, const LaneMask& mixed,
                                     PressureMoments& of) {
    keep_positive(at, area, mixed, of);
  }
};
#ifdef __x86_64__
struct WideParts {
  [[gnu::noinline, gnu::target("avx2")]] static void keep(const std::array<Lanes, 3>& at, const Lanes& area,
                                                          const LaneMask& mixed, PressureMoments& of) {
    keep_positive(at, area, mixed, of);
  }
};
#endif

/// Springs and area of all triangles, and the damped pressure where it is positive.
template <class Parts>
TRILITH_INLINE TriangleSums sum_all(std::span<const FourTriangles> triangles, double beta, const DampedMotion& motion) {
  TriangleSums sums;
  for (const FourTriangles& in : triangles) {
    const Lanes along = motion.along(in), area = area_of(in), zero{};
    const std::array<Lanes, 3> closing = motion.closing(in, along);
    std::array<Lanes, 3> damped;
    LaneMask some{}, all = ~LaneMask{};
    for (std::size_t k = 0; k < 3; ++k) {
      damped[k] = in.depth[k] + beta * closing[k];
      some |= damped[k] > 0.0, all &= damped[k] >= 0.0;
    }
    PressureMoments of_damped(damped, select(all, area, zero));
    if (const LaneMask mixed = some & ~all; any(mixed)) Parts::keep(damped, area, mixed, of_damped);
    const PressureMoments undamped(in.depth, area);
    const LinearPressure springs(in, closing, undamped), total(in, closing, of_damped);
    sums.add_pressure(in, along, springs, total);
    sums.add_area(in, in.arm[0] + in.arm[1] + in.arm[2], area * (1.0 / 12));
    add_second(in, of_damped, sums.arm_second);
    for (const Lanes& d : in.depth) sums.depth = larger<Lanes>(sums.depth, d);
  }
  return sums;
}

// One copy for wide registers and one for any machine: the same operations, so the same bits.

TriangleSums sum_narrow(std::span<const FourTriangles> triangles, double beta, const DampedMotion& motion) {
  return sum_all<NarrowParts>(triangles, beta, motion);
}
#ifdef __x86_64__
[[gnu::target("avx2")]] TriangleSums sum_wide(std::span<const FourTriangles> triangles, double beta,
                                              const DampedMotion& motion) {
  return sum_all<WideParts>(triangles, beta, motion);
}
#endif

/// over_four() for a vector and a number.
TRILITH_INLINE void take_four(const Triple<Lanes>& v, const Lanes& more, Vec3& sum, double& more_sum) {
  const Lanes of = over_four(v.x, v.y, v.z, more);
  sum = {of[0], of[1], of[2]}, more_sum = of[3];
}

}  // namespace

[[gnu::target_clones("avx2", "default")]] Vec3 spring_force(std::span<const FourTriangles> triangles) {
  const Lanes none{};
  Triple<Lanes> push{none, none, none};
  for (const FourTriangles& in : triangles)
    push = push + in.normal * (in.sign * area_of(in) * (in.depth[0] + in.depth[1] + in.depth[2]));
  Vec3 sum;
  double rest = 0;
  take_four(push, none, sum, rest);
  return sum / 3;
}

[[gnu::target_clones("avx2", "default")]] PressedSums over_lanes(const TriangleSums& in, const Triple<Lanes>& normal,
                                                                 const Vec3* push) {
  PressedSums out;
  double damping = 0;
  take_four(in.turning, in.damping, out.damping_moment, damping), take_four(in.moment, in.area, out.moment, out.area);
  take_four(in.arm, in.arm_second[4], out.arm, out.arm_second[4]);
  take_four(in.area_arm, in.area_second[4], out.area_arm, out.area_second[4]);
  const auto four = [&](const std::array<Lanes, 6>& from, std::array<double, 6>& to) {
    const Lanes sums = over_four(from[0], from[1], from[2], from[3]);
    for (int k = 0; k < 4; ++k) to[static_cast<std::size_t>(k)] = sums[k];
  };
  four(in.arm_second, out.arm_second), four(in.area_second, out.area_second);
  const Lanes rest = over_four(in.arm_second[5], in.area_second[5], in.pressure, in.power);
  out.arm_second[5] = rest[0], out.area_second[5] = rest[1], out.pressure = rest[2], out.damped = rest[3];
  for (int i = 0; i < lane_count; ++i) out.depth = out.depth > in.depth[i] ? out.depth : in.depth[i];
  const Vec3 n = lane_of(normal, 0);
  const Lanes force = over_four(in.force, Lanes{}, Lanes{}, Lanes{});
  out.damping = damping * n;
  out.force = push == nullptr ? Vec3(force[0] * n) : Vec3(*push + out.damping);
  out.damping_moment = cross(out.damping_moment, n), out.moment += out.damping_moment;
  return out;
}

PressedSums pressed_triangles(std::span<const FourTriangles> triangles, double beta, const ClosingMotion& motion,
                              const Vec3* along) {
  const Vec3 push = spring_force(triangles), *const springs = along == nullptr ? nullptr : &push;
  const DampedMotion damped(along == nullptr ? push : *along, motion);
#ifdef __x86_64__
  static const bool wide = registers_here() != Registers::narrow;
  if (wide) return over_lanes(sum_wide(triangles, beta, damped), damped.normal, springs);
#endif
  return over_lanes(sum_narrow(triangles, beta, damped), damped.normal, springs);
}

}  // namespace trilith
