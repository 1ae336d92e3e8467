// How a bearing modifies the contact of the two pieces that it connects.
#pragma once

#include <span>

#include "model/contact/broad_phase_state.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Lists in `search` the bearings that modify a contact, sorted by the pieces that they connect.
template <int D>
void list_bearings(const Model<D>& model, BroadPhaseState<D>& search);

/// Applies the bearings between two pieces to their contact: no contact while one of them is live; after its failure,
/// the contact law that replaces it. `bearings`: [bearing] their memories; `search` lists them by the pieces that they
/// connect.
template <int D>
void apply_bearings(const Model<D>& model, const BroadPhaseState<D>& search, std::span<const BearingMemory<D>> bearings,
                    NearPair& pair);

/// Depth up to which live bearings replace the contact of a pair [m]: the greatest depth in their memories.
template <int D>
double depth_stood_for(const Model<D>& model, const BroadPhaseState<D>& search,
                       std::span<const BearingMemory<D>> bearings, const NearPair& pair);

/// The contact law of a pair for a step `dt` [s]. Pressure starts at the depth up to which live bearings have replaced
/// the contact.
template <int D>
LawInUse law_beside_bearings(const Model<D>& model, const State<D>& state, const Work<D>& work, const NearPair& pair,
                             double dt = 0) {
  const double held = pair.replaced ? depth_stood_for<D>(model, work.search, state.bearing, pair) : 0;
  return {model.laws[pair.law], model.thickness, dt, held};
}

/// Sets `stood_for` ([bearing], [m]) of the pair's bearings: they replace its contact up to `depth`.
template <int D>
void stand_for(const Model<D>& model, const BroadPhaseState<D>& search, const NearPair& pair, double depth,
               std::span<double> stood_for);

/// Resets the depths: no bearing replaces a contact yet in this evaluation.
template <int D>
void begin_to_stand(const Model<D>& model, Work<D>& work) {
  work.stood_for.assign(work.search.bearing.empty() ? 0 : model.bearings.size(), 0.0);
}

/// Whether a contact with the force `force` [N] is the flat contact that a live bearing replaces. First condition: the
/// bearing's axial directions on a and on b differ by at most face_pair_max_tilt, and the force is nearer to this
/// direction than to the plane of the seat. In the plane, two faces that lie flat on each other also suffice. If the
/// faces are tilted, the depth beyond the replaced depth is in contact. A contact from the side is an ordinary one.
template <int D>
bool presses_flat(const Model<D>& model, const State<D>& state, const Work<D>& work,
                  std::span<const BearingMemory<D>> bearings, const NearPair& pair, const Vec<D>& force);

}  // namespace trilith
