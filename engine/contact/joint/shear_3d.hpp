// Shear between two solids: a Kelvin-Voigt spring in series with a slider, as in law/contact/shear.hpp, in any
// direction.
//
//            F t   ____
//          <------|__c_|
//             (   couple
//
// Slip along the plane of contact and rotation about its normal n act on one slider. Its motion is u = slip + n r turn
// and its force F = shear + n (couple / r), where r is the radius of gyration of the area. The spring dF = ks A du is
// exactly the area's. Sliding begins at the limit of contact/joint/friction_limit.hpp and follows its normal: the force
// is the nearest admissible one. So sliding never creates energy: F . du >= F' . du for any other admissible force F'.
//
// Input: the motion of the step, the force in memory, rotated with the pair, and the areas that carry it before and
// now. Output: the present force, and the energies dissipated by damping and sliding, by the mean of the force before
// and after the step.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/simd/lane_vectors.hpp"
#include "base/space.hpp"
#include "contact/joint/friction_limit.hpp"

namespace trilith {

/// Shear memory of a contact; components along the normal are couples over the radius.
struct SlidingForce {
  Vec3 elastic = Vec3::Zero(), total = Vec3::Zero();  ///< [N]
  double area = 0;                                    ///< that carries it [m2]
};

/// For one contact or four.
template <class T>
struct ShearForce {
  Triple<T> elastic, total;
  T area{};
};

/// The motion of b relative to a in a step.
struct SlidingMotion {
  Vec3 path;  ///< [m]
  Vec3 rate;  ///< present rate [m/s]
  FrictionLimit limit;
};

/// Parameters of the slider.
struct SlidingLaw {
  double ks, beta, dt;  ///< [Pa/m], [s], [s]
};

struct SlidingResponse {
  SlidingForce force;
  double slip = 0, lost_friction = 0, lost_damping = 0;  ///< [m], [J], [J]
};

/// Compliance of an area that carries shear [m/N]; 0 if there is none.
template <class T>
TRILITH_INLINE T sliding_compliance(T ks, T area) {
  const T stiffness = ks * area;
  return select(stiffness > T{}, 1.0 / stiffness, T{});
}

/// Stored elastic energy [J].
inline double sliding_energy(double ks, const SlidingForce& f) {
  return 0.5 * f.elastic.squaredNorm() * sliding_compliance(ks, f.area);
}

/// A step of the slider for one contact or four. Area that separates takes its share of the force with it and releases
/// its energy; new area starts without force.
///
/// First the spring: `total` is its force without sliding. Then `hold(held, slides)` with the admissible force and a
/// mask of the sliding lanes.
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

/// Energy dissipated in a step, by the mean of the force before and after it.
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

/// Rotates vectors with a plane of contact. The first rotation is the shortest from the normal `from` to the normal
/// `to`. The second is about `to` by `turn` [rad], the small common rotation of the two bodies in a step. Lengths are
/// conserved; the rotation is accurate to fifth order.
template <class T>
struct TurnedPlane {
  Triple<T> axis, normal;
  T cosine, share, less, sine;

  TRILITH_INLINE TurnedPlane(const Triple<T>& from, const Triple<T>& to, const T& turn)
      : axis(cross(from, to)), normal(to), cosine(from.dot(to)) {
    const T one = T{} + 1.0;
    share = one / (one + cosine);
    // Cayley's rotation by the tangent of half the angle, with two terms.
    const T tangent = 0.5 * turn * (one + turn * turn * (1.0 / 12)), scale = 2.0 / (one + tangent * tangent);
    sine = scale * tangent, less = -scale * tangent * tangent;
  }
  TRILITH_INLINE Triple<T> carry(const Triple<T>& v) const {
    // Rodrigues' formula with the sine in the axis: v + a x v + a x (a x v) / (1 + c). Near a half turn the shortest
    // rotation is undefined, and vectors are reflected.
    const Triple<T> once = cross(axis, v), shortest = v + once + cross(axis, once) * share,
                    over = v - normal * (2.0 * v.dot(normal));
    const Triple<T> in_plane = select<T>(cosine <= T{} - 0.5, over, shortest);
    const Triple<T> flat = in_plane - normal * normal.dot(in_plane);
    return in_plane + flat * less + cross(normal, in_plane) * sine;
  }
};

}  // namespace trilith
