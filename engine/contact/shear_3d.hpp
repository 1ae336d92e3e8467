// Shear between two solids: a Kelvin-Voigt spring in series with a slider, as contact/shear.hpp, of which the direction
// is free.
//
//            F t   ____          Slip along the plane of contact and turning about its normal n go through one slider:
//          <------|__c_|         the motion is u = slip + n r turn, the force F = shear + n (couple / r), r the mean
//             (   couple         distance of the area from its middle. Sliding begins at the limit of
//                                contact/friction_limit.hpp and goes along its normal.
//
// Comes in: the motion of the step, the force remembered, turned along with the pair, the area that carried it and the
// one that does now. Goes out: the force now, and what damping and sliding gave off, by the mean of force before and
// after the step.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/space.hpp"
#include "contact/friction_limit.hpp"

namespace trilith {

/// What a contact remembers of its shear; parts along the normal are couples over the radius.
struct SlidingForce {
  Vec3 elastic = Vec3::Zero(), total = Vec3::Zero();  ///< [N]
  double area = 0;                                    ///< that carries it [m2]
};

/// The motion of b against a in a step.
struct SlidingMotion {
  Vec3 path;     ///< [m]
  Vec3 rate;     ///< now [m/s]
  Vec3 normal;   ///< of the plane of contact, of length 1
  double limit;  ///< mu N [N]
};

/// How the slider is made.
struct SlidingLaw {
  double ks, beta, dt;  ///< [Pa/m], [s], [s]
};

struct SlidingResponse {
  SlidingForce force;
  double slip = 0, lost_friction = 0, lost_damping = 0;  ///< [m], [J], [J]
};

/// Compliance of an area that carries shear [m/N]; 0 where there is none.
inline double sliding_compliance(double ks, double area) {
  return ks * area > 0 ? 1 / (ks * area) : 0;
}

/// Elastic energy held [J].
inline double sliding_energy(double ks, const SlidingForce& f) {
  return 0.5 * f.elastic.squaredNorm() * sliding_compliance(ks, f.area);
}

/// True where friction cannot hold a force.
inline bool beyond_limit(const Vec3& total, const SlidingMotion& motion) {
  if (total.squaredNorm() <= 0.88 * motion.limit * motion.limit) return false;  // within the curve whatever its way
  const double turning = std::abs(motion.normal.dot(total));
  const double along = (total - motion.normal.dot(total) * motion.normal).norm();
  return !(motion.limit > 0) || limit_measure(along / motion.limit, turning / motion.limit) > 1;
}

/// The nearest force that friction holds.
inline Vec3 held_by_friction(const Vec3& total, const SlidingMotion& motion) {
  if (!(motion.limit > 0)) return Vec3::Zero();
  const double turning = motion.normal.dot(total);
  const Vec3 in_plane = total - turning * motion.normal;
  const double along = in_plane.norm();
  const auto [a, b] = nearest_on_limit(along / motion.limit, std::abs(turning) / motion.limit);
  const Vec3 slides = along > 0 ? Vec3(in_plane * (a * motion.limit / along)) : Vec3(Vec3::Zero());
  return slides + motion.normal * (turning < 0 ? -b : b) * motion.limit;
}

/// Area that parts takes its share of the force along and lets its energy go; new area carries none.
inline SlidingResponse slide(const SlidingMotion& motion, double area, const SlidingForce& before,
                             const SlidingLaw& law) {
  SlidingResponse out;
  const double stiffness = law.ks * area, compliance = sliding_compliance(law.ks, area),
               compliance_before = sliding_compliance(law.ks, before.area);
  const Vec3 kept = before.elastic * std::min(1.0, stiffness * compliance_before);
  const double relaxed = 0.5 * (before.elastic.squaredNorm() * compliance_before - kept.squaredNorm() * compliance);
  Vec3 elastic = kept + stiffness * motion.path, total = elastic + law.beta * stiffness * motion.rate;
  Vec3 stretch = motion.path;
  if (beyond_limit(total, motion)) {
    const Vec3 held = held_by_friction(total, motion);
    elastic = kept + (held - kept) * (law.dt > 0 ? law.dt / (law.dt + law.beta) : 0.0);
    total = held;
    stretch = (elastic - kept) * compliance;
  }
  const Vec3 slip = motion.path - stretch, mean_total = 0.5 * (total + before.total),
             mean_elastic = 0.5 * (elastic + before.elastic);
  out.force = {elastic, total, area};
  out.slip = slip.norm();
  out.lost_friction = mean_total.dot(slip) + relaxed + 0.5 * (before.elastic - kept).dot(stretch);
  out.lost_damping = (mean_total - mean_elastic).dot(stretch);
  return out;
}

}  // namespace trilith
