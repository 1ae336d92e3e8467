// Into an implicit scheme and out of it, and the ledger under it.
#include "step/consistent_mass.hpp"
#include "step/implicit_step.hpp"
#include "step/node_forces.hpp"
#include "step/stored_energy.hpp"

namespace trilith {
namespace {

// The ledger of an implicit scheme takes the work of outside forces by the trapezoidal rule,
//
//     W = sum over steps of (F_n + F_n+1) / 2 . (x_n+1 - x_n),
//
// so at any instant the half that belongs to the force of now, F . (x_n - x_n-1) / 2, is still to be added: it is added
// to what is shown, and to the sums themselves as the scheme ends.

/// Half of the step behind of a node.
Dofs<2> half_behind(const State<2>& s, int n) {
  const Vec2 path = s.position[n] - s.position_before[n];
  return {0.5 * path.x(), 0.5 * path.y(), 0.5 * (s.rotation[n] - s.rotation_before[n])};
}

/// Work of all nodes along half of the step behind, at the instant of the last evaluation.
void add_half_behind(const Model<2>& model, const State<2>& state, const Work<2>& work, Energy& given) {
  const std::vector<NodeForces<2>> forces = implicit_forces(model, state, work);
  for (int n = 0; n < model.nodes(); ++n) add_work(forces[n], half_behind(state, n), given);
  std::vector<Dofs<2>> added;
  added_inertia(model, state, true, added);
  for (std::size_t n = 0; n < added.size(); ++n) {
    const int node = static_cast<int>(n);
    given[EnergyTerm::support] += work_on_support(model, node, added[n], half_behind(state, node));
  }
}

/// Accelerations as the scheme begins, of consistent mass: what lumped one gives would make them ring.
void begin_consistent(const Model<2>& model, State<2>& state, std::vector<Dofs<2>> force) {
  std::vector<Dofs<2>> added, damped;
  added_inertia(model, state, false, added);
  added_damping(model, state, damped);
  for (std::size_t n = 0; n < force.size(); ++n)
    for (const int k : {0, 1, 2}) force[n][k] -= added[n][k] - (damped.empty() ? 0 : damped[n][k]);
  const std::vector<Dofs<2>> a = accelerations(model, state, force);
  for (std::size_t n = 0; n < a.size(); ++n) {
    for (const int k : {0, 1})
      if (model.support[n][k] == Support::free) state.acceleration[n][k] = a[n][k];
    if (model.support[n][2] == Support::free) state.spin_rate[n] = a[n][2];
  }
}

}  // namespace

/// m v^2 / 2 of the whole instant: velocities of an implicit scheme stand at the same time as places.
double implicit_kinetic(const Model<2>& model, const State<2>& state) {
  double sum = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs<2> mass = mass_of(model, n), v = velocity_of(state, n);
    for (const int k : {0, 1, 2})
      if (model.support[n][k] == Support::free) sum += 0.5 * mass[k] * v[k] * v[k];
  }
  return model.beam_inertias.empty() ? sum : sum + added_kinetic(model, state);
}

/// From leapfrog, whose velocities stand half a step behind: they are brought up by a dt / 2, the half step of work is
/// booked, and a = F / m starts the scheme. The step that was is then of length 0: nothing is half behind.
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

/// The velocities of now serve as those of a half step of length 0, which is how leapfrog begins.
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
