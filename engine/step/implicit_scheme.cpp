// Into an implicit scheme and out of it, and the ledger under it.
#include "step/implicit_step.hpp"
#include "step/node_forces.hpp"
#include "step/stored_energy.hpp"

namespace trilith {
namespace {

/// Half of the step behind of a node.
Dofs<2> half_behind(const State<2>& s, int n) {
  const Vec2 path = s.position[n] - s.position_before[n];
  return {0.5 * path.x(), 0.5 * path.y(), 0.5 * (s.rotation[n] - s.rotation_before[n])};
}

/// Work of all nodes along half of the step behind, at the instant of the last evaluation.
void add_half_behind(const Model<2>& model, const State<2>& state, const Work<2>& work, Energy& given) {
  const Outside outside(model, state, work);
  for (int n = 0; n < model.nodes(); ++n)
    add_work(node_forces(model, state, work, n, velocity_of(state, n), outside, {}), half_behind(state, n), given);
}

}  // namespace

double implicit_kinetic(const Model<2>& model, const State<2>& state) {
  double sum = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs<2> mass = mass_of(model, n), v = velocity_of(state, n);
    for (const int k : {0, 1, 2})
      if (model.support[n][k] == Support::free) sum += 0.5 * mass[k] * v[k] * v[k];
  }
  return sum;
}

void begin_implicit(const Model<2>& model, State<2>& state, const Work<2>& work) {
  if (state.implicit()) return;
  const Outside outside(model, state, work);
  const auto nodes = static_cast<std::size_t>(model.nodes());
  state.acceleration.assign(nodes, Vec2::Zero());
  state.spin_rate.assign(nodes, 0);
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs<2> v = velocity_of(state, n), mass = mass_of(model, n);
    const NodeForces<2> f = node_forces(model, state, work, n, v, outside, {});
    const double half = 0.5 * state.last_dt;
    add_work(f, {half * v[0], half * v[1], half * v[2]}, state.given);
    for (const int k : {0, 1, 2}) {
      if (model.support[n][k] != Support::free) continue;
      const double a = f.force[k] / mass[k];
      (k == 2 ? state.spin_rate[n] : state.acceleration[n][k]) = a;
      (k == 2 ? state.spin[n] : state.velocity[n][k]) += half * a;
    }
  }
  state.position_before = state.position;
  state.rotation_before = state.rotation;
  state.last_dt = 0;
}

void begin_explicit(const Model<2>& model, State<2>& state, const Work<2>& work) {
  if (!state.implicit()) return;
  add_half_behind(model, state, work, state.given);
  state.position_before.clear(), state.rotation_before.clear();
  state.acceleration.clear(), state.spin_rate.clear();
  state.most_energy = 0;
  state.tangent.reset();
  state.last_dt = 0;
}

Energy implicit_energy(const Model<2>& model, const State<2>& state, const Work<2>& work) {
  Energy energy = work.given;
  add_half_behind(model, state, work, energy);
  energy[EnergyTerm::kinetic] = implicit_kinetic(model, state);
  energy[EnergyTerm::strain] = work.element_stored;
  energy[EnergyTerm::contact_elastic] = contact_energy(model, state, work);
  energy[EnergyTerm::bearing_elastic] = work.bearing_stored;
  return energy;
}

}  // namespace trilith
