#include "contact/space/solid_contact.hpp"

#include "contact/joint/area_limit.hpp"
#include "contact/joint/chord.hpp"
#include "contact/plane/edge_energy.hpp"
#include "contact/plane/edge_pressure.hpp"
#include "contact/space/cut_pressure.hpp"
#include "contact/space/recorded_energy.hpp"
#include "contact/space/sampled_faces.hpp"
#include "contact/space/solid_energy.hpp"
#include "contact/space/solid_faces.hpp"
#include "contact/space/sphere_contact.hpp"

namespace trilith {
namespace {

/// The previous shear, rotated with the plane of contact and, about its normal, with both bodies.
SlidingForce turned_along(const SolidMemory& before, const Vec3& normal, double turn) {
  SlidingForce f = before.shear;
  if (before.normal.squaredNorm() == 0) return f;
  const TurnedPlane<double> plane(triple_of(before.normal), triple_of(normal), turn);
  f.elastic = vector_of(plane.carry(triple_of(f.elastic))), f.total = vector_of(plane.carry(triple_of(f.total)));
  return f;
}

/// Power of the previous damping force in the motion of b relative to a over the step [W].
double damping_power(const MovingSolid& a, const MovingSolid& b, const SolidMemory& m, double dt) {
  return m.damping.dot(Vec3(mean_velocity_at(b, a.origin, dt) - mean_velocity_at(a, a.origin, dt))) +
         m.damping_moment.dot(Vec3(mean_spin(b, dt) - mean_spin(a, dt)));
}

/// Mean motion of b relative to a over an implicit step, as friction uses it: slip along the plane, and along its
/// normal the rotation times the radius.
Vec3 mean_sliding(const MovingSolid& a, const MovingSolid& b, const Vec3& x, const Vec3& n, double radius, double dt) {
  const Vec3 slip = mean_slip(a, b, x, dt);
  return slip + (radius * n.dot(Vec3(mean_spin(b, dt) - mean_spin(a, dt))) - n.dot(slip)) * n;
}

/// Friction on the resultant, and about its normal. Its spring is at the centroid of the area, whatever the pressure.
/// If the spring followed the centre of pressure, a leaning body would be loaded by couples that derive from no energy,
/// and would flutter. The friction limit does depend on the centre of pressure.
template <class K>
void add_friction(const MovingSolid& a, const MovingSolid& b, const SolidMemory& before, const K& law,
                  const SolidPressure& pressed, SolidResponse& out) {
  const bool own = pressed.along == Vec3::Zero();
  const double normal_force = own ? pressed.force.norm() : pressed.force.dot(pressed.along);
  const Vec3 n = own ? Vec3(pressed.force / normal_force) : pressed.along;
  const double radius = pressed.radius, turning = n.dot(Vec3(b.spin - a.spin));
  Vec3 rate =
      chord_velocity_at(b, b.origin, pressed.middle, law.dt) - chord_velocity_at(a, a.origin, pressed.middle, law.dt);
  rate += (radius * turning - n.dot(rate)) * n;
  const double held = friction_limit_of(law, normal_force, pressed.area, [&] { return rate.norm(); });
  const AreaLimit limit(held, n, pressed.centre - pressed.middle, radius, pressed.friction_arm, pressed.arm);
  const SlidingMotion motion{
      law.dt * (a.behind == nullptr ? rate : mean_sliding(a, b, pressed.middle, n, radius, law.dt)), rate, limit};
  const double turned = 0.5 * law.dt * n.dot(Vec3(mean_spin(a, law.dt) + mean_spin(b, law.dt)));
  const SlidingResponse s =
      slide(motion, limit, pressed.area, turned_along(before, n, turned), SlidingLaw{law.ks, law.beta, law.dt});
  const double along = n.dot(s.force.total);
  const Vec3 shear = s.force.total - along * n;
  out.force -= shear;
  out.moment -= radius * along * n + cross(Vec3(pressed.middle - pressed.centre), shear);
  out.memory.shear = s.force, out.memory.normal = n;
  out.memory.slip += s.slip;
  out.lost_damping += s.lost_damping, out.lost_friction += s.lost_friction;
}

/// Whether some point of the shared solid is so deep in both that no axis can separate them, whatever the rounding. The
/// normal of two edges a millionth off parallel may be wrong by 1e-10.
bool surely_overlap(const PlacedSolid& a, const PlacedSolid& b, const SolidOverlapBuffer& shared) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x : shared.points) sum += x;
  const Vec3 inside = sum / static_cast<double>(shared.points.size());
  const double enough = 1e-9 * (a.solid->size + b.solid->size) + 1e-13 * inside.cwiseAbs().maxCoeff();
  const auto is_deep = [&](const PlacedSolid& solid) {
    for (int f = 0; f < solid.solid->shape.faces.count(); ++f)
      if (!(depth_below(solid, f, inside) > enough)) return false;
    return true;
  };
  return is_deep(a) && is_deep(b);
}

