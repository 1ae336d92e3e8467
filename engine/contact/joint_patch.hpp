// One patch of a joint: normal stress, exact where it is linear, and shear by one slider.
//
// Pressure. u is the overlap that the bond feels, c that of the faces (they differ where mortar fills a gap), both
// linear. A sound bond carries kn u all over the patch, a lost one kn c where c is above 0, over the true polygon. One
// that has softened carries u less what it has lost at each of the four places of the patch:
//
//     sigma = u - sum over places of (1 - hold) A/4 (u - max(c, 0))        and its moments and its energy alike
//
// Shear. Slip along both axes and turning about the patch's middle, the latter times the radius of gyration g, go
// through one slider, so that its stiffness ks A holds for all three: ks A g^2 is ks J. A force (V, T / g) is at its
// limit L on
//
//     x^2 + y^2 + k x^2 y^2 = 1,     x = V / L,  y = T / (L r),  k = 1.7 (r / g)^2 - 1,
//
// r the mean distance from the middle: turning alone has its limit L r, and a patch far from the axis that it turns
// about carries L times its mean distance from it, so that a square in 4 by 4 has its limit to .3 %. The direction of
// the force is kept as it slides.
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/joint_plan.hpp"
#include "contact/list.hpp"

namespace trilith {

/// Of a kernel: its bonds lose their strength by and by, or at once.
template <class K>
inline constexpr bool is_softening = [] {
  if constexpr (K::bonds)
    return K::softens;
  else
    return false;
}();
template <class K>
inline constexpr bool is_brittle = K::bonds && !is_softening<K>;

using PatchHolds = std::array<double, patch_points>;

/// What the normal stresses of a patch add up to, over the stiffness; moments about the joint's origin.
struct PatchStress {
  double force = 0;            ///< [m3]
  Vec2 moment = Vec2::Zero();  ///< [m4]
  double energy = 0;           ///< [m4]
  double area = 0;             ///< that carries shear [m2]

  void add(const PatchStress& o, double times) {
    force += times * o.force, moment += times * o.moment, energy += times * o.energy, area += times * o.area;
  }
};

inline PatchStress over_all(const JointPatch& p, const LinearOverlap& f) {
  const double mean = f(p.middle);
  const Vec2 own(p.xx * f.slope.x() + p.xy * f.slope.y(), p.xy * f.slope.x() + p.yy * f.slope.y());
  const double force = p.area * mean;
  return {force, force * p.middle + own, 0.5 * (force * mean + f.slope.dot(own)), p.area};
}

inline PatchStress where_closed(const JointPlan& plan, const JointPatch& p, const LinearOverlap& f) {
  double least = f(plan.corner[static_cast<std::size_t>(p.first)]), most = least;
  for (const Vec2& x : plan.corners(p)) least = std::min(least, f(x)), most = std::max(most, f(x));
  if (least > 0) return over_all(p, f);
  if (!(most > 0)) return {};
  const FaceIntegrals sum = integrals_in_contact(plan.corners(p), f.at, f.slope);
  return {sum.first, sum.first_moment, sum.energy, sum.area};
}

/// The overlaps of a patch that has gained `moved` since the mortar set.
struct PatchOverlaps {
  LinearOverlap bond, faces;
  PatchOverlaps(const JointPlan& plan, const JointPatch& p, const LinearOverlap& moved)
      : bond(moved.plus(p.laid)), faces(moved.plus(plan.standing)) {}
};

inline PatchStress elastic_stress(const JointPlan& plan, const JointPatch& p, const PatchOverlaps& o, bool bonded,
                                  const PatchHolds& hold) {
  if (!bonded) return where_closed(plan, p, o.faces);
  PatchStress out = over_all(p, o.bond);
  for (std::size_t q = 0; q < patch_points; ++q) {
    const double lack = 1 - hold[q];
    if (lack == 0) continue;
    const double u = o.bond(p.point[q]), c = std::max(o.faces(p.point[q]), 0.0), share = 0.25 * p.area * lack;
    out.force -= share * (u - c), out.moment -= share * (u - c) * p.point[q];
    out.energy -= 0.5 * share * (u * u - c * c);
  }
  return out;
}

/// Of overlaps that grow at `rate`, times beta [m]: where faces alone press they never pull by it.
inline PatchStress damping_stress(const JointPlan& plan, const JointPatch& p, const PatchOverlaps& o, bool bonded,
                                  const PatchHolds& hold, const LinearOverlap& rate) {
  if (bonded) {
    PatchStress out = over_all(p, rate);
    for (std::size_t q = 0; q < patch_points; ++q) {
      const double lack = 1 - hold[q];
      if (lack == 0) continue;
      const double r = rate(p.point[q]), c = o.faces(p.point[q]), pressed = c > 0 ? std::max(c + r, 0.0) - c : 0.0;
      const double force = 0.25 * p.area * lack * (r - pressed);
      out.force -= force, out.moment -= force * p.point[q];
    }
    return out;
  }
  const LinearOverlap damped = o.faces.plus(rate);
  std::array<Vec2, 2 * max_face_corners> closed;
  std::size_t count = 0;
  const std::span<const Vec2> corners = plan.corners(p);
  for (std::size_t i = 0; i < corners.size() && count + 2 < closed.size(); ++i) {
    const Vec2 &from = corners[i], &to = corners[i + 1 < corners.size() ? i + 1 : 0];
    const double a = o.faces(from), b = o.faces(to);
    if (a >= 0) closed[count++] = from;
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) closed[count++] = from + a / (a - b) * (to - from);
  }
  if (count < 3) return {};
  const FaceIntegrals total = integrals_in_contact({closed.data(), count}, damped.at, damped.slope);
  PatchStress out{total.first, total.first_moment, 0, 0};
  out.add(where_closed(plan, p, o.faces), -1);
  return out;
}

