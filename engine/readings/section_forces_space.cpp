#include "readings/section_forces_space.hpp"

#include <algorithm>
#include <utility>

#include "assembly/contact/solid_joints.hpp"
#include "assembly/evaluate.hpp"
#include "contact/joint/joint.hpp"
#include "contact/joint/joint_motion.hpp"
#include "contact/space/solid_faces.hpp"
#include "geometry/plane/outline_moments.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// Touching areas below this share of the square of the smaller solid are points.
constexpr double least_touching = 1e-12;

Vec3 part_across(const Vec3& v, const Vec3& n) {
  return v - n.dot(v) * n;
}

/// Shear of a patch: its sum, and its couple about the origin of the joint [N], [N m].
Vec3 patch_shear(const JointPatch& p, const PatchMemory& m) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t q = 0; q < patch_points; ++q)
    sum += Vec3(m.total_x[q], m.total_y[q], p.point_x[q] * m.total_y[q] - p.point_y[q] * m.total_x[q]);
  return sum;
}

}  // namespace

SectionStress section_stress(const CrackSection<3>& section, const SpaceForces& forces) {
  const LinearOver stress = linear_over(section.area, section.xx, section.xy, section.yy, forces.normal,
                                        Vec2(-forces.bending.y(), forces.bending.x()));
  return {stress.at, stress.slope};
}

SurfaceForces3::SurfaceForces3(const Model<3>& model, const State<3>& state, const Work<3>& work)
    : model_(model), state_(state), work_(work), slot_(model.bodies.size(), -1) {}

void SurfaceForces3::collect(std::span<const int> bodies) {
  for (const BodyForces& b : bodies_) slot_[static_cast<std::size_t>(b.body)] = -1;
  bodies_.assign(bodies.size(), {});
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies_[i].body = bodies[i];
    slot_[static_cast<std::size_t>(bodies[i])] = static_cast<int>(i);
  }
  add_contacts();
  add_bearings();
  add_loads();
  add_pushes();
  for (BodyForces& b : bodies_) sum_up(b);
}

void SurfaceForces3::add_point(int body, const PointForce& force) {
  if (body >= 0 && slot_of(body) >= 0) bodies_[static_cast<std::size_t>(slot_of(body))].points.push_back(force);
}

void SurfaceForces3::add_area(const SpreadForce& on_b, int a, int b) {
  if (slot_of(b) >= 0) bodies_[static_cast<std::size_t>(slot_of(b))].areas.push_back(on_b);
  if (slot_of(a) >= 0) bodies_[static_cast<std::size_t>(slot_of(a))].areas.push_back(on_b.reversed());
}

/// Contacts of one point stay one point. Their pressure acts at its centre, and their shear at the middle of their
/// area.
void SurfaceForces3::add_contact(std::size_t place) {
  const GeneralContact<3>& contact = work_.general_touching[place];
  const auto row = static_cast<std::size_t>(contact.row);
  const NearPair& pair = work_.pairs[row];
  const int a = model_.piece_body[pair.piece_a], b = model_.piece_body[pair.piece_b];
  if (slot_of(a) < 0 && slot_of(b) < 0) return;
  const JointMemory* joint = work_.contacts.joint_at(row);
  if (joint != nullptr && !joint->empty()) return add_joint(contact.row, *joint, a, b);
  if (add_flat(place, a, b)) return;
  const SolidMemory& memory = work_.contacts.memory[row];
  const ContactArea& area = work_.solids.areas[row];
  const Vec3 shear = part_across(memory.shear.total, memory.normal);
  const Vec3 couple = area.radius * memory.normal.dot(memory.shear.total) * memory.normal;
  add_point(b, {contact.centre, contact.force, Vec3::Zero()});
  add_point(a, {contact.centre, -contact.force, Vec3::Zero()});
  add_point(b, {area.middle, -shear, -couple});
  add_point(a, {area.middle, shear, couple});
}

void SurfaceForces3::add_contacts() {
  for (std::size_t i = 0; i < work_.general_touching.size(); ++i) add_contact(i);
}

