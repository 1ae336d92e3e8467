// The step in time for what strikes: so short that a blow keeps its energy.
//
// Central differences keep the energy of a spring, and not what happens within a step: a contact that closes a distance
// g into a step and is d deep at its end has stored k d^2 / 2, and its force has taken k d (g + d) / 2 from the motion,
// k d g / 2 too much; opening gives as much back, at another g. With the path v dt = g + d of a step that is at most
// k v^2 dt^2 / 8 for either, of a blow of energy e at the frequency w the share (w dt)^2 / 4. So all that closes or
// opens within the step, or is pressed by a blow, must keep to
//
//     sum over contacts of (k v^2 / 2 + k^2 d^2 / 2 mu) dt^2 <= 2 accuracy E,
//
// mu the mass of both together and E the energy that has been put in so far. What comes into contact later than that is
// reached by a step that ends where it touches. Contacts count, and bearings that close and open: gaps, pounding,
// cables. So do two that mortar holds and that swing by more than their bond stands.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

struct ImpactOptions {
  double accuracy = 1e-3;  ///< share of the energy put in that a blow may miss, above 0
  double safety = 0.5;     ///< share of the longest stable step that is taken, see StageOptions
};

/// `dt` [s], or what of it is short enough for what strikes; then on the ladder of settled_step. From the last
/// evaluation, and nothing else. A comparison or two where nothing that is fast could miss so much; else a look at each
/// body, and at the neighbours of those that could.
template <int D>
double impact_step(const Model<D>& model, const State<D>& state, Work<D>& work, double dt,
                   const ImpactOptions& options);

}  // namespace trilith
