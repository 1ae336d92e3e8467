// Private to view/: lines along which two bodies touched at the start, on which a crack is drawn.
#pragma once

#include <vector>

#include "results/file/results.hpp"

namespace trilith::view {

/// Part of an outline's edge, from fraction `from` to fraction `to` of the segment from outline point `edge` of `body`
/// (counted within the body) to the next one. It moves with the body, for every kind of body.
struct EdgePart {
  int body = -1, edge = -1;
  double from = 0, to = 0;
};

/// The segments along which edges of bodies `a` and `b` are opposed at the start, at most 5 % of the shorter edge
/// apart, on a's edges. None if they touch at a corner or not at all. Plane models only.
std::vector<EdgePart> joint_of(const results::Header& header, int a, int b);

}  // namespace trilith::view
