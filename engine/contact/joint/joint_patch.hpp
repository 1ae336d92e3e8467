// One patch of a joint: normal stress, exact where it is linear, and shear with a slider at each of its four points.
//
// Pressure. Let u be the overlap as it acts on the bond, and c the faces' overlap (they differ where mortar fills a
// gap). Both are linear. An intact bond carries kn u over the whole patch; a lost one carries kn c where c is positive,
// over the true polygon. A softened one carries u minus the loss at each of the patch's four points; moments and energy
// are treated alike:
//
//     sigma = u - sum over points of (1 - hold) A/4 (u - max(c, 0)).
//
// Shear. Each point has a quarter of the area and a Kelvin-Voigt spring in series with a slider, like half a line in
// the plane (law/contact/shear.hpp). The slider slides along its force, in any direction. Because the points have the
// second moments of the patch, together they turn about any axis with the stiffness ks J. If a patch has lost its bond,
// its pressure is distributed to the points in proportion to their overlaps.
//
// The points of a patch are the lanes of one SIMD register.
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/joint/joint_motion.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// Whether a kernel's bonds soften gradually or fail at once.
template <class K>
inline constexpr bool is_softening = [] {
  if constexpr (K::bonds)
    return K::softens;
  else
    return false;
}();
template <class K>
inline constexpr bool is_brittle = K::bonds && !is_softening<K>;

static_assert(patch_points == lane_count);

TRILITH_INLINE Lanes lanes_of(const PatchNumbers& v) {
  Lanes lanes;
  __builtin_memcpy(&lanes, v.data(), sizeof lanes);
  return lanes;
}
TRILITH_INLINE void store_lanes(const Lanes& v, PatchNumbers& to) {
  __builtin_memcpy(to.data(), &v, sizeof v);
}
TRILITH_INLINE double sum_of(const Lanes& v) {
  return (v[0] + v[1]) + (v[2] + v[3]);
}
TRILITH_INLINE Lanes at_points(const JointPatch& p, const LinearOverlap& f) {
  return f.at + f.slope.x() * lanes_of(p.point_x) + f.slope.y() * lanes_of(p.point_y);
}

TRILITH_INLINE PatchStress where_closed(const JointPlan& plan, const JointPatch& p, const LinearOverlap& f) {
  double least = f(plan.corner[static_cast<std::size_t>(p.first)]), most = least;
  for (const Vec2& x : plan.corners(p)) least = std::min(least, f(x)), most = std::max(most, f(x));
  if (least > 0) return over_all(p, f);
  if (!(most > 0)) return {};
  const FaceIntegrals sum = integrals_in_contact(plan.corners(p), f.at, f.slope);
  return {sum.first, sum.first_moment, sum.energy, sum.area};
}

/// Overlaps of a patch that has gained `moved` from the setting of the mortar.
struct PatchOverlaps {
  LinearOverlap gained, bond, faces;
  PatchOverlaps(const JointPlan& plan, const JointPatch& p, const LinearOverlap& moved)
      : gained(moved), bond(moved.plus(p.laid)), faces(moved.plus(plan.standing)) {}

  /// Overlap used for the strength of the bond at a point of the patch, and at its four points [m].
  [[nodiscard]] double asked(const JointPatch& p, const Vec2& x) const {
    return p.filled ? gained(x) + std::max(p.laid(x), 0.0) : bond(x);
  }
  [[nodiscard]] TRILITH_INLINE Lanes asked_at_points(const JointPatch& p) const {
    return p.filled ? at_points(p, gained) + larger(at_points(p, p.laid), Lanes{}) : at_points(p, bond);
  }
};

/// `hold`: stiffness shares of its points.
TRILITH_INLINE PatchStress elastic_stress(const JointPlan& plan, const JointPatch& p, const PatchOverlaps& o,
                                          bool bonded, const Lanes& hold) {
  if (!bonded) return where_closed(plan, p, o.faces);
  PatchStress out = over_all(p, o.bond);
  const Lanes lack = 1.0 - hold;
  if (!any(lack != Lanes{})) return out;
  const Lanes u = at_points(p, o.bond), c = larger(at_points(p, o.faces), Lanes{});
  const Lanes share = 0.25 * p.area * lack, lost = share * (u - c);
  out.force -= sum_of(lost);
  out.moment -= Vec2(sum_of(lost * lanes_of(p.point_x)), sum_of(lost * lanes_of(p.point_y)));
  out.energy -= 0.5 * sum_of(share * (u * u - c * c));
  return out;
}

