#include "step/central_difference.hpp"

#include <array>
#include <cmath>

#include "step/notice.hpp"
#include "step/stored_energy.hpp"

namespace trilith {
namespace {

/// One number for each degree of freedom of a node: x, y, rotation. Plain doubles: this is run for every node at every
/// step, and vectors of two go through memory.
using Dofs = std::array<double, 3>;

Dofs velocity_of(const State<2>& state, int n) {
  return {state.velocity[n].x(), state.velocity[n].y(), state.spin[n]};
}

Dofs mass_of(const Model<2>& model, int n) {
  return {model.mass[n], model.mass[n], model.inertia[n]};
}

/// Forces of one node at an instant, on its free degrees of freedom, and what the supports take on the others.
struct NodeForces {
  Dofs force{}, weight{}, load{}, rest{}, mass{}, on_support{};
  std::array<double, 2> element_damping{};
  bool held = false, damped = false;  ///< some degree of freedom is not free; there are dampings of the node
};

/// Dampings that belong to whole nodes.
void add_dampings(const Model<2>& model, int n, const Dofs& v, const RestDamping& rest, NodeForces& f) {
  const Dofs mass = mass_of(model, n);
  if (rest.share > 0) {
    const double speed = std::sqrt(v[0] * v[0] + v[1] * v[1]);
    const double brake = rest.share * std::sqrt(f.force[0] * f.force[0] + f.force[1] * f.force[1]);
    for (const int k : {0, 1})
      if (speed > 0) f.rest[k] = -brake / speed * v[k];
    if (v[2] != 0) f.rest[2] = -std::copysign(rest.share * std::abs(f.force[2]), v[2]);
  }
  for (const int k : {0, 1, 2}) {
    if (model.support[n][k] == Support::free) f.mass[k] = -model.mass_damping * mass[k] * v[k];
    f.force[k] += f.rest[k] + f.mass[k];
  }
}

[[gnu::always_inline]] inline NodeForces node_forces(const Model<2>& model, const Work<2>& work, int n, const Dofs& v,
                                                     const Vec2& field, const RestDamping& rest) {
  NodeForces f;
  const auto& support = model.support[n];
  const double mass = model.mass[n];
  const Dofs total{work.force[n].x(), work.force[n].y(), work.moment[n]};
  const Dofs weight{mass * field.x(), mass * field.y(), 0}, load{model.load[n].x(), model.load[n].y(), 0};
  f.held = support[0] != Support::free || support[1] != Support::free || support[2] != Support::free;
  f.force = total, f.weight = weight, f.load = load;
  if (!work.element_damping.empty()) f.element_damping = {work.element_damping[n].x(), work.element_damping[n].y()};
  for (const int k : {0, 1, 2}) {
    if (!f.held || support[k] == Support::free) continue;
    f.force[k] = f.weight[k] = f.load[k] = 0;
    f.on_support[k] = total[k] - weight[k] - load[k];
  }
  f.damped = rest.share > 0 || model.mass_damping > 0;
  if (f.damped) add_dampings(model, n, v, rest, f);
  return f;
}

/// Velocity of a driven degree of freedom that brings it to its motion's place at the end of the step.
double driven_velocity(const Model<2>& model, const State<2>& state, int n, int k, double dt) {
  const Drive& drive = model.drives[model.drive_of[n][k]];
  const double now = k == 2 ? state.rotation[n] : state.position[n][k];
  return (drive.origin + drive.motion->displacement(state.time + dt - drive.start) - now) / dt;
}

/// Half a step or so on: free degrees of freedom by their forces, driven ones by their motion, fixed ones still.
[[gnu::always_inline]] inline Dofs speed_ahead(const Model<2>& model, const State<2>& state, int n, const Dofs& v,
                                               const NodeForces& f, double span, double dt) {
  Dofs next{};
  const Dofs mass = mass_of(model, n);
  for (const int k : {0, 1, 2}) {
    const Support support = model.support[n][k];
    if (support == Support::free) next[k] = v[k] + f.force[k] / mass[k] * span;
    if (support == Support::driven) next[k] = driven_velocity(model, state, n, k, dt);
  }
  return next;
}

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
  const Vec2 field = model.gravity.at(state.time);
  double kinetic = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs v = velocity_of(state, n);
    const double half = 0.5 * state.last_dt;
    const NodeForces f = node_forces(model, work, n, v, field, options.rest);
    add_work(f, {half * v[0], half * v[1], half * v[2]}, energy);
    kinetic += kinetic_energy(model, state, n, v, speed_ahead(model, state, n, v, f, span, options.dt));
  }
  energy[EnergyTerm::kinetic] = kinetic;
  energy[EnergyTerm::strain] = work.element_stored;
  energy[EnergyTerm::contact_elastic] = contact_energy(model, state, work);
  energy[EnergyTerm::bearing_elastic] = work.bearing_stored;
  return energy;
}

void advance(const Model<2>& model, State<2>& state, Work<2>& work, const StepOptions& options) {
  notice(model, state, work);
  state.memory.swap(work.memory);
  state.bearing.swap(work.bearing);
  state.plastic.swap(work.plastic);
  const double dt = options.dt, last = state.last_dt, span = 0.5 * (last + dt);
  const Vec2 field = model.gravity.at(state.time);
  Energy given = work.given;
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs v = velocity_of(state, n);
    const NodeForces f = node_forces(model, work, n, v, field, options.rest);
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
}

}  // namespace trilith
