// A step of a joint that has cracked or slid somewhere: patch by patch, with the law of its kernel.
//
// Input: the motion of the joint and the memory of its patches. Output: their new memory, and the sums over them.
#pragma once

#include <algorithm>
#include <limits>

#include "contact/joint/joint_patch.hpp"

namespace trilith {

/// No bond remains beyond this rotation [rad].
inline constexpr double longest_bond_turn = 0.02;
/// Stiffness shares of a patch at its points.
template <class K>
TRILITH_INLINE Lanes holds_of(const K& law, const PatchMemory& m) {
  const Lanes one = Lanes{} + 1.0;
  if constexpr (is_softening<K>) {
    const Lanes damage = lanes_of(m.damage);
    if (any(damage > Lanes{})) return select(damage > Lanes{}, law.held(one - damage), one);
  }
  return one;
}

/// Opening of a patch due to sliding [m].
template <class K>
double opened_by(const K& law, double slip) {
  if constexpr (is_softening<K>) return law.dilation > 0 ? law.dilated(slip, 0.0) : 0.0;
  return 0;
}

/// Crushed depth of a patch at which the mean pressure over its pressed part does not exceed the mortar's strength, see
/// law/contact/cohesive.hpp [m]. `f`: its overlap after crushing by `before` [m].
template <class K>
double crushed_patch(const K& law, const JointPlan& plan, const JointPatch& p, const LinearOverlap& f, double before) {
  if constexpr (K::crushes) {
    return law.crush(before, [&](double depth) {
      const PatchStress pressed = where_closed(plan, p, f.raised(before - depth));
      const double limit = law.crush_limit(depth);
      return pressed.area > 0 ? pressed.force / pressed.area - limit : -limit;
    });
  }
  return before;
}

/// Sums of a joint step.
struct JointSums {
  PatchStress pressed, damping;  ///< of all patches, over the stiffness
  Vec2 shear = Vec2::Zero(), shear_elastic = Vec2::Zero();
  double couple = 0, couple_elastic = 0;  ///< about the origin [N m]
  double slip = 0;                        ///< mean of all patches in this step [m]
  bool softened = false;                  ///< some point lost strength, or mortar was crushed
  PatchLosses lost;
};
/// The law of kernel K over one step of a joint.
template <class K>
class JointStep {
 public:
  JointStep(const JointPlan& plan, const JointMotion& motion, const K& law, const JointMemory& before,
            JointMemory& after)
      : plan_(plan), motion_(motion), law_(law), before_(before), after_(after) {}

  TRILITH_INLINE void run() {
    if (after_.plan != before_.plan) after_.plan = before_.plan;
    after_.moved = motion_.moved, after_.sound = false;
    after_.patch.resize(plan_.patch.size());
    after_.bonds = motion_.turn.squaredNorm() > longest_bond_turn * longest_bond_turn ? 0U : before_.bonds;
    const double widest = widest_opening();
    if constexpr (is_brittle<K>) after_.bonds &= ~lost_bonds(widest);
    for (std::size_t k = 0; k < plan_.patch.size(); ++k) step_patch(k, widest);
  }

  JointSums sums;

 private:
  [[nodiscard]] TRILITH_INLINE PatchOverlaps overlaps(std::size_t k, const LinearOverlap& moved, double crushed) const {
    return {plan_, plan_.patch[k], moved.raised(opened_by(law_, before_.patch[k].slip) - crushed)};
  }
  /// Before the step; opening by the last slip did not act yet.
  [[nodiscard]] TRILITH_INLINE PatchOverlaps overlaps_before(std::size_t k) const {
    return overlaps(k, before_.moved, before_.patch[k].crushed + before_.patch[k].opened);
  }
  [[nodiscard]] TRILITH_INLINE PatchStress stress_before(std::size_t k) const {
    return elastic_stress(plan_, plan_.patch[k], overlaps_before(k), before_.bonded(static_cast<int>(k)),
                          holds_of(law_, before_.patch[k]));
  }

  /// Upper bound of the opening of any bond at a corner of its patch [m].
  [[nodiscard]] TRILITH_INLINE double widest_opening() const {
    double least = std::numeric_limits<double>::max();
    for (const Vec2& p : plan_.outline) least = std::min(least, motion_.moved(p) + plan_.least_at(p));
    return -least;
  }

