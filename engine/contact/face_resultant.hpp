// The resultant of a contact of two faces, found back from where they stand and what the contact remembers.
#pragma once

#include <algorithm>
#include <array>

#include "base/space.hpp"
#include "contact/face_pair.hpp"
#include "contact/memory.hpp"

namespace trilith {

/// Force of a contact as one vector at one point.
struct ContactResultant {
  Vec2 point = Vec2::Zero();  ///< centre of pressure, at mid-gap [m]
  Vec2 force = Vec2::Zero();  ///< on the second body [N]
  double normal = 0;          ///< pressing part of the force, negative in tension [N]
  double shear = 0;           ///< part along the faces, with its sign [N]
};

/// Share of its stiffness that the bond of a half holds where open: 1 where undamaged, 0 where lost.
inline double bond_hold(const ContactMemory& memory, int half, const FaceLaw& law) {
  if ((memory.bonds >> half & 1U) == 0) return 0;
  return law.last_opening > 0 ? share_held(1 - memory.damage(half), law) : 1;
}

/// Opening of a joint by the sliding it has behind it [m].
inline double dilation_of(const ContactMemory& memory, const FaceLaw& law) {
  return dilation_of(memory.slip, (memory.state & contact_worn) != 0, law);
}

/// Gaps of one half that its stresses come from, at its ends, with the mortar that fills it [m].
struct HalfGaps {
  double g0, g1;
  Filling<double> filling;
};

/// Both halves of the shared length.
inline std::array<HalfGaps, 2> half_gaps(const FaceOverlap<double>& o, const ContactMemory& m, const FaceLaw& law) {
  const double opened = dilation_of(m, law), lo = o.gap_lo - opened, hi = o.gap_hi - opened, mid = 0.5 * (lo + hi);
  const JointFilling<double> mortar(m.set[0], m.set[1]);
  const double z0 = m.crushed[0], z1 = m.crushed[1];
  return {{{lo + z0, mid + z0, mortar.half[0]}, {mid + z1, hi + z1, mortar.half[1]}}};
}

/// Elastic normal force of one half and its moment about the half's start. `hold`: see bond_hold.
struct HalfPressure {
  double force = 0, moment = 0;
  HalfPressure(const HalfGaps& gaps, double length, double hold, double kn) {
    const double c0 = -gaps.g0, c1 = -gaps.g1;
    const PositivePart<double> closed(c0, c1);
    const double slope = c1 - c0;
    LinearStress<double> stress(c0 + slope * closed.from, c0 + slope * closed.to, closed.from, closed.to);
    LinearStress<double> bond(c0, c1, 0, 1);
    add(bond, gaps.filling.stress(), hold > 0);
    mix(stress, bond, hold);
    force = kn * length * stress.sum;
    moment = kn * length * length * stress.moment;
  }
};

/// `memory`: as respond_face_pair left it for these ends. The same force as that spread to the ends, and the same
/// moment but for the shear times the change of the mid-gap line's height along the contact, which is of the order of
/// the gaps; where a bond in tension would put the point beyond the shared length, it is held at its end.
inline ContactResultant face_resultant(const FaceEnds<double>& a, const FaceEnds<double>& b,
                                       const ContactMemory& memory, const FaceLaw& law) {
  const FaceOverlap<double> o(a, b);
  const double half = 0.5 * o.shared, gap_mid = 0.5 * (o.gap_lo + o.gap_hi), middle = o.lo + half;
  const std::array<HalfGaps, 2> gaps = half_gaps(o, memory, law);
  const HalfPressure first(gaps[0], half, bond_hold(memory, 0, law), law.kn);
  const HalfPressure second(gaps[1], half, bond_hold(memory, 1, law), law.kn);
  ContactResultant out;
  out.normal = first.force + second.force + memory.damping_force[0];
  out.shear = memory.shear_total[0] + memory.shear_total[1];
  // About the middle of the shared length; the damping part is remembered about it.
  const double moment = first.moment - half * first.force + second.moment + memory.damping_force[1];
  const double offset = out.normal != 0 ? std::clamp(moment / out.normal, -half, half) : 0.0;
  const Vec2 d(o.dx, o.dy), n(o.dy, -o.dx), origin(a.x0, a.y0);
  const double s = middle + offset;
  const double height_a = (n.x() * (a.x1 - a.x0) + n.y() * (a.y1 - a.y0)) * o.inv_a * s;
  const double gap = gap_mid + (o.gap_hi - o.gap_lo) * (o.shared > 0 ? offset / o.shared : 0);
  out.point = origin + s * d + (height_a + 0.5 * gap) * n;
  out.force = out.normal * n - out.shear * d;
  return out;
}

/// The same for a contact of general shape: `normal` is its normal resultant on the second body at `centre`.
inline ContactResultant general_resultant(const Vec2& centre, const Vec2& normal, const ContactMemory& memory) {
  const double size = normal.norm(), shear = memory.shear_total[0] + memory.shear_total[1];
  const Vec2 t = size > 0 ? left_of(Vec2(normal / size)) : Vec2::Zero();
  return {centre, normal - shear * t, size, size > 0 ? shear : 0};
}

}  // namespace trilith
