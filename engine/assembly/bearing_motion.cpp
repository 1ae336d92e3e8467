#include "assembly/bearing_motion.hpp"

#include <cmath>

#include "model/pose.hpp"

namespace trilith {

template <>
Vec2 BearingMotion<2>::translation() const {
  return {displacement[0], displacement[1]};
}
template <>
Vec3 BearingMotion<3>::translation() const {
  return {displacement[0], displacement[1], displacement[2]};
}

template <int D>
std::array<double, Space<D>::dofs> BearingMotion<D>::counted(const BearingMemory<D>& memory) const {
  std::array<double, Space<D>::dofs> out{};
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = displacement[k] - memory.begun_at[k];
  return out;
}
template std::array<double, 3> BearingMotion<2>::counted(const BearingMemory<2>&) const;
template std::array<double, 6> BearingMotion<3>::counted(const BearingMemory<3>&) const;

template <>
Vec2 BearingMotion<2>::force(const std::array<double, 3>& resisting) const {
  return -axes.apply(Vec2(resisting[along], resisting[axial]));
}
template <>
Vec3 BearingMotion<3>::force(const std::array<double, 6>& resisting) const {
  return -axes.apply(Vec3(resisting[0], resisting[1], resisting[2]));
}

namespace {

// In the plane, with p the pose of a's point and q the pose of b's point:
//
//     axes = turn_p + b.angle            displacement = axes' (q - p) - rest
//     angle = turn_q - turn_p - rest     rate = axes' (v_q - v_p - spin_p x (q - p))

BearingMotion<2> plane_motion(const Turn& axes, const Vec2& displacement, const Vec2& rate, double angle, double spin,
                              const Vec2& point) {
  return {axes, {displacement.x(), displacement.y(), angle}, {rate.x(), rate.y(), spin}, point};
}

/// Motion of ends with these poses, whose relative rotation is below pi.
BearingMotion<2> motion_of_poses(const Bearing<2>& b, const Pose& p, const Pose& q) {
  const Turn axes(p.rotation + b.angle);
  const Vec2 between = q.place - p.place, rate = q.velocity - p.velocity - cross(p.spin, between);
  return plane_motion(axes, axes.undo(between) - b.rest, axes.undo(rate),
                      std::remainder(q.rotation - p.rotation - b.rest_angle, 2 * M_PI), q.spin - p.spin, q.place);
}

/// Rate of a rotation vector t under a spin w in its axes: see law/bearing/bearing.hpp. `side` is -1, or +1 for the
/// transpose. With q = (cos, sin e) of half the angle, |t|/2 cot(|t|/2) is |t|/2 cos/sin, and c is 1/12 at 0.
Vec3 through_turn(const Vec3& t, const Vec3& w, double side) {
  const double size = t.norm();
  double c = 1.0 / 12 + size * size / 720;
  if (size > 1e-3) {
    const portable::SineCosine half = portable::sine_cosine(0.5 * size);
    c = (1 - 0.5 * size * half.cosine / half.sine) / (size * size);
  }
  const Vec3 across = cross(t, w);
  return w + side * 0.5 * across + c * cross(t, across);
}

/// The rotation vector nearest to the previous one, with whole turns counted.
Vec3 nearest_turn(const UnitQuaternion& turn, const Vec3& before) {
  const Vec3 least = angle_of(turn);
  const double size = least.norm();
  if (!(before.squaredNorm() > 1) || !(size > 0)) return least;
  const Vec3 axis = least / size;
  return least + 2 * M_PI * std::round((axis.dot(before) - size) / (2 * M_PI)) * axis;
}

}  // namespace

template <>
double BearingMotion<2>::moment(const std::array<double, 3>& resisting) const {
  return -resisting[turning];
}
template <>
Vec3 BearingMotion<3>::moment(const std::array<double, 6>& resisting) const {
  const Vec3 t(displacement[3], displacement[4], displacement[5]), couples(resisting[3], resisting[4], resisting[5]);
  return -axes.apply(through_turn(t, couples, 1));
}

BearingMotion<2> bearing_motion(const Model<2>& model, const State<2>& state, std::size_t i) {
  const Bearing<2>& b = model.bearings[i];
  // Ends with one node each, the usual case, need no poses and count whole turns.
  if (!b.end_a.is_rigid() || !b.end_b.is_rigid())
    return motion_of_poses(b, pose_at(model, state, b.end_a), pose_at(model, state, b.end_b));
  const int na = b.end_a.node[0], nb = b.end_b.node[0];
  const Turn axes(state.rotation[na] + b.angle);
  const Vec2 arm_b = Turn(state.rotation[nb]).apply(b.end_b.arm[0]);
  const Vec2 from_a = state.position[nb] + arm_b - state.position[na];
  const Vec2 anchor = Turn(state.rotation[na]).apply(b.end_a.arm[0]);
  const Vec2 rate =
      state.velocity[nb] + cross(state.spin[nb], arm_b) - state.velocity[na] - cross(state.spin[na], from_a);
  return plane_motion(axes, axes.undo(Vec2(from_a - anchor)) - b.rest, axes.undo(rate),
                      state.rotation[nb] - state.rotation[na] - b.rest_angle, state.spin[nb] - state.spin[na],
                      Vec2(state.position[nb] + arm_b));
}

/// In space, with the axes A of the bearing and d from a's point to b's: displacement = A' d - rest, and rate = A' (v_b
/// - v_a - spin_a x d), where v are the velocities of the points. Rotations: law/bearing/bearing.hpp.
BearingMotion<3> bearing_motion(const Model<3>& model, const State<3>& state, std::size_t i) {
  const Bearing<3>& b = model.bearings[i];
  const BodyMotion p = motion_of(model, state, b.end_a.node[0]), q = motion_of(model, state, b.end_b.node[0]);
  const UnitQuaternion frame = p.rotation * b.angle;
  BearingMotion<3> out{turn_of(frame)};
  const Vec3 arm_b = turn_of(q.rotation).apply(b.end_b.arm[0]), arm_a = turn_of(p.rotation).apply(b.end_a.arm[0]);
  out.point = q.place + arm_b;
  const Vec3 from_a = out.point - p.place, moved = out.axes.undo(Vec3(from_a - arm_a)) - b.rest;
  const Vec3 rate = out.axes.undo(Vec3(q.velocity + cross(q.spin, arm_b) - p.velocity - cross(p.spin, from_a)));
  const auto& last = state.bearing[i].turned;
  const Vec3 turned = nearest_turn(inverse(frame) * (q.rotation * b.rest_angle), Vec3(last[0], last[1], last[2]));
  const Vec3 turning_rate = through_turn(turned, out.axes.undo(Vec3(q.spin - p.spin)), -1);
  for (const int k : {0, 1, 2}) {
    out.displacement[k] = moved[k], out.displacement[3 + k] = turned[k];
    out.rate[k] = rate[k], out.rate[3 + k] = turning_rate[k];
  }
  return out;
}

std::array<double, 3> mean_rates(const Model<2>& model, const State<2>& state, const Bearing<2>& b,
                                 const BearingMotion<2>& now, double dt) {
  if (!state.implicit()) return now.rate;
  // The first evaluation of an implicit scheme has no last step.
  if (!(dt > 0)) return {};
  const BearingMotion<2> before =
      motion_of_poses(b, pose_before(model, state, b.end_a), pose_before(model, state, b.end_b));
  const Vec2 moved = now.translation() - before.translation();
  return {moved.x() / dt, moved.y() / dt,
          std::remainder(now.displacement[turning] - before.displacement[turning], 2 * M_PI) / dt};
}

/// Rotations are taken nearest to the present ones, so that whole turns do not interfere.
std::array<double, 6> mean_rates(const Model<3>& model, const State<3>& state, const Bearing<3>& b,
                                 const BearingMotion<3>& now, double dt) {
  if (!state.implicit()) return now.rate;
  if (!(dt > 0)) return {};
  const BodyMotion p = motion_before(model, state, b.end_a.node[0]), q = motion_before(model, state, b.end_b.node[0]);
  const UnitQuaternion frame = p.rotation * b.angle;
  const Vec3 between =
      q.place + turn_of(q.rotation).apply(b.end_b.arm[0]) - p.place - turn_of(p.rotation).apply(b.end_a.arm[0]);
  const Vec3 moved = turn_of(frame).undo(between) - b.rest;
  const Vec3 last(now.displacement[3], now.displacement[4], now.displacement[5]),
      turned = nearest_turn(inverse(frame) * (q.rotation * b.rest_angle), last);
  std::array<double, 6> out{};
  for (const int k : {0, 1, 2}) out[k] = (now.displacement[k] - moved[k]) / dt, out[3 + k] = (last[k] - turned[k]) / dt;
  return out;
}

void push_ends(const Model<2>& model, const State<2>& state, const Bearing<2>& bearing, const Vec2& force,
               double moment, std::vector<Vec2>& node_force, std::vector<double>& node_moment) {
  const Vec2 between = pose_at(model, state, bearing.end_b).place - pose_at(model, state, bearing.end_a).place;
  apply_force(model, state, bearing.end_b, force, moment, node_force, node_moment);
  apply_force(model, state, bearing.end_a, -force, -cross(between, force) - moment, node_force, node_moment);
}

void push_ends(const Model<3>& model, const State<3>& state, const Bearing<3>& bearing, const Vec3& force,
               const Vec3& moment, std::vector<Vec3>& node_force, std::vector<Vec3>& node_moment) {
  const Vec3 point = point_of(model, state, bearing.end_b);
  push_contact_frame(model, state, bearing.end_b.node[0], point, force, moment, node_force, node_moment);
  push_contact_frame(model, state, bearing.end_a.node[0], point, -force, -moment, node_force, node_moment);
}

}  // namespace trilith
