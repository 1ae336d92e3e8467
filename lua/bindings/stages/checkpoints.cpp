#include "bindings/stages/checkpoints.hpp"

#include <algorithm>
#include <cmath>

namespace trilith::script {
namespace {

template <class... Vectors>
std::size_t bytes_in(const Vectors&... vectors) {
  return (std::size_t{0} + ... + (vectors.size() * sizeof(typename Vectors::value_type)));
}

/// Memory size of contact memories [bytes].
std::size_t bytes_of_contacts(const ContactHistory& c) {
  return bytes_in(c.key, c.memory, c.law_row, c.law_memory);
}
std::size_t bytes_of_contacts(const SolidHistory& c) {
  std::size_t patches = 0;
  for (const JointMemory& joint : c.joint) patches += bytes_in(joint.patch);
  return patches + bytes_in(c.key, c.memory, c.joint_of, c.joint);
}

/// The next integer multiple of `every` [s], so that two branches have checkpoints at the same times with any step
/// lengths.
double due_after(double time, double every) {
  constexpr double rounding = 1e-9;
  return every * (std::floor(time / every + rounding) + 1);
}

}  // namespace

template <int D>
std::size_t bytes_of(const State<D>& s) {
  const std::size_t tangent = s.tangent ? bytes_in(s.tangent->column, s.tangent->row, s.tangent->value) : 0;
  return sizeof(State<D>) + tangent + bytes_of_contacts(s.contacts) +
         bytes_in(s.position, s.rotation, s.velocity, s.spin, s.parted, s.bearing, s.plastic, s.beam_memory,
                  s.seat_lost, s.moved_at, s.resting);
}

template <int D>
std::size_t bytes_of(const Model<D>& m) {
  std::size_t names = 0;
  for (const Body& b : m.bodies) names += 64 * (1 + b.groups.size());
  return sizeof(Model<D>) + names +
         bytes_in(m.mass, m.inertia, m.support, m.start_position, m.start_rotation, m.start_velocity, m.start_spin,
                  m.load, m.bodies, m.body_radius, m.skin_place, m.skin_node, m.skin_turn, m.piece_body, m.piece_first,
                  m.corner_skin, m.edge_is_face, m.edge_corner, m.elements, m.element_batches, m.element_number,
                  m.beams, m.space_elements, m.fits, m.fit_number, m.element_bound, m.laws, m.law_of, m.bearings,
                  m.seats, m.drives, m.drive_of);
}

std::size_t Checkpoints::bytes() const {
  std::size_t sum = 0;
  const void* before = nullptr;
  for (const Checkpoint& c : list_)
    std::visit(
        [&](const auto& s) {
          sum += c.bytes + (s.model.get() != before ? bytes_of(*s.model) : 0);
          before = s.model.get();
        },
        c.snapshot);
  return sum;
}

void Checkpoints::add(Checkpoint checkpoint) {
  checkpoint.bytes = sizeof(Checkpoint) +
                     std::visit([](const auto& s) { return bytes_of(s.state); }, checkpoint.snapshot) +
                     checkpoint.timers.size() * sizeof(Timer);
  next_ = due_after(checkpoint.time(), options.every);
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
  next_ = list_.empty() ? 0 : due_after(list_.back().time(), options.every);
  return taken;
}

}  // namespace trilith::script
