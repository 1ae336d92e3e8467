// An intact joint, without cracks and sliding: one spring for its whole area.
//
// Overlap and shear are linear over the joint, so force and moments follow from the area, and the largest stress is at
// a corner of its outline. Once it may exceed the law's limit, the joint is computed patch by patch
// (contact/joint/joint_step.hpp).
//
//     V += ks A slip,   T += ks J turn          stress at p:  V/A + T/J times the arm
#pragma once

#include <algorithm>
#include <limits>

#include "contact/joint/joint_step.hpp"

namespace trilith {

/// Second polar moment about the centroid [m4].
inline double polar_moment(const JointPatch& p) {
  return p.xx + p.yy;
}

/// Normal stress of the bonds of an intact joint, after the motion `moved` from the setting of the mortar.
inline PatchStress intact_stress(const JointPlan& plan, const LinearOverlap& moved) {
  PatchStress out = over_all(plan.whole, moved);
  out.energy += moved.at * plan.laid.force + moved.slope.dot(plan.laid.moment);
  out.force += plan.laid.force, out.moment += plan.laid.moment, out.energy += plan.laid.energy;
  return out;
}

/// Shear stress of an intact joint at an arm from its centroid [Pa]; `shear`: force and couple about the centroid.
inline Vec2 intact_shear_at(const JointPlan& plan, const Vec3& shear, const Vec2& arm) {
  const double twist = shear.z() / polar_moment(plan.whole);
  return {shear.x() / plan.whole.area - twist * arm.y(), shear.y() / plan.whole.area + twist * arm.x()};
}

/// Elastic energy of its shear [J].
inline double intact_shear_energy(const JointPlan& plan, const Vec3& elastic, double ks) {
  if (!(ks > 0)) return 0;
  return 0.5 * elastic.head<2>().squaredNorm() / (ks * plan.whole.area) +
         0.5 * elastic.z() * elastic.z() / (ks * polar_moment(plan.whole));
}

/// Distributes the joint's shear to its patches.
inline void spread_shear(JointMemory& joint) {
  divide(joint);
  const JointPatch& whole = joint.plan->whole;
  joint.sound = false;
  for (std::size_t k = 0; k < joint.plan->patch.size(); ++k) {
    const JointPatch& p = joint.plan->patch[k];
    PatchMemory& m = joint.patch[k];
    const Lanes x = lanes_of(p.point_x) - whole.middle.x(), y = lanes_of(p.point_y) - whole.middle.y();
    const auto spread = [&](const Vec3& shear, PatchNumbers& along_x, PatchNumbers& along_y) {
      const double twist = shear.z() / polar_moment(whole);
      store_lanes(0.25 * p.area * (shear.x() / whole.area - twist * y), along_x);
      store_lanes(0.25 * p.area * (shear.y() / whole.area + twist * x), along_y);
    };
    m = {};
    spread(joint.elastic, m.elastic_x, m.elastic_y), spread(joint.total, m.total_x, m.total_y);
    m.active = p.area;
  }
}

/// A step of an intact joint; false, without a result, where some point may exceed its limit.
template <class K>
bool step_intact(const JointPlan& plan, const JointMotion& motion, const K& law, const JointMemory& before,
                 JointMemory& after, JointSums& sums) {
  if constexpr (K::bonds) {
    const JointPatch& whole = plan.whole;
    const Vec2& middle = whole.middle;
    const Vec3 rate(motion.slip.x() - motion.spin * middle.y(), motion.slip.y() + motion.spin * middle.x(),
                    motion.spin);
    const Vec3 mean(motion.mean_slip.x() - motion.mean_spin * middle.y(),
                    motion.mean_slip.y() + motion.mean_spin * middle.x(), motion.mean_spin);
    const Vec3 path = law.dt * mean, stiffness = law.ks * Vec3(whole.area, whole.area, polar_moment(whole));
    after.elastic = before.elastic + stiffness.cwiseProduct(path);
    after.total = after.elastic + law.beta * stiffness.cwiseProduct(rate);
    if (motion.turn.squaredNorm() > longest_bond_turn * longest_bond_turn) return false;
    double least = std::numeric_limits<double>::max(), most = 0, highest = 0;
    for (const Vec2& p : plan.outline) {
      const double overlap = motion.moved(p) + plan.least_at(p);
      least = std::min({least, overlap, overlap + law.beta * motion.rate(p)});
      highest = std::max(highest, motion.moved(p) + plan.most_at(p));
      for (const Vec3* shear : {&after.elastic, &after.total})
        most = std::max(most, intact_shear_at(plan, *shear, p - middle).squaredNorm());
    }
    if constexpr (K::crushes)
      if (law.crushing > 0 && highest > law.crushing) return false;
    const double strength = law.shear_strength(std::max(least, 0.0), std::max(-least, 0.0));
    if (!(-law.kn * least < law.tension) || !(strength > 0) || !(most < strength * strength)) return false;
    if (after.plan != before.plan) after.plan = before.plan;
    after.moved = motion.moved, after.bonds = before.bonds, after.sound = true;
    sums.pressed = intact_stress(plan, motion.moved);
    if (law.beta > 0) sums.damping = over_all(whole, LinearOverlap().plus(motion.rate, law.beta));
    sums.shear = after.total.head<2>(), sums.shear_elastic = after.elastic.head<2>();
    sums.couple = after.total.z() + cross(middle, sums.shear);
    sums.couple_elastic = after.elastic.z() + cross(middle, sums.shear_elastic);
    sums.lost.damping = 0.5 * Vec3(after.total - after.elastic + before.total - before.elastic).dot(path);
    return true;
  }
  return false;
}

}  // namespace trilith
