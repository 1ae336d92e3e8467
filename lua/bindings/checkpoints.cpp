#include "checkpoints.hpp"

#include <algorithm>
#include <cmath>

namespace trilith::script {
namespace {

template <class... Vectors>
std::size_t bytes_in(const Vectors&... vectors) {
  return (std::size_t{0} + ... + (vectors.size() * sizeof(typename Vectors::value_type)));
}

}  // namespace

std::size_t bytes_of(const State<2>& s) {
  const std::size_t tangent = s.tangent ? bytes_in(s.tangent->column, s.tangent->row, s.tangent->value) : 0;
  return sizeof(State<2>) + tangent +
         bytes_in(s.position, s.rotation, s.velocity, s.spin, s.contacts.key, s.contacts.memory, s.contacts.law_row,
                  s.contacts.law_memory, s.parted, s.bearing, s.plastic, s.beam_memory, s.seat_lost, s.moved_at,
                  s.resting);
}

std::size_t bytes_of(const Model<2>& m) {
  std::size_t names = 0;
  for (const Body& b : m.bodies) names += 64 * (1 + b.groups.size());
  return sizeof(Model<2>) + names +
         bytes_in(m.mass, m.inertia, m.support, m.start_position, m.start_rotation, m.start_velocity, m.start_spin,
                  m.load, m.bodies, m.body_radius, m.skin_place, m.skin_node, m.skin_turn, m.piece_body, m.piece_first,
                  m.corner_skin, m.edge_is_face, m.edge_corner, m.elements, m.element_batches, m.element_number,
                  m.beams, m.element_bound, m.laws, m.law_of, m.bearings, m.seats, m.drives, m.drive_of);
}

std::size_t Checkpoints::bytes() const {
  std::size_t sum = 0;
  const Model<2>* before = nullptr;
  for (const Checkpoint& c : list_) {
    sum += c.bytes;
    if (c.snapshot.model.get() != before) sum += bytes_of(*c.snapshot.model);
    before = c.snapshot.model.get();
  }
  return sum;
}

bool Checkpoints::due(const Simulation<2>& now) const {
  return on && (list_.empty() || now.state().time >= next_ ||
                now.stage()->report.begun != list_.back().snapshot.stage->report.begun);
}

void Checkpoints::add(Checkpoint checkpoint) {
  checkpoint.bytes =
      sizeof(Checkpoint) + bytes_of(checkpoint.snapshot.state) + checkpoint.timers.size() * sizeof(Timer);
  next_ = checkpoint.time() + options.every;
  list_.push_back(std::move(checkpoint));
  drop_oldest();
}

void Checkpoints::drop_oldest() {
  while (list_.size() > 1 &&
         (static_cast<int>(list_.size()) > options.count || static_cast<double>(bytes()) > options.bytes))
    list_.pop_front();
}

const Checkpoint* Checkpoints::nearest(double time) const {
  const Checkpoint* found = nullptr;
  for (const Checkpoint& c : list_)
    if (found == nullptr || std::abs(c.time() - time) < std::abs(found->time() - time)) found = &c;
  return found;
}

std::vector<Checkpoint> Checkpoints::take_after(double time) {
  const auto first = std::find_if(list_.begin(), list_.end(), [&](const Checkpoint& c) { return c.time() > time; });
  std::vector<Checkpoint> taken(std::make_move_iterator(first), std::make_move_iterator(list_.end()));
  list_.erase(first, list_.end());
  next_ = list_.empty() ? 0 : list_.back().time() + options.every;
  return taken;
}

}  // namespace trilith::script
