#include "world/state.hpp"

#include "base/hash.hpp"
#include "world/motion_hash.hpp"
#include "world/state_words.hpp"

namespace trilith {

template <int D>
State<D> initial_state(const Model<D>& model) {
  State<D> state;
  state.position = model.start_position;
  state.rotation = model.start_rotation;
  state.velocity = model.start_velocity;
  state.spin = model.start_spin;
  state.bearing.resize(model.bearings.size());
  for (std::size_t i = 0; i < model.bearings.size(); ++i)
    if (model.bearings[i].starts_waiting) state.bearing[i].status = BearingStatus::waiting;
  state.plastic.resize(static_cast<std::size_t>(model.plastic_points));
  state.beam_memory.assign(static_cast<std::size_t>(model.beam_memory), 0);
  state.seat_lost.resize(model.seats.size());
  state.moved_at.assign(model.bodies.size(), 0);
  state.resting.assign(model.bodies.size(), 1);
  state.left.assign(model.bodies.size(), 0);
  return state;
}

template <int D>
std::uint64_t motion_hash(const State<D>& state) {
  Hash hash;
  hash.add(state.time);
  hash.add(static_cast<std::uint64_t>(state.step));
  hash.add(state.last_dt);
  for (std::size_t n = 0; n < state.position.size(); ++n) {
    for_each_number(state.position[n], [&](double v) { hash.add(v); });
    for_each_number(state.rotation[n], [&](double v) { hash.add(v); });
    for_each_number(state.velocity[n], [&](double v) { hash.add(v); });
    for_each_number(state.spin[n], [&](double v) { hash.add(v); });
  }
  for (const double energy : state.given.value) hash.add(energy);
  return hash.value();
}

template <int D>
std::uint64_t state_hash(const State<D>& state) {
  Hash hash;
  for (const std::uint64_t word : state_words(state)) hash.add(word);
  return hash.value();
}

template State<2> initial_state(const Model<2>&);
template State<3> initial_state(const Model<3>&);
template std::uint64_t motion_hash(const State<2>&);
template std::uint64_t motion_hash(const State<3>&);
template std::uint64_t state_hash(const State<2>&);
template std::uint64_t state_hash(const State<3>&);

}  // namespace trilith
