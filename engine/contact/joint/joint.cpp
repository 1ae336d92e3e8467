#include "contact/joint/joint.hpp"

#include <algorithm>

#include "base/simd/registers.hpp"
#include "contact/joint/chord.hpp"
#include "contact/joint/intact_joint.hpp"
#include "contact/joint/setting_shear.hpp"
#include "contact/space/solid_faces.hpp"

namespace trilith {
namespace {

/// Unbonded faces that have slid by more than this share of their width share a different area than their joint.
constexpr double longest_slide = 0.01;

std::uint32_t all_bonds(const JointPlan& plan) {
  return (1U << plan.patches) - 1U;
}

// One copy for wide registers and one for any machine: the same operations, so the same bits.

template <class K>
void step_narrow(JointStep<K>& step) {
  step.run();
}
#ifdef __x86_64__
template <class K>
[[gnu::target("avx2")]] void step_wide(JointStep<K>& step) {
  step.run();
}
#endif

template <class K>
void step_as_here(JointStep<K>& step) {
#ifdef __x86_64__
  static const bool wide = registers_here() != Registers::narrow;
  if (wide) return step_wide(step);
#endif
  step_narrow(step);
}

/// A step patch by patch, for a joint that may have been intact before.
template <class K>
JointSums step_by_patches(const JointMotion& motion, const K& law, const JointMemory& joint, JointMemory& after) {
  const auto run = [&](const JointMemory& before) {
    JointStep<K> step(*before.plan, motion, law, before, after);
    step_as_here(step);
    return step.sums;
  };
  if (!joint.sound) return run(joint);
  JointMemory patches = joint;
  spread_shear(patches);
  return run(patches);
}

/// Moment on b of a normal stress with the given moment about the joint's origin.
Vec3 moment_on_b(const JointMotion& motion, const Vec2& moment) {
  return cross(motion.in_world(moment), motion.normal);
}

/// Forces, and the contact's memory, including the values that ordinary solids need if the joint ends.
void add_up(const JointSums& step, const JointPlan& plan, const JointMotion& motion, double kn, const BodyMotion& a,
            SolidResponse& out) {
  const Vec3 &n = motion.normal, shear = motion.in_world(step.shear), elastic = motion.in_world(step.shear_elastic);
  const Vec3 damping = kn * step.damping.force * n, turning = moment_on_b(motion, kn * step.damping.moment);
  out.centre = motion.origin;
  out.normal_force = kn * step.pressed.force * n + damping;
  out.force = out.normal_force - shear;
  out.moment = moment_on_b(motion, kn * step.pressed.moment) + turning - step.couple * n;
  out.area = step.pressed.area;
  out.memory.shear = {elastic + step.couple_elastic / plan.radius * n, shear + step.couple / plan.radius * n,
                      step.pressed.area};
  out.memory.normal = n;
  out.memory.damping = damping;
  out.memory.damping_moment = turning + cross(Vec3(motion.origin - a.place), damping);
  out.memory.state = contact_touching | contact_general;
}

/// Motion of the seats; after an implicit step with the mean rates of the displacement.
JointMotion motion_over_step(const JointPlan& plan, const BodyMotion& a, const BodyMotion& b, double dt) {
  JointMotion motion(plan, a, b);
  if (a.behind == nullptr || b.behind == nullptr) {
    const Vec3 chord =
        chord_part(b.spin, Vec3(motion.origin - b.place), dt) - chord_part(a.spin, Vec3(motion.origin - a.place), dt);
    motion.rate.at -= motion.normal.dot(chord);
    motion.slip += Vec2(motion.x.dot(chord), motion.y.dot(chord));
    motion.mean_slip = motion.slip;
    return motion;
  }
  const auto begin = [](const BodyMotion& body) {
    return BodyMotion{body.behind->place_before, body.behind->rotation_before, Vec3::Zero(), Vec3::Zero()};
  };
  motion.over_step(JointMotion(plan, begin(a), begin(b)), dt);
  return motion;
}

/// Half of the power of the previous and present damping forces, times the step [J].
double joint_damping_loss(const BodyMotion& a, const BodyMotion& b, const SolidMemory& before, const SolidMemory& now,
                          double dt) {
  const Vec3 rate = mean_velocity_at(b, a.place, dt) - mean_velocity_at(a, a.place, dt),
             spin = mean_spin(b, dt) - mean_spin(a, dt);
  const Vec3 force = before.damping + now.damping, moment = before.damping_moment + now.damping_moment;
  return -0.5 * dt * (force.dot(rate) + moment.dot(spin));
}

double deepest_overlap(const JointPlan& plan, const JointMotion& motion) {
  double most = 0;
  for (const Vec2& p : plan.outline) most = std::max(most, motion.moved(p) + plan.standing(p));
  return most;
}

/// Whether the faces have moved so far that the patches no longer represent the shared area: slid, tilted or pressed
/// together beyond the limits of flat faces. Called only for joints without a bond.
bool has_left(const JointPlan& plan, const JointMotion& motion, double depth) {
  const double slid = motion.aside.norm() + std::abs(motion.turn.z()) * plan.width;
  return slid > longest_slide * plan.width || motion.turn.head<2>().norm() > flat_faces_max_tilt ||
         depth > flat_faces_max_depth * plan.width;
}

/// Pressure on patch k, over the stiffness. Opening by the slip of the last step does not act yet.
template <class K>
PatchStress stress_of(const JointMemory& joint, std::size_t k, const K& law) {
  const JointPatch& p = joint.plan->patch[k];
  const PatchMemory& m = joint.patch[k];
  const PatchOverlaps o(*joint.plan, p, joint.moved.raised(opened_by(law, m.slip) - m.opened - m.crushed));
  return elastic_stress(*joint.plan, p, o, joint.bonded(static_cast<int>(k)), holds_of(law, m));
}

/// Compressive force, negative where the joint is in tension [N].
template <class K>
double pressing_force(const JointMemory& joint, const K& law) {
  if (joint.sound) return law.kn * intact_stress(*joint.plan, joint.moved).force;
  double sum = 0;
  for (std::size_t k = 0; k < joint.plan->patch.size(); ++k) sum += law.kn * stress_of(joint, k, law).force;
  return sum;
}

/// Stored energy of a joint [J]. For an intact joint the stress is linear over the whole face, and the energy is a
/// closed form in three displacements. Otherwise it is summed over patches, each with its remaining bonds and opening.
/// Shear stores tau^2 / (2 ks) per unit area; each point of a patch represents a part of `active`.
template <class K>
double energy_of(const JointMemory& joint, const K& law) {
  if (joint.sound)
    return law.kn * intact_stress(*joint.plan, joint.moved).energy +
           intact_shear_energy(*joint.plan, joint.elastic, law.ks);
  double sum = 0;
  for (std::size_t k = 0; k < joint.plan->patch.size(); ++k) {
    const PatchMemory& m = joint.patch[k];
    sum += law.kn * stress_of(joint, k, law).energy;
    const Lanes x = lanes_of(m.elastic_x), y = lanes_of(m.elastic_y);
    if (law.ks * m.active > 0) sum += 2 * sum_of(x * x + y * y) / (law.ks * m.active);
  }
  return sum;
}

bool is_damaged(const JointMemory& m) {
  if (m.sound) return false;
  for (std::size_t k = 0; k < m.plan->patch.size(); ++k)
    for (const double d : m.patch[k].damage)
      if (d > 0) return true;
  return false;
}

}  // namespace

// Input: positions and motions of both bodies, memories of contact and joint. Output: force, moment and memories of the
// trial step, and its dissipated energy.
//
//     intact  --- a limit is exceeded --->  patch by patch  --- no bond, no contact or slid away --->  ended.
//
// The stress of an intact joint is linear over the face, at the cost of one patch. The joint is divided into patches
// when the stress at a corner reaches a limit. `step_intact` then returns false, and the step by patches starts from
// the history variables before the step.
JointResponse respond_joint(const BodyMotion& a, const BodyMotion& b, const SolidMemory& before,
                            const JointMemory& joint, const LawInUse& use, JointMemory& after) {
  const JointPlan& plan = *joint.plan;
  const JointMotion motion = motion_over_step(plan, a, b, use.dt);
  return with_kernel(use, [&]<class K>(const K& law) {
    JointSums sums;
    if (!joint.sound || !step_intact(plan, motion, law, joint, after, sums))
      sums = step_by_patches(motion, law, joint, after);
    JointResponse out;
    SolidResponse& contact = out.contact;
    add_up(sums, plan, motion, law.kn, a, contact);
    contact.memory.slip = before.slip + sums.slip;
    contact.depth = deepest_overlap(plan, motion);
    contact.middle = motion.origin, contact.normal = motion.normal, contact.radius = plan.radius;
    contact.friction_arm = plan.friction_arm;
    contact.arm = spread_arms(plan.whole.xx / plan.whole.area, plan.whole.xy / plan.whole.area,
                              plan.whole.yy / plan.whole.area, motion.x, motion.y);
    contact.lost_friction = sums.lost.friction, contact.lost_fracture = sums.lost.fracture;
    contact.lost_damping = sums.lost.damping + joint_damping_loss(a, b, before, contact.memory, law.dt);
    contact.touching = after.bonds != 0 || contact.area > 0;
    out.ends = after.bonds == 0 && (!contact.touching || has_left(plan, motion, contact.depth));
    if (!contact.touching) contact.memory = {};
    // A joint keeps the crushed depth of each patch; ordinary solids keep the largest one for the whole contact.
    contact.memory.keep_crushed(before.crushed + (out.ends ? after.most_crushed() : 0.0), 0);
    if (joint.bonds != after.bonds || sums.softened) {
      const JointChange change = joint_change(joint, after);
      out.changed = change.broken || change.cracked || change.crushed;
    }
    return out;
  });
}

double joint_energy(const JointMemory& joint, const LawInUse& use) {
  return with_kernel(use, [&](const auto& law) { return energy_of(joint, law); });
}

std::vector<PatchStress> patch_stresses(const JointMemory& joint, const LawInUse& use) {
  return with_kernel(use, [&](const auto& law) {
    std::vector<PatchStress> out;
    const auto add = [&](const PatchStress& stress) { out.emplace_back().add(stress, law.kn); };
    if (joint.sound)
      add(intact_stress(*joint.plan, joint.moved));
    else
      for (std::size_t k = 0; k < joint.plan->patch.size(); ++k) add(stress_of(joint, k, law));
    return out;
  });
}

double carried_force(const JointMemory& joint, const SolidMemory& contact, const LawInUse& use) {
  const double pressing = with_kernel(use, [&](const auto& law) { return pressing_force(joint, law); });
  const Vec3& n = contact.normal;
  const Vec3 shear = contact.shear.total - n.dot(contact.shear.total) * n;
  return Vec3(pressing * n + contact.damping - shear).norm();
}

JointChange joint_change(const JointMemory& before, const JointMemory& now) {
  JointChange change;
  change.broken = before.bonds != now.bonds;
  change.cracked =
      !change.broken && before.bonds != 0 && !before.empty() && !now.empty() && !is_damaged(before) && is_damaged(now);
  change.crushed = !(before.most_crushed() > 0) && now.most_crushed() > 0;
  return change;
}

// The shear carried by the contact is transferred to the joint, in its axes, so that the setting of mortar releases no
// force.
JointMemory set_joint(const FaceOverlap3& faces, const BodyMotion& a, const BodyMotion& b, const SolidMemory& before,
                      const ContactLaw& law) {
  const auto plan = std::make_shared<JointPlan>(plan_joint(faces, a, b));
  if (before.crushed > 0) {  // crushed mortar carries no pressure over its crushed depth
    plan->standing = plan->standing.raised(-before.crushed);
    divide_joint(*plan);
  }
  const JointMotion motion(*plan, a, b);
  const auto along_axes = [&](const Vec3& force) {
    return Vec3(motion.x.dot(force), motion.y.dot(force), plan->radius * motion.normal.dot(force));
  };
  JointMemory joint;
  joint.bonds = all_bonds(*plan), joint.sound = true;
  joint.elastic = along_axes(before.shear.elastic), joint.total = along_axes(before.shear.total);
  joint.plan = plan;
  apply_setting_shear(joint, law);
  if (joint.sound) leave_out_patches(*plan);
  return joint;
}

}  // namespace trilith
