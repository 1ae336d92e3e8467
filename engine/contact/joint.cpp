#include "contact/joint.hpp"

#include <algorithm>
#include <limits>

#include "contact/joint_motion.hpp"
#include "contact/joint_patch.hpp"
#include "contact/solid_faces.hpp"

namespace trilith {
namespace {

/// Turned further than this no bond lasts [rad].
constexpr double longest_turn = 0.02;
/// Slid by more than this share of their width, faces without bonds share another area than that of their joint.
constexpr double longest_slide = 0.01;

/// Shares of its stiffness that a patch holds at its places.
template <class K>
Lanes holds_of(const K& law, const PatchMemory& m) {
  const Lanes one = Lanes{} + 1.0;
  if constexpr (is_softening<K>) {
    const Lanes damage = lanes_of(m.damage);
    if (any(damage > Lanes{})) return select(damage > Lanes{}, law.held(one - damage), one);
  }
  return one;
}

/// How far sliding has opened a patch [m].
template <class K>
double opened_by(const K& law, double slip) {
  if constexpr (is_softening<K>) return law.dilation > 0 ? law.dilated(slip, 0.0) : 0.0;
  return 0;
}

std::uint32_t all_bonds(const JointPlan& plan) {
  return (1U << plan.patch.size()) - 1U;
}

/// The law of kernel K over one step of a joint.
template <class K>
class JointStep {
 public:
  JointStep(const JointPlan& plan, const JointMotion& motion, const K& law, const JointMemory& before,
            JointMemory& after)
      : plan_(plan), motion_(motion), law_(law), before_(before), after_(after) {}

  void run() {
    if (after_.plan != before_.plan) after_.plan = before_.plan;
    after_.moved = motion_.moved;
    after_.bonds = motion_.turn.squaredNorm() > longest_turn * longest_turn ? 0U : before_.bonds;
    const double widest = widest_opening();
    if constexpr (is_brittle<K>) after_.bonds &= ~lost_bonds(widest);
    for (std::size_t k = 0; k < plan_.patch.size(); ++k) step_patch(k, widest);
  }

  PatchStress pressed, damping;  ///< of all patches, over the stiffness
  Vec2 shear = Vec2::Zero(), shear_elastic = Vec2::Zero();
  double couple = 0, couple_elastic = 0;  ///< about the origin [N m]
  double slip = 0;                        ///< mean of all patches in this step [m]
  bool softened = false;                  ///< some place lost strength
  PatchLosses lost;

 private:
  [[nodiscard]] PatchOverlaps overlaps(std::size_t k, const LinearOverlap& moved) const {
    return {plan_, plan_.patch[k], moved.raised(opened_by(law_, before_.patch[k].slip))};
  }

  /// Of any bond at a corner of its patch, or more [m].
  [[nodiscard]] double widest_opening() const {
    double least = std::numeric_limits<double>::max();
    for (const Vec2& p : plan_.outline)
      least =
          std::min(least, plan_.filled ? motion_.moved(p) + plan_.least_laid : motion_.moved(p) + plan_.standing(p));
    return -least;
  }

  /// Brittle bonds that are beyond their limit: of tension at a corner of a patch, of shear at one of its places.
  [[nodiscard]] std::uint32_t lost_bonds(double widest) const {
    std::uint32_t gone = 0;
    for (std::size_t k = 0; k < plan_.patch.size(); ++k) {
      if (!before_.bonded(static_cast<int>(k))) continue;
      const JointPatch& p = plan_.patch[k];
      const PatchOverlaps o = overlaps(k, motion_.moved);
      double opening = -std::numeric_limits<double>::max();
      if (law_.kn * widest > law_.tension)
        for (const Vec2& x : plan_.corners(p)) opening = std::max(opening, -o.bond(x));
      const Lanes zero{}, u = at_points(p, o.bond), closed = larger(u, zero), open = closed - u;
      const PatchTrial trial(law_, p, before_.patch[k], p.area, motion_);
      const Lanes shear_now = root(trial.elastic.dot(trial.elastic)), size = zero + 0.25 * p.area;
      if (any(law_.exceeded(zero + opening, shear_now, law_.shear_strength(closed, open), size))) gone |= 1U << k;
    }
    return gone != 0 && !law_.by_point ? ~0U : gone;
  }

