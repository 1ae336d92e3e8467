#include "contact/space/pressed_triangles.hpp"

#include "base/simd/registers.hpp"

namespace trilith {
namespace {

/// Weights of four triangles: 1 or 0 in each lane, for springs and area, and for springs with damping; the cosine to
/// the push, and their closing speeds.
struct alignas(32) CountedFour {
  Lanes springs, damped, along;
  std::array<Lanes, 3> closing;
};

/// Integrals of a pressure that is linear over each triangle.
struct LinearPressure : TrianglePressure {
  std::array<Lanes, 3> at;  // the corners
  Lanes sum;
  Triple<Lanes> weighted;

  /// `speed`: sum of the closing speeds at the corners; `twelfth` of the area.
  TRILITH_INLINE LinearPressure(const std::array<Lanes, 3>& corners, const FourTriangles& in,
                                const std::array<Lanes, 3>& closing, const Triple<Lanes>& arms, const Lanes& speed,
                                const Lanes& twelfth)
      : at(corners), sum(at[0] + at[1] + at[2]) {
    force = 4.0 * twelfth * sum;
    weighted = in.arm[0] * at[0] + in.arm[1] * at[1] + in.arm[2] * at[2];
    first = (arms * sum + weighted) * twelfth;
    power = twelfth * (sum * speed + at[0] * closing[0] + at[1] * closing[1] + at[2] * closing[2]);
  }
  /// Second moments, `sixtieth` of the area.
  TRILITH_INLINE void add_second(const FourTriangles& in, const Triple<Lanes>& u, const Lanes& sixtieth,
                                 std::array<Lanes, 6>& sums) const {
    const ArmProducts uu(u, u), pp(in.arm[0], in.arm[0]), qq(in.arm[1], in.arm[1]), rr(in.arm[2], in.arm[2]),
        uw(u, weighted), wu(weighted, u);
    const std::array<Lanes, 3> own{sum + 2.0 * at[0], sum + 2.0 * at[1], sum + 2.0 * at[2]};
    for (std::size_t k = 0; k < 6; ++k)
      sums[k] +=
          sixtieth * (sum * uu.of[k] + uw.of[k] + wu.of[k] + own[0] * pp.of[k] + own[1] * qq.of[k] + own[2] * rr.of[k]);
  }
};

TRILITH_INLINE void sum_four(const FourTriangles& in, const CountedFour& of, double beta, TriangleSums& sums) {
  const Triple<Lanes> u = in.arm[0] + in.arm[1] + in.arm[2];
  const Lanes area = area_of(in), speed = of.closing[0] + of.closing[1] + of.closing[2];
  const Lanes twelfth = area * of.springs * (1.0 / 12);
  std::array<Lanes, 3> damped;
  for (std::size_t i = 0; i < 3; ++i) damped[i] = in.depth[i] + beta * of.closing[i];
  const LinearPressure springs(in.depth, in, of.closing, u, speed, twelfth),
      total(damped, in, of.closing, u, speed, area * of.damped * (1.0 / 12));
  sums.add_pressure(in, of.along, springs, total);
  sums.add_area(in, u, twelfth);
  total.add_second(in, u, area * of.damped * (1.0 / 60), sums.arm_second);
  for (const Lanes& d : in.depth) sums.depth = larger<Lanes>(sums.depth, d * of.springs);
}

/// A corner of a triangle that is partly pressed.
struct DampedCorner {
  Vec3 arm;
  double depth, closing, damped;
};

/// The part of a triangle in one lane where the damped pressure is positive.
struct PressedPart {
  std::array<DampedCorner, 4> corner;
  std::size_t count = 0;

  TRILITH_INLINE PressedPart(const FourTriangles& in, const CountedFour& of, double beta, int lane) {
    std::array<DampedCorner, 3> all;
    for (std::size_t k = 0; k < 3; ++k) {
      const double depth = in.depth[k][lane], closing = of.closing[k][lane];
      all[k] = {lane_of(in.arm[k], lane), depth, closing, depth + beta * closing};
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const DampedCorner &p = all[k], &q = all[k == 2 ? 0 : k + 1];
      if (p.damped >= 0) corner[count++] = p;
      if ((p.damped > 0 && q.damped < 0) || (p.damped < 0 && q.damped > 0)) {
        const double t = p.damped / (p.damped - q.damped);
        corner[count++] = {p.arm + t * (q.arm - p.arm), p.depth + t * (q.depth - p.depth),
                           p.closing + t * (q.closing - p.closing), 0};
      }
    }
  }
};

/// Parts of triangles with active damping; their springs are already counted.
class PressedParts {
 public:
  PressedParts(double beta, TriangleSums& sums) : beta_(beta), sums_(sums) {}

