// Begin and end of an implicit scheme, and its energy ledger.
#include "assembly/element/consistent_mass.hpp"
#include "assembly/element/rotary_inertia.hpp"
#include "assembly/implicit_turn.hpp"
#include "assembly/node_forces.hpp"
#include "assembly/stored_energy.hpp"
#include "assembly/water/water_mass.hpp"
#include "assembly/water/water_work.hpp"
#include "integrate/implicit/implicit_step.hpp"

namespace trilith {
namespace {

// The ledger of an implicit scheme integrates the work of external forces by the trapezoidal rule,
//
//     W = sum over steps of (F_n + F_n+1) / 2 . (x_n+1 - x_n).
//
// At any instant the half that belongs to the present force, F . (x_n - x_n-1) / 2, is still missing. It is added to
// the displayed ledger, and to the sums themselves when the scheme ends.

/// Half of the last step of a node.
template <int D>
Dofs<D> half_behind(const State<D>& s, int n) {
  return dofs_of(Vec<D>(0.5 * (s.position[n] - s.position_before[n])),
                 Spin<D>(0.5 * turn_between(s.rotation_before[n], s.rotation[n])));
}

/// Work of all nodes along half of the last step, at the instant of the last evaluation.
template <int D>
void add_half_behind(const Model<D>& model, const State<D>& state, const Work<D>& work, Energy& given) {
  const std::vector<NodeForces<D>> forces = implicit_forces(model, state, work);
  for (int n = 0; n < model.nodes(); ++n) add_work(forces[n], half_behind(state, n), given);
  book_water<D>(model, {work.water, work.water_moment}, given, [&](int n) { return half_behind(state, n); });
  std::vector<Dofs<D>> added;
  added_inertia(model, state, true, added);
  for (std::size_t n = 0; n < added.size(); ++n) {
    const int node = static_cast<int>(n);
    given[EnergyTerm::support] += work_on_support(model, node, added[n], half_behind(state, node));
  }
}

/// Kinetic energy of the consistent mass that explicit steps do not have [J].
template <int D>
double added_beyond_explicit(const Model<D>& model, const State<D>& state) {
  return added_kinetic(model, state) - rotary_energy(model, state) - water_energy(model, state);
}

/// Initial accelerations of the scheme with the consistent mass. Accelerations of the lumped mass would excite spurious
/// vibration.
template <int D>
void begin_consistent(const Model<D>& model, State<D>& state, std::vector<Dofs<D>> force) {
  std::vector<Dofs<D>> added, damped;
  added_inertia(model, state, false, added);
  added_damping(model, state, damped);
  for (std::size_t n = 0; n < force.size(); ++n)
    for (int k = 0; k < Space<D>::dofs; ++k) force[n][k] -= added[n][k] - (damped.empty() ? 0 : damped[n][k]);
  if constexpr (D == 3)
    for (std::size_t n = 0; n < force.size(); ++n) {
      const Vec3 kept = cross(state.spin[n], momentum_of(model.inertia[n], state.rotation[n], state.spin[n]));
      for (int k = 0; k < 3; ++k) force[n][static_cast<std::size_t>(3 + k)] -= kept[k];
    }
  const std::vector<Dofs<D>> a = accelerations(model, state, force);
  for (std::size_t n = 0; n < a.size(); ++n)
    for (int k = 0; k < Space<D>::dofs; ++k) {
      if (model.support[n][k] != Support::free) continue;
      if (k < D)
        state.acceleration[n][k] = a[n][k];
      else
        number_at(k - D, state.spin_rate[n]) = a[n][k];
    }
}

/// Spin and its rate at the instant, from the values half a step before, under the present moment.
void begin_turning(const Model<2>& model, State<2>& state, int n, double moment, double half) {
  if (model.support[n][2] != Support::free) return;
  state.spin_rate[n] = moment / model.inertia[n];
  state.spin[n] += half * state.spin_rate[n];
}
void begin_turning(const Model<3>& model, State<3>& state, int n, const Vec3& moment, double half) {
  const std::array<bool, 3> free = free_turns(model, n);
  if (!free[0] && !free[1] && !free[2]) return;
  const Vec3 spin = spin_ahead(model.inertia[n], state.rotation[n], state.spin[n], moment, half, free, state.spin[n]);
  for (int k = 0; k < 3; ++k)
    if (free[static_cast<std::size_t>(k)]) state.spin[n][k] = spin[k];
  state.spin_rate[n] = spin_rate_under(model, state, n, moment);
}

}  // namespace

/// Kinetic energy m v^2 / 2 at the instant: in an implicit scheme velocities and positions refer to the same time.
template <int D>
double implicit_kinetic(const Model<D>& model, const State<D>& state) {
  double sum = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs<D> mass = mass_of(model, state, n), v = velocity_of(state, n);
    for (int k = 0; k < 3; ++k)
      if (model.support[n][k] == Support::free) sum += 0.5 * mass[k] * v[k] * v[k];
    if constexpr (D == 3) {
      const Vec3 momentum = momentum_of(model.inertia[n], state.rotation[n], state.spin[n]);
      for (int k = 3; k < 6; ++k)
        if (model.support[n][k] == Support::free) sum += 0.5 * v[k] * momentum[k - 3];
    }
  }
  return !has_added_mass(model) ? sum : sum + added_kinetic(model, state);
}

