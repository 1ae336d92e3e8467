#include "step/take_out.hpp"

#include <algorithm>

#include "step/bearing_motion.hpp"
#include "step/displacement_control.hpp"
#include "step/evaluate.hpp"
#include "world/pose.hpp"

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

Event left_event(const Model<2>& model, const State<2>& state, int body) {
  const Pose pose = body_pose(model, state, body);
  Event e = event_of(state, EventType::body_left, body);
  e.value = pose.velocity.norm();
  e.set_place(pose.place);
  return e;
}
Event left_event(const Model<3>& model, const State<3>& state, int body) {
  const int node = model.bodies[body].first_node;
  Event e = event_of(state, EventType::body_left, body);
  e.value = state.velocity[node].norm();
  e.set_place(state.position[node]);
  return e;
}

/// Ends the bearings of bodies that have left.
template <int D>
void end_bearings(const Model<D>& model, State<D>& state, const Work<D>& work, std::vector<Event>& events) {
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    const Bearing<D>& b = model.bearings[i];
    BearingMemory<D>& memory = state.bearing[i];
    if (state.left[b.body_a] == 0 && state.left[b.body_b] == 0) continue;
    if (is_live(memory.status)) {
      Event e = event_of(state, EventType::bearing_failed, b.body_a);
      e.body_b = b.body_b, e.bearing = static_cast<int>(i);
      e.value = work.bearing_displacement[i].norm();
      if constexpr (D == 2)
        e.set_place(pose_at(model, state, b.end_a).place);
      else
        e.set_place(point_of(state, b.end_a));
      events.push_back(e);
    }
    if (is_live(memory.status) || memory.status == BearingStatus::waiting) memory.status = BearingStatus::failed;
  }
}

/// Its acceleration and the step behind it too, or implicit steps would begin with a motion it has not.
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

}  // namespace

/// Held where it is, the body is like ground. The energy that goes with it, of motion, contacts, bearings and its
/// weight, is what the balance differs by before and after; it is booked, so that the balance goes on.
template <int D>
std::vector<Event> take_out(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
                            std::span<const int> bodies) {
  const double before = energy_now(model, state, work, options).balance();
  std::vector<Event> events;
  for (const int b : bodies) {
    events.push_back(left_event(model, state, b));
    state.left[b] = 1;
  }
  end_bearings(model, state, work, events);
  for (const int b : bodies) stop(model, state, b);
  std::erase_if(state.parted, [&](const Parted& p) {
    return state.left[model.piece_body[first_piece(p.contact)]] != 0 ||
           state.left[model.piece_body[second_piece(p.contact)]] != 0;
  });
  // Its nodes are fixed, and pairs found anew without it; the balance is then taken from a new evaluation.
  hold_left(model, state);
  work.valid = false;
  evaluate(model, state, work, state.last_dt);
  if constexpr (D == 2)
    if (!state.implicit()) control_displacement(model, state, work, options);
  const double taken = before - energy_now(model, state, work, options).balance();
  state.given[EnergyTerm::left_bounds] += taken;
  work.given[EnergyTerm::left_bounds] += taken;
  return events;
}

template <int D>
bool hold_left(Model<D>& model, const State<D>& state) {
  bool any = false;
  for (std::size_t b = 0; b < state.left.size(); ++b) {
    if (state.left[b] == 0) continue;
    any = true;
    const Body& body = model.bodies[b];
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
      model.support[n].fill(Support::fixed);
      model.drive_of[n].fill(-1);
    }
  }
  return any && model.free_dofs() == 0;
}

template std::vector<Event> take_out(Model<2>&, State<2>&, Work<2>&, const StepOptions&, std::span<const int>);
template bool hold_left(Model<2>&, const State<2>&);
template std::vector<Event> take_out(Model<3>&, State<3>&, Work<3>&, const StepOptions&, std::span<const int>);
template bool hold_left(Model<3>&, const State<3>&);

}  // namespace trilith
