// Joints of mortar in space that are divided, or continue on another body.
#include <algorithm>
#include <limits>

#include "contact/joint/intact_joint.hpp"
#include "edit/split_contacts_space.hpp"
#include "geometry/plane/outline_moments.hpp"

namespace trilith {
namespace {

/// A part of a joint with less than this share of its area is left out.
constexpr double least_joint_part = 1e-9;

std::uint32_t bonds_of_all(const JointPlan& plan) {
  return (1U << plan.patches) - 1U;
}

JointSeat moved_within(const JointSeat& seat, const Vec2& by) {
  const Turn3 turn(seat.axes);
  return {seat.place + by.x() * turn.x() + by.y() * turn.y(), seat.axes};
}

LinearOverlap about(const LinearOverlap& f, const Vec2& origin) {
  return {f(origin), f.slope};
}

/// The shear of a part of an intact joint: force, and couple about the centroid of the part.
Vec3 part_of_shear(const JointPatch& whole, const OutlineMoments& part, const Vec3& shear) {
  const double twist = shear.z() / polar_moment(whole);
  const Vec2 force = part.area * (shear.head<2>() / whole.area + twist * left_of(part.middle - whole.middle));
  return {force.x(), force.y(), twist * (part.xx + part.yy)};
}

/// The patch of a divided joint that is nearest to a point.
std::size_t patch_near(const JointPlan& plan, const Vec2& at) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < plan.patch.size(); ++k)
    if (const double apart = (plan.patch[k].middle - at).squaredNorm(); apart < least) least = apart, best = k;
  return best;
}

/// The memory of a patch for a new patch inside it, with the same stresses.
PatchMemory resized(const PatchMemory& old, double share) {
  PatchMemory out = old;
  for (auto* numbers : {&out.elastic_x, &out.elastic_y, &out.total_x, &out.total_y})
    for (double& v : *numbers) v *= share;
  out.active *= share;
  return out;
}

/// Gives each patch of `joint` the memory of the nearest patch of `whole`. `old_place` maps its points there.
template <class Place>
void take_patches(const JointMemory& whole, JointMemory& joint, Place&& old_place) {
  const JointPlan& plan = *joint.plan;
  joint.patch.resize(plan.patch.size());
  joint.bonds = 0;
  for (std::size_t k = 0; k < plan.patch.size(); ++k) {
    const std::size_t from = patch_near(*whole.plan, old_place(plan.patch[k].middle));
    joint.patch[k] = resized(whole.patch[from], plan.patch[k].area / whole.plan->patch[from].area);
    if (whole.bonded(static_cast<int>(from))) joint.bonds |= 1U << k;
  }
}

/// A vector along the axes of a joint, along the axes of the same joint seen from its other side.
Vec2 mirrored(const Vec2& v) {
  return {v.x(), -v.y()};
}
LinearOverlap mirrored(const LinearOverlap& f) {
  return {f.at, mirrored(f.slope)};
}

}  // namespace

JointMemory part_of_joint(const JointMemory& whole, std::span<const Vec2> corners) {
  const JointPlan& old = *whole.plan;
  if (corners.size() < 3) return {};
  const OutlineMoments part(corners);
  if (!(part.area > least_joint_part * old.whole.area)) return {};
  const auto plan = std::make_shared<JointPlan>(old);
  plan->in_a = moved_within(old.in_a, part.middle), plan->in_b = moved_within(old.in_b, part.middle);
  plan->standing = about(old.standing, part.middle);
  plan->outline.clear();
  for (const Vec2& p : corners) plan->outline.emplace_back(p - part.middle);
  divide_joint(*plan);
  JointMemory joint;
  joint.moved = about(whole.moved, part.middle), joint.sound = whole.sound;
  joint.plan = plan;
  if (whole.sound) {
    joint.bonds = bonds_of_all(*plan);
    joint.elastic = part_of_shear(old.whole, part, whole.elastic);
    joint.total = part_of_shear(old.whole, part, whole.total);
    leave_out_patches(*plan);
  } else {
    take_patches(whole, joint, [&](const Vec2& p) { return Vec2(p + part.middle); });
  }
  return joint;
}

void move_seat(JointMemory& joint, bool first, const BodyMotion& from, const BodyMotion& to) {
  const auto plan = std::make_shared<JointPlan>(*joint.plan);
  JointSeat& seat = first ? plan->in_a : plan->in_b;
  const Vec3 place = from.place + Turn3(from.rotation).apply(seat.place);
  const UnitQuaternion back = inverse(to.rotation);
  seat = {Turn3(back).apply(Vec3(place - to.place)), renormalised(back * (from.rotation * seat.axes))};
  joint.plan = plan;
}

/// Half a turn about x exchanges the sides: x stays, y and the normal are reversed. Shear is the force of the second
/// body on the first; its couple about the normal keeps its sign.
JointMemory turned_joint(const JointMemory& joint) {
  const JointPlan& old = *joint.plan;
  const UnitQuaternion half_turn{0, 1, 0, 0};
  const auto plan = std::make_shared<JointPlan>(old);
  plan->in_a = {old.in_b.place, old.in_b.axes * half_turn}, plan->in_b = {old.in_a.place, old.in_a.axes * half_turn};
  std::swap(plan->face_a, plan->face_b);
  plan->standing = mirrored(old.standing);
  plan->outline.clear();
  for (auto p = old.outline.rbegin(); p != old.outline.rend(); ++p) plan->outline.push_back(mirrored(*p));
  divide_joint(*plan);
  JointMemory out = joint;
  out.plan = plan, out.moved = mirrored(joint.moved);
  const auto seen_from_there = [](const Vec3& shear) { return Vec3(-shear.x(), shear.y(), shear.z()); };
  out.elastic = seen_from_there(joint.elastic), out.total = seen_from_there(joint.total);
  if (joint.sound) {
    leave_out_patches(*plan);
    return out;
  }
  take_patches(joint, out, [](const Vec2& p) { return mirrored(p); });
  for (PatchMemory& m : out.patch)
    for (auto* numbers : {&m.elastic_x, &m.total_x})
      for (double& v : *numbers) v = -v;
  return out;
}

}  // namespace trilith
