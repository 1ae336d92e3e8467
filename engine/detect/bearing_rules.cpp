#include "detect/bearing_rules.hpp"

#include <algorithm>

#include "base/rotation_3d.hpp"
#include "contact/face_overlap.hpp"

namespace trilith {
namespace {

ContactKey key_beside(int p, int q) {
  return contact_key(std::min(p, q), std::max(p, q));
}

/// f(bearing) for each that alters the contact of a pair.
template <int D, class F>
void for_bearings_beside(const PieceSearch<D>& search, const NearPair& pair, F&& f) {
  if (search.bearing.empty()) return;
  const ContactKey key = key_beside(pair.piece_a, pair.piece_b);
  for (auto at = std::lower_bound(search.bearing.begin(), search.bearing.end(), std::pair(key, 0));
       at != search.bearing.end() && at->first == key; ++at)
    f(static_cast<std::size_t>(at->second));
}

}  // namespace

// A bearing may stand for the contact between its two pieces (it then carries what the contact would) or leave another
// law in its place once it has failed. Pairs ask for theirs by key, so that the list is sorted by key, then by number:
// the order of bearings decides where several lie beside one pair.
template <int D>
void list_bearings(const Model<D>& model, PieceSearch<D>& search) {
  search.bearing.clear();
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    const Bearing<D>& b = model.bearings[i];
    if (b.piece_a < 0 || b.piece_b < 0 || !b.alters_contact()) continue;
    search.bearing.emplace_back(key_beside(b.piece_a, b.piece_b), i);
  }
  std::sort(search.bearing.begin(), search.bearing.end());
}

template <int D>
void apply_bearings(const Model<D>& model, const PieceSearch<D>& search, std::span<const BearingMemory<D>> bearings,
                    NearPair& pair) {
  for_bearings_beside(search, pair, [&](std::size_t i) {
    const Bearing<D>& b = model.bearings[i];
    if (is_live(bearings[i].status))
      pair.replaced = pair.replaced || b.replaces_contact;
    else if (b.contact_after >= 0)
      pair.law = b.contact_after;
  });
}

// Whether a bearing that stands for the contact answers for this force in space. Its faces, square to the axis z that
// each body keeps of it, must still lie flat on each other, and the force must be nearer to that axis than 45 degrees:
// (z . f)^2 >= f . f / 2. Solids that meet by another face, or tilted, touch as if there were no bearing.
bool presses_flat(const Model<3>& model, const State<3>& state, const PieceSearch<3>& search,
                  std::span<const BearingMemory<3>> bearings, const NearPair& pair, const Vec3& force) {
  bool flat = false;
  for_bearings_beside(search, pair, [&](std::size_t i) {
    const Bearing<3>& b = model.bearings[i];
    if (!b.replaces_contact || !is_live(bearings[i].status)) return;
    const Vec3 on_a = turn_of(motion_of(model, state, b.end_a.node[0]).rotation * b.angle).z(),
               on_b = turn_of(motion_of(model, state, b.end_b.node[0]).rotation * b.rest_angle).z();
    const double pull = on_a.dot(force);
    flat = flat || (cross(on_a, on_b).norm() <= face_pair_max_tilt && 2 * pull * pull >= force.squaredNorm());
  });
  return flat;
}

template void list_bearings(const Model<2>&, PieceSearch<2>&);
template void list_bearings(const Model<3>&, PieceSearch<3>&);
template void apply_bearings(const Model<2>&, const PieceSearch<2>&, std::span<const BearingMemory<2>>, NearPair&);
template void apply_bearings(const Model<3>&, const PieceSearch<3>&, std::span<const BearingMemory<3>>, NearPair&);

}  // namespace trilith
