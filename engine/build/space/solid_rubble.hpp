// Rubble masonry in space: irregular convex stones that fill a box or a convex solid.
#pragma once

#include <string>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// Stones are the Voronoi cells of random points: all points of a stone are nearer to its point than to any other.
struct SolidRubble {
  std::string name = {};
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< box to fill [m]; used if `within` has no corners
  Polyhedron within = {};                        ///< convex solid to be filled [m]
  int stones = 50;                               ///< 1 to 10000
  int relaxations = 3;  ///< number of times that each point moves to the centroid of its stone (Lloyd 1982), 0 to 100.
                        ///< More relaxations give more uniform size and shape
  double aspect = 1;    ///< approximate ratio of width (along x and y) to height of the stones, 0.1 to 10
  double joint = 0;     ///< free width between stones [m], at most half of a stone's mean size; 0: they touch
  double jitter = 0;    ///< after relaxation each point moves by up to this distance along x, y and z [m], same limit
  int seed = 1;         ///< the same number gives the same bits everywhere

  static constexpr std::string_view kind = "rubble";
  static constexpr std::string_view sentence = "irregular stones that fill a box";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<SolidRubble>;
    return std::tuple(
        K::Vector{&SolidRubble::low, "low", "corner of the box", must_be_given},
        K::Vector{&SolidRubble::high, "high", "opposite corner", must_be_given},
        K::Count{&SolidRubble::stones, "stones", "number of stones", 1, 10000},
        K::Count{&SolidRubble::relaxations, "relaxations", "number of relaxations; more give more even stones", 0, 100},
        K::Number{&SolidRubble::aspect, "aspect", "1", "width of stones over height", {0.1, 10}},
        K::Number{&SolidRubble::joint, "joint", "m", "gap between stones", not_below_zero},
        K::Number{&SolidRubble::jitter, "jitter", "m", "largest random shift of points", not_below_zero},
        K::Count{&SolidRubble::seed, "seed", "seed of the random numbers"});
  }
  /// build_solid_rubble.
  [[nodiscard]] SolidParts parts() const;
};

/// Stones "r1", "r2", ... from the bottom up by their centroids, in group "stones" and the rubble's name. Without
/// joint, neighbours lie flat on each other and the stones fill the solid. With a joint each stone is offset by half of
/// it from its neighbours, not from the solid's faces. Faces are plane to rounding, because each is a cut by one plane.
/// They may be small, which relaxation makes rare. Throws InputError for a solid that is not convex, a box without
/// volume and numbers out of range.
std::vector<SolidPart> build_solid_rubble(const SolidRubble& rubble);

}  // namespace trilith
