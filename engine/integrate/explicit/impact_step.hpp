// Accuracy limit of the time step for impacts. The step is short enough for an impact to keep its energy.
//
// Central differences keep the energy of a linear spring, but not across a change of contact state within a step. A
// contact closes a distance g into a step and has the penetration d at its end. It then stores k d^2 / 2, while its
// force takes k d (g + d) / 2 from the motion: k d g / 2 too much. Opening returns as much, with another g. Over the
// path v dt = g + d of a step, the error of either is at most k v^2 dt^2 / 8. For an impact of energy e at the
// frequency w this is the share (w dt)^2 / 4. So the contacts that open, close or are compressed by an impact must
// satisfy
//
//     sum over contacts of (k v^2 / 2 + k^2 d^2 / 2 mu) dt^2 <= 2 accuracy E.
//
// Here mu is the reduced mass of both bodies and E the energy supplied so far. If a contact begins later than this
// limit allows, the step ends at its start. The sum contains contacts, bearings that close and open (gaps, pounding,
// cables), and mortar bonds whose vibration exceeds their breaking energy.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

struct ImpactOptions {
  double accuracy = 1e-3;  ///< allowed energy error of an impact as a share of the energy supplied, above 0
  double safety = 0.5;     ///< fraction of the longest stable step in use, see StageOptions
};

/// `dt` [s], or the longest step that all impacts allow, rounded down to the ladder of settled_step. The result depends
/// on the last evaluation alone. The cost is one or two comparisons if nothing is fast; otherwise a loop over the
/// bodies, and over the neighbours of fast bodies.
template <int D>
double impact_step(const Model<D>& model, const State<D>& state, Work<D>& work, double dt,
                   const ImpactOptions& options);

}  // namespace trilith
