#include "step/central_difference.hpp"

#include <algorithm>
#include <array>

#include "base/team.hpp"
#include "body/rigid_turn_lanes.hpp"
#include "step/implicit_step.hpp"
#include "step/mass_scaling.hpp"
#include "step/node_forces.hpp"
#include "step/stored_energy.hpp"

namespace trilith {
namespace {

/// Of the leapfrog scheme: half of m v(-) v(+), which together with the potential is kept exactly; m v^2 / 2 at the
/// very start, where there is no step behind. Of turns in space: half of w(-) L(+), both of the body as it is turned
/// now.
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

/// Lengths of time that a step has to do with [s].
struct StepSpan {
  double last, next;  ///< the step behind and the one ahead
  double between;     ///< from the middle of the one to that of the other
};

/// Turns a node for a time dt with the spin that its step begins with. A free body keeps its angular momentum and not
/// its spin; one that is held about some axis of the world keeps its spin.
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

/// One step of any node. Returns what works on it from outside and its dampings do along its path.
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

/// True where forces, weight and steady loads are all that nodes go by: no dampings of their own, no load curve.
template <int D>
bool goes_plainly(const Model<D>& model, const Outside<D>& outside, const StepOptions& options) {
  return !(options.rest.share > 0) && !(model.mass_damping > 0) && outside.moment == nullptr &&
         outside.correction == nullptr;
}

/// Free to move; and to turn where it `turns`, else fixed against that and not turning.
template <bool turns>
[[gnu::always_inline]] inline bool is_free(const Model<2>& model, const State<2>& state, int n) {
  const auto& s = model.support[n];
  if (s[0] != Support::free || s[1] != Support::free) return false;
  return turns ? s[2] == Support::free : s[2] == Support::fixed && state.spin[n] == 0;
}

/// The works of nodes that go plainly are added to the ledger as they come ...
struct AddedWork {
  State<2>& state;
  double gravity = state.given[EnergyTerm::gravity], load = state.given[EnergyTerm::load],
         element_damping = state.given[EnergyTerm::element_damping];

  void take(int /*n*/, const NodeWork& w) { gravity -= w.weight, load += w.load, element_damping -= w.element_damping; }
  /// Of a turn alone, after the rest.
  void take_turn(int /*n*/, double damping) { element_damping -= damping; }
  void end() const {
    state.given[EnergyTerm::gravity] = gravity;
    state.given[EnergyTerm::load] = load;
    state.given[EnergyTerm::element_damping] = element_damping;
  }
};

/// ... or kept, where threads share them. A turn that elements damp has a work of its own.
struct KeptWork {
  NodeWorks& works;
  bool turns_are_damped;