/// An intact joint has one linear stress, a divided one has a stress for each patch. Damping is spread over the whole.
void SurfaceForces3::add_joint(int row, const JointMemory& joint, int a, int b) {
  const NearPair& pair = work_.pairs[static_cast<std::size_t>(row)];
  const JointPlan& plan = *joint.plan;
  const BodyMotion on_a = body_motion(model_, state_, pair.piece_a, plan.face_a);
  const JointMotion motion(plan, on_a, body_motion(model_, state_, pair.piece_b, plan.face_b));
  const SolidMemory& memory = work_.contacts.memory[static_cast<std::size_t>(row)];
  const Vec3& n = motion.normal;
  const Vec3 damping_moment = memory.damping_moment - cross(Vec3(motion.origin - on_a.place), memory.damping);
  const std::vector<PatchStress> stress =
      patch_stresses(joint, {model_.laws[static_cast<std::size_t>(pair.law)], model_.thickness, 0});
  const auto add = [&](std::span<const Vec2> polygon, const PatchStress& pressed, const Vec3& shear, const Vec2& middle,
                       double share) {
    const Vec3 damping = share * memory.damping;
    const Vec3 force = pressed.force * n + damping - motion.in_world(shear.head<2>());
    const Vec3 moment = cross(motion.in_world(pressed.moment), n) + cross(motion.in_world(middle), damping) +
                        share * damping_moment - shear.z() * n;
    add_area(SpreadForce(motion.origin, motion.x, motion.y, polygon, force, moment), a, b);
  };
  if (joint.sound) {
    const Vec3 shear(motion.x.dot(memory.shear.total), motion.y.dot(memory.shear.total),
                     plan.radius * n.dot(memory.shear.total));
    add(plan.outline, stress.front(), shear, plan.whole.middle, 1);
    return;
  }
  for (std::size_t k = 0; k < plan.patch.size(); ++k) {
    const JointPatch& p = plan.patch[k];
    add(plan.corners(p), stress[k], patch_shear(p, joint.patch[k]), p.middle, p.area / plan.whole.area);
  }
}

/// Two faces that lie flat on each other: the polygon where they overlap.
bool SurfaceForces3::add_flat(std::size_t place, int a, int b) {
  const GeneralContact<3>& contact = work_.general_touching[place];
  const auto row = static_cast<std::size_t>(contact.row);
  const NearPair& pair = work_.pairs[row];
  const ConvexSolid &one = model_.piece_solid[static_cast<std::size_t>(pair.piece_a)],
                    &other = model_.piece_solid[static_cast<std::size_t>(pair.piece_b)];
  if (pair.replaced || one.is_sphere() || other.is_sphere()) return false;
  if (!is_linear(model_.laws[static_cast<std::size_t>(pair.law)])) return false;
  FaceOverlap3 faces;
  if (!flat_faces(work_.solids.placed[static_cast<std::size_t>(pair.piece_a)],
                  work_.solids.placed[static_cast<std::size_t>(pair.piece_b)], faces))
    return false;
  const MeanPlane& plane = faces.plane;
  const std::span<const Vec2> shared(faces.shared.corner.data(), static_cast<std::size_t>(faces.shared.count));
  const std::vector<Vec2> closed = part_below(shared, -plane.overlap, Vec2(-plane.slope));
  const double size = std::min(one.size, other.size);
  if (closed.size() < 3 || !(OutlineMoments(closed).area > least_touching * size * size)) return false;
  const SolidMemory& memory = work_.contacts.memory[row];
  const ContactArea& area = work_.solids.areas[row];
  const Vec3 shear = part_across(memory.shear.total, memory.normal);
  const Vec3 couple = area.radius * memory.normal.dot(memory.shear.total) * memory.normal;
  const Vec3 moment = cross(Vec3(contact.centre - plane.origin), contact.force) -
                      cross(Vec3(area.middle - plane.origin), shear) - couple;
  add_area(SpreadForce(plane.origin, plane.x, plane.y, closed, contact.force - shear, moment), a, b);
  return true;
}

