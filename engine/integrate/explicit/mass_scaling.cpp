#include "integrate/explicit/mass_scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "assembly/element/rotary_inertia.hpp"
#include "assembly/node_forces.hpp"
#include "assembly/whole_body.hpp"
#include "base/error.hpp"
#include "base/team.hpp"

namespace trilith {
namespace {

/// Steps that miss the requested length by less are accepted; the difference is rounding of the bound.
constexpr double near_enough = 1 - 1e-9;
/// Bodies per chunk of a thread.
constexpr int scaled_stretch = 16;

/// k dt^2 + 2 c dt over its limit 4.
double demand(const RateBound& rate, double dt) {
  return 0.25 * dt * dt * rate.stiffness + 0.5 * dt * rate.damping;
}

/// Rigid part of the velocities of a body.
template <int D>
RigidPart<D> rigid_motion(const Model<D>& model, const State<D>& state, int body, const WholeBody<D>& whole) {
  return rigid_part(model, state, body, whole, [&](int n) { return Vec<D>(model.mass[n] * state.velocity[n]); });
}

/// Kinetic energy of the deforming part of the motion of a body, on its free degrees of freedom [J].
template <int D>
double deforming_energy(const Model<D>& model, const State<D>& state, int body) {
  const RigidPart<D> rigid = rigid_motion(model, state, body, whole_body(model, state, body));
  const Body& b = model.bodies[body];
  double sum = 0;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
    Vec<D> v = state.velocity[n] - rigid.at(state.position[n]);
    for (int k = 0; k < D; ++k)
      if (model.support[n][k] != Support::free) v[k] = 0;
    sum += 0.5 * model.mass[n] * v.squaredNorm();
  }
  return sum;
}

template <int D>
double mass_of_free_nodes(const Model<D>& model, int body) {
  const Body& b = model.bodies[body];
  double sum = 0;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) sum += model.moves(n) ? model.mass[n] : 0;
  return sum;
}

template <int D>
bool may_be_scaled(const Model<D>& model, const State<D>& state, const MassScaling& asked, int body) {
  if (!is_of_elements(model.bodies[body]) || !model.body_moves(body) || state.left[body] != 0) return false;
  return asked.bodies.empty() || std::find(asked.bodies.begin(), asked.bodies.end(), body) != asked.bodies.end();
}

/// Throws "mass_scaling: ..." for a body that would need more than its allowed share.
template <int D>
[[noreturn]] void refuse(const Model<D>& model, const BodyRates& rates, const MassScaling& asked, double safety,
                         int body, double share) {
  const double allowed = safety * scaled_step(rates, asked.most, model.mass_damping);
  const std::string& name = model.bodies[body].name;
  if (share < unbounded)
    throw InputError(
        fmt::format("mass_scaling: step is {:g} s, which needs {:.3g} times the mass of body '{}' against deformation, "
                    "must be at most {:g} times; use a step of at most {:.2g} s, or a larger 'most'",
                    asked.step, share, name, asked.most, allowed));
  throw InputError(
      fmt::format("mass_scaling: step is {:g} s, must be at most {:.2g} s: body '{}' would be unstable even if it were "
                  "rigid; use a shorter step, or a larger safety",
                  asked.step, allowed, name));
}

template <int D>
void find_shares(const Model<D>& model, const State<D>& state, ScaledMass& found) {
  double mass = 0, added = 0;
  int bodies = 0;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    const double own = mass_of_free_nodes(model, b), share = state.added_share[b];
    mass += own, added += share * own, bodies += share > 0 ? 1 : 0;
    if (share > found.most) found.most = share, found.body = b;
  }
  found.bodies = std::max(found.bodies, bodies);
  if (mass > 0) found.share = std::max(found.share, added / mass);
}

/// Twice the kinetic energy of the rotation of a node [J].
double rotary_energy_of(const Model<2>& model, const State<2>& state, int n) {
  return model.inertia[n] * state.spin[n] * state.spin[n];
}
double rotary_energy_of(const Model<3>& model, const State<3>& state, int n) {
  return state.spin[n].dot(momentum_of(model.inertia[n], state.rotation[n], state.spin[n]));
}

template <int D>
void find_energies(const Model<D>& model, const State<D>& state, ScaledMass& found) {
  double own = 0;
  for (int n = 0; n < model.nodes(); ++n)
    if (model.moves(n))
      own += 0.5 * (model.mass[n] * state.velocity[n].squaredNorm() + rotary_energy_of(model, state, n));
  found.kinetic = std::max(found.kinetic, own);
  found.energy = std::max(found.energy, added_energy(model, state));
}

}  // namespace