  void take(int n, const NodeWork& w) const {
    const auto at = static_cast<std::size_t>(n);
    works.is_plain[at] = turns_are_damped ? 0 : 1;
    if (turns_are_damped)
      works.full[at] = w;
    else
      works.plain[at] = {w.weight, w.load, w.element_damping};
  }
  void take_turn(int n, double damping) const { works.full[static_cast<std::size_t>(n)].turn_damping = damping; }
  void end() const {}
};

/// advance_node for a run of free nodes before `last` that go plainly: the same sums without the terms that are 0, kept
/// in registers. Returns the first node after the run.
template <bool turns, class Taken>
int advance_free(const Model<2>& model, State<2>& state, const Work<2>& work, const Outside<2>& outside,
                 const StepSpan& span, int n, int last, Taken taken) {
  const Vec2* damping = work.element_damping.empty() ? nullptr : work.element_damping.data();
  const Vec2* added = work.added_inertia.empty() ? nullptr : work.added_inertia.data();
  const double* couple = work.element_damping_moment.empty() ? nullptr : work.element_damping_moment.data();
  for (; n < last && is_free<turns>(model, state, n); ++n) {
    const double mass = model.mass[n];
    const Vec2 force = added == nullptr ? work.force[n] : Vec2(work.force[n] + added[n]), &steady = outside.load[n];
    Vec2 &v = state.velocity[n], &place = state.position[n];
    const double u = v.x() + force.x() / mass * span.between, w = v.y() + force.y() / mass * span.between;
    const double x = 0.5 * (span.last * v.x() + span.next * u), y = 0.5 * (span.last * v.y() + span.next * w);
    NodeWork done;
    done.weight = mass * outside.field.x() * x + mass * outside.field.y() * y;
    done.load = steady.x() * x + steady.y() * y;
    if (damping != nullptr) done.element_damping = damping[n].x() * x + damping[n].y() * y;
    taken.take(n, done);
    v = {u, w};
    place = {place.x() + span.next * u, place.y() + span.next * w};
    if constexpr (turns) {
      double& spin = state.spin[n];
      const double before = spin;
      spin += work.moment[n] / model.inertia[n] * span.between;
      if (couple != nullptr) taken.take_turn(n, couple[n] * 0.5 * (span.last * before + span.next * spin));
      state.rotation[n] += span.next * spin;
    }
  }
  taken.end();
  return n;
}

/// Free in all its ways.
bool is_free(const Model<3>& model, int n) {
  const auto& support = model.support[n];
  return std::all_of(support.begin(), support.end(), [](Support s) { return s == Support::free; });
}

/// Free nodes in space that go plainly, four at a time: the turns of four at once, the rest as advance_node has it.
struct FreeNodes {
  const Model<3>& model;
  State<3>& state;
  const Work<3>& work;
  const Outside<3>& outside;
  StepSpan span;
  NodeWorks& works;
  std::array<int, lane_count> node{};
  int count = 0;

  void add(int n) {
    node[static_cast<std::size_t>(count++)] = n;
    if (count == lane_count) advance_four();
  }
  /// Those that are left.
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
      const auto at = static_cast<std::size_t>(n);
      works.plain[at] = advance_one(n), works.is_plain[at] = 1;
      state.spin[n] = lane_of(turning.spin, i);
      state.rotation[n] = {turning.rotation.w[i], turning.rotation.x[i], turning.rotation.y[i], turning.rotation.z[i]};
    }
    count = 0;
  }
  PlainWork advance_one(int n) {
    const double mass = model.mass[n];
    Vec3 &v = state.velocity[n], &place = state.position[n];
    const Vec3 next = v + work.force[n] / mass * span.between, path = 0.5 * (span.last * v + span.next * next);
    v = next, place += span.next * next;
    return {mass * outside.field.dot(path), outside.load[n].dot(path), 0};
  }
};

void keep(int n, const NodeWork& work, NodeWorks& works) {
  const auto at = static_cast<std::size_t>(n);
  works.full[at] = work, works.is_plain[at] = 0;
}

/// Nodes from `first` to before `last` in space.
void advance_range(const Model<3>& model, State<3>& state, const Work<3>& work, const StepOptions& options,
                   const StepSpan& span, const Outside<3>& outside, int first, int last, NodeWorks& works) {
  const bool plain = goes_plainly(model, outside, options) && work.element_damping.empty();
  FreeNodes free{model, state, work, outside, span, works};
  for (int n = first; n < last; ++n) {
    if (plain && is_free(model, n))
      free.add(n);
    else
      keep(n, advance_node(model, state, work, outside, options, span, n), works);
  }
  free.end();
}

/// Nodes from `first` to before `last` in the plane. `run()`: what takes the works of nodes that go plainly;
/// `add(n, work)` takes those of the others.
template <class Run, class Add>
void advance_range(const Model<2>& model, State<2>& state, const Work<2>& work, const StepOptions& options,
                   const StepSpan& span, const Outside<2>& outside, int first, int last, Run&& run, Add&& add) {
  const bool plain = goes_plainly(model, outside, options);
  for (int n = first; n < last;) {
    if (plain && is_free<true>(model, state, n)) {
      n = advance_free<true>(model, state, work, outside, span, n, last, run());
    } else if (plain && is_free<false>(model, state, n)) {
      n = advance_free<false>(model, state, work, outside, span, n, last, run());
    } else {
      add(n, advance_node(model, state, work, outside, options, span, n));
      ++n;
    }
  }
}