/// Integrals of another overlap `f`, where positive, over the part of a patch whose faces overlap.
inline PatchStress where_both_closed(const JointPlan& plan, const JointPatch& p, const LinearOverlap& faces,
                                     const LinearOverlap& f) {
  std::array<Vec2, 2 * max_face_corners> closed;
  std::size_t count = 0;
  const std::span<const Vec2> corners = plan.corners(p);
  for (std::size_t i = 0; i < corners.size() && count + 2 < closed.size(); ++i) {
    const Vec2 &from = corners[i], &to = corners[i + 1 < corners.size() ? i + 1 : 0];
    const double a = faces(from), b = faces(to);
    if (a >= 0) closed[count++] = from;
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) closed[count++] = from + a / (a - b) * (to - from);
  }
  if (count < 3) return {};
  const FaceIntegrals sum = integrals_in_contact({closed.data(), count}, f.at, f.slope);
  return {sum.first, sum.first_moment, 0, 0};
}

/// For overlaps that grow at `rate`, times beta [m]: unbonded faces have no tension due to it.
TRILITH_INLINE PatchStress damping_stress(const JointPlan& plan, const JointPatch& p, const PatchOverlaps& o,
                                          bool bonded, const Lanes& hold, const LinearOverlap& rate) {
  if (!bonded) {
    PatchStress out = where_both_closed(plan, p, o.faces, o.faces.plus(rate));
    out.add(where_closed(plan, p, o.faces), -1);
    return out;
  }
  PatchStress out = over_all(p, rate);
  const Lanes lack = 1.0 - hold, zero{};
  if (!any(lack != zero)) return out;
  const Lanes r = at_points(p, rate), c = at_points(p, o.faces);
  const Lanes pressed = select(c > zero, larger(c + r, zero) - c, zero), lost = 0.25 * p.area * lack * (r - pressed);
  out.force -= sum_of(lost);
  out.moment -= Vec2(sum_of(lost * lanes_of(p.point_x)), sum_of(lost * lanes_of(p.point_y)));
  return out;
}

/// Normal forces at the points of a patch over kn; if its bond is lost, `all` is their sum [m3]. `damping`: rate of the
/// overlap times beta [m].
TRILITH_INLINE Lanes normal_at_points(const JointPatch& p, const PatchOverlaps& o, bool bonded, const Lanes& hold,
                                      const LinearOverlap& damping, double all) {
  const Lanes c = larger(at_points(p, o.faces), Lanes{});
  if (bonded) return 0.25 * p.area * (c + hold * (at_points(p, o.bond) - c) + at_points(p, damping));
  const double sum = sum_of(c);
  return sum > 0 ? larger(all, 0.0) / sum * c : Lanes{} + 0.25 * larger(all, 0.0);
}

/// A vector at each point of a patch.
struct PointVectors {
  Lanes x, y;

  TRILITH_INLINE friend PointVectors operator+(const PointVectors& a, const PointVectors& b) {
    return {a.x + b.x, a.y + b.y};
  }
  TRILITH_INLINE friend PointVectors operator-(const PointVectors& a, const PointVectors& b) {
    return {a.x - b.x, a.y - b.y};
  }
  TRILITH_INLINE friend PointVectors operator*(const Lanes& s, const PointVectors& v) { return {s * v.x, s * v.y}; }
  TRILITH_INLINE friend PointVectors operator*(double s, const PointVectors& v) { return {s * v.x, s * v.y}; }
  [[nodiscard]] TRILITH_INLINE Lanes dot(const PointVectors& o) const { return x * o.x + y * o.y; }
};

/// Trial state of a patch's shear, before its sliders. Corresponds to ShearTrial in the plane.
struct PatchTrial {
  PointVectors kept, elastic, total;  ///< force kept, force with all slip elastic, force with damping [N]
  PointVectors path, along;           ///< [m]; unit vector along the total
  Lanes size;                         ///< of the total [N]
  double stiffness, compliance, relaxed;

  template <class K>
  TRILITH_INLINE PatchTrial(const K& law, const JointPatch& p, const PatchMemory& before, double area,
                            const JointMotion& motion) {
    const double stiffness_before = 0.25 * law.ks * before.active;
    const double compliance_before = stiffness_before > 0 ? 1 / stiffness_before : 0;
    stiffness = 0.25 * law.ks * area, compliance = stiffness > 0 ? 1 / stiffness : 0;
    const PointVectors held{lanes_of(before.elastic_x), lanes_of(before.elastic_y)};
    kept = std::min(1.0, stiffness * compliance_before) * held;
    relaxed = 0.5 * (sum_of(held.dot(held)) * compliance_before - sum_of(kept.dot(kept)) * compliance);
    const PointVectors rate{motion.slip.x() - motion.spin * lanes_of(p.point_y),
                            motion.slip.y() + motion.spin * lanes_of(p.point_x)};
    const PointVectors mean{motion.mean_slip.x() - motion.mean_spin * lanes_of(p.point_y),
                            motion.mean_slip.y() + motion.mean_spin * lanes_of(p.point_x)};
    path = law.dt * mean;
    elastic = kept + stiffness * path;
    total = elastic + law.beta * stiffness * rate;
    size = root(total.dot(total));
    along = (1.0 / select(size > Lanes{}, size, Lanes{} + 1.0)) * total;
  }
};

