// Pieces of one body that stand in each other.
#pragma once

#include <string>
#include <vector>

#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// Throws InputError where two convex pieces overlap by more than `allowed` times the size of the smaller one: their
/// volume would count twice. It names the deepest two. `owner` begins the message.
void refuse_overlapping_pieces(const std::vector<Polyhedron>& pieces, double allowed, const std::string& owner);

}  // namespace trilith
