#include "edit/deactivate.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "assembly/bearing_motion.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/implicit_turn.hpp"
#include "assembly/node_forces.hpp"
#include "assembly/start.hpp"
#include "edit/restart.hpp"
#include "model/pose.hpp"
#include "statics/displacement_control.hpp"

namespace trilith {
namespace {

template <int D>
Event event_of(const State<D>& state, EventType type, int body) {
  Event e;
  e.type = type;
  e.time = state.time;
  e.step = state.step;
  e.body_a = body;
  return e;
}

/// Event with the position and speed of the body; an added body has no speed.
Event body_event(const Model<2>& model, const State<2>& state, EventType type, int body) {
  const Pose pose = body_pose(model, state, body);
  Event e = event_of(state, type, body);
  if (type != EventType::body_added) e.value = pose.velocity.norm();
  e.set_place(pose.place);
  return e;
}
Event body_event(const Model<3>& model, const State<3>& state, EventType type, int body) {
  const Pose3 pose = body_pose(model, state, body);
  Event e = event_of(state, type, body);
  if (type != EventType::body_added) e.value = pose.velocity.norm();
  e.set_place(pose.place);
  return e;
}

Vec2 first_point_of(const Model<2>& model, const State<2>& state, const Bearing<2>& b) {
  return pose_at(model, state, b.end_a).place;
}
Vec3 first_point_of(const Model<3>& model, const State<3>& state, const Bearing<3>& b) {
  return point_of(model, state, b.end_a);
}

template <int D>
Event bearing_event_of(const Model<D>& model, const State<D>& state, EventType type, std::size_t row) {
  const Bearing<D>& b = model.bearings[row];
  Event e = event_of(state, type, b.body_a);
  e.body_b = b.body_b, e.bearing = static_cast<int>(row);
  e.set_place(first_point_of(model, state, b));
  return e;
}

/// Ends the bearings of deactivated bodies: they fail if the bodies left the bounds, otherwise they are removed.
template <int D>
void end_bearings(const Model<D>& model, State<D>& state, const Work<D>& work, BearingStatus as,
                  std::vector<Event>& events) {
  const bool removed = as == BearingStatus::removed;
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    const Bearing<D>& b = model.bearings[i];
    BearingMemory<D>& memory = state.bearing[i];
    if (state.left[b.body_a] == 0 && state.left[b.body_b] == 0) continue;
    if (is_live(memory.status)) {
      events.push_back(
          bearing_event_of(model, state, removed ? EventType::bearing_removed : EventType::bearing_failed, i));
      if (!removed) events.back().value = work.bearing_displacement[i].norm();
    }
    if (is_live(memory.status) || memory.status == BearingStatus::waiting) memory.status = as;
  }
}

/// Also resets the acceleration and the last step, which would give implicit steps a wrong initial motion.
template <int D>
void stop(const Model<D>& model, State<D>& state, int body) {
  const Body& b = model.bodies[body];
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
    state.velocity[n] = Vec<D>::Zero(), state.spin[n] = nothing<Spin<D>>();
  if (!state.implicit()) return;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
    state.acceleration[n] = Vec<D>::Zero(), state.spin_rate[n] = nothing<Spin<D>>();
    state.position_before[n] = state.position[n], state.rotation_before[n] = state.rotation[n];
  }
}

/// A deactivated body touches nothing, so its recent separations are forgotten.
template <int D>
void forget_parting(const Model<D>& model, State<D>& state) {
  std::erase_if(state.parted, [&](const Parted& p) {
    return state.left[model.piece_body[first_piece(p.contact)]] != 0 ||
           state.left[model.piece_body[second_piece(p.contact)]] != 0;
  });
}

/// Balance of the ledger after a change that makes all pairs stale [J].
template <int D>
double balance_anew(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options) {
  hold_left(model, state);
  work.valid = false;
  evaluate(model, state, work, state.last_dt);
  control_displacement(model, state, work, options);
  return energy_now(model, state, work, options).balance();
}

/// Books the difference of the balance under `term`, so that the balance continues without a jump.
template <int D>
void book(State<D>& state, Work<D>& work, EnergyTerm term, double lost) {
  const double amount = energy_term_info[static_cast<std::size_t>(term)].sign * lost;
  state.given[term] += amount;
  work.given[term] += amount;
}

/// True if a reactivated body is free to move.
template <int D>
bool comes_free(const Model<D>& model, std::span<const int> bodies) {
  return std::any_of(model.set_aside.begin(), model.set_aside.end(), [&](const SetAside<D>& s) {
    const bool is_free = std::count(s.support.begin(), s.support.end(), Support::free) > 0;
    return is_free && std::any_of(bodies.begin(), bodies.end(), [&](int body) {
             const Body& b = model.bodies[body];
             return s.node >= b.first_node && s.node < b.first_node + b.nodes;
           });
  });
}

/// A reactivated body is at rest in its position, with its previous supports.
template <int D>
void bring_back(Model<D>& model, State<D>& state, int body) {
  state.left[body] = 0;
  state.removed_at[body] = never_removed;
  const Body& b = model.bodies[body];
  std::erase_if(model.set_aside, [&](const SetAside<D>& s) {
    if (s.node < b.first_node || s.node >= b.first_node + b.nodes) return false;
    model.support[s.node] = s.support;
    model.drive_of[s.node] = s.drive_of;
    return true;
  });
}

}  // namespace