/// Energies dissipated by a patch in a step [J].
struct PatchLosses {
  double damping = 0, friction = 0, fracture = 0;
};

/// Ends a shear step. Sliding points move by `slip` [m] with the force `held` [N] along the trial force.
TRILITH_INLINE void end_patch_shear(const PatchTrial& trial, const PatchMemory& before, double area,
                                    const LaneMask& slides, const Lanes& slip, const Lanes& held, PatchMemory& after,
                                    PatchLosses& lost) {
  const PointVectors slid = select(slides, slip, Lanes{}) * trial.along;
  const PointVectors elastic = trial.elastic - trial.stiffness * slid, sliding = held * trial.along;
  const PointVectors total{select(slides, sliding.x, trial.total.x), select(slides, sliding.y, trial.total.y)};
  store_lanes(elastic.x, after.elastic_x), store_lanes(elastic.y, after.elastic_y);
  store_lanes(total.x, after.total_x), store_lanes(total.y, after.total_y);
  after.active = area, after.slip = before.slip;
  lost.friction += trial.relaxed;
  const PointVectors elastic_before{lanes_of(before.elastic_x), lanes_of(before.elastic_y)};
  const PointVectors total_before{lanes_of(before.total_x), lanes_of(before.total_y)};
  if (!(trial.stiffness > 0)) {  // work of the previous force over half of the displacement, not dissipated
    lost.friction += 0.5 * sum_of(elastic_before.dot(trial.path));
    lost.damping += 0.5 * sum_of((total_before - elastic_before).dot(trial.path));
    return;
  }
  after.slip += 0.25 * sum_of(select(slides, magnitude(slip), Lanes{}));
  const PointVectors mean_total = 0.5 * (total + total_before);
  const PointVectors mean_elastic = 0.5 * (elastic + elastic_before), stretch = trial.path - slid;
  lost.friction += sum_of(mean_total.dot(slid) + 0.5 * (elastic_before - trial.kept).dot(stretch));
  lost.damping += sum_of((mean_total - mean_elastic).dot(stretch));
}

/// Coulomb friction up to `limit` [N] without a bond, as Coulomb::slide.
template <class K>
TRILITH_INLINE void slide_patch(const K& law, const PatchTrial& trial, const PatchMemory& before, double area,
                                const Lanes& limit, PatchMemory& after, PatchLosses& lost) {
  const double share = law.dt > 0 ? law.dt / (law.dt + law.beta) : 0.0;
  const Lanes kept = trial.kept.dot(trial.along),
              slip = trial.path.dot(trial.along) - trial.compliance * share * (limit - kept);
  end_patch_shear(trial, before, area, trial.size > limit, slip, limit, after, lost);
}

/// A softening bond, present or lost, as Cohesive::Kernel::slide. `normal`: normal forces [N].
template <class K>
TRILITH_INLINE void soften_patch(const K& law, const PatchTrial& trial, const PatchMemory& before, double area,
                                 const Lanes& normal, PatchMemory& after, PatchLosses& lost) {
  const Lanes zero{};
  HalfState<Lanes> h{};
  h.length = zero + 0.25 * area, h.strength = 1.0 - lanes_of(after.damage), h.bonded = h.strength > zero;
  const Lanes kept = trial.kept.dot(trial.along), move = trial.path.dot(trial.along);
  const SofteningSlider<Lanes> slider(h, law, normal, zero + trial.compliance, kept, move);
  const LaneMask slides = trial.size > slider.limit;
  const Lanes slip = move - (slider.elastic - kept) * trial.compliance;
  end_patch_shear(trial, before, area, slides, slip, slider.held, after, lost);
  if (!any(slides)) return;
  store_lanes(select(slides, 1.0 - slider.strength, lanes_of(after.damage)), after.damage);
  const double cohesive = sum_of(select(slides, slider.cohesive, zero));
  lost.friction -= cohesive, lost.fracture += cohesive;
}

}  // namespace trilith
