#include "statics/displacement_control.hpp"

#include <algorithm>

#include "assembly/node_forces.hpp"
#include "element/rigid/rigid_turn.hpp"
#include "model/pushes.hpp"

namespace trilith {
namespace {

/// Moment per unit of the push's force about the node that rotates row `i`: the sum of all rows that rotate with it,
/// returned once, with the first of them.
template <int D>
Moment<D> lever_about(const State<D>& state, const Push<D>& push, std::size_t i) {
  const int node = push.rows[i].turn;
  const auto levers = [&](const PushRow<D>& row) { return row.turn == node && !row.place.isZero(0); };
  Moment<D> sum = nothing<Moment<D>>();
  if (!levers(push.rows[i]) ||
      std::any_of(push.rows.begin(), push.rows.begin() + static_cast<std::ptrdiff_t>(i), levers))
    return sum;
  for (std::size_t k = i; k < push.rows.size(); ++k)
    if (const PushRow<D>& row = push.rows[k]; levers(row))
      sum += row.weight * cross(Vec<D>(turn_of(state.rotation[node]).apply(row.place)), push.direction);
  return sum;
}

/// Rate of the push's displacement after the step, and its change per unit of force.
struct Response {
  double rate = 0, per_force = 0;
};

/// Adds the contribution of a rotating node with the spin `next`: l . w, and l . J^-1 l span for the free rotations.
void add_turning(const Model<2>& model, const State<2>& /*state*/, int n, double lever, double next, double span,
                 Response& r) {
  r.rate += lever * next;
  if (model.support[n][2] == Support::free) r.per_force += lever * lever / model.inertia[n] * span;
}
void add_turning(const Model<3>& model, const State<3>& state, int n, const Vec3& lever, const Vec3& next, double span,
                 Response& r) {
  r.rate += lever.dot(next);
  r.per_force += span * lever.dot(spin_rate_by(model.inertia[n], state.rotation[n], lever, free_turns(model, n)));
}

/// The weighted velocity of the pushed points after the step under the present forces. Also the sum of w^2 / m times
/// the time over which a force acts on a leapfrog velocity, which is the mean of the last and the next step.
template <int D>
Response respond(const Model<D>& model, const State<D>& state, const Work<D>& work, const Push<D>& push,
                 const StepOptions& options, const RestDamping& rest) {
  const Outside<D> outside(model, state, work);
  const double span = 0.5 * (state.last_dt + options.dt);
  const auto ahead = [&](int n) {
    const Dofs<D> v = velocity_of(state, n);
    return speed_ahead(model, state, n, v, node_forces(model, state, work, n, v, outside, rest), span, options.dt);
  };
  Response r;
  for (std::size_t i = 0; i < push.rows.size(); ++i) {
    const PushRow<D>& row = push.rows[i];
    const Dofs<D> next = ahead(row.node);
    for (int k = 0; k < Space<D>::translations; ++k) {
      const double share = row.weight * push.direction[k];
      if (share == 0) continue;
      r.rate += share * next[k];
      if (model.support[row.node][k] == Support::free) r.per_force += share * share / model.mass[row.node] * span;
    }
    const Moment<D> lever = lever_about(state, push, i);
    if (lever != nothing<Moment<D>>()) add_turning(model, state, row.turn, lever, about_of(ahead(row.turn)), span, r);
  }
  return r;
}

template <int D>
void add(const State<D>& state, const Push<D>& push, double size, std::vector<Vec<D>>& force,
         std::vector<Moment<D>>& moment) {
  for (std::size_t i = 0; i < push.rows.size(); ++i) {
    const PushRow<D>& row = push.rows[i];
    force[row.node] += size * Vec<D>(row.weight * push.direction);
    moment[row.turn] += size * lever_about(state, push, i);
  }
}

template <int D>
void find_unbalanced(const Model<D>& model, Work<D>& work) {
  double most = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    if (!model.moves(n)) continue;
    Vec<D> left = work.force[n];
    for (int k = 0; k < Space<D>::translations; ++k)
      if (model.support[n][k] != Support::free) left[k] = 0;
    most = std::max(most, left.norm());
  }
  work.unbalanced = most;
}

}  // namespace

template <int D>
void control_displacement(const Model<D>& model, const State<D>& state, Work<D>& work, const StepOptions& options) {
  if (model.pushes.empty() || state.implicit()) return;
  work.correction.assign(work.load.size(), Vec<D>::Zero());
  work.correction_moment.assign(work.load.size(), nothing<Moment<D>>());
  for (std::size_t i = 0; i < model.pushes.size(); ++i) {
    const Push<D>& push = model.pushes[i];
    const double then = push.origin + push.motion->displacement(state.time + options.dt - push.start);
    const double rate = (then - push_place(state, push)) / options.dt;
    const Response free = respond(model, state, work, push, options, {});
    if (!(free.per_force > 0)) continue;  // all fixed
    const double force = (rate - free.rate) / free.per_force;
    add(state, push, force, work.load, work.load_moment);
    add(state, push, force, work.force, work.moment);
    // With `force` applied the node is nearly balanced, so RestDamping is small; its effect is compensated by the
    // correction.
    const Response damped = respond(model, state, work, push, options, options.rest);
    const double more = (rate - damped.rate) / damped.per_force;
    add(state, push, more, work.correction, work.correction_moment);
    work.push_force[i] = force;
  }
  // The push changes the residual of its nodes.
  find_unbalanced(model, work);
}

template void control_displacement(const Model<2>&, const State<2>&, Work<2>&, const StepOptions&);
template void control_displacement(const Model<3>&, const State<3>&, Work<3>&, const StepOptions&);

}  // namespace trilith
