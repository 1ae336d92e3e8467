#include "model/state.hpp"

#include "base/hash.hpp"
#include "model/io/motion_hash.hpp"
#include "model/io/state_words.hpp"

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

namespace {

/// Appends the part of `whole` that `rows` lacks.
template <class T>
void extend(std::vector<T>& rows, const std::vector<T>& whole) {
  rows.insert(rows.end(), whole.begin() + static_cast<std::ptrdiff_t>(rows.size()), whole.end());
}

}  // namespace

template <int D>
void extend_state(State<D>& state, const Model<D>& grown) {
  State<D> fresh = initial_state(grown);
  fresh.moved_at.assign(fresh.moved_at.size(), state.time);
  extend(state.position, fresh.position), extend(state.rotation, fresh.rotation);
  extend(state.velocity, fresh.velocity), extend(state.spin, fresh.spin);
  if (state.implicit()) {
    const std::size_t nodes = fresh.position.size();
    extend(state.position_before, fresh.position), extend(state.rotation_before, fresh.rotation);
    state.acceleration.resize(nodes, Vec<D>::Zero()), state.spin_rate.resize(nodes, nothing<Spin<D>>());
  }
  state.tangent = nullptr;
  extend(state.bearing, fresh.bearing), extend(state.plastic, fresh.plastic);
  extend(state.beam_memory, fresh.beam_memory), extend(state.seat_lost, fresh.seat_lost);
  extend(state.moved_at, fresh.moved_at), extend(state.resting, fresh.resting), extend(state.left, fresh.left);
  if (!state.added_share.empty()) state.added_share.resize(fresh.left.size(), 0);
  if (!state.removed_at.empty()) state.removed_at.resize(fresh.left.size(), never_removed);
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
  for (std::size_t k = 0; k < state.given.value.size(); ++k)
    if (k < plain_energy_terms || state.given.value[k] != 0) hash.add(state.given.value[k]);
  for (const FieldState& field : state.fields)
    for (const double v : field.value) hash.add(v);
  return hash.value();
}

template <int D>
std::uint64_t state_hash(const State<D>& state) {
  Hash hash;
  for (const std::uint64_t word : state_words(state)) hash.add(word);
  return hash.value();
}

template State<2> initial_state(const Model<2>&);
template void extend_state(State<2>&, const Model<2>&);
template void extend_state(State<3>&, const Model<3>&);
template State<3> initial_state(const Model<3>&);
template std::uint64_t motion_hash(const State<2>&);
template std::uint64_t motion_hash(const State<3>&);
template std::uint64_t state_hash(const State<2>&);
template std::uint64_t state_hash(const State<3>&);

}  // namespace trilith
