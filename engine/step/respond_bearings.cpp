// Bearings: relative motion of two points in the axes of the first body, one law per direction.
#include <algorithm>
#include <cmath>

#include "step/evaluate.hpp"
#include "step/turned_back.hpp"
#include "world/pose.hpp"

namespace trilith {
namespace {

/// Displacement and rate of b's point against a's, in the bearing's axes.
/// In axes fixed to a, so that both may turn as one rigid piece: with p the point of a and q that of b
///
///     axes = turn_p + b.angle            displacement = axes' (q - p) - rest
///     angle = turn_q - turn_p - rest     rate = axes' (v_q - v_p - spin_p x (q - p))
struct RelativeMotion {
  Turn axes;
  Vec2 displacement, rate;
  double angle, spin;
};

/// Of ends with these poses, which turn by less than half a circle against each other.
RelativeMotion motion_of_poses(const Bearing<2>& b, const Pose& p, const Pose& q) {
  const Turn axes(p.rotation + b.angle);
  const Vec2 between = q.place - p.place, rate = q.velocity - p.velocity - cross(p.spin, between);
  return {axes, axes.undo(between) - b.rest, axes.undo(rate),
          std::remainder(q.rotation - p.rotation - b.rest_angle, 2 * M_PI), q.spin - p.spin};
}

RelativeMotion motion_of_ties(const Model<2>& model, const State<2>& state, const Bearing<2>& b) {
  return motion_of_poses(b, pose_at(model, state, b.end_a), pose_at(model, state, b.end_b));
}

RelativeMotion relative_motion(const Model<2>& model, const State<2>& state, const Bearing<2>& b) {
  // Ties to one node each, as nearly always, need no poses, and count whole turns too.
  if (!b.end_a.is_rigid() || !b.end_b.is_rigid()) return motion_of_ties(model, state, b);
  const int na = b.end_a.node[0], nb = b.end_b.node[0];
  const Turn axes(state.rotation[na] + b.angle);
  const Vec2 arm_b = Turn(state.rotation[nb]).apply(b.end_b.arm[0]);
  const Vec2 from_a = state.position[nb] + arm_b - state.position[na];
  const Vec2 anchor = Turn(state.rotation[na]).apply(b.end_a.arm[0]);
  const Vec2 rate =
      state.velocity[nb] + cross(state.spin[nb], arm_b) - state.velocity[na] - cross(state.spin[na], from_a);
  return {axes, axes.undo(Vec2(from_a - anchor)) - b.rest, axes.undo(rate),
          state.rotation[nb] - state.rotation[na] - b.rest_angle, state.spin[nb] - state.spin[na]};
}

/// Mean rates over the step behind, by direction: those of now, but where an implicit scheme took it.
std::array<double, 3> mean_rates(const Model<2>& model, const State<2>& state, const Bearing<2>& b,
                                 const RelativeMotion& now, double dt) {
  if (!state.implicit()) return {now.rate.x(), now.rate.y(), now.spin};
  // The first evaluation under a scheme has no step behind it.
  if (!(dt > 0)) return {};
  const RelativeMotion before =
      motion_of_poses(b, pose_before(model, state, b.end_a), pose_before(model, state, b.end_b));
  const Vec2 moved = now.displacement - before.displacement;
  return {moved.x() / dt, moved.y() / dt, std::remainder(now.angle - before.angle, 2 * M_PI) / dt};
}

DirectionResponse respond(const DirectionLaw& law, const DirectionMotion& motion, const DirectionMemory& before) {
  return std::visit(
      [&](const auto& l) {
        if constexpr (std::is_same_v<std::decay_t<decltype(l)>, std::monostate>)
          return DirectionResponse{};
        else
          return l.respond(motion, before);
      },
      law);
}

/// The first direction beyond its limit, or -1.
int direction_beyond(const Bearing<2>& b, const std::array<double, 3>& displacement) {
  for (int k = 0; k < 3; ++k)
    if (std::abs(displacement[k]) > b.limit[k]) return k;
  return -1;
}

void respond_live(const Model<2>& model, const State<2>& state, Work<2>& work, std::size_t i, double dt) {
  const Bearing<2>& b = model.bearings[i];
  const BearingMemory& before = state.bearing[i];
  BearingMemory& after = work.bearing[i];
  const RelativeMotion m = relative_motion(model, state, b);
  const std::array<double, 3> displacement{m.displacement.x(), m.displacement.y(), m.angle};
  const std::array<double, 3> rate{m.rate.x(), m.rate.y(), m.spin};
  const std::array<double, 3> mean = mean_rates(model, state, b, m, dt);
  std::array<double, 3> force{};
  double compression = 0;
  for (const int k : {axial, along, turning}) {  // friction along the seat needs the axial force first
    // The law gives force, energies and memory of the trial; nothing of State is written.
    const DirectionMotion motion{displacement[k], rate[k], dt, compression, mean[k]};
    const DirectionResponse r = respond(b.law[k], motion, before.direction[k]);
    after.direction[k] = r.memory;
    force[k] = r.force();
    if (k == axial) compression = std::max(0.0, -r.memory.force);
    if (r.yielding && after.status == BearingStatus::intact) after.status = BearingStatus::yielded;
    work.bearing_energy[i] += r.stored;
    work.given[EnergyTerm::bearing_inner] += r.lost_inner;
    work.given[EnergyTerm::bearing_damping] += r.lost_damping;
  }
  work.bearing_stored += work.bearing_energy[i];
  // On b, against its displacement; a gets the opposite through b's point, so that nothing turns both together.
  work.bearing_force[i] = -m.axes.apply(Vec2(force[along], force[axial]));
  work.bearing_moment[i] = -force[turning];
  work.bearing_displacement[i] = m.displacement;
  const int beyond = direction_beyond(b, displacement);
  if (beyond < 0) return;
  after.status = BearingStatus::failed;
  after.failed_direction = static_cast<std::uint32_t>(beyond);
}

/// Of a live one: its laws are asked again for both ways.
double turned_back(const Model<2>& model, const State<2>& state, const Work<2>& work, std::size_t i, double dt) {
  const Bearing<2>& b = model.bearings[i];
  const RelativeMotion m = relative_motion(model, state, b);
  const std::array<double, 3> displacement{m.displacement.x(), m.displacement.y(), m.angle};
  const std::array<double, 3> rate{m.rate.x(), m.rate.y(), m.spin};
  const std::array<double, 3> mean = mean_rates(model, state, b, m, dt);
  const double compression = std::max(0.0, -work.bearing[i].direction[axial].force);
  double sum = 0;
  for (const int k : {axial, along, turning}) {
    const Ways way(rate[k], mean[k], dt);
    if (way.back == 0) continue;
    const double time_on = dt - way.time_back;
    const DirectionMotion on{displacement[k] - way.back, 0, time_on, compression, way.on / time_on};
    const DirectionMotion back{displacement[k], rate[k], way.time_back, compression, way.back / way.time_back};
    const DirectionResponse r = respond(b.law[k], back, respond(b.law[k], on, state.bearing[i].direction[k]).memory);
    const DirectionMemory& now = work.bearing[i].direction[k];
    sum += 0.5 * std::abs((now.force + now.damping - r.force()) * way.back);
  }
  return sum;
}

DirectionMemory memory_at(const DirectionLaw& law, double displacement) {
  return std::visit(
      [&](const auto& l) {
        if constexpr (requires { l.begin_at(displacement); })
          return l.begin_at(displacement);
        else
          return DirectionMemory{};
      },
      law);
}

}  // namespace

/// Sliders and dashpots begin where they are, springs with what their displacement asks: that energy is new.
double begin_bearing(const Model<2>& model, const State<2>& state, Work<2>& work, int i) {
  const Bearing<2>& b = model.bearings[i];
  BearingMemory& begun = work.bearing[i];
  begun = {};
  const RelativeMotion m = relative_motion(model, state, b);
  const std::array<double, 3> displacement{m.displacement.x(), m.displacement.y(), m.angle};
  double stored = 0, compression = 0;
  for (const int k : {axial, along, turning}) {
    const DirectionMotion at_rest{displacement[k], 0, 0, compression};
    const DirectionResponse r = respond(b.law[k], at_rest, memory_at(b.law[k], displacement[k]));
    begun.direction[k] = r.memory;
    stored += r.stored;
    if (k == axial) compression = std::max(0.0, -r.memory.force);
  }
  return stored;
}

void respond_bearings(const Model<2>& model, const State<2>& state, Work<2>& work, double dt) {
  const std::size_t count = model.bearings.size();
  work.bearing.resize(count);
  work.bearing_force.assign(count, Vec2::Zero());
  work.bearing_moment.assign(count, 0.0);
  work.bearing_displacement.resize(count, Vec2::Zero());
  work.bearing_energy.assign(count, 0.0);
  work.bearing_stored = 0;
  for (std::size_t i = 0; i < count; ++i) {
    work.bearing[i] = state.bearing[i];
    if (is_live(state.bearing[i].status)) respond_live(model, state, work, i, dt);
  }
}

double bearings_turned_back(const Model<2>& model, const State<2>& state, const Work<2>& work, double dt) {
  double sum = 0;
  for (std::size_t i = 0; i < model.bearings.size(); ++i)
    if (is_live(state.bearing[i].status)) sum += turned_back(model, state, work, i, dt);
  return sum;
}

}  // namespace trilith