  /// Brittle bonds beyond their limit: of tension at a corner of a patch, of shear at one of its points.
  [[nodiscard]] TRILITH_INLINE std::uint32_t lost_bonds(double widest) const {
    std::uint32_t gone = 0;
    for (std::size_t k = 0; k < plan_.patch.size(); ++k) {
      if (!before_.bonded(static_cast<int>(k))) continue;
      const JointPatch& p = plan_.patch[k];
      const PatchOverlaps o = overlaps(k, motion_.moved, before_.patch[k].crushed);
      double opening = -std::numeric_limits<double>::max();
      if (law_.kn * widest > law_.tension)
        for (const Vec2& x : plan_.corners(p)) opening = std::max(opening, -o.asked(p, x));
      const Lanes zero{}, u = o.asked_at_points(p), closed = larger(u, zero), open = closed - u;
      const PatchTrial trial(law_, p, before_.patch[k], p.area, motion_);
      const Lanes shear_now = root(trial.elastic.dot(trial.elastic)), size = zero + 0.25 * p.area;
      if (any(law_.exceeded(zero + opening, shear_now, law_.shear_strength(closed, open), size))) gone |= 1U << k;
    }
    return gone != 0 && !law_.by_point ? ~0U : gone;
  }

  /// Damage by opening. A patch whose points have all failed has lost its bond. A point represents a quarter of its
  /// patch. The centre of this quarter lies sqrt(3)/2 as far out as the point, and the opening varies over it by
  /// sqrt(3/4 variance of the four). This is exact for a rectangle that bends about one of its axes.
  TRILITH_INLINE void open_patch(std::size_t k, const PatchOverlaps& o) {
    if constexpr (is_softening<K>) {
      PatchMemory& m = after_.patch[k];
      const Lanes damage = lanes_of(m.damage), opening = -o.asked_at_points(plan_.patch[k]), one = Lanes{} + 1.0;
      const double mean = 0.25 * sum_of(opening);
      const Lanes aside = 0.5 * std::sqrt(3.0) * (opening - mean);
      const double spread = 0.5 * std::sqrt(sum_of(aside * aside));
      const Lanes left = law_.strength_left_over(mean + aside - spread, mean + aside + spread, one - damage);
      store_lanes(select(left < one - damage, one - left, damage), m.damage);
      keep_bond(k);
    }
  }
  TRILITH_INLINE void keep_bond(std::size_t k) {
    PatchNumbers& damage = after_.patch[k].damage;
    if (after_.bonded(static_cast<int>(k)) && *std::min_element(damage.begin(), damage.end()) < 1) return;
    after_.bonds &= ~(1U << k), damage.fill(1);
  }

  TRILITH_INLINE void step_patch(std::size_t k, double widest) {
    const JointPatch& p = plan_.patch[k];
    const PatchMemory& was = before_.patch[k];
    PatchMemory& is = after_.patch[k];
    const bool was_bonded = before_.bonded(static_cast<int>(k));
    const double deeper = crush(k, was_bonded);
    const PatchOverlaps o = overlaps(k, motion_.moved, is.crushed);
    is.damage = was.damage;
    if (is_softening<K> && was_bonded && (widest > first_opening() || after_.bonds == 0)) open_patch(k, o);
    const bool bonded = after_.bonded(static_cast<int>(k));
    const Lanes hold = holds_of(law_, is);
    const PatchStress stress = elastic_stress(plan_, p, o, bonded, hold);
    sums.pressed.add(stress, 1);
    double force = stress.force;
    LinearOverlap damped;
    if (law_.beta > 0 && stress.area > 0) {
      damped = damped.plus(motion_.rate, law_.beta);
      if (deeper > 0 && law_.dt > 0) damped.at -= law_.beta * deeper / law_.dt;
      const PatchStress more = damping_stress(plan_, p, o, bonded, hold, damped);
      sums.damping.add(more, 1), force += more.force;
    }
    slide(k, stress, law_.kn * normal_at_points(p, o, bonded, hold, damped, force));
    const bool weaker = was_bonded && (!after_.bonded(static_cast<int>(k)) || is.damage != was.damage);
    if (weaker || deeper > 0) sums.lost.fracture += dissipated(k, stress, deeper > 0);
    sums.softened = sums.softened || is.damage != was.damage || deeper > 0;
    sum_shear(p, is, is.slip - was.slip);
  }

