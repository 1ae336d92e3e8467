#include "integrate/explicit/central_difference.hpp"

#include <algorithm>
#include <array>

#include "assembly/element/rotary_inertia.hpp"
#include "assembly/node_forces.hpp"
#include "assembly/stored_energy.hpp"
#include "assembly/water/water_mass.hpp"
#include "assembly/water/water_work.hpp"
#include "base/team.hpp"
#include "element/rigid/rigid_turn_lanes.hpp"
#include "integrate/explicit/mass_scaling.hpp"
#include "integrate/implicit/implicit_step.hpp"

namespace trilith {
namespace {

/// Kinetic energy of the leapfrog scheme, half of m v(-) v(+). Its sum with the potential energy is conserved exactly.
/// At the start, without a previous step, it is m v^2 / 2. Rotations in space contribute half of w(-) L(+), both in the
/// present orientation of the body.
template <int D>
double kinetic_energy(const Model<D>& model, const State<D>& state, int n, const Dofs<D>& v, const Dofs<D>& ahead) {
  const Dofs<D>& next = state.last_dt > 0 ? ahead : v;
  const auto& support = model.support[n];
  double sum = 0;
  for (int k = 0; k < Space<D>::translations; ++k)
    if (support[k] == Support::free) sum += 0.5 * model.mass[n] * v[k] * next[k];
  if constexpr (D == 2) {
    if (support[2] == Support::free) sum += 0.5 * model.inertia[n] * v[2] * next[2];
  } else {
    const Vec3 momentum = momentum_of(model.inertia[n], state.rotation[n], about_of(next));
    for (int k = 3; k < 6; ++k)
      if (support[k] == Support::free) sum += 0.5 * v[k] * momentum[k - 3];
  }
  return sum;
}

/// Time intervals of a step [s].
struct StepSpan {
  double last, next;  ///< last step and next step
  double between;     ///< from the middle of the last step to the middle of the next one
};

/// Rotates a node for a time dt with the spin at the start of the step. A free body keeps its angular momentum rather
/// than its spin; a body with a fixed axis in the world keeps its spin.
void turn_node(const Model<2>& /*model*/, State<2>& state, int n, double spin, double dt) {
  state.spin[n] = spin;
  state.rotation[n] += dt * spin;
}
void turn_node(const Model<3>& model, State<3>& state, int n, const Vec3& spin, double dt) {
  const auto [x, y, z] = free_turns(model, n);
  UnitQuaternion& rotation = state.rotation[n];
  if (x && y && z) {
    const Vec3& inertia = model.inertia[n];
    const Vec3 momentum = momentum_of(inertia, rotation, spin);
    rotation = turned_freely(inertia, rotation, momentum, dt);
    state.spin[n] = spin_of(inertia, rotation, momentum);
  } else {
    rotation = renormalised(rotation_by(dt * spin) * rotation);
    state.spin[n] = spin;
  }
}

/// One step of any node. Returns the work of external forces and of its damping along its path.
template <int D>
[[gnu::noinline]] NodeWork advance_node(const Model<D>& model, State<D>& state, const Work<D>& work,
                                        const Outside<D>& outside, const StepOptions& options, const StepSpan& span,
                                        int n) {
  const Dofs<D> v = velocity_of(state, n);
  const NodeForces<D> f = node_forces(model, state, work, n, v, outside, options.rest);
  const Dofs<D> next = speed_ahead(model, state, n, v, f, span.between, span.next);
  Dofs<D> path;
  for (std::size_t k = 0; k < path.size(); ++k) path[k] = 0.5 * (span.last * v[k] + span.next * next[k]);
  state.velocity[n] = along_of(next);
  state.position[n] += span.next * state.velocity[n];
  turn_node(model, state, n, about_of(next), span.next);
  return work_of(f, path);
}

/// True if mass damping or rest damping acts on the nodes.
template <int D>
bool has_node_damping(const Model<D>& model, const StepOptions& options) {
  return options.rest.share > 0 || model.mass_damping > 0;
}
/// True if the external loads are weight and constant forces: no load curve and no correction.
template <int D>
bool has_steady_loads(const Outside<D>& outside) {
  return outside.moment == nullptr && outside.correction == nullptr;
}

/// True if the node is free to move. With `turns` its rotation is free too; otherwise the rotation is fixed and zero.
template <bool turns>
[[gnu::always_inline]] inline bool is_free(const Model<2>& model, const State<2>& state, int n) {
  const auto& s = model.support[n];
  if (s[0] != Support::free || s[1] != Support::free) return false;
  return turns ? s[2] == Support::free : s[2] == Support::fixed && state.spin[n] == 0;
}

/// Damping moments on a free node in the plane: the corresponding part of add_dampings.
struct TurnDamping {
  double rest = 0, mass;  ///< N m

