#include "contact/space/flat_contact.hpp"

#include "base/simd/registers.hpp"
#include "contact/joint/chord.hpp"
#include "contact/joint/friction_projection.hpp"
#include "contact/space/solid_faces.hpp"

namespace trilith {
namespace {

/// The overlap over the mean plane, and its rate.
struct OverlapMotion {
  LinearInLanes overlap, rate;

  TRILITH_INLINE OverlapMotion(const FlatContacts& in, const PlaneInLanes& plane)
      : overlap{plane.overlap, plane.slope} {
    const Triple<Lanes> spin = in.b.spin - in.a.spin,
                        closing = in.b.velocity_at(plane.origin) - in.a.velocity_at(plane.origin);
    const Lanes zero{};
    rate.at = zero - plane.normal.dot(closing);
    rate.slope = {zero - plane.normal.dot(cross(spin, plane.x)), zero - plane.normal.dot(cross(spin, plane.y))};
  }
  TRILITH_INLINE void move(const Pair2<Lanes>& by) { overlap.at = overlap(by), rate.at = rate(by); }
  [[nodiscard]] TRILITH_INLINE LinearInLanes damped(const Lanes& beta) const {
    return {overlap.at + beta * rate.at, overlap.slope + rate.slope * beta};
  }
};

/// Integrals of a linear function over a polygon: of the function, and of its product with the position.
struct LinearIntegrals {
  Lanes force;
  Pair2<Lanes> first;

  TRILITH_INLINE LinearIntegrals(const LinearInLanes& of, const AreaInLanes& over)
      : force(of.at * over.area + of.slope.dot(over.first)),
        first{of.at * over.first.x + of.slope.x * over.xx + of.slope.y * over.xy,
              of.at * over.first.y + of.slope.x * over.xy + of.slope.y * over.yy} {}
  [[nodiscard]] TRILITH_INLINE Lanes times(const LinearInLanes& other) const {
    return other.at * force + other.slope.dot(first);
  }
};

/// Whether the faces lie flat: they oppose each other within the tilt limit, are near, touch, and are not too deep for
/// the width of their shared polygon. `depth`: largest overlap; `least`: smallest overlap of a corner, negative where
/// it is open.
TRILITH_INLINE LaneMask lies_flat(const FlatContacts& in, const EdgesInLanes& shared, const LinearInLanes& overlap,
                                  Lanes& depth, Lanes& least) {
  const Lanes zero{};
  const FacesInLanes& f = in.faces;
  const Lanes far = zero + 1e300;
  Pair2<Lanes> low{far, far}, high{zero - far, zero - far};
  Lanes twice{};
  depth = zero, least = far;
  for (std::size_t i = 0; i < static_cast<std::size_t>(shared.count); ++i) {
    const LaneMask alive = shared.alive[i];
    const Pair2<Lanes>&p = shared.from[i], &q = shared.to[i];
    const Lanes here = overlap(p);
    depth = larger(depth, select(alive, here, zero)), least = smaller(least, select(alive, here, far));
    low = {smaller(low.x, select(alive, p.x, far)), smaller(low.y, select(alive, p.y, far))};
    high = {larger(high.x, select(alive, p.x, -far)), larger(high.y, select(alive, p.y, -far))};
    twice += select(alive, cross(p, q), zero);
  }
  const Pair2<Lanes> extent = high - low;
  const Lanes width = 0.5 * twice / root(extent.dot(extent));
  const Triple<Lanes> apart = f.a[0] - f.b[0];
  const Lanes distance = select(in.b_is_larger, zero - f.normal_b.dot(apart), f.normal_a.dot(apart));
  return (f.normal_a.dot(f.normal_b) <= opposed_enough + zero) & (magnitude(distance) <= in.near) & (twice > zero) &
         (depth > zero) & (depth <= flat_faces_max_depth * width);
}

/// Pressure over the polygon, all about `plane.origin`.
struct FlatPressure {
  AreaInLanes area;  // in contact
  Lanes pressure, damping, damped;
  Pair2<Lanes> centre, middle;
  Triple<Lanes> damping_moment;  // about the centre of pressure
  Lanes radius, friction_arm;
  std::array<Triple<Lanes>, 2> arm;