/// Switches from leapfrog, whose velocities lag by half a step: they are advanced by a dt / 2, the work of the half
/// step is booked, and a = F / m starts the scheme. The last step then has length 0, so no half step is outstanding.
template <int D>
void begin_implicit(const Model<D>& model, State<D>& state, const Work<D>& work) {
  if (state.implicit()) return;
  const Outside outside(model, state, work);
  const auto nodes = static_cast<std::size_t>(model.nodes());
  state.acceleration.assign(nodes, Vec<D>::Zero());
  state.spin_rate.assign(nodes, nothing<Spin<D>>());
  std::vector<Dofs<D>> force;
  const bool has_added = has_added_mass(model);
  book_water(model, state, work, state.given, 0.5 * state.last_dt);
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs<D> v = velocity_of(state, n);
    const NodeForces<D> f = node_forces(model, state, work, n, v, outside, {});
    const double half = 0.5 * state.last_dt;
    Dofs<D> path = v;
    for (double& p : path) p *= half;
    add_work(f, path, state.given);
    for (int k = 0; k < Space<D>::translations; ++k) {
      if (model.support[n][k] != Support::free) continue;
      const double a = f.force[k] / model.mass[n];
      state.acceleration[n][k] = a, state.velocity[n][k] += half * a;
    }
    begin_turning(model, state, n, about_of(f.force), half);
    if (!has_added) continue;
    force.push_back(f.force);
    // The forces of explicit steps contain the share of the added mass.
    for (int k = 0; k < D && !work.added_inertia.empty(); ++k)
      if (model.support[n][k] == Support::free) force.back()[k] -= work.added_inertia[n][k];
  }
  if (!force.empty()) {
    const std::vector<Dofs<D>> water = water_inertia(model, state, work);
    for (std::size_t n = 0; n < water.size(); ++n)
      for (std::size_t k = 0; k < water[n].size(); ++k)
        if (model.support[n][k] == Support::free) force[n][k] -= water[n][k];
    begin_consistent(model, state, std::move(force));
    state.given[EnergyTerm::numerical] -= added_beyond_explicit(model, state);
  }
  state.position_before = state.position;
  state.rotation_before = state.rotation;
  state.last_dt = 0;
}

/// The present velocities serve as velocities of a half step of length 0, which is how leapfrog starts.
template <int D>
void begin_explicit(const Model<D>& model, State<D>& state, const Work<D>& work) {
  if (!state.implicit()) return;
  add_half_behind(model, state, work, state.given);
  state.given[EnergyTerm::numerical] += added_beyond_explicit(model, state);
  state.position_before.clear(), state.rotation_before.clear();
  state.acceleration.clear(), state.spin_rate.clear();
  state.most_energy = 0;
  state.tangent.reset();
  state.last_dt = 0;
}

template <int D>
Energy implicit_energy(const Model<D>& model, const State<D>& state, const Work<D>& work) {
  Energy energy = work.given;
  add_half_behind(model, state, work, energy);
  energy[EnergyTerm::kinetic] = implicit_kinetic(model, state);
  energy[EnergyTerm::strain] = work.element_stored;
  energy[EnergyTerm::contact_elastic] = contact_energy(model, state, work);
  energy[EnergyTerm::bearing_elastic] = work.bearing_stored;
  return energy;
}

template double implicit_kinetic(const Model<2>&, const State<2>&);
template double implicit_kinetic(const Model<3>&, const State<3>&);
template void begin_implicit(const Model<2>&, State<2>&, const Work<2>&);
template void begin_implicit(const Model<3>&, State<3>&, const Work<3>&);
template void begin_explicit(const Model<2>&, State<2>&, const Work<2>&);
template void begin_explicit(const Model<3>&, State<3>&, const Work<3>&);
template Energy implicit_energy(const Model<2>&, const State<2>&, const Work<2>&);
template Energy implicit_energy(const Model<3>&, const State<3>&, const Work<3>&);

}  // namespace trilith
