// Shear between two solids: a Kelvin-Voigt spring in series with a slider, as law/contact/shear.hpp, of which the
// direction is free.
//
//            F t   ____          Slip along the plane of contact and turning about its normal n go through one slider:
//          <------|__c_|         the motion is u = slip + n r turn, the force F = shear + n (couple / r), r the radius
//             (   couple         of gyration of the area, and the spring dF = ks A du that of the area to the last
//                                term. Sliding begins at the limit of contact/joint/friction_limit.hpp and goes along
//                                its normal: the force is the nearest that friction holds.
//
// So sliding never gives energy: F . du >= F' . du for any other force F' within the limit.
//
// Comes in: the motion of the step, the force remembered, turned along with the pair, the area that carried it and the
// one that does now. Goes out: the force now, and what damping and sliding gave off, by the mean of force before and
// after the step.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/simd/lane_vectors.hpp"
#include "base/space.hpp"
#include "contact/joint/friction_limit.hpp"

namespace trilith {

/// What a contact remembers of its shear; parts along the normal are couples over the radius.
struct SlidingForce {
  Vec3 elastic = Vec3::Zero(), total = Vec3::Zero();  ///< [N]
  double area = 0;                                    ///< that carries it [m2]
};

/// The same of one contact or of four.
template <class T>
struct ShearForce {
  Triple<T> elastic, total;
  T area{};
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
template <class T>
TRILITH_INLINE T sliding_compliance(T ks, T area) {
  const T stiffness = ks * area;
  return select(stiffness > T{}, 1.0 / stiffness, T{});
}

/// Elastic energy held [J].
inline double sliding_energy(double ks, const SlidingForce& f) {
  return 0.5 * f.elastic.squaredNorm() * sliding_compliance(ks, f.area);
}

/// A step of the slider of one contact or of four. Area that parts takes its share of the force along and lets its
/// energy go; new area carries none.
///
/// First the spring: what it would carry if nothing slid is `total`. Then `hold(held, slides)` with what friction holds
/// of that and where it does not hold all.
template <class T>
struct SlidingStep {
  Triple<T> path, kept, elastic, total;
  T stiffness, compliance, relaxed;

  TRILITH_INLINE SlidingStep(const Triple<T>& along, const Triple<T>& rate, const T& area, const ShearForce<T>& before,
                             const T& ks, const T& beta)
      : path(along), stiffness(ks * area), compliance(sliding_compliance<T>(ks, area)) {
    const T one = T{} + 1.0, compliance_before = sliding_compliance<T>(ks, before.area);
    kept = before.elastic * smaller(one, stiffness * compliance_before);
    relaxed = 0.5 * (before.elastic.square() * compliance_before - kept.square() * compliance);
    elastic = kept + path * stiffness;
    total = elastic + rate * (beta * stiffness);
  }

  TRILITH_INLINE Triple<T> hold(const Triple<T>& held, const Mask<T>& slides, const T& beta, double dt) {
    const T share = dt > 0 ? dt / (dt + beta) : T{};
    elastic = select<T>(slides, kept + (held - kept) * share, elastic);
    total = select<T>(slides, held, total);
    return select<T>(slides, (elastic - kept) * compliance, path);
  }
};

/// What a step gave off: by the mean of the force before and after it.
template <class T>
struct SlidingLoss {
  T slip, friction, damping;

  TRILITH_INLINE SlidingLoss(const SlidingStep<T>& step, const Triple<T>& stretch, const ShearForce<T>& before) {
    const T half = T{} + 0.5;
    const Triple<T> slid = step.path - stretch, mean_total = (step.total + before.total) * half,
                    mean_elastic = (step.elastic + before.elastic) * half;
    slip = root(slid.square());
    friction = mean_total.dot(slid) + step.relaxed + half * (before.elastic - step.kept).dot(stretch);
    damping = (mean_total - mean_elastic).dot(stretch);
  }
};

/// One contact.
inline SlidingResponse slide(const SlidingMotion& motion, double area, const SlidingForce& before,
                             const SlidingLaw& law) {
  const ShearForce<double> last{triple_of(before.elastic), triple_of(before.total), before.area};
  SlidingStep<double> step(triple_of(motion.path), triple_of(motion.rate), area, last, law.ks, law.beta);
  Triple<double> held = step.total;
  const bool slides = motion.limit.is_below(vector_of(step.total));
  if (slides) held = triple_of(motion.limit.nearest_to(vector_of(step.total)));
  const Triple<double> stretch = step.hold(held, slides, law.beta, law.dt);
  const SlidingLoss<double> lost(step, stretch, last);
  return {{vector_of(step.elastic), vector_of(step.total), area}, lost.slip, lost.friction, lost.damping};
}

/// Takes vectors that belong to a plane of contact along with it: from a plane of normal `from` to one of normal `to`,
/// the shortest way, and about `to` by `turn` [rad], small, as the two bodies turn together in a step. Lengths stay;
/// the turn is right to the fifth order.
template <class T>
struct TurnedPlane {
  Triple<T> axis, normal;
  T cosine, share, less, sine;

  TRILITH_INLINE TurnedPlane(const Triple<T>& from, const Triple<T>& to, const T& turn)
      : axis(cross(from, to)), normal(to), cosine(from.dot(to)) {
    const T one = T{} + 1.0;
    share = one / (one + cosine);
    // Cayley's turn by the tangent of half the angle, of which two terms are taken.
    const T tangent = 0.5 * turn * (one + turn * turn * (1.0 / 12)), scale = 2.0 / (one + tangent * tangent);
    sine = scale * tangent, less = -scale * tangent * tangent;
  }
  TRILITH_INLINE Triple<T> carry(const Triple<T>& v) const {
    // Rodrigues with the sine in the axis: v + a x v + a x (a x v) / (1 + c); turned over there is no shortest way
    // worth the name.
    const Triple<T> once = cross(axis, v), shortest = v + once + cross(axis, once) * share,
                    over = v - normal * (2.0 * v.dot(normal));
    const Triple<T> in_plane = select<T>(cosine <= T{} - 0.5, over, shortest);
    const Triple<T> flat = in_plane - normal * normal.dot(in_plane);
    return in_plane + flat * less + cross(normal, in_plane) * sine;
  }
};

}  // namespace trilith