/// Whether two solids share volume, and no axis separates them beyond rounding. If they were apart the axes are tested
/// first, otherwise the volume: both orders give the same result.
bool overlap(const PlacedSolid& a, const PlacedSolid& b, Separation3& apart, SolidOverlapBuffer& shared) {
  const bool was_apart = apart.distance > 0;
  if (was_apart) apart = separation_from(apart, a, b);
  if (was_apart && apart.distance > 0) return false;
  const bool some = shared_volume(a, b, shared) > 0, sure = was_apart || (some && surely_overlap(a, b, shared));
  if (!sure) apart = separation(a, b, 0);
  if (!some || (!sure && apart.distance > 0)) return false;
  apart.distance = 0;
  return true;
}

/// As two solids separate, their elastic shear is released, and the last damping force does work for half a step more.
/// The crushed depth of their mortar is kept.
SolidResponse parted(const MovingSolid& a, const MovingSolid& b, const SolidMemory& before, double ks, double dt) {
  SolidResponse out;
  out.memory.keep_crushed(before.crushed, 0);
  out.lost_friction = sliding_energy(ks, before.shear);
  out.lost_damping = -0.5 * dt * damping_power(a, b, before, dt);
  return out;
}

/// Crushes the mortar until the mean pressure of the solid in `shared` does not exceed its strength; returns the
/// pressure with damping. The mean is taken over the pressed region, of the springs alone.
template <class K>
SolidPressure crushed_pressure(const MovingSolid& a, const MovingSolid& b, const LawInUse& use, const K& law,
                               SolidOverlapBuffer& shared, double before, const Vec3* along) {
  SolidPressure pressed;
  const auto excess = [&](double depth) {
    pressed = solid_pressure(a, b, use, shared, depth, along);
    pressed.crushed = depth;
    const double springs = (pressed.force - pressed.damping).norm(), limit = law.crush_limit(depth);
    return pressed.area > 0 ? springs / (law.kn * pressed.area) - limit : -limit;
  };
  const double depth = law.crush(before, excess);
  if (pressed.crushed != depth) excess(depth);
  return pressed;
}

/// Energy dissipated by the increase of the crushed depth, with the mean of the crushing force before and now, and the
/// remaining memory. pressure_between has left the shared solid in the buffer.
void keep_crushed(const MovingSolid& a, const MovingSolid& b, const SolidMemory& before, const LawInUse& use,
                  double depth, SolidRoom& room, SolidResponse& out) {
  const double force = solid_crushing_force(a.placed, b.placed, use, room.shared, room.part, depth);
  const bool touched = (before.state & contact_touching) != 0;
  const double last = !touched ? 0 : before.crushing_force > 0 ? before.crushing_force : force;
  out.lost_fracture = 0.5 * (last + force) * (depth - before.crushed);
  out.memory.keep_crushed(depth, force);
}

}  // namespace

SolidPressure cut_pressure(const MovingSolid& a, const MovingSolid& b, const LawInUse& use, Separation3& apart,
                           SolidOverlapBuffer& shared, double crushed, const Vec3* along) {
  const bool whole = !(use.held > 0);
  if (!overlap(a.placed, b.placed, apart, shared)) return {};
  return with_kernel(use, [&]<class K>(const K& law) {
    if constexpr (K::crushes)
      if (whole && law.crushing > 0) return crushed_pressure(a, b, use, law, shared, crushed, along);
    return solid_pressure(a, b, use, shared, whole ? 0 : std::max(crushed, use.held), along);
  });
}

