#include "contact/space/flat_contact.hpp"

#include "base/simd/registers.hpp"
#include "contact/space/friction_lanes.hpp"
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
  out.normal = select<Lanes>(out.presses, plane.normal, Triple<Lanes>{});
  const NormalInLanes normal{out.normal * p.pressure,  p.pressure,       Triple<Lanes>{},
                             plane.normal * p.damping, p.damping_moment, p.damped};
  respond_normal(in, normal, out);
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
