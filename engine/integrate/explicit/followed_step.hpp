// Accuracy limit of the time step for slow actions and vibrations. Motions, load curves and soft bearings are resolved
// in time, also if the stable step is much longer.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Lower limit of followed_step [s]. Shorter steps for records, limits and springs follow from the stable step of stiff
/// parts alone.
inline constexpr double shortest_followed_step = 0.005;

/// `dt` [s], or the longest step that resolves all actions within the next `ahead` [s], at least
/// shortest_followed_step. It is limited to:
///   - Half of the sample interval of each motion and of the straight load curve parts.
///   - A quarter of 1 / w of each bearing spring and of 1 / rate of its dashpot. Half of 1 / w of elements and beams.
///   - shortest_followed_step for bearings with a limit, whose failure must be found in time.
///   - shortest_followed_step under displacement control.
/// Contacts, gaps, cables and buffers are handled by integrate/explicit/impact_step.hpp. The result depends on Model
/// and State alone.
template <int D>
double followed_step(const Model<D>& model, const State<D>& state, double dt, double ahead);

}  // namespace trilith