SolidPressure pressure_between(const MovingSolid& a, const MovingSolid& b, const LawInUse& use, Separation3& apart,
                               SolidOverlapBuffer& shared, bool may_be_flat, double crushed, const Vec3* along) {
  const bool whole = !(use.held > 0);  // the fast methods do not support a contact that starts at a depth
  const bool linear = is_linear(use.law), has_faces = linear || has_sampled_faces(use.law);
  if (FaceOverlap3 faces; whole && may_be_flat && has_faces && flat_faces(a.placed, b.placed, faces)) {
    apart.distance = 0;
    const MovingSolid face_a = a.by_face(faces.face_a), face_b = b.by_face(faces.face_b);
    return linear ? face_pressure(face_a, face_b, plain_friction(use), faces)
                  : sampled_face_pressure(face_a, face_b, use, faces, shared.triangles);
  }
  if (whole && along == nullptr && have_few_faces(a.placed, b.placed) && linear) {
    SolidPressure pressed;
    const PlainFriction law = plain_friction(use);
    if (edge_pressure(a, b, law.kn, law.beta, shared.triangles, pressed)) {
      apart.distance = 0;
      return pressed;
    }
  }
  return cut_pressure(a, b, use, apart, shared, crushed, along);
}

SolidResponse polyhedron_contact_forces(const MovingSolid& whole_a, const MovingSolid& whole_b,
                                        const SolidMemory& before, const LawInUse& use, const SolidPressure& pressed,
                                        SolidRoom& room) {
  const MovingSolid a = whole_a.by_face(pressed.face_a), b = whole_b.by_face(pressed.face_b);
  return with_kernel(use, [&](const auto& law) {
    SolidResponse out = parted(a, b, before, law.ks, law.dt);
    if (!(pressed.area > 0)) return out;
    out.touching = true;
    out.force = out.normal_force = pressed.force, out.moment = pressed.moment;
    out.centre = pressed.centre, out.area = pressed.area, out.depth = pressed.depth;
    out.face_a = pressed.face_a, out.face_b = pressed.face_b;
    out.middle = pressed.middle;
    out.normal = pressed.along == Vec3::Zero() ? Vec3(pressed.force.normalized()) : pressed.along;
    out.radius = pressed.radius, out.arm = pressed.arm, out.friction_arm = pressed.friction_arm;
    out.memory.state = contact_touching | contact_general;
    if (pressed.crushed > 0) keep_crushed(a, b, before, use, pressed.crushed, room, out);
    out.memory.slip = before.slip;
    out.memory.damping = pressed.damping;
    out.memory.damping_moment = pressed.damping_moment + cross(Vec3(pressed.centre - a.origin), pressed.damping);
    const double damped = a.behind == nullptr ? pressed.damped : -damping_power(a, b, out.memory, law.dt);
    out.lost_damping = 0.5 * law.dt * (damped - damping_power(a, b, before, law.dt));
    if (pressed.force.dot(out.normal) > 0) {
      out.lost_friction = 0;
      add_friction(a, b, before, law, pressed, out);
    }
    return out;
  });
}

double solid_contact_energy(const PlacedSolid& a, const PlacedSolid& b, const SolidMemory& memory, const LawInUse& use,
                            SolidOverlapBuffer& shared, SolidOverlapBuffer& scratch) {
  FaceOverlap3 faces;
  const bool sphere = a.solid->is_sphere() || b.solid->is_sphere(), linear = is_linear(use.law);
  const bool flat = !sphere && !(use.held > 0) && (linear || has_sampled_faces(use.law)) && flat_faces(a, b, faces);
  const double pressure = sphere           ? sphere_energy(a, b, use)
                          : flat && linear ? face_energy(plain_friction(use), faces)
                          : flat           ? sampled_face_energy(use, faces, shared.triangles)
                                 : solid_energy(a, b, use, shared, scratch, std::max(memory.crushed, use.held));
  return pressure + sliding_energy(plain_friction(use).ks, memory.shear);
}

double recorded_contact_energy(const PlacedSolid& a, const PlacedSolid& b, const SolidMemory& memory,
                               const LawInUse& use, SolidOverlapBuffer& shared, SolidOverlapBuffer& scratch) {
  const bool sphere = a.solid->is_sphere() || b.solid->is_sphere();
  const bool whole = !sphere && is_linear(use.law) && !(use.held > 0) && !(memory.crushed > 0);
  FaceOverlap3 faces;
  double depths = 0;
  if (whole && have_few_faces(a, b) && !flat_faces(a, b, faces) && edge_depths(a, b, shared.triangles, depths)) {
    const PlainFriction law = plain_friction(use);
    return 0.5 * law.kn * depths + sliding_energy(law.ks, memory.shear);
  }
  return solid_contact_energy(a, b, memory, use, shared, scratch);
}

}  // namespace trilith