  /// Damage by opening. A patch whose places have all failed has lost its bond.
  void open_patch(std::size_t k, const PatchOverlaps& o) {
    if constexpr (is_softening<K>) {
      PatchMemory& m = after_.patch[k];
      const Lanes damage = lanes_of(m.damage), opening = -at_points(plan_.patch[k], o.bond), one = Lanes{} + 1.0;
      const Lanes left = law_.strength_left(opening, one - damage);
      store_lanes(select(left < one - damage, one - left, damage), m.damage);
      keep_bond(k);
    }
  }
  void keep_bond(std::size_t k) {
    PatchNumbers& damage = after_.patch[k].damage;
    if (after_.bonded(static_cast<int>(k)) && *std::min_element(damage.begin(), damage.end()) < 1) return;
    after_.bonds &= ~(1U << k), damage.fill(1);
  }

  void step_patch(std::size_t k, double widest) {
    const JointPatch& p = plan_.patch[k];
    const PatchMemory& was = before_.patch[k];
    PatchMemory& is = after_.patch[k];
    const PatchOverlaps o = overlaps(k, motion_.moved);
    is.damage = was.damage;
    const bool was_bonded = before_.bonded(static_cast<int>(k));
    if (is_softening<K> && was_bonded && (widest > first_opening() || after_.bonds == 0)) open_patch(k, o);
    const bool bonded = after_.bonded(static_cast<int>(k));
    const Lanes hold = holds_of(law_, is);
    const PatchStress stress = elastic_stress(plan_, p, o, bonded, hold);
    pressed.add(stress, 1);
    double force = stress.force;
    LinearOverlap damped;
    if (law_.beta > 0 && stress.area > 0) {
      damped = damped.plus(motion_.rate, law_.beta);
      const PatchStress more = damping_stress(plan_, p, o, bonded, hold, damped);
      damping.add(more, 1), force += more.force;
    }
    slide(k, stress, law_.kn * normal_at_points(p, o, bonded, hold, damped, force));
    if (was_bonded && (!after_.bonded(static_cast<int>(k)) || is.damage != was.damage))
      lost.fracture += given_off(k, stress);
    softened = softened || is.damage != was.damage;
    sum_shear(p, is, is.slip - was.slip);
  }

  [[nodiscard]] double first_opening() const {
    if constexpr (K::bonds) return law_.first_opening();
    return 0;
  }

  /// `normal`: at its places [N].
  void slide(std::size_t k, const PatchStress& stress, const Lanes& normal) {
    const PatchMemory& was = before_.patch[k];
    PatchMemory& is = after_.patch[k];
    const PatchTrial trial(law_, plan_.patch[k], was, stress.area, motion_);
    if constexpr (is_softening<K>) {
      soften_patch(law_, trial, was, stress.area, normal, is, lost);
      keep_bond(k);
      // The work sliding does against the pressure as it opens the joint comes out of what friction would take.
      const double opened = opened_by(law_, is.slip) - opened_by(law_, was.slip);
      if (opened > 0) lost.friction -= law_.kn * (stress.force + 0.5 * opened * stress.area) * opened;
    } else {
      const bool bonded = after_.bonded(static_cast<int>(k));
      const Lanes limit = bonded ? Lanes{} + std::numeric_limits<double>::max() : law_.mu * larger(normal, Lanes{});
      slide_patch(law_, trial, was, stress.area, limit, is, lost);
    }
  }