  [[gnu::always_inline]] TurnDamping(const Model<2>& model, int n, double spin, double moment,
                                     const RestDamping& damping)
      : mass(-model.mass_damping * model.inertia[n] * spin) {
    if (damping.share > 0 && spin != 0) rest = -std::copysign(damping.share * std::abs(moment), spin);
  }
};

/// Fast form of advance_node for a run of free nodes before `last` under steady loads. It computes the same sums
/// without the terms that are 0, and keeps the sums in registers. Returns the first node after the run.
template <bool turns, bool has_damping>
int advance_free(const Model<2>& model, State<2>& state, const Work<2>& work, const Outside<2>& outside,
                 const RestDamping& rest, const StepSpan& steps, int n, int last, NodeWork& sums) {
  // Local copies, so that the compiler knows that the loop does not change them.
  const StepSpan span = steps;
  const Vec2 field = outside.field, *const load = outside.load, *const on = work.force.data();
  const double *const masses = model.mass.data(), *const inertias = model.inertia.data();
  const double* const moment = work.moment.data();
  const Vec2* damping = work.element_damping.empty() ? nullptr : work.element_damping.data();
  const Vec2* added = work.added_inertia.empty() ? nullptr : work.added_inertia.data();
  const double* couple = work.element_damping_moment.empty() ? nullptr : work.element_damping_moment.data();
  Vec2 *const velocity = state.velocity.data(), *const position = state.position.data();
  double *const spins = state.spin.data(), *const rotations = state.rotation.data();
  double weight = sums.weight, from_load = sums.load, damped = sums.element_damping;
  double by_rest = sums.rest, by_mass = sums.mass;
  for (; n < last && is_free<turns>(model, state, n); ++n) {
    const double mass = masses[n];
    Vec2 &v = velocity[n], &place = position[n];
    Vec2 force = on[n];
    PlaneDamping node;
    if constexpr (has_damping) node = PlaneDamping(model, n, v, force, rest), force += node.force();
    if (added != nullptr) force += added[n];
    const Vec2& steady = load[n];
    const double u = v.x() + force.x() / mass * span.between, w = v.y() + force.y() / mass * span.between;
    const double x = 0.5 * (span.last * v.x() + span.next * u), y = 0.5 * (span.last * v.y() + span.next * w);
    weight += mass * field.x() * x + mass * field.y() * y;
    from_load += steady.x() * x + steady.y() * y;
    if (damping != nullptr) damped += damping[n].x() * x + damping[n].y() * y;
    double node_rest = node.rest.x() * x + node.rest.y() * y, node_mass = node.mass.x() * x + node.mass.y() * y;
    v = {u, w};
    place = {place.x() + span.next * u, place.y() + span.next * w};
    if constexpr (turns) {
      double& spin = spins[n];
      const double before = spin;
      if constexpr (has_damping) {
        const TurnDamping turn(model, n, before, moment[n], rest);
        spin += (moment[n] + (turn.rest + turn.mass)) / inertias[n] * span.between;
        const double angle = 0.5 * (span.last * before + span.next * spin);
        node_rest += turn.rest * angle, node_mass += turn.mass * angle;
      } else {
        spin += moment[n] / inertias[n] * span.between;
      }
      if (couple != nullptr) damped += couple[n] * 0.5 * (span.last * before + span.next * spin);
      rotations[n] += span.next * spin;
    }
    if constexpr (has_damping) by_rest += node_rest, by_mass += node_mass;
  }
  sums.weight = weight, sums.load = from_load, sums.element_damping = damped;
  sums.rest = by_rest, sums.mass = by_mass;
  return n;
}

/// True if all degrees of freedom of the node are free.
bool is_free(const Model<3>& model, int n) {
  const auto& support = model.support[n];
  return std::all_of(support.begin(), support.end(), [](Support s) { return s == Support::free; });
}

/// Advances free nodes in space (see goes_plainly) four at a time. The rotations of four nodes are computed together;
/// the rest follows advance_node.
struct FreeNodes {
  const Model<3>& model;
  State<3>& state;
  const Work<3>& work;
  const Outside<3>& outside;
  StepSpan span;
  NodeWork& sums;
  std::array<int, lane_count> node{};
  int count = 0;

