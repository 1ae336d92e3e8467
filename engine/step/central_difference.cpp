#include "step/central_difference.hpp"

#include "step/lead.hpp"
#include "step/node_forces.hpp"
#include "step/notice.hpp"
#include "step/stored_energy.hpp"

namespace trilith {
namespace {

[[gnu::always_inline]] inline double dot(const Dofs& a, const Dofs& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Work of weight, loads, supports and dampings along `path`. A step's path is half a step's at either velocity, before
/// and after the instant of the forces: the work a leapfrog step really does.
[[gnu::always_inline]] inline void add_work(const NodeForces& f, const Dofs& path, Energy& given) {
  given[EnergyTerm::gravity] -= dot(f.weight, path);
  given[EnergyTerm::load] += dot(f.load, path);
  if (f.held) given[EnergyTerm::support] -= dot(f.on_support, path);
  given[EnergyTerm::element_damping] -= f.element_damping[0] * path[0] + f.element_damping[1] * path[1];
  if (!f.damped) return;
  given[EnergyTerm::rest_damping] -= dot(f.rest, path);
  given[EnergyTerm::mass_damping] -= dot(f.mass, path);
}

/// Of the leapfrog scheme: half of m v(-) v(+), which together with the potential is kept exactly; m v^2 / 2 at the
/// very start, where there is no step behind.
double kinetic_energy(const Model<2>& model, const State<2>& state, int n, const Dofs& v, const Dofs& next) {
  const Dofs mass = mass_of(model, n);
  double sum = 0;
  for (const int k : {0, 1, 2})
    if (model.support[n][k] == Support::free) sum += 0.5 * mass[k] * v[k] * (state.last_dt > 0 ? next[k] : v[k]);
  return sum;
}

}  // namespace

Energy energy_now(const Model<2>& model, const State<2>& state, const Work<2>& work, const StepOptions& options) {
  Energy energy = work.given;
  const double span = 0.5 * (state.last_dt + options.dt);
  const Outside outside(model, state, work);
  double kinetic = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs v = velocity_of(state, n);
    const double half = 0.5 * state.last_dt;
    const NodeForces f = node_forces(model, work, n, v, outside, options.rest);
    add_work(f, {half * v[0], half * v[1], half * v[2]}, energy);
    kinetic += kinetic_energy(model, state, n, v, speed_ahead(model, state, n, v, f, span, options.dt));
  }
  energy[EnergyTerm::kinetic] = kinetic;
  energy[EnergyTerm::strain] = work.element_stored;
  energy[EnergyTerm::contact_elastic] = contact_energy(model, state, work);
  energy[EnergyTerm::bearing_elastic] = work.bearing_stored;
  return energy;
}

void advance(const Model<2>& model, State<2>& state, Work<2>& work, const StepOptions& options, StepTimes* times) {
  StepClock clock(times);
  lead(model, state, work, options);
  notice(model, state, work);
  clock.mark(StepPart::notice);
  state.memory.swap(work.memory);
  state.bearing.swap(work.bearing);
  state.plastic.swap(work.plastic);
  const double dt = options.dt, last = state.last_dt, span = 0.5 * (last + dt);
  const Outside outside(model, state, work);
  Energy given = work.given;
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs v = velocity_of(state, n);
    const NodeForces f = node_forces(model, work, n, v, outside, options.rest);
    const Dofs next = speed_ahead(model, state, n, v, f, span, dt);
    Dofs path;
    for (const int k : {0, 1, 2}) path[k] = 0.5 * (last * v[k] + dt * next[k]);
    add_work(f, path, given);
    state.velocity[n] = {next[0], next[1]};
    state.spin[n] = next[2];
    state.position[n] += Vec2(dt * next[0], dt * next[1]);
    state.rotation[n] += dt * next[2];
  }
  state.given = given;
  state.time += dt;
  state.last_dt = dt;
  ++state.step;
  clock.mark(StepPart::advance);
}

}  // namespace trilith
