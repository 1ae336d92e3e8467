#include "contact/pressed_triangles.hpp"

namespace trilith {
namespace {

using Four = PressedTriangles::Four;
using SumsInLanes = PressedTriangles::Lane4;

/// Integrals over kn of a pressure that is linear over each triangle: of it, of it times the arm, of it times the
/// closing speed.
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

TRILITH_INLINE void add_four(const Four& in, double beta, SumsInLanes& sums) {
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

// One copy for wide registers and one for any machine: the same operations, so the same bits.

void add_narrow(const Four& in, double beta, SumsInLanes& sums) {
  add_four(in, beta, sums);
}
#ifdef __x86_64__
[[gnu::target("avx2")]] void add_wide(const Four& in, double beta, SumsInLanes& sums) {
  add_four(in, beta, sums);
}
#endif

double over_lanes(const Lanes& v) {
  return (v[0] + v[1]) + (v[2] + v[3]);
}
Vec3 over_lanes(const Triple<Lanes>& v) {
  return {over_lanes(v.x), over_lanes(v.y), over_lanes(v.z)};
}

}  // namespace

void PressedTriangles::flush() {
  count_ = 0;
#ifdef __x86_64__
  static const bool wide = __builtin_cpu_supports("avx2") != 0;
  if (wide) return add_wide(four_, beta_, sums_);
#endif
  add_narrow(four_, beta_, sums_);
}

PressedSums PressedTriangles::sums() {
  if (count_ > 0) {
    for (int i = count_; i < lane_count; ++i) four_.springs[i] = four_.damped[i] = 0;
    flush();
  }
  PressedSums out;
  out.force = over_lanes(sums_.force), out.moment = over_lanes(sums_.moment);
  out.damping = over_lanes(sums_.damping), out.damping_moment = over_lanes(sums_.damping_moment);
  out.damped = over_lanes(sums_.power), out.pressure = over_lanes(sums_.pressure);
  out.arm = over_lanes(sums_.arm), out.area = over_lanes(sums_.area), out.area_arm = over_lanes(sums_.area_arm);
  for (std::size_t k = 0; k < 6; ++k) {
    out.arm_second[k] = over_lanes(sums_.arm_second[k]);
    out.area_second[k] = over_lanes(sums_.area_second[k]);
  }
  for (int i = 0; i < lane_count; ++i) out.depth = out.depth > sums_.depth[i] ? out.depth : sums_.depth[i];
  return out;
}

}  // namespace trilith
