// Overlapping pieces of one body.
#pragma once

#include <string>
#include <vector>

#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// Throws InputError if two convex pieces overlap by more than `allowed` times the size of the smaller one: their
/// volume would count twice. The message names the deepest pair and begins with `owner`.
void refuse_overlapping_pieces(const std::vector<Polyhedron>& pieces, double allowed, const std::string& owner);

}  // namespace trilith
