#include "step/central_difference.hpp"

#include <cmath>

#include "step/notice.hpp"
#include "step/stored_energy.hpp"

namespace trilith {
namespace {

/// Forces of one node at an instant, on its free degrees of freedom, and what the supports take on the others.
struct NodeForces {
  Vec2 force = Vec2::Zero(), weight = Vec2::Zero(), load = Vec2::Zero(), rest = Vec2::Zero(), mass = Vec2::Zero();
  double moment = 0, rest_moment = 0, mass_moment = 0;
  Vec2 on_support = Vec2::Zero();
  double moment_on_support = 0;
};

NodeForces node_forces(const Model<2>& model, const State<2>& state, const Work<2>& work, int n, const Vec2& field,
                       const RestDamping& rest) {
  NodeForces f;
  const auto& support = model.support[n];
  const double mass = model.mass[n];
  for (const int k : {0, 1}) {
    if (support[k] == Support::free) {
      f.force[k] = work.force[n][k];
      f.weight[k] = mass * field[k];
      f.load[k] = model.load[n][k];
      f.mass[k] = -model.mass_damping * mass * state.velocity[n][k];
    } else {
      f.on_support[k] = work.force[n][k] - mass * field[k] - model.load[n][k];
    }
  }
  if (support[2] == Support::free) {
    f.moment = work.moment[n];
    f.mass_moment = -model.mass_damping * model.inertia[n] * state.spin[n];
  } else {
    f.moment_on_support = work.moment[n];
  }
  if (rest.share > 0) {
    const double speed = state.velocity[n].norm();
    if (speed > 0) f.rest = -rest.share * f.force.norm() / speed * state.velocity[n];
    if (state.spin[n] != 0) f.rest_moment = -std::copysign(rest.share * std::abs(f.moment), state.spin[n]);
  }
  f.force += f.rest + f.mass;
  f.moment += f.rest_moment + f.mass_moment;
  return f;
}

/// Velocity and spin of a node.
struct NodeSpeed {
  Vec2 velocity;
  double spin;
};

/// Half a step or so on: free degrees of freedom by their forces, driven ones by their motion, fixed ones still.
NodeSpeed speed_ahead(const Model<2>& model, const State<2>& state, int n, const NodeForces& f, double span,
                      double dt) {
  NodeSpeed next{state.velocity[n], state.spin[n]};
  const auto& support = model.support[n];
  const auto driven = [&](int k, double now) {
    const Drive& drive = model.drives[model.drive_of[n][k]];
    return (drive.origin + drive.motion->displacement(state.time + dt - drive.start) - now) / dt;
  };
  for (const int k : {0, 1}) {
    if (support[k] == Support::free) next.velocity[k] += f.force[k] / model.mass[n] * span;
    if (support[k] == Support::fixed) next.velocity[k] = 0;
    if (support[k] == Support::driven) next.velocity[k] = driven(k, state.position[n][k]);
  }
  if (support[2] == Support::free) next.spin += f.moment / model.inertia[n] * span;
  if (support[2] == Support::fixed) next.spin = 0;
  if (support[2] == Support::driven) next.spin = driven(2, state.rotation[n]);
  return next;
}

/// Work of weight, loads, supports and dampings over half a step at one velocity. Two halves, before and after the
/// instant of the forces, make the work a leapfrog step really does.
void add_half_step(const NodeForces& f, const Vec2& velocity, double spin, double half, Energy& given) {
  given[EnergyTerm::gravity] -= half * f.weight.dot(velocity);
  given[EnergyTerm::load] += half * f.load.dot(velocity);
  given[EnergyTerm::support] -= half * (f.on_support.dot(velocity) + f.moment_on_support * spin);
  given[EnergyTerm::rest_damping] -= half * (f.rest.dot(velocity) + f.rest_moment * spin);
  given[EnergyTerm::mass_damping] -= half * (f.mass.dot(velocity) + f.mass_moment * spin);
}

/// Of the leapfrog scheme: half of m v(-) v(+), which together with the potential is kept exactly; m v^2 / 2 at the
/// very start, where there is no step behind.
double kinetic_energy(const Model<2>& model, const State<2>& state, int n, const NodeSpeed& next) {
  double sum = 0;
  const bool started = state.last_dt > 0;
  const auto& support = model.support[n];
  const Vec2& v = state.velocity[n];
  for (const int k : {0, 1})
    if (support[k] == Support::free) sum += 0.5 * model.mass[n] * v[k] * (started ? next.velocity[k] : v[k]);
  if (support[2] == Support::free)
    sum += 0.5 * model.inertia[n] * state.spin[n] * (started ? next.spin : state.spin[n]);
  return sum;
}

}  // namespace

Energy energy_now(const Model<2>& model, const State<2>& state, const Work<2>& work, const StepOptions& options) {
  Energy energy = work.given;
  const double span = 0.5 * (state.last_dt + options.dt);
  const Vec2 field = model.gravity.at(state.time);
  double kinetic = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    const NodeForces f = node_forces(model, state, work, n, field, options.rest);
    add_half_step(f, state.velocity[n], state.spin[n], 0.5 * state.last_dt, energy);
    kinetic += kinetic_energy(model, state, n, speed_ahead(model, state, n, f, span, options.dt));
  }
  energy[EnergyTerm::kinetic] = kinetic;
  energy[EnergyTerm::contact_elastic] = contact_energy(model, state, work);
  energy[EnergyTerm::bearing_elastic] = work.bearing_stored;
  return energy;
}

void advance(const Model<2>& model, State<2>& state, Work<2>& work, const StepOptions& options) {
  notice(model, state, work);
  state.memory.swap(work.memory);
  state.bearing.swap(work.bearing);
  state.given = work.given;
  const double dt = options.dt, span = 0.5 * (state.last_dt + dt);
  const Vec2 field = model.gravity.at(state.time);
  for (int n = 0; n < model.nodes(); ++n) {
    const NodeForces f = node_forces(model, state, work, n, field, options.rest);
    const NodeSpeed next = speed_ahead(model, state, n, f, span, dt);
    add_half_step(f, state.velocity[n], state.spin[n], 0.5 * state.last_dt, state.given);
    add_half_step(f, next.velocity, next.spin, 0.5 * dt, state.given);
    state.velocity[n] = next.velocity;
    state.spin[n] = next.spin;
    state.position[n] += dt * next.velocity;
    state.rotation[n] += dt * next.spin;
  }
  state.time += dt;
  state.last_dt = dt;
  ++state.step;
}

}  // namespace trilith