/// Adds what nodes came to, with the bits of one after the other: sums in registers take half the time of sums in
/// memory.
void add_all(const NodeWorks& all, Energy& given) {
  double gravity = given[EnergyTerm::gravity], load = given[EnergyTerm::load], support = given[EnergyTerm::support],
         element_damping = given[EnergyTerm::element_damping], rest = given[EnergyTerm::rest_damping],
         mass = given[EnergyTerm::mass_damping];
  for (std::size_t n = 0; n < all.is_plain.size(); ++n) {
    if (all.is_plain[n] != 0) {
      const PlainWork& w = all.plain[n];
      gravity -= w.weight, load += w.load, element_damping -= w.element_damping;
      continue;
    }
    const NodeWork& w = all.full[n];
    gravity -= w.weight, load += w.load, support -= w.support;
    element_damping -= w.element_damping;
    if (w.turn_damping != 0) element_damping -= w.turn_damping;
    rest -= w.rest, mass -= w.mass;
  }
  given[EnergyTerm::gravity] = gravity, given[EnergyTerm::load] = load, given[EnergyTerm::support] = support;
  given[EnergyTerm::element_damping] = element_damping;
  given[EnergyTerm::rest_damping] = rest, given[EnergyTerm::mass_damping] = mass;
}

/// Nodes that threads take at a time: some ten microseconds.
template <int D>
constexpr int node_stretch = D == 2 ? 128 : 64;

/// Nodes do not ask each other; their works are added in their order.
template <int D>
void advance_nodes(const Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                   const StepSpan& span) {
  const Outside outside(model, state, work);
  constexpr int stretch = node_stretch<D>;
  if constexpr (D == 2)
    if (work.threads <= 1 || model.nodes() <= stretch)
      return advance_range(
          model, state, work, options, span, outside, 0, model.nodes(), [&] { return AddedWork{state}; },
          [&](int /*n*/, const NodeWork& w) { add(w, state.given); });
  NodeWorks& works = work.node_work;
  works.resize(static_cast<std::size_t>(model.nodes()));
  const bool turns_are_damped = !work.element_damping_moment.empty();
  share(work.threads, model.nodes(), stretch, [&](int first, int last, int /*thread*/) {
    if constexpr (D == 2) {
      advance_range(
          model, state, work, options, span, outside, first, last,
          [&] {
            return KeptWork{works, turns_are_damped};
          },
          [&](int n, const NodeWork& w) { keep(n, w, works); });
    } else {
      advance_range(model, state, work, options, span, outside, first, last, works);
    }
  });
  add_all(works, state.given);
}

/// Elastic energies that are found from the state [J].
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
  // Half of v(-) M v(+) as if the step to come were as long as the one behind: v^2 - (a dt / 2)^2 of the speed v of
  // now. One of another length would add v a (dt' - dt) / 2, which no force has done.
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
  if (!state.added_share.empty()) kinetic += added_kinetic(model, state, work, state.last_dt > 0 ? span : 0);
  energy[EnergyTerm::kinetic] = kinetic;
  add_stored(model, state, work, energy);
  return energy;
}

template <int D>
void advance(const Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options, StepTimes* times) {
  StepClock clock(times);
  const double dt = options.dt, last = state.last_dt, span = 0.5 * (last + dt);
  advance_nodes(model, state, work, options, {last, dt, span});
  state.time += dt;
  state.last_dt = dt;
  ++state.step;
  clock.mark(StepPart::advance);
}

template Energy energy_now(const Model<2>&, const State<2>&, const Work<2>&, const StepOptions&);
template Energy energy_now(const Model<3>&, const State<3>&, const Work<3>&, const StepOptions&);
template void advance(const Model<2>&, State<2>&, Work<2>&, const StepOptions&, StepTimes*);
template void advance(const Model<3>&, State<3>&, Work<3>&, const StepOptions&, StepTimes*);

}  // namespace trilith
