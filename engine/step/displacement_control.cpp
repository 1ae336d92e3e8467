#include "step/displacement_control.hpp"

#include <algorithm>

#include "step/node_forces.hpp"
#include "world/loads.hpp"

namespace trilith {
namespace {

/// What a unit of the push's force is about the node that turns row `i`: of all rows that turn with it, given once,
/// with the first of them.
double lever_about(const State<2>& state, const Push<2>& push, std::size_t i) {
  const int node = push.rows[i].turn;
  const auto levers = [&](const PushRow<2>& row) { return row.turn == node && !row.place.isZero(0); };
  if (!levers(push.rows[i]) ||
      std::any_of(push.rows.begin(), push.rows.begin() + static_cast<std::ptrdiff_t>(i), levers))
    return 0;
  double sum = 0;
  for (std::size_t k = i; k < push.rows.size(); ++k)
    if (const PushRow<2>& row = push.rows[k]; levers(row))
      sum += row.weight * cross(Turn(state.rotation[node]).apply(row.place), push.direction);
  return sum;
}

/// Rate of the push's displacement after the step, and how much a unit of force changes it.
struct Response {
  double rate = 0, per_force = 0;
};

/// The velocity after the step under the forces of now, weighed as the push weighs its points, and sum of w^2 / m
/// times the time over which a force acts on a leapfrog velocity, the mean of the steps behind and ahead.
Response respond(const Model<2>& model, const State<2>& state, const Work<2>& work, const Push<2>& push,
                 const StepOptions& options, const RestDamping& rest) {
  const Outside outside(model, state, work);
  const double span = 0.5 * (state.last_dt + options.dt);
  Response r;
  const auto add = [&](int n, int k, double lever) {
    if (lever == 0) return;
    const Dofs<2> v = velocity_of(state, n);
    const NodeForces<2> f = node_forces(model, state, work, n, v, outside, rest);
    r.rate += lever * speed_ahead(model, state, n, v, f, span, options.dt)[k];
    if (model.support[n][k] == Support::free) r.per_force += lever * lever / mass_of(model, state, n)[k] * span;
  };
  for (std::size_t i = 0; i < push.rows.size(); ++i) {
    const PushRow<2>& row = push.rows[i];
    for (const int k : {0, 1}) add(row.node, k, row.weight * push.direction[k]);
    add(row.turn, 2, lever_about(state, push, i));
  }
  return r;
}

void add(const State<2>& state, const Push<2>& push, double size, std::vector<Vec2>& force,
         std::vector<double>& moment) {
  for (std::size_t i = 0; i < push.rows.size(); ++i) {
    const PushRow<2>& row = push.rows[i];
    force[row.node] += size * Vec2(row.weight * push.direction);
    moment[row.turn] += size * lever_about(state, push, i);
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
  work.correction.assign(work.load.size(), Vec2::Zero());
  work.correction_moment.assign(work.load.size(), 0);
  for (std::size_t i = 0; i < model.pushes.size(); ++i) {
    const Push<2>& push = model.pushes[i];
    const double then = push.origin + push.motion->displacement(state.time + options.dt - push.start);
    const double rate = (then - push_place(state, push)) / options.dt;
    const Response free = respond(model, state, work, push, options, {});
    if (!(free.per_force > 0)) continue;  // all held
    const double force = (rate - free.rate) / free.per_force;
    add(state, push, force, work.load, work.load_moment);
    add(state, push, force, work.force, work.moment);
    // With `force` in place the node is nearly balanced, so RestDamping finds little to answer; what it takes is the
    // correction.
    const Response damped = respond(model, state, work, push, options, options.rest);
    const double more = (rate - damped.rate) / damped.per_force;
    add(state, push, more, work.correction, work.correction_moment);
    work.push_force[i] = force;
  }
  // The push has changed what is left over on the nodes it acts on.
  find_unbalanced(model, work);
}

}  // namespace trilith