/// How near a shear force is to the limit of a patch: times as much as one at a limit of 1 N.
inline double shear_measure(const JointPatch& p, const Vec3& f) {
  const double flat = 1 / (p.turning * p.turning), rounder = 1.7 / flat - 1;
  const double x = f.x() * f.x() + f.y() * f.y(), y = f.z() * f.z() * flat, sum = x + y;
  return std::sqrt(0.5 * (sum + std::sqrt(sum * sum + 4 * rounder * x * y)));
}

/// A step of a patch's shear before its slider is asked. As ShearTrial in the plane.
struct PatchTrial {
  Vec3 kept, elastic, total;  ///< force kept, with the step's slip all elastic, and with its damping [N]
  Vec3 path;                  ///< [m]
  double stiffness, compliance, relaxed, measure;
  Vec3 along;  ///< direction of the total, of which the slider is asked

  PatchTrial(const Coulomb& law, const JointPatch& p, const PatchMemory& before, double area, const Vec3& rate) {
    stiffness = law.ks * area, compliance = stiffness > 0 ? 1 / stiffness : 0;
    const double compliance_before = law.ks * before.active > 0 ? 1 / (law.ks * before.active) : 0;
    kept = before.elastic * std::min(1.0, stiffness * compliance_before);
    relaxed = 0.5 * (before.elastic.squaredNorm() * compliance_before - kept.squaredNorm() * compliance);
    path = law.dt * rate;
    elastic = kept + stiffness * path;
    total = elastic + law.beta * stiffness * rate;
    measure = shear_measure(p, total);
    along = measure > 0 ? Vec3(total / measure) : Vec3(Vec3::Zero());
  }
  /// Along the direction of the total, where that has the size `measure`.
  [[nodiscard]] double part(const Vec3& v) const { return v.dot(along) / along.squaredNorm(); }
};

/// Energies that a patch gives off in a step [J].
struct PatchLosses {
  double damping = 0, friction = 0, fracture = 0;
};

/// Ends a step of shear: `slip` [m] and the force `held` [N] along the trial's direction where it slides.
inline void end_patch_shear(const PatchTrial& trial, const PatchMemory& before, double area, bool slides, double slip,
                            double held, PatchMemory& after, PatchLosses& lost) {
  const Vec3 slid = slides ? Vec3(slip * trial.along) : Vec3(Vec3::Zero());
  after.elastic = trial.elastic - trial.stiffness * slid;
  after.total = slides ? Vec3(held * trial.along) : trial.total;
  after.active = area, after.slip = before.slip + slid.norm();
  const Vec3 mean_total = 0.5 * (after.total + before.total), mean_elastic = 0.5 * (after.elastic + before.elastic);
  if (!(trial.stiffness > 0)) {
    lost.friction += trial.relaxed;
    return;
  }
  const Vec3 stretch = trial.path - slid;
  lost.friction += mean_total.dot(slid) + trial.relaxed + 0.5 * (before.elastic - trial.kept).dot(stretch);
  lost.damping += (mean_total - mean_elastic).dot(stretch);
}

/// Friction, and nothing beside it, as Coulomb::slide.
inline void slide_patch(const Coulomb& law, const PatchTrial& trial, const PatchMemory& before, double area,
                        double limit, PatchMemory& after, PatchLosses& lost) {
  const bool slides = trial.measure > limit;
  double slip = 0;
  if (slides) {
    const double kept = trial.part(trial.kept), share = law.dt > 0 ? law.dt / (law.dt + law.beta) : 0.0;
    slip = trial.part(trial.path) - (limit - kept) * share * trial.compliance;
  }
  end_patch_shear(trial, before, area, slides, slip, limit, after, lost);
}

/// A bond that softens, as Cohesive::Kernel::slide: the places that still hold lose alike. `normal`: pressure [N].
template <class K>
void soften_patch(K law, const PatchTrial& trial, const PatchMemory& before, double area, double normal,
                  PatchMemory& after, PatchLosses& lost) {
  int alive = 0;
  double strength = 0;
  for (const double d : after.damage) alive += d < 1 ? 1 : 0, strength += 1 - d;
  HalfState<double> h{};
  const double share = alive / static_cast<double>(patch_points);
  h.length = share * area, h.bonded = alive > 0, h.strength = alive > 0 ? strength / alive : 0.0;
  if (alive > 0) law.ks /= share;  // the slider reckons with the stiffness of the length that holds
  const SofteningSlider<double> slider(h, law, normal, trial.compliance, trial.part(trial.kept),
                                       trial.part(trial.path));
  const bool slides = trial.measure > slider.limit;
  const double slip =
      slides ? trial.part(trial.path) - (slider.elastic - trial.part(trial.kept)) * trial.compliance : 0.0;
  end_patch_shear(trial, before, area, slides, slip, slider.held, after, lost);
  if (!slides) return;
  for (double& d : after.damage) d = std::min(1.0, d + (h.strength - slider.strength));
  const double cohesive = slider.cohesive * trial.along.squaredNorm();
  lost.friction -= cohesive, lost.fracture += cohesive;
}

}  // namespace trilith