  void add(int n) {
    node[static_cast<std::size_t>(count++)] = n;
    if (count == lane_count) advance_four();
  }
  /// Advances the remaining nodes.
  void end() {
    if (count > 0) advance_four();
  }

 private:
  void advance_four() {
    for (int i = count; i < lane_count; ++i) node[static_cast<std::size_t>(i)] = node[0];
    const auto four = [&](const std::vector<Vec3>& of) {
      return four_of(of[node[0]], of[node[1]], of[node[2]], of[node[3]]);
    };
    TurningInLanes turning;
    const auto& q = state.rotation;
    for (int i = 0; i < lane_count; ++i) {
      const UnitQuaternion& of = q[node[static_cast<std::size_t>(i)]];
      turning.rotation.w[i] = of.w, turning.rotation.x[i] = of.x;
      turning.rotation.y[i] = of.y, turning.rotation.z[i] = of.z;
    }
    turning.spin = four(state.spin), turning.moment = four(work.moment), turning.inertia = four(model.inertia);
    turn_four(turning, span.between, span.next);
    for (int i = 0; i < count; ++i) {
      const int n = node[static_cast<std::size_t>(i)];
      advance_one(n);
      state.spin[n] = lane_of(turning.spin, i);
      state.rotation[n] = {turning.rotation.w[i], turning.rotation.x[i], turning.rotation.y[i], turning.rotation.z[i]};
    }
    count = 0;
  }
  void advance_one(int n) {
    const double mass = model.mass[n];
    Vec3 &v = state.velocity[n], &place = state.position[n];
    const Vec3 next = v + work.force[n] / mass * span.between, path = 0.5 * (span.last * v + span.next * next);
    v = next, place += span.next * next;
    sums.weight += mass * outside.field.dot(path), sums.load += outside.load[n].dot(path);
  }
};

/// Advances the nodes from `first` to before `last` in space. Returns the work done on them.
NodeWork advance_range(const Model<3>& model, State<3>& state, const Work<3>& work, const StepOptions& options,
                       const StepSpan& span, const Outside<3>& outside, int first, int last) {
  NodeWork sums;
  const bool plain = !has_node_damping(model, options) && has_steady_loads(outside) && work.element_damping.empty();
  FreeNodes free{model, state, work, outside, span, sums};
  for (int n = first; n < last; ++n) {
    if (plain && is_free(model, n))
      free.add(n);
    else
      sums += advance_node(model, state, work, outside, options, span, n);
  }
  free.end();
  return sums;
}

/// Advances the nodes from `first` to before `last` in the plane. Returns the work done on them.
template <bool has_damping>
NodeWork advance_range(const Model<2>& model, State<2>& state, const Work<2>& work, const StepOptions& options,
                       const StepSpan& span, const Outside<2>& outside, int first, int last) {
  const bool is_steady = has_steady_loads(outside);
  NodeWork sums;
  for (int n = first; n < last;) {
    if (is_steady && is_free<true>(model, state, n)) {
      n = advance_free<true, has_damping>(model, state, work, outside, options.rest, span, n, last, sums);
    } else if (is_steady && is_free<false>(model, state, n)) {
      n = advance_free<false, has_damping>(model, state, work, outside, options.rest, span, n, last, sums);
    } else {
      sums += advance_node(model, state, work, outside, options, span, n);
      ++n;
    }
  }
  return sums;
}
NodeWork advance_range(const Model<2>& model, State<2>& state, const Work<2>& work, const StepOptions& options,
                       const StepSpan& span, const Outside<2>& outside, int first, int last) {
  return has_node_damping(model, options)
             ? advance_range<true>(model, state, work, options, span, outside, first, last)
             : advance_range<false>(model, state, work, options, span, outside, first, last);
}

/// Nodes per chunk of a thread, about 10 microseconds. The work of each chunk is summed separately.
template <int D>
constexpr int node_stretch = D == 2 ? 128 : 64;

/// Advances all nodes. Nodes are independent of each other. The work is summed by chunks, in the order of the chunks,
/// so the bits do not depend on the number of threads.
template <int D>
void advance_nodes(const Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                   const StepSpan& span) {
  const Outside outside(model, state, work);
  constexpr int stretch = node_stretch<D>;
  const int stretches = (model.nodes() + stretch - 1) / stretch;
  work.node_work.resize(static_cast<std::size_t>(stretches));
  share(work.threads, stretches, 1, [&](int first, int last, int /*thread*/) {
    for (int s = first; s < last; ++s) {
      const int from = s * stretch, to = std::min(model.nodes(), from + stretch);
      work.node_work[static_cast<std::size_t>(s)] = advance_range(model, state, work, options, span, outside, from, to);
    }
  });
  for (const NodeWork& w : work.node_work) add(w, state.given);
}

/// Adds the elastic energies that follow from the state [J].
void add_stored(const Model<2>& model, const State<2>& state, const Work<2>& work, Energy& energy) {
  energy[EnergyTerm::strain] = work.element_stored;
  energy[EnergyTerm::contact_elastic] = contact_energy(model, state, work);
  energy[EnergyTerm::bearing_elastic] = work.bearing_stored;
}
void add_stored(const Model<3>& model, const State<3>& state, const Work<3>& work, Energy& energy) {
  energy[EnergyTerm::strain] = work.element_stored;
  energy[EnergyTerm::contact_elastic] = contact_energy(model, state, work);
  energy[EnergyTerm::bearing_elastic] = work.bearing_stored;
}

}  // namespace

template <int D>
Energy energy_now(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options) {
  if (state.implicit()) return implicit_energy(model, state, work);
  Energy energy = work.given;
  // Half of v(-) M v(+), as if the next step were as long as the last one: v^2 - (a dt / 2)^2 with the present speed v.
  // With another length dt' the term v a (dt' - dt) / 2 would be added, which is not work of a force.
  const double span = state.last_dt;
  const Outside outside(model, state, work);
  double kinetic = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs<D> v = velocity_of(state, n);
    const NodeForces<D> f = node_forces(model, state, work, n, v, outside, options.rest);
    Dofs<D> path = v;
    for (double& p : path) p *= 0.5 * state.last_dt;
    add_work(f, path, energy);
    kinetic += kinetic_energy(model, state, n, v, speed_ahead(model, state, n, v, f, span, options.dt));
  }
  book_water(model, state, work, energy, 0.5 * state.last_dt);
  if (!state.added_share.empty()) kinetic += added_kinetic(model, state, work, options, state.last_dt > 0 ? span : 0);
  kinetic += rotary_kinetic(model, state, work, options) + water_kinetic(model, state, work, options);
  energy[EnergyTerm::kinetic] = kinetic;
  add_stored(model, state, work, energy);
  return energy;
}

template <int D>
StepResult CentralDifference::step(const StepInput<D>& in) const {
  advance(in.model, in.state, in.work, {in.dt, in.rest}, in.times);
  return {true, in.dt, ""};
}

template <int D>
void advance(const Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options, StepTimes* times) {
  StepClock clock(times);
  const double dt = options.dt, last = state.last_dt, span = 0.5 * (last + dt);
  book_water(model, state, work, state.given, 0.5 * last);
  advance_nodes(model, state, work, options, {last, dt, span});
  book_water(model, state, work, state.given, 0.5 * dt);
  state.time += dt;
  state.last_dt = dt;
  ++state.step;
  clock.mark(StepPart::advance);
}

template Energy energy_now(const Model<2>&, const State<2>&, const Work<2>&, const StepOptions&);
template Energy energy_now(const Model<3>&, const State<3>&, const Work<3>&, const StepOptions&);
template StepResult CentralDifference::step(const StepInput<2>&) const;
template StepResult CentralDifference::step(const StepInput<3>&) const;
template void advance(const Model<2>&, State<2>&, Work<2>&, const StepOptions&, StepTimes*);
template void advance(const Model<3>&, State<3>&, Work<3>&, const StepOptions&, StepTimes*);

}  // namespace trilith