  /// Crushes a patch as its overlap requires; returns the increase of its depth [m].
  TRILITH_INLINE double crush(std::size_t k, bool bonded) {
    if constexpr (K::crushes) {
      const double before = before_.patch[k].crushed;
      if (law_.crushing > 0) {
        const PatchOverlaps o = overlaps(k, motion_.moved, before);
        after_.patch[k].crushed = crushed_patch(law_, plan_, plan_.patch[k], bonded ? o.bond : o.faces, before);
      }
      return after_.patch[k].crushed - before;
    }
    return 0;
  }

  [[nodiscard]] double first_opening() const {
    if constexpr (K::bonds) return law_.first_opening();
    return 0;
  }

  /// `normal`: at its points [N].
  TRILITH_INLINE void slide(std::size_t k, const PatchStress& stress, const Lanes& normal) {
    const PatchMemory& was = before_.patch[k];
    PatchMemory& is = after_.patch[k];
    const PatchTrial trial(law_, plan_.patch[k], was, stress.area, motion_);
    if constexpr (is_softening<K>) {
      soften_patch(law_, trial, was, stress.area, normal, is, sums.lost);
      keep_bond(k);
      // Sliding that opens the joint does work against the pressure, see Cohesive::Kernel::lifting.
      is.opened = opened_by(law_, is.slip) - opened_by(law_, was.slip);
      if (was.opened > 0) sums.lost.friction -= 0.5 * law_.kn * was.opened * (stress_before(k).force + stress.force);
    } else {
      const bool bonded = after_.bonded(static_cast<int>(k));
      const Lanes limit = bonded ? Lanes{} + std::numeric_limits<double>::max() : law_.mu * larger(normal, Lanes{});
      slide_patch(law_, trial, was, stress.area, limit, is, sums.lost);
    }
  }

  /// Energy dissipated by a weakened bond or crushed mortar [J]: its energy before minus after the step, plus the work
  /// of the mean stresses of both instants, which is the work of a leapfrog step. Pressure of the faces alone is
  /// excluded, because the integration error as they separate is not a fracture. `now`: the present stress; `crushes`:
  /// crushing dissipates part of that pressure.
  [[nodiscard]] double dissipated(std::size_t k, PatchStress now, bool crushes) const {
    const JointPatch& p = plan_.patch[k];
    const PatchOverlaps then = overlaps_before(k), here = overlaps(k, motion_.moved, after_.patch[k].crushed);
    PatchStress first = stress_before(k);
    PatchStress last =
        elastic_stress(plan_, p, here, after_.bonded(static_cast<int>(k)), holds_of(law_, after_.patch[k]));
    if (!crushes) {
      const PatchStress pressed = where_closed(plan_, p, here.faces);
      first.add(where_closed(plan_, p, then.faces), -1), last.add(pressed, -1), now.add(pressed, -1);
    }
    const LinearOverlap gained = motion_.moved.plus(before_.moved, -1);
    const double work = 0.5 * ((first.force + now.force) * gained.at + (first.moment + now.moment).dot(gained.slope));
    // The work of the opening by the last slip is part of the friction, see slide().
    const double lifted = 0.5 * before_.patch[k].opened * (first.force + now.force);
    return law_.kn * (first.energy - last.energy + work + lifted);
  }

  TRILITH_INLINE void sum_shear(const JointPatch& p, const PatchMemory& m, double slid) {
    const Lanes x = lanes_of(p.point_x), y = lanes_of(p.point_y);
    const auto add = [&](const PatchNumbers& along_x, const PatchNumbers& along_y, Vec2& force, double& about) {
      const Lanes fx = lanes_of(along_x), fy = lanes_of(along_y);
      force += Vec2(sum_of(fx), sum_of(fy)), about += sum_of(x * fy - y * fx);
    };
    add(m.total_x, m.total_y, sums.shear, sums.couple);
    add(m.elastic_x, m.elastic_y, sums.shear_elastic, sums.couple_elastic);
    sums.slip += slid * p.area / plan_.whole.area;
  }

  const JointPlan& plan_;
  const JointMotion& motion_;
  const K& law_;
  const JointMemory& before_;
  JointMemory& after_;
};

}  // namespace trilith
