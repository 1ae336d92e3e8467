#include "world/state.hpp"

#include "base/hash.hpp"
#include "world/motion_hash.hpp"

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
  state.seat_lost.resize(model.seats.size());
  state.moved_at.assign(model.bodies.size(), 0);
  state.resting.assign(model.bodies.size(), 1);
  state.left.assign(model.bodies.size(), 0);
  return state;
}

template State<2> initial_state(const Model<2>& model);

namespace {

void add(Hash& hash, const ContactMemory& m) {
  for (const int h : {0, 1}) {
    hash.add(m.shear_elastic[h]);
    hash.add(m.shear_total[h]);
    hash.add(m.damping_force[h]);
    hash.add(m.active[h]);
    hash.add(m.own[h]);
    hash.add(m.set[h]);
    hash.add(m.crushed[h]);
  }
  hash.add(m.slip);
  hash.add(static_cast<std::uint64_t>(m.bonds) << 32 | m.state);
}

void add(Hash& hash, const BearingMemory& m) {
  hash.add(static_cast<std::uint64_t>(m.status) << 32 | m.failed_direction);
  for (const DirectionMemory& d : m.direction)
    for (const double v : {d.inner, d.force, d.damping, d.travelled, d.compression}) hash.add(v);
}

void add_nodes(Hash& hash, const State<2>& state) {
  for (std::size_t i = 0; i < state.position.size(); ++i)
    for (const double v : {state.position[i].x(), state.position[i].y(), state.rotation[i], state.velocity[i].x(),
                           state.velocity[i].y(), state.spin[i]})
      hash.add(v);
}

}  // namespace

template <>
std::uint64_t motion_hash(const State<2>& state) {
  Hash hash;
  hash.add(state.time);
  hash.add(static_cast<std::uint64_t>(state.step));
  hash.add(state.last_dt);
  add_nodes(hash, state);
  for (const double energy : state.given.value) hash.add(energy);
  return hash.value();
}

template <>
std::uint64_t state_hash(const State<2>& state) {
  Hash hash;
  hash.add(state.time);
  hash.add(static_cast<std::uint64_t>(state.step));
  hash.add(state.dt);
  hash.add(state.safety);
  hash.add(state.last_dt);
  add_nodes(hash, state);
  for (std::size_t i = 0; i < state.contact.size(); ++i) {
    if (state.memory[i].empty()) continue;
    hash.add(state.contact[i]);
    add(hash, state.memory[i]);
  }
  for (const Parted& p : state.parted) {
    hash.add(p.contact);
    hash.add(p.time);
  }
  for (const ContactKey bodies : state.passed) hash.add(bodies);
  for (const BearingMemory& m : state.bearing) add(hash, m);
  for (const PlasticMemory& p : state.plastic)
    for (const double v : {p.xx, p.yy, p.zz, p.xy, p.measure}) hash.add(v);
  for (const std::uint8_t lost : state.seat_lost) hash.add(std::uint64_t{lost});
  for (std::size_t i = 0; i < state.moved_at.size(); ++i) {
    hash.add(state.moved_at[i]);
    hash.add(std::uint64_t{state.resting[i]});
  }
  // What has not happened adds nothing, so that a run in which nothing leaves has the hash it always had.
  for (std::size_t i = 0; i < state.left.size(); ++i)
    if (state.left[i] != 0) hash.add(std::uint64_t{i});
  for (std::size_t i = 0; i < state.given.value.size(); ++i)
    if (static_cast<EnergyTerm>(i) != EnergyTerm::left_bounds || state.given.value[i] != 0)
      hash.add(state.given.value[i]);
  return hash.value();
}

}  // namespace trilith
