// Readings of softening mortar, see law/contact/cohesive.hpp: gaps, stored energy, and changes within a step.
#pragma once

#include "law/contact/cohesive.hpp"

namespace trilith {

inline std::array<HalfGaps, 2> Cohesive::Kernel::gaps(const FaceOverlap<double>& o, const ContactMemory& m,
                                                      const Memory<double>& own) const {
  const double opened = dilated(m.slip, own.worn), lo = o.gap_lo - opened, hi = o.gap_hi - opened,
               mid = 0.5 * (lo + hi);
  const JointFilling<double> mortar(own.set[0], own.set[1]);
  const double z0 = own.crushed[0], z1 = own.crushed[1];
  return {{{lo + z0, mid + z0, mortar.half[0]}, {mid + z1, hi + z1, mortar.half[1]}}};
}

inline double Cohesive::Kernel::stored_in_both(const FaceOverlap<double>& o, const ContactMemory& m,
                                               const Memory<double>& own) const {
  if (!o.sane) return 0;
  const std::array<HalfGaps, 2> g = stressed_gaps(*this, o, m, own);
  return stored_in_half(*this, g[0], 0.5 * o.shared, m, own, 0) +
         stored_in_half(*this, g[1], 0.5 * o.shared, m, own, 1);
}

/// Energy of two faces that their contact loses when it becomes a general one: by dilation, and by unequal crushing of
/// the halves.
inline ShapeLoss Cohesive::Kernel::leave_faces(const FaceOverlap<double>& o, const ContactMemory& m,
                                               const Memory<double>& own) const {
  Memory<double> worn = own;
  worn.worn = 1;
  Memory<double> even = worn;
  for (double& half : even.crushed) half = crushed(own);
  ShapeLoss lost;
  if (dilation > 0) lost.friction = stored_in_both(o, m, own) - stored_in_both(o, m, worn);
  if (crushing > 0) lost.fracture = stored_in_both(o, m, worn) - stored_in_both(o, m, even);
  return lost;
}

inline JointChange Cohesive::Kernel::change(const ContactMemory& before, const Memory<double>& own,
                                            const ContactMemory& now, const Memory<double>& after) {
  const auto damaged = [](const Memory<double>& m) { return most_damage(m) > 0; };
  JointChange change;
  change.broken = before.bonds != now.bonds;
  change.cracked = !change.broken && before.bonds != 0 && !damaged(own) && damaged(after);
  change.crushed = !(crushed(own) > 0) && crushed(after) > 0;
  return change;
}

}  // namespace trilith