  /// What a bond that holds less than before gave off: its energy before and after the step, and the work between, with
  /// the mean of the stresses of both instants, which is what a leapfrog step does [J]. `now`: the stress of now.
  [[nodiscard]] double given_off(std::size_t k, const PatchStress& now) const {
    const JointPatch& p = plan_.patch[k];
    const PatchOverlaps then = overlaps(k, before_.moved);
    const PatchStress first =
        elastic_stress(plan_, p, then, before_.bonded(static_cast<int>(k)), holds_of(law_, before_.patch[k]));
    const PatchStress last = elastic_stress(plan_, p, overlaps(k, motion_.moved), after_.bonded(static_cast<int>(k)),
                                            holds_of(law_, after_.patch[k]));
    const LinearOverlap gained = motion_.moved.plus(before_.moved, -1);
    const double work = 0.5 * ((first.force + now.force) * gained.at + (first.moment + now.moment).dot(gained.slope));
    return law_.kn * (first.energy - last.energy + work);
  }

  void sum_shear(const JointPatch& p, const PatchMemory& m, double slid) {
    const Lanes x = lanes_of(p.point_x), y = lanes_of(p.point_y);
    const auto add = [&](const PatchNumbers& along_x, const PatchNumbers& along_y, Vec2& force, double& about) {
      const Lanes fx = lanes_of(along_x), fy = lanes_of(along_y);
      force += Vec2(sum_of(fx), sum_of(fy)), about += sum_of(x * fy - y * fx);
    };
    add(m.total_x, m.total_y, shear, couple);
    add(m.elastic_x, m.elastic_y, shear_elastic, couple_elastic);
    slip += slid * p.area / plan_.area;
  }

