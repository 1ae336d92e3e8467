// The watch on pieces that get too deep into each other: past the middle of the thinner one a contact cannot tell on
// which side a piece belongs, and may push it out on the wrong one.
#pragma once

#include <vector>

#include "model/event.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// An overlap above this share of the thinner piece's thickness is told, once for each two bodies.
inline constexpr double deep_penetration_share = 0.5;

/// body_passed for every two bodies of which a piece of one is too deep in one of the other at the instant that was
/// evaluated, or has been within the last step; they are kept in State::passed. For each step once. It looks only where
/// that may be: once the fastest point has gone far enough since the last look, and at what the last step may have
/// taken through another.
std::vector<Event> report_deep_penetration(const Model<2>& model, State<2>& state, Work<2>& work);
/// In space: of the contacts that touch now.
std::vector<Event> report_deep_penetration(const Model<3>& model, State<3>& state, Work<3>& work);

}  // namespace trilith