/// A deactivated body is fixed in its position, like ground. The energy that leaves with it (motion, contacts,
/// bearings, weight) is the difference of the balance before and after; it is booked, so that the balance continues.
template <int D>
std::vector<Event> deactivate(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                              std::span<const int> bodies) {
  const double before = energy_now(model, state, work, options).balance();
  std::vector<Event> events;
  for (const int b : bodies) {
    events.push_back(body_event(model, state, EventType::body_left, b));
    state.left[b] = 1;
  }
  end_bearings(model, state, work, BearingStatus::failed, events);
  for (const int b : bodies) stop(model, state, b);
  forget_parting(model, state);
  book(state, work, EnergyTerm::left_bounds, before - balance_anew(model, state, work, options));
  return events;
}

/// As deactivate, but requested by the user instead of the bounds. Bodies and bearings are marked as removed with their
/// time, so that they can be reactivated, and the ledger has a separate term for them.
template <int D>
std::vector<Event> remove(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                          const Parts& parts) {
  const double before = energy_now(model, state, work, options).balance();
  std::vector<Event> events;
  state.removed_at.resize(state.left.size(), never_removed);
  for (const int b : parts.bodies) {
    events.push_back(body_event(model, state, EventType::body_removed, b));
    state.left[b] = 1;
    state.removed_at[b] = state.time;
  }
  end_bearings(model, state, work, BearingStatus::removed, events);
  for (const int i : parts.bearings) {
    if (state.bearing[i].status == BearingStatus::removed) continue;  // removed with a body
    state.bearing[i].status = BearingStatus::removed;
    events.push_back(bearing_event_of(model, state, EventType::bearing_removed, static_cast<std::size_t>(i)));
  }
  for (const int b : parts.bodies) stop(model, state, b);
  forget_parting(model, state);
  book(state, work, EnergyTerm::removed, before - balance_anew(model, state, work, options));
  return events;
}

/// Bodies are reactivated in their last position, at rest, and may overlap slightly with bodies that have moved there.
/// The same two balances give the energy of the overlap. Displacements of bearings count from now on, or from the first
/// position.
template <int D>
std::vector<Event> reactivate(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                              const Parts& parts) {
  std::vector<Event> events;
  std::optional<RestartedRun<D>> anew;
  if (comes_free(model, parts.bodies)) events = anew.emplace(model, state, work).events();
  const double before = energy_now(model, state, work, options).balance();
  for (const int b : parts.bodies) {
    bring_back(model, state, b);
    events.push_back(body_event(model, state, EventType::body_added, b));
  }
  for (const int i : parts.bearings) {
    start_bearing(model, state, work, i,
                  parts.from_start ? std::array<double, Space<D>::dofs>{}
                                   : bearing_motion(model, state, static_cast<std::size_t>(i)).displacement);
    state.bearing[i] = work.bearing[i];
    if (model.bearings[i].starts_waiting) state.bearing[i].status = BearingStatus::waiting;
    events.push_back(bearing_event_of(model, state, EventType::bearing_added, static_cast<std::size_t>(i)));
  }
  book(state, work, EnergyTerm::added, before - balance_anew(model, state, work, options));
  if (anew) anew->go_on(model, state, work);
  return events;
}

/// Any other change of parameters: the energy stored under the new parameters minus the energy under the old ones is
/// added or removed.
template <int D>
void modify(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
            const std::function<void(Model<D>&)>& change, std::span<const int> begun) {
  const double before = energy_now(model, state, work, options).balance();
  change(model);
  for (const int i : begun) {
    if (!is_live(state.bearing[i].status)) continue;
    start_bearing(model, state, work, i, state.bearing[i].begun_at);
    state.bearing[i] = work.bearing[i];
  }
  book(state, work, EnergyTerm::added, before - balance_anew(model, state, work, options));
}

namespace {

/// Degrees of freedom that are freed start with the speed of their prescribed motion, or 0. Returns their kinetic
/// energy [J]: the ledger does not contain the energy of driven nodes.
template <int D>
double begin_freed(const Model<D>& model, const Model<D>& changed, State<D>& state) {
  double moved = 0;
  for (int n = 0; n < model.nodes(); ++n)
    for (int k = 0; k < Space<D>::dofs; ++k) {
      if (model.support[n][k] == Support::free || changed.support[n][k] != Support::free) continue;
      const int drive = model.drive_of[n][k], axis = k - Space<D>::translations;
      const double speed = drive < 0 ? 0 : model.drives[drive].motion->velocity(state.time - model.drives[drive].start);
      (axis < 0 ? state.velocity[n][k] : number_at(axis, state.spin[n])) = speed;
      moved += 0.5 * mass_of(model, state, n)[k] * speed * speed;
    }
  return moved;
}

}  // namespace