  TRILITH_INLINE void add(const FourTriangles& in, const CountedFour& of, int lane) {
    const PressedPart part(in, of, beta_, lane);
    for (std::size_t i = 2; i < part.count; ++i) {
      for (const std::size_t k : {0U, 1U, 2U}) {
        const DampedCorner& c = part.corner[k == 0 ? 0 : i + k - 2];
        set(four_.arm[k], c.arm);
        four_.depth[k][count_] = c.depth, closing_[k][count_] = c.closing;
      }
      set(four_.normal, lane_of(in.normal, lane));
      along_[count_] = of.along[lane];
      if (++count_ == lane_count) flush();
    }
  }
  /// Adds the damped pressure of the parts; unused lanes have no weight.
  TRILITH_INLINE void flush() {
    if (count_ == 0) return;
    const Lanes counts = select(LaneMask{0, 1, 2, 3} < count_, Lanes{} + 1.0, Lanes{});
    const Triple<Lanes> u = four_.arm[0] + four_.arm[1] + four_.arm[2];
    const Lanes area = area_of(four_), speed = closing_[0] + closing_[1] + closing_[2];
    std::array<Lanes, 3> damped;
    for (std::size_t i = 0; i < 3; ++i) damped[i] = four_.depth[i] + beta_ * closing_[i];
    const LinearPressure total(damped, four_, closing_, u, speed, area * counts * (1.0 / 12));
    sums_.add_damped(along_, total);
    total.add_second(four_, u, area * counts * (1.0 / 60), sums_.arm_second);
    count_ = 0;
  }
  [[nodiscard]] bool empty() const { return count_ == 0; }

 private:
  TRILITH_INLINE void set(Triple<Lanes>& to, const Vec3& v) {
    to.x[count_] = v.x(), to.y[count_] = v.y(), to.z[count_] = v.z();
  }

  double beta_;
  TriangleSums& sums_;
  int count_ = 0;
  FourTriangles four_{};
  std::array<Lanes, 3> closing_{};
  Lanes along_{};
};

/// The calls of PressedParts for one width of registers. They stay outside of the loop over all triangles, because few
/// triangles are partly pressed and the loop then keeps its sums in registers.
struct NarrowParts {
  [[gnu::noinline]] static void add(PressedParts& parts, const FourTriangles& in, const CountedFour& of, int lane) {
    parts.add(in, of, lane);
  }
  [[gnu::noinline]] static void flush(PressedParts& parts) { parts.flush(); }
};
#ifdef __x86_64__
struct WideParts {
  [[gnu::noinline, gnu::target("avx2")]] static void add(PressedParts& parts, const FourTriangles& in,
                                                         const CountedFour& of, int lane) {
    parts.add(in, of, lane);
  }
  [[gnu::noinline, gnu::target("avx2")]] static void flush(PressedParts& parts) { parts.flush(); }
};
#endif

/// Springs and area of all triangles, and damping of triangles whose pressure is positive at all corners. If it is
/// positive at some corners only, the pressed part is added separately.
template <class Parts>
TRILITH_INLINE TriangleSums sum_all(std::span<const FourTriangles> triangles, double beta, const DampedMotion& motion) {
  TriangleSums sums;
  PressedParts parts(beta, sums);
  for (const FourTriangles& in : triangles) {
    CountedFour of;
    of.along = motion.along(in), of.closing = motion.closing(in, of.along);
    LaneMask some{}, all = ~LaneMask{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Lanes damped = in.depth[k] + beta * of.closing[k];
      some |= damped > 0.0, all &= damped >= 0.0;
    }
    of.springs = Lanes{} + 1.0, of.damped = select(all, of.springs, Lanes{});
    sum_four(in, of, beta, sums);
    if (const LaneMask mixed = some & ~all; any(mixed))
      for (int i = 0; i < lane_count; ++i)
        if (mixed[i] != 0) Parts::add(parts, in, of, i);
  }
  if (!parts.empty()) Parts::flush(parts);
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

/// Sums over the lanes of four vectors.
TRILITH_INLINE Lanes over_four(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  const Lanes ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7),
              cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

TRILITH_INLINE void over_four(const Triple<Lanes>& v, const Lanes& more, Vec3& sum, double& more_sum) {
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
  over_four(push, none, sum, rest);
  return sum / 3;
}

[[gnu::target_clones("avx2", "default")]] PressedSums over_lanes(const TriangleSums& in, const Triple<Lanes>& normal,
                                                                 const Vec3* push) {
  PressedSums out;
  double damping = 0;
  over_four(in.turning, in.damping, out.damping_moment, damping), over_four(in.moment, in.area, out.moment, out.area);
  over_four(in.arm, in.arm_second[4], out.arm, out.arm_second[4]);
  over_four(in.area_arm, in.area_second[4], out.area_arm, out.area_second[4]);
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
