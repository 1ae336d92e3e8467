// What bearings make of the contact of the two pieces they sit between.
#pragma once

#include <span>

#include "model/contact/broad_phase_state.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Notes in `search` the bearings that alter a contact, by the pieces they sit between.
template <int D>
void list_bearings(const Model<D>& model, BroadPhaseState<D>& search);

/// What the bearings between two pieces make of their contact: held off while one of them lives; after its failure, the
/// law it became. `bearings`: [bearing] their memories; `search` has them by the pieces they sit between.
template <int D>
void apply_bearings(const Model<D>& model, const BroadPhaseState<D>& search, std::span<const BearingMemory<D>> bearings,
                    NearPair& pair);

/// Depth [m] up to which live bearings stand for the contact of a pair: the greatest that they remember.
template <int D>
double depth_stood_for(const Model<D>& model, const BroadPhaseState<D>& search,
                       std::span<const BearingMemory<D>> bearings, const NearPair& pair);

/// The law of a pair for a step `dt` [s], which presses by what lies deeper than live bearings have stood for.
template <int D>
LawInUse law_beside_bearings(const Model<D>& model, const State<D>& state, const Work<D>& work, const NearPair& pair,
                             double dt = 0) {
  const double held = pair.replaced ? depth_stood_for<D>(model, work.search, state.bearing, pair) : 0;
  return {model.laws[pair.law], model.thickness, dt, held};
}

/// Writes to `stood_for` ([bearing], [m]) that those bearings stand for the contact of a pair up to `depth`.
template <int D>
void stand_for(const Model<D>& model, const BroadPhaseState<D>& search, const NearPair& pair, double depth,
               std::span<double> stood_for);

/// No bearing stands for a contact yet, in this evaluation.
template <int D>
void begin_to_stand(const Model<D>& model, Work<D>& work) {
  work.stood_for.assign(work.search.bearing.empty() ? 0 : model.bearings.size(), 0.0);
}

/// Whether a contact whose force is `force` [N] is the flat one that a live bearing stands for: the bearing's axial
/// direction is tilted on b against a by no more than faces may be to lie flat (face_pair_max_tilt), and the force is
/// nearer to it than to the seat's plane; or, in the plane, two faces lie flat on each other. Of what tilts, the part
/// that goes deeper than the bearing has stood for touches, and so does what strikes from the side.
template <int D>
bool presses_flat(const Model<D>& model, const State<D>& state, const Work<D>& work,
                  std::span<const BearingMemory<D>> bearings, const NearPair& pair, const Vec<D>& force);

}  // namespace trilith