double share_for(const BodyRates& rates, double mass_damping, double dt) {
  const double braked = 0.5 * dt * mass_damping;
  const double elements = demand(rates.elements, dt) + braked, contacts = demand(rates.contacts, dt);
  if (elements + contacts <= 1) return 0;
  const double rigid = demand(rates.rigid, dt) + braked;
  return rigid < 1 ? std::max(0.0, elements + contacts / (1 - rigid) - 1) : unbounded;
}

/// Bisection: the share increases with the step.
double scaled_step(const BodyRates& rates, double share, double mass_damping) {
  double low = rates.plain, high = longest_step;
  for (int i = 0; i < 60 && low < high * (1 - 1e-15); ++i) {
    const double middle = 0.5 * (low + high);
    (share_for(rates, mass_damping, middle) <= share ? low : high) = middle;
  }
  return low;
}

/// Skips bodies whose step is longer than the shortest so far.
void shorten_to_scaled(const BodyRates& rates, double share, double mass_damping, int body, StableStep& found) {
  if (share_for(rates, mass_damping, found.dt) <= share) return;
  const double dt = scaled_step(rates, share, mass_damping);
  if (dt < found.dt)
    found = {dt, body, rates.contacts.stiffness + rates.elements.stiffness,
             rates.contacts.damping + (rates.elements.damping + mass_damping)};
}

template <int D>
void measure_scaled(const Model<D>& model, const State<D>& state, ScaledMass& found) {
  find_shares(model, state, found);
  find_energies(model, state, found);
}

template <int D>
bool scale_masses(const Model<D>& model, State<D>& state, const Work<D>& work, const MassScaling& asked, double safety,
                  bool must, ScaledMass& found) {
  const std::vector<BodyRates> rates = body_rates(model, state, work, true);
  const double wanted = asked.step / safety;
  bool changed = state.added_share.empty();
  if (changed) state.added_share.assign(model.bodies.size(), 0);
  double plain = longest_step;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (!model.body_moves(b)) continue;
    plain = std::min(plain, rates[b].plain);
    if (!may_be_scaled(model, state, asked, b)) continue;
    double& share = state.added_share[b];
    double needed = share_for(rates[b], model.mass_damping, wanted);
    if (must && needed > asked.most) refuse(model, rates[b], asked, safety, b, needed);
    if (!(needed < unbounded)) continue;
    needed = std::min(needed, asked.most);
    if (needed <= share) continue;
    state.given[EnergyTerm::added] += (needed - share) * deforming_energy(model, state, b);
    share = needed, changed = true;
  }
  const double before = settled_step(plain, safety);
  found.before = found.before > 0 ? std::min(found.before, before) : before;
  const StableStep stable = must ? stable_step(model, state, work) : StableStep{};
  if (must && stable.dt < near_enough * wanted)
    throw InputError(fmt::format(
        "mass_scaling: step is {:g} s, must be at most {:.2g} s, the limit of body '{}' ({}), whose masses are not "
        "scaled",
        asked.step, safety * stable.dt, model.bodies[stable.body].name, name_of(model.bodies[stable.body].kind)));
  measure_scaled(model, state, found);
  return changed;
}

template <int D>
void unscale_masses(const Model<D>& model, State<D>& state) {
  state.given[EnergyTerm::removed] += added_energy(model, state);
  state.added_share.clear();
}

namespace {

/// Rigid-body acceleration of a body under its nodal forces, with nodes that turn with the body.
template <int D>
RigidPart<D> rigid_acceleration(const Model<D>& model, const State<D>& state, int body, const WholeBody<D>& whole,
                                const std::vector<Vec<D>>& force) {
  RigidPart<D> out;
  if (!whole.moves()) return out;
  out.centre = whole.centre;
  Moment<D> momentum = nothing<Moment<D>>(), moment = nothing<Moment<D>>();
  const Body& b = model.bodies[body];
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
    const Vec<D> arm = state.position[n] - whole.centre;
    momentum += cross(arm, Vec<D>(model.mass[n] * state.velocity[n]));
    out.along += force[n], moment += cross(arm, force[n]);
  }
  out.spin = turn_from(whole, momentum);
  out.along = whole.goes.cwiseProduct(out.along) / whole.mass;
  out.about = turn_from(whole, moment - gyroscopic(whole, out.spin));
  return out;
}

