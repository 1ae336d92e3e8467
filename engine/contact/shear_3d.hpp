// Shear between two solids: a Kelvin-Voigt spring in series with a slider, as contact/shear.hpp, of which the direction
// is free.
//
//            F t   ____          Slip along the plane of contact and turning about its normal n go through one slider:
//          <------|__c_|         the motion is u = slip + n r turn, the force F = shear + n (couple / r), r the radius
//             (   couple         of gyration of the area, and the spring dF = ks A du that of the area to the last
//                                term. Sliding begins at the limit of contact/friction_limit.hpp and goes along its
//                                normal: the force is the nearest that friction holds.
//
// So sliding never gives energy: F . du >= F' . du for any other force F' within the limit.
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
  Vec3 path;  ///< [m]
  Vec3 rate;  ///< now [m/s]
  FrictionLimit limit;
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
  if (motion.limit.is_below(total)) {
    const Vec3 held = motion.limit.nearest_to(total);
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
