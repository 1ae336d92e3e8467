// Watch on deep penetration. Beyond the middle of the thinner piece a contact cannot determine the side on which a
// piece belongs, and may push it out on the wrong side.
#pragma once

#include <vector>

#include "model/event/event.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Overlap that is reported once for each pair of bodies, as a share of the thickness of the thinner piece.
inline constexpr double deep_penetration_share = 0.5;

/// Events body_passed for all pairs of bodies with pieces that are too deep at the evaluated instant, or were too deep
/// within the last step. The pairs are stored in State::passed. Call it once per step. Pairs are checked only if the
/// travel of the fastest point since the last check, or the path of the last step, can have made them too deep.
std::vector<Event> report_deep_penetration(const Model<2>& model, State<2>& state, Work<2>& work);
/// The version for space checks the contacts that touch now.
std::vector<Event> report_deep_penetration(const Model<3>& model, State<3>& state, Work<3>& work);

}  // namespace trilith
