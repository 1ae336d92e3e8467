// Friction of four contacts of solids at once, and their response to a normal pressure.
//
// Input: motion, memory and law of the contacts; the normal force with its damping; area, centre and spread of the
// pressed area in the response. Output: the response: total forces and moments, the new memory, dissipated energies.
// Friction follows contact/joint/shear_3d.hpp, with its spring at the centroid of the area, whatever the pressure.
#pragma once

#include "contact/joint/chord.hpp"
#include "contact/joint/friction_projection.hpp"
#include "contact/space/flat_contact.hpp"

namespace trilith {

/// FrictionLimit of four contacts.
struct FourLimits {
  Lanes force, radius, arm;
  Triple<Lanes> normal, offset;
  LaneMask wide;

  TRILITH_INLINE FourLimits(const Lanes& held, const Triple<Lanes>& across, const Triple<Lanes>& from_middle,
                            const Lanes& gyration, const Lanes& distance)
      : normal(across) {
    const Lanes zero{}, one = zero + 1.0;
    wide = gyration > zero;
    force = select(held > zero + least_held_force, held, zero);
    radius = select(wide, gyration, one), arm = select(wide, larger(distance, 0.01 * gyration), one);
    offset = select<Lanes>(wide, from_middle - across * across.dot(from_middle), Triple<Lanes>{});
  }
  /// `arms`: orientation of the area, used only where a contact is near its limit.
  [[nodiscard]] TRILITH_INLINE LaneMask is_below(const Triple<Lanes>& spring,
                                                 const std::array<Triple<Lanes>, 2>& arms) const {
    const Lanes zero{}, one = zero + 1.0, turning = normal.dot(spring), per = 1.0 / force;
    const Triple<Lanes> across = (spring - normal * turning) * per;
    const Lanes couple = (radius * turning - normal.dot(cross(offset, spring - normal * turning))) * per / arm;
    const Lanes x2 = across.square(), y2 = couple * couple;
    const LaneMask none = flip(force > zero);
    // Upper bound of the measure of any area for V^2 up to 1.
    const LaneMask near = (x2 > one) | flip(x2 * (2.0 - x2) + y2 * (one + most_turn * x2) <= one);
    if (!any(none | near)) return LaneMask{};
    return none | (near & flip(spread(arms).beyond_square(across, couple) <= one));
  }
  [[nodiscard]] TRILITH_INLINE LimitSpread<Lanes> spread(const std::array<Triple<Lanes>, 2>& arms) const {
    const Triple<Lanes> none{};
    return {select<Lanes>(wide, arms[0], none), select<Lanes>(wide, arms[1], none)};
  }
};

/// One by one, for the few lanes that do not converge or have no direction in the plane.
[[gnu::noinline]] inline void hold_alone(const FourLimits& limits, const LimitSpread<Lanes>& spread,
                                         const LaneMask& alone, const Triple<Lanes>& spring, Triple<Lanes>& held) {
  for (int i = 0; i < lane_count; ++i) {
    if (alone[i] == 0) continue;
    AreaLimit limit(FrictionLimit(limits.force[i], lane_of(limits.normal, i), Vec3::Zero(), 0, 0));
    limit.offset = lane_of(limits.offset, i), limit.radius = limits.radius[i], limit.arm = limits.arm[i];
    limit.spread.a = spread.a[i], limit.spread.along_a = spread.along_a[i];
    limit.spread.c = spread.c[i], limit.spread.along_c = spread.along_c[i];
    limit.spread.p = triple_of(lane_of(spread.p, i)), limit.spread.q = triple_of(lane_of(spread.q, i));
    const Vec3 nearest = limit.nearest_to(lane_of(spring, i));
    held.x[i] = nearest.x(), held.y[i] = nearest.y(), held.z[i] = nearest.z();
  }
}

/// Projects the lanes in `below`, whose limit is exceeded, to the nearest admissible force.
TRILITH_INLINE void hold_back(const FourLimits& limits, const std::array<Triple<Lanes>, 2>& arms, const LaneMask& below,
                              Triple<Lanes>& spring) {
  const LimitSpread<Lanes> spread = limits.spread(arms);
  const LaneMask holds = below & (limits.force > Lanes{});
  const LimitFrame<Lanes> frame(limits.normal, limits.offset, spring);
  const LimitPlaces<Lanes> places{frame.off / limits.arm, limits.radius / limits.arm, spread.in(frame.x, frame.y)};
  const Triple<Lanes> beyond = places.from_spring(frame.shares(limits.force, spring));
  Triple<Lanes> z;
  const LaneMask asked = holds & frame.known,
                 alone = nearest_by_newton<Lanes>(places, beyond, asked, z) | (holds & flip(frame.known));
  const Triple<Lanes> held = frame.force_of(limits.force, spring_on_limit(places, z));
  const Triple<Lanes> before = spring;
  spring = select<Lanes>(below, select<Lanes>(holds, held, Triple<Lanes>{}), spring);
  if (any(alone)) hold_alone(limits, spread, alone, before, spring);
}

/// Power of the previous damping force in the motion of b relative to a [W].
TRILITH_INLINE Lanes power_remembered(const ContactsInLanes& in) {
  const Triple<Lanes> rate = in.b.velocity_at(in.a.origin) - in.a.velocity;
  return in.before.damping.dot(rate) + in.before.damping_moment.dot(in.b.spin - in.a.spin);
}

/// Bit of a kind: friction slides.
inline constexpr std::int64_t slides_bit = std::int64_t{1} << told_lines;

/// Friction on the resultant, and about its normal: see add_friction of contact/space/solid_contact.cpp.
TRILITH_INLINE void add_friction(const ContactsInLanes& in, const Lanes& normal_force, FlatResponses& out,
                                 Triple<Lanes>& moment) {
  const Lanes half_step = Lanes{} + 0.5 * in.dt, step = Lanes{} + in.dt;
  const Triple<Lanes>& n = out.normal;
  Triple<Lanes> rate = in.b.velocity_at(out.middle) - in.a.velocity_at(out.middle);
  rate = rate + (chord_part(in.b.spin, out.middle - in.b.origin, in.dt) -
                 chord_part(in.a.spin, out.middle - in.a.origin, in.dt));
  rate = rate + n * (out.radius * n.dot(in.b.spin - in.a.spin) - n.dot(rate));
  const TurnedPlane<Lanes> plane(in.before.normal, n, half_step * n.dot(in.a.spin + in.b.spin));
  const ShearForce<Lanes> before{plane.carry(in.before.shear.elastic), plane.carry(in.before.shear.total),
                                 in.before.shear.area};
  SlidingStep<Lanes> slid(rate * step, rate, out.area, before, in.ks, in.beta);
  const FourLimits limit(in.mu * normal_force, n, out.centre - out.middle, out.radius, out.friction_arm);
  const LaneMask below = limit.is_below(slid.total, out.arm) & out.presses & out.flat;
  out.kind |= below & (LaneMask{} + slides_bit);
  Triple<Lanes> stretch = slid.path;
  if (any(below)) {
    Triple<Lanes> held = slid.total;
    hold_back(limit, out.arm, below, held);
    stretch = slid.hold(held, below, in.beta, in.dt);
  }
  const SlidingLoss<Lanes> lost(slid, stretch, before);
  const Lanes along = n.dot(slid.total);
  const Triple<Lanes> shear = slid.total - n * along;
  out.force = out.force - shear;
  moment = moment - n * (out.radius * along) - cross(out.middle - out.centre, shear);
  out.memory.shear = {slid.elastic, slid.total, out.area};
  out.memory.slip = in.before.slip + lost.slip;
  out.lost_damping += select(out.presses, lost.damping, Lanes{}), out.lost_friction = lost.friction;
}

/// Normal pressure of four contacts.
struct NormalInLanes {
  Triple<Lanes> force;                    ///< on b [N]
  Lanes pressure;                         ///< its magnitude [N]
  Triple<Lanes> moment;                   ///< on b about the centre of pressure [N m]
  Triple<Lanes> damping, damping_moment;  ///< the part due to damping, about the same centre
  Lanes damped;                           ///< power dissipated by damping [W]
};

/// Completes the response of the lanes of `out.presses`, whose area, centre, middle, normal, spread and depth are
/// known. If the pressure has no force (only tensile damping), there is no friction, and the spring's energy is
/// dissipated. The couple of springs on several faces, which damping along one direction does not take up, remains.
TRILITH_INLINE void respond_normal(const ContactsInLanes& in, const NormalInLanes& normal, FlatResponses& out) {
  const Lanes zero{}, half_step = zero + 0.5 * in.dt;
  const Triple<Lanes> none{};
  out.force = out.normal_force = normal.force;
  out.memory.damping = normal.damping;
  out.memory.damping_moment = normal.damping_moment + cross(out.centre - in.a.origin, normal.damping);
  out.lost_damping = half_step * (normal.damped - power_remembered(in));
  Triple<Lanes> moment = normal.moment;
  const Lanes let_go = 0.5 * in.before.shear.elastic.square() * sliding_compliance<Lanes>(in.ks, in.before.shear.area);
  add_friction(in, normal.pressure, out, moment);
  // Without force there is no friction, and its elastic energy is lost.
  out.force = select<Lanes>(out.presses, out.force, none);
  moment = select<Lanes>(out.presses, moment, normal.moment);
  out.memory.normal = out.normal;
  out.memory.shear.elastic = select<Lanes>(out.presses, out.memory.shear.elastic, none);
  out.memory.shear.total = select<Lanes>(out.presses, out.memory.shear.total, none);
  out.memory.shear.area = select(out.presses, out.memory.shear.area, zero);
  out.memory.slip = select(out.presses, out.memory.slip, in.before.slip);
  out.lost_friction = select(out.presses, out.lost_friction, let_go);
  out.moment_a = none - moment - cross(out.centre - in.a.origin, out.force);
  out.moment_b = moment + cross(out.centre - in.b.origin, out.force);
}

}  // namespace trilith
