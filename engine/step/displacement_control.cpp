#include "step/displacement_control.hpp"

#include <algorithm>

#include "step/node_forces.hpp"
#include "world/loads.hpp"

namespace trilith {
namespace {

/// What a unit of the push's force is on x, y and rotation of a point's node.
Dofs lever_of(const State<2>& state, const Push& push, const PushRow& row) {
  const Vec2 arm = Turn(state.rotation[row.node]).apply(row.place), &d = push.direction;
  return {row.weight * d.x(), row.weight * d.y(), row.weight * cross(arm, d)};
}

/// Rate of the push's displacement after the step, and how much a unit of force changes it.
struct Response {
  double rate = 0, per_force = 0;
};

/// The velocity after the step under the forces of now, weighed as the push weighs its points, and sum of w^2 / m
/// times the time over which a force acts on a leapfrog velocity, the mean of the steps behind and ahead.
Response respond(const Model<2>& model, const State<2>& state, const Work<2>& work, const Push& push,
                 const StepOptions& options, const RestDamping& rest) {
  const Outside outside(model, state, work);
  const double span = 0.5 * (state.last_dt + options.dt);
  Response r;
  for (const PushRow& row : push.rows) {
    const int n = row.node;
    const Dofs v = velocity_of(state, n), mass = mass_of(model, n), lever = lever_of(state, push, row);
    const NodeForces f = node_forces(model, work, n, v, outside, rest);
    const Dofs next = speed_ahead(model, state, n, v, f, span, options.dt);
    for (const int k : {0, 1, 2}) {
      if (lever[k] == 0) continue;
      r.rate += lever[k] * next[k];
      if (model.support[n][k] == Support::free) r.per_force += lever[k] * lever[k] / mass[k] * span;
    }
  }
  return r;
}

void add(const State<2>& state, const Push& push, double size, std::vector<Vec2>& force, std::vector<double>& moment) {
  for (const PushRow& row : push.rows) {
    const Dofs lever = lever_of(state, push, row);
    force[row.node] += size * Vec2(lever[0], lever[1]);
    moment[row.node] += size * lever[2];
  }
}

void find_unbalanced(const Model<2>& model, Work<2>& work) {
  double most = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    if (!model.moves(n)) continue;
    Vec2 left = work.force[n];
    for (const int k : {0, 1})
      if (model.support[n][k] != Support::free) left[k] = 0;
    most = std::max(most, left.norm());
  }
  work.unbalanced = most;
}

}  // namespace

void control_displacement(const Model<2>& model, const State<2>& state, Work<2>& work, const StepOptions& options) {
  if (model.pushes.empty()) return;
  work.trim.assign(work.load.size(), Vec2::Zero());
  work.trim_moment.assign(work.load.size(), 0);
  for (std::size_t i = 0; i < model.pushes.size(); ++i) {
    const Push& push = model.pushes[i];
    // Where the points are to be at the end of the step, over its length: the velocity they need.
    const double then = push.origin + push.motion->displacement(state.time + options.dt - push.start);
    const double rate = (then - push_place(state, push)) / options.dt;
    const Response free = respond(model, state, work, push, options, {});
    if (!(free.per_force > 0)) continue;  // all held
    const double force = (rate - free.rate) / free.per_force;
    add(state, push, force, work.load, work.load_moment);
    add(state, push, force, work.force, work.moment);
    // With `force` in place the node is nearly balanced, so RestDamping finds little to answer; what it takes is the
    // trim.
    const Response damped = respond(model, state, work, push, options, options.rest);
    const double more = (rate - damped.rate) / damped.per_force;
    add(state, push, more, work.trim, work.trim_moment);
    work.push_force[i] = force;
  }
  // The push has changed what is left over on the nodes it acts on.
  find_unbalanced(model, work);
}

}  // namespace trilith
