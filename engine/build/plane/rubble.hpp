// Walls of irregular stones: the Voronoi cells of random points within a polygon.
#pragma once

#include <string>
#include <vector>

#include "build/plane/part.hpp"

namespace trilith {

/// Irregular stones that fill a polygon.
struct Rubble {
  std::string name = {};
  Polygon outline = {};  ///< simple; any way round, m
  int stones = 50;       ///< 1 to 10000; of a concave outline some may come out in two pieces
  int relaxations = 3;   ///< times that each point moves to its cell's centroid (Lloyd 1982); 0 to 1000. The more, the
                         ///< more even in size and shape
  double aspect = 1;     ///< about how much longer than high stones are, 0.1 to 10
  double least_edge = -1;  ///< no face is shorter, but where the outline makes it so, m; negative: a tenth of a
                           ///< stone's mean size; at most three tenths
  double joint = 0;        ///< free width between stones, m, below half a stone's mean size; 0: they touch
  double jitter = 0;       ///< each point moves by up to this much in x and y after relaxation, m, likewise
  int seed = 1;            ///< the same number gives the same bits everywhere
};

/// Stones "r1", "r2", ... from the bottom up by their centroids, in group "stones" and the rubble's name. Without
/// joint, neighbours share the corners of their faces to the bit and the stones fill the outline; most are convex, and
/// a stone whose short faces were taken out may be slightly concave. With a joint each stone is set back by half of it
/// from its neighbours, not from the outline. Throws InputError for an outline that is none (see check_polygon) and
/// numbers out of range.
std::vector<Part> build_rubble(const Rubble& rubble);

}  // namespace trilith