/// Both forces of a bearing act along one line through the point of its second body.
void SurfaceForces3::add_bearings() {
  for (std::size_t i = 0; i < model_.bearings.size() && i < work_.bearing_force.size(); ++i) {
    const Bearing<3>& b = model_.bearings[i];
    if (slot_of(b.body_a) < 0 && slot_of(b.body_b) < 0) continue;
    const Vec3 place = point_of(model_, state_, b.end_b), first = point_of(model_, state_, b.end_a);
    const Vec3 &force = work_.bearing_force[i], &moment = work_.bearing_moment[i];
    add_point(b.body_b, {place, force, moment});
    add_point(b.body_a, {first, -force, -moment - cross(Vec3(place - first), force)});
  }
}

void SurfaceForces3::add_loads() {
  for_load_parts(model_, [&](const auto& load, int part, const LoadPart& row) {
    const int body = load.body_of(part);
    if (body >= 0 && slot_of(body) >= 0) bodies_[static_cast<std::size_t>(slot_of(body))].loads.push_back(row);
  });
}

void SurfaceForces3::add_pushes() {
  for (std::size_t i = 0; i < model_.pushes.size() && i < work_.push_force.size(); ++i)
    for (const PushRow<3>& row : model_.pushes[i].rows) {
      const auto n = static_cast<std::size_t>(row.node);
      const Vec3 place =
          state_.position[n] + Turn3(state_.rotation[static_cast<std::size_t>(row.turn)]).apply(row.place);
      add_point(body_of_node(model_, row.node),
                {place, work_.push_force[i] * row.weight * model_.pushes[i].direction, Vec3::Zero()});
    }
}

void SurfaceForces3::sum_up(BodyForces& body) const {
  const auto n = static_cast<std::size_t>(model_.bodies[static_cast<std::size_t>(body.body)].first_node);
  body.sum.about = state_.position[n];
  for (const PointForce& f : body.points) body.sum.add(f.point, f.force, f.moment);
  for (const SpreadForce& f : body.areas) body.sum.add(f.centre, f.whole.force, f.whole.moment);
  WholeLoads<3> on{{model_, state_, &work_, &work_.closed_joints}, body.sum};
  apply_parts(model_, body.loads, on);
}

/// In the axes of the body. Leapfrog velocities are half a step old; the spin is brought to the instant.
SpaceForces SurfaceForces3::in_section(std::size_t i, const CrackSection<3>& section) const {
  const BodyForces& b = bodies_[i];
  const auto n = static_cast<std::size_t>(model_.bodies[static_cast<std::size_t>(b.body)].first_node);
  const Turn3 turn(state_.rotation[n]);
  const Vec3 middle = state_.position[n] + turn.apply(section.centre), normal = turn.apply(section.normal);
  ForceSum<3> behind{middle};
  for (const PointForce& f : b.points)
    if (normal.dot(f.point - middle) <= 0) behind.add(f.point, f.force, f.moment);
  for (const SpreadForce& f : b.areas) {
    const SpreadPart part = f.behind(middle, normal);
    behind.add(f.centre, part.force, part.moment);
  }
  LoadsBehind<3> on{{model_, state_, &work_, &work_.closed_joints}, middle, normal, behind};
  apply_parts(model_, b.loads, on);
  const Vec3 &inertia = model_.inertia[n], moment = turn.undo(b.sum.moment);
  const auto turning_at = [&](const Vec3& spin) {
    return Vec3((moment - cross(spin, Vec3(inertia.cwiseProduct(spin)))).cwiseQuotient(inertia));
  };
  const Vec3 last = turn.undo(state_.spin[n]);
  const double back = state_.implicit() ? 0.0 : 0.5 * state_.last_dt;
  const Vec3 first_turning = turning_at(last), spin = last + back * turning_at(last + back * first_turning);
  const Vec3 turning = turning_at(spin), arm = section.centroid;
  const Vec3 inert =
      section.mass * (turn.undo(b.sum.force) / model_.mass[n] + cross(turning, arm) + cross(spin, cross(spin, arm)));
  const Vec3 force = inert - turn.undo(behind.force);
  const Vec3 about = section.inertia * turning + cross(spin, Vec3(section.inertia * spin)) +
                     cross(Vec3(arm - section.centre), inert) - turn.undo(behind.moment);
  return {section.normal.dot(force), Vec2(section.x.dot(force), section.y.dot(force)),
          Vec2(section.x.dot(about), section.y.dot(about)), section.normal.dot(about)};
}

}  // namespace trilith
