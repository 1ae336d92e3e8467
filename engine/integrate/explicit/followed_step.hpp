// The step in time for what acts or swings slowly: short enough that motions, load curves and soft bearings are
// followed, where the longest stable step would pass over them.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// No step is shortened below this for what it follows: records, limits and springs that ask for less have it from what
/// is stiff, or have never had it [s].
inline constexpr double shortest_followed_step = 0.005;

/// `dt` [s], or what of it follows what acts within the next `ahead` [s], at least shortest_followed_step:
///   - half of the sample step of each motion that acts, and of the straight parts of a load curve;
///   - a quarter of 1 / w of each bearing's spring, of 1 / rate of its dashpot, and half of 1 / w of elements and
///   beams;
///   - shortest_followed_step beside a bearing with a limit, which is to be seen in time, and under displacement
///   control.
/// Contacts, gaps, cables and buffers have their own look: integrate/explicit/impact_step.hpp. From Model and State
/// alone.
template <int D>
double followed_step(const Model<D>& model, const State<D>& state, double dt, double ahead);

}  // namespace trilith