template <int D>
SupportChange support_change(const Model<D>& model, const Model<D>& changed) {
  SupportChange out;
  for (int n = 0; n < model.nodes(); ++n)
    for (int k = 0; k < Space<D>::dofs; ++k) {
      const bool was = model.support[n][k] == Support::free, is = changed.support[n][k] == Support::free;
      out.frees = out.frees || (is && !was), out.stops = out.stops || (was && !is);
    }
  return out;
}

/// Contacts between constrained bodies store no energy. A freed body therefore adds the energy of its contacts, and a
/// stopped body removes it together with its kinetic energy. Energy of a prescribed motion was supplied by its
/// supports.
template <int D>
std::vector<Event> change_supports(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                                   Model<D> changed) {
  const bool frees = support_change(model, changed).frees;
  std::optional<RestartedRun<D>> anew;
  if (frees) anew.emplace(model, state, work);
  const double before = energy_now(model, state, work, options).balance();
  if (frees) state.given[EnergyTerm::support] += begin_freed(model, changed, state);
  model = std::move(changed);
  book(state, work, frees ? EnergyTerm::added : EnergyTerm::removed,
       before - balance_anew(model, state, work, options));
  if (!anew) return {};
  anew->go_on(model, state, work);
  return anew->events();
}

/// The grown model contains all previous parts under the same indices, so the state is only extended. Contacts within
/// `reach` of a new body are bonded as at the start.
template <int D>
std::vector<Event> grow(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options, Model<D> grown,
                        double reach) {
  const RestartedRun<D> anew(model, state, work);
  const double before = energy_now(model, state, work, options).balance();
  const std::size_t bodies = model.bodies.size(), bearings = model.bearings.size();
  model = std::move(grown);
  extend_state(state, model);
  work.drop();
  set_bonds(model, state, reach, static_cast<int>(bodies));
  std::vector<Event> events = anew.events();
  for (std::size_t b = bodies; b < model.bodies.size(); ++b)
    events.push_back(body_event(model, state, EventType::body_added, static_cast<int>(b)));
  for (std::size_t i = bearings; i < model.bearings.size(); ++i)
    events.push_back(bearing_event_of(model, state, EventType::bearing_added, i));
  book(state, work, EnergyTerm::added, before - balance_anew(model, state, work, options));
  anew.go_on(model, state, work);
  return events;
}

namespace {

/// Fixes a node. Its previous supports are stored, including later requests; nothing is stored if it was fixed
/// permanently.
template <int D>
void set_aside(Model<D>& model, int node) {
  SetAside<D> held;
  held.node = node;
  held.support.fill(Support::fixed);
  held.drive_of.fill(-1);
  if (model.support[node] == held.support && model.drive_of[node] == held.drive_of) return;
  std::swap(model.support[node], held.support);
  std::swap(model.drive_of[node], held.drive_of);
  const auto known = std::find_if(model.set_aside.begin(), model.set_aside.end(),
                                  [&](const SetAside<D>& s) { return s.node == node; });
  if (known != model.set_aside.end())
    *known = held;
  else
    model.set_aside.push_back(held);
}

}  // namespace

template <int D>
bool hold_left(Model<D>& model, const State<D>& state) {
  bool any = false;
  for (std::size_t b = 0; b < state.left.size(); ++b) {
    if (state.left[b] == 0) continue;
    any = true;
    const Body& body = model.bodies[b];
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n) set_aside(model, n);
  }
  return any && model.free_dofs() == 0;
}

template std::vector<Event> deactivate(Model<2>&, State<2>&, Work<2>&, const StepOptions&, std::span<const int>);
template bool hold_left(Model<2>&, const State<2>&);
template std::vector<Event> remove(Model<2>&, State<2>&, Work<2>&, const StepOptions&, const Parts&);
template std::vector<Event> remove(Model<3>&, State<3>&, Work<3>&, const StepOptions&, const Parts&);
template std::vector<Event> reactivate(Model<2>&, State<2>&, Work<2>&, const StepOptions&, const Parts&);
template std::vector<Event> reactivate(Model<3>&, State<3>&, Work<3>&, const StepOptions&, const Parts&);
template void modify(Model<2>&, State<2>&, Work<2>&, const StepOptions&, const std::function<void(Model<2>&)>&,
                     std::span<const int>);
template void modify(Model<3>&, State<3>&, Work<3>&, const StepOptions&, const std::function<void(Model<3>&)>&,
                     std::span<const int>);
template std::vector<Event> grow(Model<2>&, State<2>&, Work<2>&, const StepOptions&, Model<2>, double);
template std::vector<Event> grow(Model<3>&, State<3>&, Work<3>&, const StepOptions&, Model<3>, double);
template SupportChange support_change(const Model<2>&, const Model<2>&);
template SupportChange support_change(const Model<3>&, const Model<3>&);
template std::vector<Event> change_supports(Model<2>&, State<2>&, Work<2>&, const StepOptions&, Model<2>);
template std::vector<Event> change_supports(Model<3>&, State<3>&, Work<3>&, const StepOptions&, Model<3>);
template std::vector<Event> deactivate(Model<3>&, State<3>&, Work<3>&, const StepOptions&, std::span<const int>);
template bool hold_left(Model<3>&, const State<3>&);

}  // namespace trilith
