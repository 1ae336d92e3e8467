// Private to view/: where two bodies lay against each other at the start: the line a crack between them is drawn on.
#pragma once

#include <vector>

#include "results/file/results.hpp"

namespace trilith::view {

/// Part of an outline's edge, from share `from` to share `to` of the way from outline point `edge` of `body` (counted
/// within the body) to the next one. It goes with the body, whatever its kind.
struct EdgePart {
  int body = -1, edge = -1;
  double from = 0, to = 0;
};

/// The pieces along which edges of bodies `a` and `b` face each other at the start, at most 5 % of the shorter edge
/// apart, on a's edges; none where they touch at a corner or not at all. Two dimensions.
std::vector<EdgePart> joint_of(const results::Header& header, int a, int b);

}  // namespace trilith::view
