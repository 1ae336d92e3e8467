#include "contact/pressed_triangles.hpp"

#include "base/registers.hpp"

namespace trilith {
namespace {

using Four = PressedTriangles::Four;
using SumsInLanes = PressedTriangles::Lane4;

/// Integrals over kn of a pressure that is linear over each triangle: of it, of
/// it times the arm, of it times the closing speed.
struct LinearPressure {
  std::array<Lanes, 3> at;  // the corners
  Lanes sum, force, power;
  Triple<Lanes> weighted, first;

  TRILITH_INLINE LinearPressure(const std::array<Lanes, 3>& corners, const Four& in, const Triple<Lanes>& arms,
                                const Lanes& speed, const Lanes& twelfth)
      : at(corners), sum(at[0] + at[1] + at[2]), force(4.0 * twelfth * sum) {
    weighted = in.arm[0] * at[0] + in.arm[1] * at[1] + in.arm[2] * at[2];
    first = (arms * sum + weighted) * twelfth;
    power = twelfth * (sum * speed + at[0] * in.closing[0] + at[1] * in.closing[1] + at[2] * in.closing[2]);
  }
};

/// Products of vectors, in the order of PressedSums.
struct Products {
  std::array<Lanes, 6> of;
  TRILITH_INLINE Products(const Triple<Lanes>& a, const Triple<Lanes>& b)
      : of{a.x * b.x, a.y * b.y, a.z * b.z, a.x * b.y, a.y * b.z, a.z * b.x} {}
};

/// Second moments of the area and of the pressure.
TRILITH_INLINE void add_second(const Four& in, const Triple<Lanes>& u, const LinearPressure& p, const Lanes& area_share,
                               const Lanes& share, SumsInLanes& sums) {
  const Products uu(u, u), pp(in.arm[0], in.arm[0]), qq(in.arm[1], in.arm[1]), rr(in.arm[2], in.arm[2]),
      uw(u, p.weighted), wu(p.weighted, u);
  const std::array<Lanes, 3> own{p.sum + 2.0 * p.at[0], p.sum + 2.0 * p.at[1], p.sum + 2.0 * p.at[2]};
  for (std::size_t k = 0; k < 6; ++k) {
    sums.area_second[k] += area_share * (uu.of[k] + pp.of[k] + qq.of[k] + rr.of[k]);
    sums.arm_second[k] +=
        share * (p.sum * uu.of[k] + uw.of[k] + wu.of[k] + own[0] * pp.of[k] + own[1] * qq.of[k] + own[2] * rr.of[k]);
  }
}

TRILITH_INLINE void sum_four(const Four& in, double beta, SumsInLanes& sums) {
  const Triple<Lanes> u = in.arm[0] + in.arm[1] + in.arm[2];
  const Lanes area = 0.5 * in.normal.dot(cross(in.arm[1] - in.arm[0], in.arm[2] - in.arm[0]));
  const Lanes speed = in.closing[0] + in.closing[1] + in.closing[2], whole = area * in.springs;
  std::array<Lanes, 3> damped;
  for (std::size_t i = 0; i < 3; ++i) damped[i] = in.depth[i] + beta * in.closing[i];
  const LinearPressure springs(in.depth, in, u, speed, whole * (1.0 / 12)),
      total(damped, in, u, speed, area * in.damped * (1.0 / 12));
  const Triple<Lanes> n = in.normal * in.sign;
  sums.force = sums.force + n * total.force, sums.moment = sums.moment + cross(total.first, n);
  sums.damping = sums.damping + n * (total.force - springs.force);
  sums.damping_moment = sums.damping_moment + cross(total.first - springs.first, n);
  sums.power += total.power - springs.power;
  sums.pressure += total.force, sums.arm = sums.arm + total.first;
  sums.area += whole, sums.area_arm = sums.area_arm + u * (whole * (1.0 / 3));
  add_second(in, u, total, whole * (1.0 / 12), area * in.damped * (1.0 / 60), sums);
  for (const Lanes& d : in.depth) sums.depth = larger<Lanes>(sums.depth, d * in.springs);
}

// One copy for wide registers and one for any machine: the same operations, so
// the same bits.

void add_narrow(const Four& in, double beta, SumsInLanes& sums) {
  sum_four(in, beta, sums);
}
#ifdef __x86_64__
[[gnu::target("avx2")]] void add_wide(const Four& in, double beta, SumsInLanes& sums) {
  sum_four(in, beta, sums);
}
#endif

/// Sums over the lanes of four vectors.
TRILITH_INLINE Lanes over_lanes(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  const Lanes ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7),
              cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

TRILITH_INLINE void over_lanes(const Triple<Lanes>& v, const Lanes& more, Vec3& sum, double& more_sum) {
  const Lanes of = over_lanes(v.x, v.y, v.z, more);
  sum = {of[0], of[1], of[2]}, more_sum = of[3];
}

[[gnu::target_clones("avx2", "default")]] void add_lanes(const SumsInLanes& in, PressedSums& out) {
  double none = 0;
  over_lanes(in.force, in.power, out.force, out.damped), over_lanes(in.damping, in.pressure, out.damping, out.pressure);
  over_lanes(in.moment, in.area, out.moment, out.area);
  over_lanes(in.damping_moment, Lanes{}, out.damping_moment, none);
  over_lanes(in.arm, in.arm_second[4], out.arm, out.arm_second[4]);
  over_lanes(in.area_arm, in.area_second[4], out.area_arm, out.area_second[4]);
  const auto four = [&](const std::array<Lanes, 6>& from, std::array<double, 6>& to) {
    const Lanes sums = over_lanes(from[0], from[1], from[2], from[3]);
    for (int k = 0; k < 4; ++k) to[static_cast<std::size_t>(k)] = sums[k];
  };
  four(in.arm_second, out.arm_second), four(in.area_second, out.area_second);
  const Lanes rest = over_lanes(in.arm_second[5], in.area_second[5], Lanes{}, Lanes{});
  out.arm_second[5] = rest[0], out.area_second[5] = rest[1];
  for (int i = 0; i < lane_count; ++i) out.depth = out.depth > in.depth[i] ? out.depth : in.depth[i];
}

}  // namespace

/// Each sum for itself: set as one stretch of memory, it would be waited for.
PressedTriangles::PressedTriangles(double beta) : beta_(beta) {
  const Lanes none{};
  for (Triple<Lanes>* v :
       {&sums_.force, &sums_.moment, &sums_.damping, &sums_.damping_moment, &sums_.arm, &sums_.area_arm})
    v->x = none, v->y = none, v->z = none;
  sums_.power = none, sums_.pressure = none, sums_.area = none, sums_.depth = none;
  for (std::size_t k = 0; k < 6; ++k) sums_.arm_second[k] = none, sums_.area_second[k] = none;
}

void PressedTriangles::flush() {
  count_ = 0;
  add_four(four_);
}

void PressedTriangles::add_four(const Four& four) {
#ifdef __x86_64__
  static const bool wide = registers_here() != Registers::narrow;
  if (wide) return add_wide(four, beta_, sums_);
#endif
  add_narrow(four, beta_, sums_);
}

/// A copy of the first that counts for nothing.
void PressedTriangles::leave_out(int lane) {
  const auto copy = [&](Triple<Lanes>& v) { v.x[lane] = v.x[0], v.y[lane] = v.y[0], v.z[lane] = v.z[0]; };
  copy(four_.normal), four_.sign[lane] = 0, four_.springs[lane] = 0, four_.damped[lane] = 0;
  for (std::size_t k = 0; k < 3; ++k)
    copy(four_.arm[k]), four_.depth[k][lane] = four_.depth[k][0], four_.closing[k][lane] = four_.closing[k][0];
}

PressedSums PressedTriangles::sums() {
  if (count_ > 0) {
    for (int i = count_; i < lane_count; ++i) leave_out(i);
    flush();
  }
  PressedSums out;
  add_lanes(sums_, out);
  return out;
}

}  // namespace trilith
