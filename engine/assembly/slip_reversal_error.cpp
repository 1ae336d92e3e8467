#include "assembly/slip_reversal_error.hpp"

#include <cmath>

#include "assembly/contact/contact_rows.hpp"
#include "assembly/contact/solid_joints.hpp"
#include "contact/joint/area_limit.hpp"
#include "contact/joint/shear_3d.hpp"
#include "contact/plane/face_pair.hpp"

namespace trilith {
namespace {

/// Positions and velocities of two faces at the end of the step, with the mean velocities over it, as the kernel for
/// four rows reads them (assembly/contact/face_contact_simd.hpp), here for one row.
FaceMotion<double> motion_of(const Work<2>& work, const NearPair& p) {
  FaceEnds<double> a = face_ends(work, p.a0, p.a1), b = face_ends(work, p.b0, p.b1);
  FaceMotion<double> motion(a, b, p.corner);
  const auto over_step = [&](int from, int to, FaceEnds<double>& ends) {
    const Vec2 &u = work.skin_mean[from], &v = work.skin_mean[to];
    ends.u0 = u.x(), ends.v0 = u.y(), ends.u1 = v.x(), ends.v1 = v.y();
  };
  over_step(p.a0, p.a1, a), over_step(p.b0, p.b1, b);
  motion.set_over_step(a, b);
  return motion;
}

/// Replaces the slip of both halves by these paths.
FaceMotion<double> slid(FaceMotion<double> motion, double first, double second, double dt) {
  motion.mean.slip_lo = 0.5 * (3 * first - second) / dt, motion.mean.slip_hi = 0.5 * (3 * second - first) / dt;
  return motion;
}

/// Memory of the two halves before the step, from the row of State.
FaceMemory<double> face_memory(const ContactMemory& m) {
  FaceMemory<double> out;
  for (const int h : {0, 1}) {
    out.shear_elastic[h] = m.shear_elastic[h], out.shear_total[h] = m.shear_total[h];
    out.damping_force[h] = m.damping_force[h], out.active[h] = m.active[h];
    out.bonds[h] = m.bonded(h);
  }
  out.slip = m.slip;
  out.general = (m.state & contact_general) != 0;
  return out;
}

/// Error of one pair of faces. With linear rates a half moved by the path `on` and then by the path `back`, see Ways.
/// The law is evaluated once for each path, the second time with the memory of the first. Its result S2 is compared
/// with the result S1 for the whole path at once. Along the way back the mean force has the error (S1 - S2) / 2, and
/// its work this error times the path:
///
///     w = sum over the halves of |S1 - S2| |back| / 2                                                             [J]
double of_faces(const Model<2>& model, const ContactHistory& before, const Work<2>& work, int row, double dt) {
  const NearPair& p = work.pairs[row];
  const FaceMotion<double> motion = motion_of(work, p);
  const FaceMemory<double> memory = face_memory(before.memory[row]);
  const FaceHalves<double> halves(motion.overlap, motion.rates, motion.mean, memory);
  const Ways way[2] = {{halves.half[0].slip_rate, halves.half[0].slip_mean, dt},
                       {halves.half[1].slip_rate, halves.half[1].slip_mean, dt}};
  if (way[0].back == 0 && way[1].back == 0) return 0;
  return with_kernel(law_in_use(model, p.law, dt), [&]<class K>(const K& law) {
    FaceMotion<double> turning = slid(motion, way[0].on, way[1].on, dt);
    turning.rates.slip_lo = turning.rates.slip_hi = 0;
    const auto on = respond_face_motion<K>(turning, memory, law_memory<K>(before.law_numbers(row)), law);
    const auto back = respond_face_motion<K>(slid(motion, way[0].back, way[1].back, dt), on.memory, on.own, law);
    double sum = 0;
    for (const int h : {0, 1})
      sum += 0.5 * std::abs((work.contacts.memory[row].shear_total[h] - back.memory.shear_total[h]) * way[h].back);
    return sum;
  });
}

/// Error of a contact of any shape, with one friction element at the centre of pressure. The normal force and the
/// length of contact are those at the end of the step. The path is the relative displacement of the two bodies along t,
/// across the force.
double of_general(const Model<2>& model, const State<2>& state, const ContactHistory& before, const Work<2>& work,
                  const GeneralContact<2>& g, double dt) {
  const NearPair& p = work.pairs[g.row];
  if (!(g.force.squaredNorm() > 0)) return 0;
  const Vec2 t = left_of(Vec2(g.force.normalized()));
  PieceCorners corners_a, corners_b;
  const PlacedPiece a = placed_piece(model, state, work, p.piece_a, corners_a);
  const PlacedPiece b = placed_piece(model, state, work, p.piece_b, corners_b);
  const auto slip = [&](const PlacedPiece& on_a, const PlacedPiece& on_b) {
    return t.dot(Vec2(on_b.velocity_at(g.centre) - on_a.velocity_at(g.centre)));
  };
  const double rate = slip(a, b);
  const Ways way(rate, slip(a.mean(), b.mean()), dt);
  if (way.back == 0) return 0;
  const ContactMemory &m = before.memory[g.row], &now = work.contacts.memory[g.row];
  HalfResponse<double> out{};
  out.normal = g.force.norm();
  HalfState<double> half{};
  half.length = g.size, half.slip_mean = way.on / dt;
  with_kernel(law_in_use(model, p.law, dt), [&](const auto& law) {
    const ShearBefore<double> both{m.shear_elastic[0] + m.shear_elastic[1], m.shear_total[0] + m.shear_total[1],
                                   m.active[0] + m.active[1]};
    slide_unbonded(law, half, g.size, both, out);
    half.slip_rate = rate, half.slip_mean = way.back / dt;
    slide_unbonded(law, half, g.size, {out.shear_elastic, out.shear_total, out.active}, out);
  });
  return 0.5 * std::abs((now.shear_total[0] + now.shear_total[1] - out.shear_total) * way.back);
}

}  // namespace

double slip_reversal_error(const Model<2>& model, const State<2>& state, const Work<2>& work, double dt) {
  const ContactHistory& before = contacts_before(state, work);
  double sum = bearing_reversal_error(model, state, work, dt);
  for (int row = 0; row < static_cast<int>(work.pairs.size()); ++row) {
    const std::uint32_t now = work.contacts.memory[row].state;
    if ((now & contact_touching) != 0 && (now & contact_general) == 0) sum += of_faces(model, before, work, row, dt);
  }
  for (const GeneralContact<2>& g : work.general_touching) sum += of_general(model, state, before, work, g, dt);
  return sum;
}

namespace {

/// Slip vector of a contact in space: the slip in its plane, and along its normal the rotation times the radius of the
/// area.
Vec3 sliding(const Vec3& slip, const Vec3& spin, const Vec3& n, double radius) {
  return slip + (radius * n.dot(spin) - n.dot(slip)) * n;
}

/// Error of a contact in space without mortar, along the direction in which it slides at the end. With linear rates it
/// moved on by one part of the path and back by the other; its law is evaluated for both.
double of_solids(const Model<3>& model, const State<3>& state, const Work<3>& work, const GeneralContact<3>& g,
                 const ContactArea& area, double dt) {
  const NearPair& p = work.pairs[g.row];
  if (!(g.force.squaredNorm() > 0)) return 0;
  const Vec3 n = g.force.normalized();
  const BodyMotion a = body_motion(model, state, work, p.piece_a, -1),
                   b = body_motion(model, state, work, p.piece_b, -1);
  const Vec3 rate =
      sliding(b.velocity_at(area.middle) - a.velocity_at(area.middle), Vec3(b.spin - a.spin), n, area.radius);
  const Vec3 mean =
      sliding(mean_slip(a, b, area.middle, dt), Vec3(mean_spin(b, dt) - mean_spin(a, dt)), n, area.radius);
  const double size = rate.norm();
  if (!(size > 0)) return 0;
  const Ways way(size, mean.dot(rate) / size, dt);
  if (way.back == 0) return 0;
  const LawInUse use{model.laws[p.law], model.thickness, dt};
  const PlainFriction law = plain_friction(use);
  const double held = with_kernel(use, [&](const auto& kernel) {
    return friction_limit_of(kernel, g.force.norm(), area.area, [&] { return size; });
  });
  const Vec3 back = way.back / size * rate, on = dt * mean - back;
  const AreaLimit limit(held, n, g.centre - area.middle, area.radius, area.friction_arm, area.arm);
  const SlidingForce& before = contacts_before(state, work).memory[g.row].shear;
  const SlidingForce turned =
      slide({on, Vec3::Zero(), limit}, limit, area.area, before, {law.ks, law.beta, dt - way.time_back}).force;
  const SlidingForce then =
      slide({back, rate, limit}, limit, area.area, turned, {law.ks, law.beta, way.time_back}).force;
  return 0.5 * std::abs((work.contacts.memory[g.row].shear.total - then.total).dot(back));
}

}  // namespace

/// Mortar joints that slide within their bonds are ignored.
double slip_reversal_error(const Model<3>& model, const State<3>& state, const Work<3>& work, double dt) {
  double sum = bearing_reversal_error(model, state, work, dt);
  for (const GeneralContact<3>& g : work.general_touching) {
    const auto row = static_cast<std::size_t>(g.row);
    const JointMemory* joint = work.contacts.joint_at(row);
    if (joint == nullptr || joint->empty()) sum += of_solids(model, state, work, g, work.solids.areas[row], dt);
  }
  return sum;
}

}  // namespace trilith
