#include "events/body_events.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/team.hpp"

namespace trilith {
namespace {

double size_of(double spin) {
  return std::abs(spin);
}
double size_of(const Vec3& spin) {
  return spin.norm();
}

/// True if a component of the velocity of the first node alone shows that a body moves, as for most bodies.
template <int D>
bool plainly_moves(const Model<D>& model, const State<D>& state, int node) {
  return state.velocity[node].cwiseAbs().maxCoeff() > model.still_speed && model.moves(node);
}

/// Value of State::resting within body_events(): the body came to rest in this step and is not yet reported.
constexpr std::uint8_t just_now = 2;

/// Updates the rest state of a body: slower than still_speed for still_time, at its fastest point. For a rigid body
/// this is |v| + |spin| times its radius. True if the body has come to rest.
template <int D>
bool comes_to_rest(const Model<D>& model, State<D>& state, std::size_t b) {
  if (!model.body_moves(static_cast<int>(b))) return false;
  const int n = model.bodies[b].first_node;
  double speed = state.velocity[n].norm();
  if (model.bodies[b].is_rigid()) speed += size_of(state.spin[n]) * model.body_radius[b];
  for (int i = 1; i < model.bodies[b].nodes; ++i) speed = std::max(speed, state.velocity[n + i].norm());
  if (speed > model.still_speed) {
    state.moved_at[b] = state.time;
    state.resting[b] = 0;
    return false;
  }
  if (state.resting[b] != 0 || state.time - state.moved_at[b] < model.still_time) return false;
  state.resting[b] = just_now;
  return true;
}

/// Updates the bodies from `first` to before `last`. True if a body has come to rest. Every body is tested at every
/// step, so the fast test comes first: it decides for nearly all moving bodies.
template <int D>
bool some_come_to_rest(const Model<D>& model, State<D>& state, const Work<D>& work, int first, int last) {
  bool some = false;
  for (auto b = static_cast<std::size_t>(first); b < static_cast<std::size_t>(last); ++b) {
    if (!plainly_moves(model, state, work.body[b].node)) {
      some = comes_to_rest(model, state, b) || some;
      continue;
    }
    state.moved_at[b] = state.time;
    state.resting[b] = 0;
  }
  return some;
}

/// Bodies per chunk of a thread; some microseconds.
constexpr int looked_at = 512;

}  // namespace

/// Time and bodies, with which every event of a step begins.
template <int D>
Event event_now(const State<D>& state, EventType type, int body_a, int body_b) {
  Event e;
  e.type = type;
  e.time = state.time;
  e.step = state.step;
  e.body_a = body_a;
  e.body_b = body_b;
  return e;
}

/// Bodies are independent; the events are in the order of the bodies.
template <int D>
void body_events(const Model<D>& model, State<D>& state, Work<D>& work) {
  std::atomic<bool> some = false;
  const int bodies = static_cast<int>(work.body.size());
  share(work.threads, bodies, looked_at, [&](int first, int last, int /*thread*/) {
    if (some_come_to_rest(model, state, work, first, last)) some = true;
  });
  if (!some) return;
  for (int b = 0; b < bodies; ++b) {
    if (state.resting[b] != just_now) continue;
    state.resting[b] = 1;
    work.events.push_back(event_now(state, EventType::body_at_rest, b, -1));
  }
}

template Event event_now(const State<2>&, EventType, int, int);
template Event event_now(const State<3>&, EventType, int, int);
template void body_events(const Model<2>&, State<2>&, Work<2>&);
template void body_events(const Model<3>&, State<3>&, Work<3>&);

}  // namespace trilith