  const JointPlan& plan_;
  const JointMotion& motion_;
  const K& law_;
  const JointMemory& before_;
  JointMemory& after_;
};

/// Of a stress along the normal with that moment about the origin of the joint: the moment on b.
Vec3 moment_on_b(const JointMotion& motion, const Vec2& moment) {
  return cross(motion.in_world(moment), motion.normal);
}

/// Forces, and what the contact remembers: also what other solids would, should the joint end.
template <class K>
void add_up(const JointStep<K>& step, const JointPlan& plan, const JointMotion& motion, const K& law,
            const BodyMotion& a, SolidResponse& out) {
  const Vec3 &n = motion.normal, shear = motion.in_world(step.shear), elastic = motion.in_world(step.shear_elastic);
  const Vec3 damping = law.kn * step.damping.force * n, turning = moment_on_b(motion, law.kn * step.damping.moment);
  out.centre = motion.origin;
  out.normal_force = law.kn * step.pressed.force * n + damping;
  out.force = out.normal_force - shear;
  out.moment = moment_on_b(motion, law.kn * step.pressed.moment) + turning - step.couple * n;
  out.area = step.pressed.area;
  out.memory.shear = {elastic + step.couple_elastic / plan.radius * n, shear + step.couple / plan.radius * n,
                      step.pressed.area};
  out.memory.normal = n;
  out.memory.damping = damping;
  out.memory.damping_moment = turning + cross(Vec3(motion.origin - a.place), damping);
  out.memory.state = contact_touching | contact_general;
}

/// Half of the power that both dampings take, of now and of before, times the step [J].
double damping_loss(const BodyMotion& a, const BodyMotion& b, const SolidMemory& before, const SolidMemory& now,
                    double dt) {
  const Vec3 rate = b.velocity_at(a.place) - a.velocity, spin = b.spin - a.spin;
  const Vec3 force = before.damping + now.damping, moment = before.damping_moment + now.damping_moment;
  return -0.5 * dt * (force.dot(rate) + moment.dot(spin));
}

double deepest(const JointPlan& plan, const JointMotion& motion) {
  double most = 0;
  for (const Vec2& p : plan.outline) most = std::max(most, motion.moved(p) + plan.standing(p));
  return most;
}

bool has_left(const JointPlan& plan, const JointMotion& motion, double depth) {
  const double slid = motion.aside.norm() + std::abs(motion.turn.z()) * plan.width;
  return slid > longest_slide * plan.width || motion.turn.head<2>().norm() > flat_faces_max_tilt ||
         depth > flat_faces_max_depth * plan.width;
}

template <class K>
double energy_of(const JointMemory& joint, const K& law) {
  double sum = 0;
  for (std::size_t k = 0; k < joint.plan->patch.size(); ++k) {
    const JointPatch& p = joint.plan->patch[k];
    const PatchMemory& m = joint.patch[k];
    const PatchOverlaps o(*joint.plan, p, joint.moved.raised(opened_by(law, m.slip)));
    sum += law.kn * elastic_stress(*joint.plan, p, o, joint.bonded(static_cast<int>(k)), holds_of(law, m)).energy;
    const Lanes x = lanes_of(m.elastic_x), y = lanes_of(m.elastic_y);
    if (law.ks * m.active > 0) sum += 2 * sum_of(x * x + y * y) / (law.ks * m.active);
  }
  return sum;
}

bool is_damaged(const JointMemory& m) {
  for (std::size_t k = 0; k < m.plan->patch.size(); ++k)
    for (const double d : m.patch[k].damage)
      if (d > 0) return true;
  return false;
}

}  // namespace

JointResponse respond_joint(const BodyMotion& a, const BodyMotion& b, const SolidMemory& before,
                            const JointMemory& joint, const LawInUse& use, JointMemory& after) {
  const JointPlan& plan = *joint.plan;
  const JointMotion motion(plan, a, b);
  return with_kernel(use, [&]<class K>(const K& law) {
    JointStep<K> step(plan, motion, law, joint, after);
    step.run();
    JointResponse out;
    SolidResponse& contact = out.contact;
    add_up(step, plan, motion, law, a, contact);
    contact.memory.slip = before.slip + step.slip;
    contact.depth = deepest(plan, motion);
    contact.lost_friction = step.lost.friction, contact.lost_fracture = step.lost.fracture;
    contact.lost_damping = step.lost.damping + damping_loss(a, b, before, contact.memory, law.dt);
    contact.touching = after.bonds != 0 || contact.area > 0;
    out.ends = after.bonds == 0 && (!contact.touching || has_left(plan, motion, contact.depth));
    if (!contact.touching) contact.memory = {};
    out.changed = joint.bonds != after.bonds || (step.softened && joint_change(joint, after).cracked);
    return out;
  });
}

double joint_energy(const JointMemory& joint, const LawInUse& use) {
  return with_kernel(use, [&](const auto& law) { return energy_of(joint, law); });
}

JointChange joint_change(const JointMemory& before, const JointMemory& now) {
  JointChange change;
  change.broken = before.bonds != now.bonds;
  change.cracked =
      !change.broken && before.bonds != 0 && !before.empty() && !now.empty() && !is_damaged(before) && is_damaged(now);
  return change;
}

/// A force V in the middle and a couple T are spread as V/A and T/J times the arm, as an elastic area carries them.
JointMemory set_joint(const FaceOverlap3& faces, const BodyMotion& a, const BodyMotion& b, const SolidMemory& before) {
  const auto plan = std::make_shared<JointPlan>(plan_joint(faces, a, b));
  JointMemory joint;
  joint.plan = plan;
  joint.bonds = all_bonds(*plan);
  const JointMotion motion(*plan, a, b);
  double second = 0;
  for (const JointPatch& p : plan->patch) second += p.area * p.middle.squaredNorm() + p.xx + p.yy;
  const auto spread = [&](const Vec3& force, PatchNumbers PatchMemory::*along_x, PatchNumbers PatchMemory::*along_y) {
    const Vec2 mean = Vec2(motion.x.dot(force), motion.y.dot(force)) / plan->area;
    const double twist = motion.normal.dot(force) * plan->radius / second;
    for (std::size_t k = 0; k < plan->patch.size(); ++k) {
      const JointPatch& p = plan->patch[k];
      store_lanes(0.25 * p.area * (mean.x() - twist * lanes_of(p.point_y)), joint.patch[k].*along_x);
      store_lanes(0.25 * p.area * (mean.y() + twist * lanes_of(p.point_x)), joint.patch[k].*along_y);
      joint.patch[k].active = p.area;
    }
  };
  spread(before.shear.elastic, &PatchMemory::elastic_x, &PatchMemory::elastic_y);
  spread(before.shear.total, &PatchMemory::total_x, &PatchMemory::total_y);
  return joint;
}

}  // namespace trilith
