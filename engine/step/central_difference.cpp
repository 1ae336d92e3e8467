#include "step/central_difference.hpp"

#include "step/implicit_step.hpp"
#include "step/node_forces.hpp"
#include "step/stored_energy.hpp"

namespace trilith {
namespace {

/// Of the leapfrog scheme: half of m v(-) v(+), which together with the potential is kept exactly; m v^2 / 2 at the
/// very start, where there is no step behind.
double kinetic_energy(const Model<2>& model, const State<2>& state, int n, const Dofs& v, const Dofs& next) {
  const Dofs mass = mass_of(model, n);
  double sum = 0;
  for (const int k : {0, 1, 2})
    if (model.support[n][k] == Support::free) sum += 0.5 * mass[k] * v[k] * (state.last_dt > 0 ? next[k] : v[k]);
  return sum;
}

/// Lengths of time that a step has to do with [s].
struct StepSpan {
  double last, next;  ///< the step behind and the one ahead
  double between;     ///< from the middle of the one to that of the other
};

/// One step of any node.
[[gnu::noinline]] void advance_node(const Model<2>& model, State<2>& state, const Work<2>& work, const Outside& outside,
                                    const StepOptions& options, const StepSpan& span, int n) {
  const Dofs v = velocity_of(state, n);
  const NodeForces f = node_forces(model, work, n, v, outside, options.rest);
  const Dofs next = speed_ahead(model, state, n, v, f, span.between, span.next);
  Dofs path;
  for (const int k : {0, 1, 2}) path[k] = 0.5 * (span.last * v[k] + span.next * next[k]);
  add_work(f, path, state.given);
  state.velocity[n] = {next[0], next[1]};
  state.spin[n] = next[2];
  state.position[n] += Vec2(span.next * next[0], span.next * next[1]);
  state.rotation[n] += span.next * next[2];
}

/// True where forces, weight and steady loads are all that nodes go by: no dampings of their own, no load curve.
bool goes_plainly(const Model<2>& model, const Outside& outside, const StepOptions& options) {
  return !(options.rest.share > 0) && !(model.mass_damping > 0) && outside.moment == nullptr && outside.trim == nullptr;
}

/// Free to move; and to turn where it `turns`, else fixed against that and not turning.
template <bool turns>
[[gnu::always_inline]] inline bool is_free(const Model<2>& model, const State<2>& state, int n) {
  const auto& s = model.support[n];
  if (s[0] != Support::free || s[1] != Support::free) return false;
  return turns ? s[2] == Support::free : s[2] == Support::fixed && state.spin[n] == 0;
}

/// advance_node for a run of free nodes that go plainly: the same sums without the terms that are 0, kept in registers.
/// Returns the first node after the run.
template <bool turns>
int advance_free(const Model<2>& model, State<2>& state, const Work<2>& work, const Outside& outside,
                 const StepSpan& span, int n) {
  const Vec2* damping = work.element_damping.empty() ? nullptr : work.element_damping.data();
  const double* couple = work.element_damping_moment.empty() ? nullptr : work.element_damping_moment.data();
  double gravity = state.given[EnergyTerm::gravity], load = state.given[EnergyTerm::load],
         element_damping = state.given[EnergyTerm::element_damping];
  for (; n < model.nodes() && is_free<turns>(model, state, n); ++n) {
    const double mass = model.mass[n];
    const Vec2 &force = work.force[n], &steady = outside.load[n];
    Vec2 &v = state.velocity[n], &place = state.position[n];
    const double u = v.x() + force.x() / mass * span.between, w = v.y() + force.y() / mass * span.between;
    const double x = 0.5 * (span.last * v.x() + span.next * u), y = 0.5 * (span.last * v.y() + span.next * w);
    gravity -= mass * outside.field.x() * x + mass * outside.field.y() * y;
    load += steady.x() * x + steady.y() * y;
    if (damping != nullptr) element_damping -= damping[n].x() * x + damping[n].y() * y;
    v = {u, w};
    place = {place.x() + span.next * u, place.y() + span.next * w};
    if constexpr (turns) {
      double& spin = state.spin[n];
      const double before = spin;
      spin += work.moment[n] / model.inertia[n] * span.between;
      if (couple != nullptr) element_damping -= couple[n] * 0.5 * (span.last * before + span.next * spin);
      state.rotation[n] += span.next * spin;
    }
  }
  state.given[EnergyTerm::gravity] = gravity;
  state.given[EnergyTerm::load] = load;
  state.given[EnergyTerm::element_damping] = element_damping;
  return n;
}

void advance_nodes(const Model<2>& model, State<2>& state, const Work<2>& work, const StepOptions& options,
                   const StepSpan& span) {
  const Outside outside(model, state, work);
  const bool plain = goes_plainly(model, outside, options);
  for (int n = 0; n < model.nodes();) {
    if (plain && is_free<true>(model, state, n))
      n = advance_free<true>(model, state, work, outside, span, n);
    else if (plain && is_free<false>(model, state, n))
      n = advance_free<false>(model, state, work, outside, span, n);
    else
      advance_node(model, state, work, outside, options, span, n++);
  }
}

}  // namespace

Energy energy_now(const Model<2>& model, const State<2>& state, const Work<2>& work, const StepOptions& options) {
  if (state.implicit()) return implicit_energy(model, state, work);
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

void advance(const Model<2>& model, State<2>& state, const Work<2>& work, const StepOptions& options,
             StepTimes* times) {
  StepClock clock(times);
  const double dt = options.dt, last = state.last_dt, span = 0.5 * (last + dt);
  advance_nodes(model, state, work, options, {last, dt, span});
  state.time += dt;
  state.last_dt = dt;
  ++state.step;
  clock.mark(StepPart::advance);
}

}  // namespace trilith
