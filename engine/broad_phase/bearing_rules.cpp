#include "broad_phase/bearing_rules.hpp"

#include <algorithm>
#include <cmath>

#include "base/rotation_3d.hpp"
#include "broad_phase/pairs.hpp"
#include "law/contact/face_overlap.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

ContactKey key_beside(int p, int q) {
  return contact_key(std::min(p, q), std::max(p, q));
}

/// Calls f(bearing) for each bearing that modifies the contact of a pair.
template <int D, class F>
void for_bearings_beside(const BroadPhaseState<D>& search, const NearPair& pair, F&& f) {
  if (search.bearing.empty()) return;
  const ContactKey key = key_beside(pair.piece_a, pair.piece_b);
  for (auto at = std::lower_bound(search.bearing.begin(), search.bearing.end(), std::pair(key, 0));
       at != search.bearing.end() && at->first == key; ++at)
    f(static_cast<std::size_t>(at->second));
}

/// The axial direction of a bearing, as fixed to either body.
template <int D>
struct AxialWays {
  Vec<D> on_a, on_b;

  /// Sine of the angle between the two directions.
  [[nodiscard]] double tilt() const {
    if constexpr (D == 2)
      return std::abs(cross(on_a, on_b));
    else
      return cross(on_a, on_b).norm();
  }
};
AxialWays<2> axial_ways(const Model<2>& model, const State<2>& state, const Bearing<2>& b) {
  const double on_a = pose_at(model, state, b.end_a).rotation, on_b = pose_at(model, state, b.end_b).rotation;
  const auto way = [&](double angle) { return Turn(b.angle + angle).apply(Vec2::UnitY()); };
  return {way(on_a), way(on_b - b.rest_angle)};
}
AxialWays<3> axial_ways(const Model<3>& model, const State<3>& state, const Bearing<3>& b) {
  return {turn_of(motion_of(model, state, b.end_a.node[0]).rotation * b.angle).z(),
          turn_of(motion_of(model, state, b.end_b.node[0]).rotation * b.rest_angle).z()};
}

}  // namespace

// A bearing may replace the contact between its two pieces, whose load it carries, or set another contact law after its
// failure. Pairs look up their bearings by key. So the list is sorted by key, then by index: if one pair has several
// bearings, their order decides.
template <int D>
void list_bearings(const Model<D>& model, BroadPhaseState<D>& search) {
  search.bearing.clear();
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    const Bearing<D>& b = model.bearings[i];
    if (b.piece_a < 0 || b.piece_b < 0 || !b.alters_contact()) continue;
    search.bearing.emplace_back(key_beside(b.piece_a, b.piece_b), i);
  }
  std::sort(search.bearing.begin(), search.bearing.end());
}

template <int D>
void apply_bearings(const Model<D>& model, const BroadPhaseState<D>& search, std::span<const BearingMemory<D>> bearings,
                    NearPair& pair) {
  for_bearings_beside(search, pair, [&](std::size_t i) {
    const Bearing<D>& b = model.bearings[i];
    if (is_live(bearings[i].status))
      pair.replaced = pair.replaced || b.replaces_contact;
    else if (b.contact_after >= 0)
      pair.law = b.contact_after;
  });
}

// A bearing replaces the overlap of its two faces while they lie flat. On soft springs the overlap may be deep, and the
// contact would act on all of it as soon as the faces tilt. From then on only the overlap beyond the replaced depth
// carries pressure (`LawInUse::held`), so the contact begins without force and energy. After the two have separated,
// the whole overlap counts again.

template <int D>
double depth_stood_for(const Model<D>& model, const BroadPhaseState<D>& search,
                       std::span<const BearingMemory<D>> bearings, const NearPair& pair) {
  double depth = 0;
  for_bearings_beside(search, pair, [&](std::size_t i) {
    if (model.bearings[i].replaces_contact && is_live(bearings[i].status))
      depth = std::max(depth, bearings[i].stood_for);
  });
  return depth;
}

template <int D>
void stand_for(const Model<D>& model, const BroadPhaseState<D>& search, const NearPair& pair, double depth,
               std::span<double> stood_for) {
  for_bearings_beside(search, pair, [&](std::size_t i) {
    if (model.bearings[i].replaces_contact) stood_for[i] = depth;
  });
}

// Whether a bearing that replaces the contact covers this force. Its faces, normal to the axial direction as fixed to
// each body, must still lie flat on each other. The force must be within 45 degrees of that axis:
// 2 (z . f)^2 >= f . f. In the plane, any two faces that lie flat on each other also qualify. Contact at another face,
// or of tilted faces, acts as if there were no bearing.
template <int D>
bool presses_flat(const Model<D>& model, const State<D>& state, const Work<D>& work,
                  std::span<const BearingMemory<D>> bearings, const NearPair& pair, const Vec<D>& force) {
  bool flat = false;
  if constexpr (D == 2) {
    NearPair faces = pair;
    flat = choose_face_pair(model, work, false, faces);
  }
  for_bearings_beside(work.search, pair, [&](std::size_t i) {
    const Bearing<D>& b = model.bearings[i];
    if (!b.replaces_contact || !is_live(bearings[i].status)) return;
    const AxialWays<D> axial = axial_ways(model, state, b);
    const double pull = axial.on_a.dot(force);
    flat = flat || (axial.tilt() <= face_pair_max_tilt && 2 * pull * pull >= force.squaredNorm());
  });
  return flat;
}

template void list_bearings(const Model<2>&, BroadPhaseState<2>&);
template void list_bearings(const Model<3>&, BroadPhaseState<3>&);
template void apply_bearings(const Model<2>&, const BroadPhaseState<2>&, std::span<const BearingMemory<2>>, NearPair&);
template void apply_bearings(const Model<3>&, const BroadPhaseState<3>&, std::span<const BearingMemory<3>>, NearPair&);
template bool presses_flat(const Model<2>&, const State<2>&, const Work<2>&, std::span<const BearingMemory<2>>,
                           const NearPair&, const Vec2&);
template bool presses_flat(const Model<3>&, const State<3>&, const Work<3>&, std::span<const BearingMemory<3>>,
                           const NearPair&, const Vec3&);
template double depth_stood_for(const Model<2>&, const BroadPhaseState<2>&, std::span<const BearingMemory<2>>,
                                const NearPair&);
template double depth_stood_for(const Model<3>&, const BroadPhaseState<3>&, std::span<const BearingMemory<3>>,
                                const NearPair&);
template void stand_for(const Model<2>&, const BroadPhaseState<2>&, const NearPair&, double, std::span<double>);
template void stand_for(const Model<3>&, const BroadPhaseState<3>&, const NearPair&, double, std::span<double>);

}  // namespace trilith