  /// `open`: some corner of the polygon has no overlap, or may have none by rounding.
  TRILITH_INLINE FlatPressure(const FlatContacts& in, const PlaneInLanes& plane, const OverlapMotion& motion,
                              const LaneMask& open, EdgesInLanes& polygon) {
    if (any(open))
      cut_edges(polygon, motion.overlap);
    else
      ++polygon.lines;
    const LinearInLanes damped_overlap = motion.damped(in.beta);
    const MomentsInLanes pressed = pressed_part(polygon, damped_overlap);
    const LinearIntegrals springs(motion.overlap, area), total(damped_overlap, pressed);
    const Lanes one = Lanes{} + 1.0;
    middle = area.first * (one / area.area);
    centre = select<Lanes>(total.force > Lanes{}, total.first * (one / total.force), middle);
    pressure = larger(in.kn * total.force, Lanes{});
    damping = in.kn * (total.force - springs.force);
    const Pair2<Lanes> arm_of = (total.first - springs.first) * in.kn - centre * damping;
    damping_moment = cross(plane.along(arm_of), plane.normal);
    damped = in.kn * (total.times(motion.rate) - springs.times(motion.rate));
    set_spread(plane);
    set_friction_arm(damped_overlap, pressed, total.force);
  }

 private:
  /// The moments of the part with overlap and positive pressure; also of the area in contact.
  TRILITH_INLINE MomentsInLanes pressed_part(EdgesInLanes& polygon, const LinearInLanes& damped_overlap) {
    const int before = polygon.count;
    LaneMask cut{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(before); ++i)
      cut |= polygon.alive[i] & (damped_overlap(polygon.from[i]) < Lanes{});
    if (any(cut)) {
      area = area_of(polygon);
      cut_edges(polygon, damped_overlap);
      return moments_of(polygon);
    }
    const MomentsInLanes all = moments_of(polygon);
    area = all;
    return all;
  }
  TRILITH_INLINE void set_spread(const PlaneInLanes& plane) {
    const Lanes zero{}, one = zero + 1.0, per = one / area.area;
    const Lanes xx = area.xx * per - middle.x * middle.x, yy = area.yy * per - middle.y * middle.y,
                xy = area.xy * per - middle.x * middle.y;
    radius = root(larger(zero, xx + yy));
    const LaneMask wide = xx > zero;
    const Lanes along = select(wide, root(xx), zero), aside = select(wide, xy / along, zero);
    arm[0] = plane.along({along, aside});
    arm[1] = plane.y * root(larger(zero, yy - aside * aside));
  }
  /// Mean distance of the pressure from its centre.
  TRILITH_INLINE void set_friction_arm(const LinearInLanes& f, const MomentsInLanes& m, const Lanes& force) {
    const Lanes zero{}, per = 1.0 / force;
    const Lanes xx = (f.at * m.xx + f.slope.x * m.xxx + f.slope.y * m.xxy) * per - centre.x * centre.x,
                yy = (f.at * m.yy + f.slope.x * m.xyy + f.slope.y * m.yyy) * per - centre.y * centre.y,
                xy = (f.at * m.xy + f.slope.x * m.xxy + f.slope.y * m.xyy) * per - centre.x * centre.y;
    friction_arm = select(force > zero, mean_distance<Lanes>(xx + yy, xx * yy - xy * xy), zero);
  }
};

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
[[gnu::noinline]] void hold_alone(const FourLimits& limits, const LimitSpread<Lanes>& spread, const LaneMask& alone,
                                  const Triple<Lanes>& spring, Triple<Lanes>& held) {
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
TRILITH_INLINE Lanes power_remembered(const FlatContacts& in) {
  const Triple<Lanes> rate = in.b.velocity_at(in.a.origin) - in.a.velocity;
  return in.before.damping.dot(rate) + in.before.damping_moment.dot(in.b.spin - in.a.spin);
}

/// Bit of a kind: friction slides.
constexpr std::int64_t slides_bit = std::int64_t{1} << told_lines;

/// Friction on the resultant, and about its normal: see add_friction of contact/space/solid_contact.cpp.
TRILITH_INLINE void add_friction(const FlatContacts& in, const FlatPressure& p, FlatResponses& out,
                                 Triple<Lanes>& moment) {
  const Lanes half_step = Lanes{} + 0.5 * in.dt, step = Lanes{} + in.dt;
  const Triple<Lanes>& n = out.normal;
  Triple<Lanes> rate = in.b.velocity_at(out.middle) - in.a.velocity_at(out.middle);
  rate = rate + (chord_part(in.b.spin, out.middle - in.b.origin, in.dt) -
                 chord_part(in.a.spin, out.middle - in.a.origin, in.dt));
  rate = rate + n * (p.radius * n.dot(in.b.spin - in.a.spin) - n.dot(rate));
  const TurnedPlane<Lanes> plane(in.before.normal, n, half_step * n.dot(in.a.spin + in.b.spin));
  const ShearForce<Lanes> before{plane.carry(in.before.shear.elastic), plane.carry(in.before.shear.total),
                                 in.before.shear.area};
  SlidingStep<Lanes> slid(rate * step, rate, p.area.area, before, in.ks, in.beta);
  const FourLimits limit(in.mu * p.pressure, n, out.centre - out.middle, p.radius, p.friction_arm);
  const LaneMask below = limit.is_below(slid.total, p.arm) & out.presses & out.flat;
  out.kind |= below & (LaneMask{} + slides_bit);
  Triple<Lanes> stretch = slid.path;
  if (any(below)) {
    Triple<Lanes> held = slid.total;
    hold_back(limit, p.arm, below, held);
    stretch = slid.hold(held, below, in.beta, in.dt);
  }
  const SlidingLoss<Lanes> lost(slid, stretch, before);
  const Lanes along = n.dot(slid.total);
  const Triple<Lanes> shear = slid.total - n * along;
  out.force = out.force - shear;
  moment = moment - n * (p.radius * along) - cross(out.middle - out.centre, shear);
  out.memory.shear = {slid.elastic, slid.total, p.area.area};
  out.memory.slip = in.before.slip + lost.slip;
  out.lost_damping += select(out.presses, lost.damping, Lanes{}), out.lost_friction = lost.friction;
}

/// Pressure first, then friction. If the pressure has no force (only tensile damping), there is no friction, and the
/// spring's energy is dissipated.
TRILITH_INLINE void respond_four(const FlatContacts& in, FlatResponses& out) {
  const Lanes zero{};
  PlaneInLanes plane = mean_plane(in.faces);
  EdgesInLanes polygon;
  share_edges(in.faces, plane, polygon);
  OverlapMotion motion(in, plane);
  Lanes least;
  out.flat = lies_flat(in, polygon, motion.overlap, out.depth, least);
  out.rough = polygon.rough;
  out.kind = LaneMask{};
  if (!any(out.flat)) return;
  const Pair2<Lanes> middle = middle_of(polygon);
  move_edges(polygon, middle), motion.move(middle);
  plane.origin = plane.origin + plane.along(middle);
  // Moving the reference to the centroid changes overlaps by rounding, far less than this.
  const LaneMask open = out.flat & (least <= 1e-6 * out.depth);
  const FlatPressure p(in, plane, motion, open, polygon);
  out.rough |= polygon.rough, out.kind = lines_of(polygon);
  out.area = p.area.area, out.radius = p.radius, out.friction_arm = p.friction_arm, out.arm = p.arm;
  const LaneMask has_area = p.area.area > zero;
  out.presses = has_area & (p.pressure > zero);
  out.centre = plane.origin + plane.along(p.centre), out.middle = plane.origin + plane.along(p.middle);
  const Triple<Lanes> none{};
  out.normal = select<Lanes>(out.presses, plane.normal, none);
  out.force = out.normal_force = out.normal * p.pressure;
  out.memory.damping = plane.normal * p.damping;
  out.memory.damping_moment = p.damping_moment + cross(out.centre - in.a.origin, out.memory.damping);
  const Lanes half_step = zero + 0.5 * in.dt;
  out.lost_damping = half_step * (p.damped - power_remembered(in));
  Triple<Lanes> moment{};
  const Lanes let_go = 0.5 * in.before.shear.elastic.square() * sliding_compliance<Lanes>(in.ks, in.before.shear.area);
  add_friction(in, p, out, moment);
  // Without force there is no friction, and its elastic energy is lost.
  out.force = select<Lanes>(out.presses, out.force, none), moment = select<Lanes>(out.presses, moment, none);
  out.memory.normal = out.normal;
  out.memory.shear.elastic = select<Lanes>(out.presses, out.memory.shear.elastic, none);
  out.memory.shear.total = select<Lanes>(out.presses, out.memory.shear.total, none);
  out.memory.shear.area = select(out.presses, out.memory.shear.area, zero);
  out.memory.slip = select(out.presses, out.memory.slip, in.before.slip);
  out.lost_friction = select(out.presses, out.lost_friction, let_go);
  out.moment_a = none - moment - cross(out.centre - in.a.origin, out.force);
  out.moment_b = moment + cross(out.centre - in.b.origin, out.force);
  out.presses = has_area;
}

// One copy for each register width: the same operations, so the same bits. The widest saves a tenth to a fifth.

void respond_narrow(const FlatContacts& in, FlatResponses& out) {
  respond_four(in, out);
}
#ifdef __x86_64__
[[gnu::target("avx2")]] void respond_wide(const FlatContacts& in, FlatResponses& out) {
  respond_four(in, out);
}
[[gnu::target("arch=x86-64-v4")]] void respond_widest(const FlatContacts& in, FlatResponses& out) {
  respond_four(in, out);
}
#endif

}  // namespace

void respond_flat(const FlatContacts& in, FlatResponses& out) {
#ifdef __x86_64__
  static const Registers here = registers_here();
  if (here == Registers::widest) return respond_widest(in, out);
  if (here == Registers::wide) return respond_wide(in, out);
#endif
  respond_narrow(in, out);
}

}  // namespace trilith
