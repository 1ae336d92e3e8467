// Rubble masonry in space: irregular convex stones that fill a box or a convex solid.
#pragma once

#include <string>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// Stones are the Voronoi cells of random points: each is what is nearer to its point than to any other.
struct SolidRubble {
  std::string name = {};
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< box to be filled, m; used where `within` has no corners
  Polyhedron within = {};                        ///< convex solid to be filled, m
  int stones = 50;                               ///< 1 to 10000
  int relaxations = 3;  ///< times that each point moves to its stone's centroid (Lloyd 1982); 0 to 100. The more, the
                        ///< more even in size and shape
  double aspect = 1;    ///< about how much wider (along x and y) than high stones are, 0.1 to 10
  double joint = 0;     ///< free width between stones, m, at most half a stone's mean size; 0: they touch
  double jitter = 0;    ///< each point moves by up to this much along x, y and z after relaxation, m, likewise
  int seed = 1;         ///< the same number gives the same bits everywhere
};

/// Stones "r1", "r2", ... from the bottom up by their centroids, in group "stones" and the rubble's name. Without joint
/// neighbours lie flat on each other and the stones fill the solid; with a joint each stone is set back by half of it
/// from its neighbours, not from the solid's faces. Faces are plane to rounding, for each is a cut by one plane, and
/// may be small, if not next to nothing: relaxation makes that rare. Throws InputError for a solid that is not convex,
/// a box without volume and numbers out of range.
std::vector<SolidPart> build_solid_rubble(const SolidRubble& rubble);

}  // namespace trilith
