// Into an implicit scheme and out of it, and the ledger under it.
#include "step/consistent_mass.hpp"
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
  std::vector<Dofs<2>> added;
  added_inertia(model, state, true, added);
  for (std::size_t n = 0; n < added.size(); ++n) {
    const int node = static_cast<int>(n);
    given[EnergyTerm::support] += work_on_support(model, node, added[n], half_behind(state, node));
  }
}

/// Accelerations as the scheme begins, of consistent mass: what lumped one gives would make them ring.
void begin_consistent(const Model<2>& model, State<2>& state, std::vector<Dofs<2>> force) {
  std::vector<Dofs<2>> added;
  added_inertia(model, state, false, added);
  for (std::size_t n = 0; n < force.size(); ++n)
    for (const int k : {0, 1, 2}) force[n][k] -= added[n][k];
  const std::vector<Dofs<2>> a = accelerations(model, state, force);
  for (std::size_t n = 0; n < a.size(); ++n) {
    for (const int k : {0, 1})
      if (model.support[n][k] == Support::free) state.acceleration[n][k] = a[n][k];
    if (model.support[n][2] == Support::free) state.spin_rate[n] = a[n][2];
  }
}

}  // namespace

double implicit_kinetic(const Model<2>& model, const State<2>& state) {
  double sum = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs<2> mass = mass_of(model, n), v = velocity_of(state, n);
    for (const int k : {0, 1, 2})
      if (model.support[n][k] == Support::free) sum += 0.5 * mass[k] * v[k] * v[k];
  }
  return model.beam_inertias.empty() ? sum : sum + added_kinetic(model, state);
}

void begin_implicit(const Model<2>& model, State<2>& state, const Work<2>& work) {
  if (state.implicit()) return;
  const Outside outside(model, state, work);
  const auto nodes = static_cast<std::size_t>(model.nodes());
  state.acceleration.assign(nodes, Vec2::Zero());
  state.spin_rate.assign(nodes, 0);
  std::vector<Dofs<2>> force;
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
    if (!model.beam_inertias.empty()) force.push_back(f.force);
  }
  if (!force.empty()) {
    begin_consistent(model, state, std::move(force));
    state.given[EnergyTerm::numerical] -= added_kinetic(model, state);
  }
  state.position_before = state.position;
  state.rotation_before = state.rotation;
  state.last_dt = 0;
}

void begin_explicit(const Model<2>& model, State<2>& state, const Work<2>& work) {
  if (!state.implicit()) return;
  add_half_behind(model, state, work, state.given);
  state.given[EnergyTerm::numerical] += added_kinetic(model, state);
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
