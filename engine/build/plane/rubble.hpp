// Walls of irregular stones: the Voronoi cells of random points within a polygon.
#pragma once

#include <string>
#include <vector>

#include "build/plane/part.hpp"

namespace trilith {

/// Irregular stones that fill a polygon.
struct Rubble {
  std::string name = {};
  Polygon outline = {};  ///< simple, in either orientation [m]
  int stones = 50;       ///< 1 to 10000; in a concave outline some stones may consist of two pieces
  int relaxations = 3;   ///< number of times that each point moves to the centroid of its cell (Lloyd 1982), 0 to 1000.
                         ///< More relaxations give more uniform size and shape
  double aspect = 1;     ///< approximate ratio of length to height of the stones, 0.1 to 10
  double least_edge = -1;  ///< least length of a face, except where the outline is shorter [m]; negative: a tenth of a
                           ///< stone's mean size; at most three tenths
  double joint = 0;        ///< free width between stones [m], below half of a stone's mean size; 0: they touch
  double jitter = 0;       ///< after relaxation each point moves by up to this distance in x and y [m], same limit
  int seed = 1;            ///< the same number gives the same bits everywhere
};

/// Stones "r1", "r2", ... from the bottom up by their centroids, in group "stones" and the rubble's name. Without
/// joint, neighbours share the corners of their faces to the bit and the stones fill the outline. Most stones are
/// convex; a stone whose short faces were removed may be slightly concave. With a joint each stone is offset by half of
/// it from its neighbours, not from the outline. Throws InputError for an invalid outline (see check_polygon) and
/// numbers out of range.
std::vector<Part> build_rubble(const Rubble& rubble);

}  // namespace trilith