/// Computes f, then the addition f' = (m a - f) share / (1 + share) with the rigid-body acceleration a under f. With
/// `all_count`, the free nodes are subject to nothing but these forces.
template <int D>
void add_inertia_of(const Model<D>& model, const State<D>& state, const Work<D>& work, const Outside<D>& outside,
                    const RestDamping& rest, bool all_count, int b, std::vector<Vec<D>>& added) {
  const double part = state.added_share[b] / (1 + state.added_share[b]);
  const Body& body = model.bodies[b];
  const WholeBody<D> whole = whole_body(model, state, b);
  const bool plain = all_count && whole.is_free();
  if (!plain)
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
      added[n] = along_of(node_forces(model, state, work, n, velocity_of(state, n), outside, rest).force);
  const std::vector<Vec<D>>& force = plain ? work.force : added;
  const RigidPart<D> rigid = rigid_acceleration(model, state, b, whole, force);
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
    added[n] = part * (model.mass[n] * rigid.turning_at(state.position[n]) - force[n]);
}

}  // namespace

template <int D>
void add_inertia(const Model<D>& model, const State<D>& state, Work<D>& work, const StepOptions& options) {
  work.added_inertia.clear();
  const bool rotary = !state.implicit() && has_one_element_bodies(model);
  if (state.added_share.empty() && !rotary) return;
  std::vector<Vec<D>>& added = work.added_inertia;
  const Outside<D> outside(model, state, work);
  const bool is_plain = !(options.rest.share > 0) && !(model.mass_damping > 0) && outside.correction == nullptr;
  added.assign(model.mass.size(), Vec<D>::Zero());
  const int scaled = static_cast<int>(state.added_share.size());
  share(work.threads, scaled, scaled_stretch, [&](int first, int last, int /*thread*/) {
    for (int b = first; b < last; ++b)
      if (state.added_share[b] > 0) add_inertia_of(model, state, work, outside, options.rest, is_plain, b, added);
  });
  if (rotary) add_rotary_inertia(model, state, work, options, is_plain, added);
}

template <int D>
double added_energy(const Model<D>& model, const State<D>& state) {
  double sum = 0;
  for (std::size_t b = 0; b < state.added_share.size(); ++b)
    if (state.added_share[b] > 0) sum += state.added_share[b] * deforming_energy(model, state, static_cast<int>(b));
  return sum;
}

/// The deforming part satisfies d(+) = d(-) + span (dv/dt - a) while the body turns, and f' = -share D (dv/dt - a) is
/// self-balanced. Returns half of share d(-) D d(+). The contribution of a body's rotary inertia to f' is neglected.
template <int D>
double added_kinetic(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options,
                     double span) {
  double sum = added_energy(model, state);
  if (work.added_inertia.empty()) return sum;
  std::vector<Vec<D>> rotary(model.mass.size(), Vec<D>::Zero());
  if (has_one_element_bodies(model)) add_rotary_inertia(model, state, work, options, false, rotary);
  for (std::size_t b = 0; b < state.added_share.size(); ++b) {
    if (!(state.added_share[b] > 0)) continue;
    const Body& body = model.bodies[b];
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
      for (int k = 0; k < D; ++k)
        if (model.support[n][k] == Support::free)
          sum -= 0.5 * span * (work.added_inertia[n][k] - rotary[n][k]) * state.velocity[n][k];
  }
  return sum;
}

template bool scale_masses(const Model<2>&, State<2>&, const Work<2>&, const MassScaling&, double, bool, ScaledMass&);
template bool scale_masses(const Model<3>&, State<3>&, const Work<3>&, const MassScaling&, double, bool, ScaledMass&);
template void measure_scaled(const Model<2>&, const State<2>&, ScaledMass&);
template void measure_scaled(const Model<3>&, const State<3>&, ScaledMass&);
template void unscale_masses(const Model<2>&, State<2>&);
template void unscale_masses(const Model<3>&, State<3>&);
template void add_inertia(const Model<2>&, const State<2>&, Work<2>&, const StepOptions&);
template void add_inertia(const Model<3>&, const State<3>&, Work<3>&, const StepOptions&);
template double added_energy(const Model<2>&, const State<2>&);
template double added_energy(const Model<3>&, const State<3>&);
template double added_kinetic(const Model<2>&, const State<2>&, const Work<2>&, const StepOptions&, double);
template double added_kinetic(const Model<3>&, const State<3>&, const Work<3>&, const StepOptions&, double);

}  // namespace trilith
