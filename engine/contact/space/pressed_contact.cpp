#include "contact/space/pressed_contact.hpp"

#include <cstddef>
#include <type_traits>

#include "base/simd/lane_rows.hpp"
#include "base/simd/registers.hpp"
#include "contact/space/friction_lanes.hpp"
#include "contact/space/solid_pressure.hpp"

namespace trilith {
namespace {

// Sums are read as rows of numbers, in this order.
static_assert(std::is_standard_layout_v<PairSums> && sizeof(PairSums) == 37 * sizeof(double) &&
              offsetof(PairSums, origin) == 34 * sizeof(double) &&
              offsetof(PressedSums, damping_moment) == 9 * sizeof(double) &&
              offsetof(PressedSums, arm_second) == 17 * sizeof(double) &&
              offsetof(PressedSums, area_second) == 27 * sizeof(double) &&
              offsetof(PressedSums, depth) == 33 * sizeof(double));

/// PairSums of four pairs.
struct FourSums {
  Triple<Lanes> force, moment, damping, damping_moment, arm, area_arm, origin;
  Lanes damped, pressure, area, depth;
  std::array<Lanes, 6> arm_second, area_second;

  TRILITH_INLINE explicit FourSums(const std::array<const PairSums*, lane_count>& of) {
    std::array<const double*, lane_count> first;
    for (std::size_t i = 0; i < of.size(); ++i) first[i] = of[i]->sums.force.data();
    const FourRowsOf<const double> row(first);
    row.load(0, force.x, force.y, force.z, moment.x);
    row.load(4, moment.y, moment.z, damping.x, damping.y);
    row.load(8, damping.z, damping_moment.x, damping_moment.y, damping_moment.z);
    row.load(12, damped, pressure, arm.x, arm.y);
    row.load(16, arm.z, arm_second[0], arm_second[1], arm_second[2]);
    row.load(20, arm_second[3], arm_second[4], arm_second[5], area);
    row.load(24, area_arm.x, area_arm.y, area_arm.z, area_second[0]);
    row.load(28, area_second[1], area_second[2], area_second[3], area_second[4]);
    row.load(32, area_second[5], depth, origin.x, origin.y);
    row.load(36, origin.z);
  }
};

/// Two axes in the plane normal to unit vectors, the first as in line_across().
struct PlaneAxes {
  Triple<Lanes> x, y;

  TRILITH_INLINE explicit PlaneAxes(const Triple<Lanes>& n) {
    const Lanes zero{}, along_x = magnitude(n.x), along_y = magnitude(n.y), along_z = magnitude(n.z);
    const LaneMask by_x = (along_x <= along_y) & (along_x <= along_z), by_y = along_y <= along_z;
    x = select<Lanes>(by_x, {zero, n.z, zero - n.y},
                      select<Lanes>(by_y, {zero - n.z, zero, n.x}, {n.y, zero - n.x, zero}));
    x = x * ((zero + 1.0) / root(x.square())), y = cross(n, x);
  }
};

/// Second moments in a plane: the sums over a whole (an area or a force) about the middle of it.
struct SpreadInPlane {
  Lanes xx, xy, yy;

  TRILITH_INLINE SpreadInPlane(const std::array<Lanes, 6>& second, const Lanes& whole, const Triple<Lanes>& middle,
                               const PlaneAxes& axes) {
    const auto applied = [&](const Triple<Lanes>& v) TRILITH_INLINE_LAMBDA {
      return Triple<Lanes>{second[0] * v.x + second[3] * v.y + second[5] * v.z,
                           second[3] * v.x + second[1] * v.y + second[4] * v.z,
                           second[5] * v.x + second[4] * v.y + second[2] * v.z};
    };
    const Triple<Lanes> of_x = applied(axes.x), of_y = applied(axes.y);
    const Lanes per = 1.0 / whole, along = axes.x.dot(middle), aside = axes.y.dot(middle);
    xx = axes.x.dot(of_x) * per - along * along, xy = axes.y.dot(of_x) * per - along * aside;
    yy = axes.y.dot(of_y) * per - aside * aside;
  }
};

/// spread_arms() and the radius of gyration of four areas.
TRILITH_INLINE void set_area_spread(const SpreadInPlane& of, const PlaneAxes& axes, FlatResponses& out) {
  const Lanes zero{};
  const LaneMask wide = of.xx > zero;
  const Lanes along = select(wide, root(of.xx), zero), aside = select(wide, of.xy / along, zero);
  out.radius = root(larger(zero, of.xx + of.yy));
  out.arm[0] = axes.x * along + axes.y * aside;
  out.arm[1] = axes.y * root(larger(zero, of.yy - aside * aside));
}

TRILITH_INLINE void respond_four_pressed(const PressedContacts& in, FlatResponses& out) {
  const Lanes zero{}, one = zero + 1.0, k = 0.5 * in.kn;
  const FourSums sums(in.sums);
  out.flat = sums.area > zero, out.rough = LaneMask{}, out.kind = LaneMask{};
  const LaneMask pressed = sums.pressure > zero;
  const Triple<Lanes> middle = sums.area_arm * (one / sums.area),
                      arm = select<Lanes>(pressed, sums.arm * (one / sums.pressure), middle);
  NormalInLanes normal;
  normal.force = sums.force * k, normal.pressure = root(normal.force.square());
  out.presses = out.flat & (normal.pressure > zero);
  const Triple<Lanes> n = select<Lanes>(out.presses, normal.force * (one / normal.pressure), {zero, zero, one});
  const PlaneAxes axes(n);
  set_area_spread({sums.area_second, sums.area, middle, axes}, axes, out);
  const SpreadInPlane of_pressure(sums.arm_second, sums.pressure, arm, axes);
  out.friction_arm = select(pressed,
                            mean_distance<Lanes>(of_pressure.xx + of_pressure.yy,
                                                 of_pressure.xx * of_pressure.yy - of_pressure.xy * of_pressure.xy),
                            zero);
  out.area = 0.5 * sums.area, out.depth = sums.depth;
  out.centre = sums.origin + arm, out.middle = sums.origin + middle;
  out.normal = select<Lanes>(out.presses, n, Triple<Lanes>{});
  normal.moment = sums.moment * k - cross(arm, normal.force);
  normal.damping = sums.damping * k;
  normal.damping_moment = sums.damping_moment * k - cross(arm, normal.damping);
  normal.damped = k * sums.damped;
  respond_normal(in, normal, out);
  out.presses = out.flat;
}

// One copy for each register width: the same operations, so the same bits.

void pressed_narrow(const PressedContacts& in, FlatResponses& out) {
  respond_four_pressed(in, out);
}
#ifdef __x86_64__
[[gnu::target("avx2")]] void pressed_wide(const PressedContacts& in, FlatResponses& out) {
  respond_four_pressed(in, out);
}
#endif

}  // namespace

void respond_pressed(const PressedContacts& in, FlatResponses& out) {
#ifdef __x86_64__
  static const bool wide = registers_here() != Registers::narrow;
  if (wide) return pressed_wide(in, out);
#endif
  pressed_narrow(in, out);
}

}  // namespace trilith
