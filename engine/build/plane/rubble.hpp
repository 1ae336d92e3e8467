// Walls of irregular stones: the Voronoi cells of random points within a polygon.
#pragma once

#include <string>
#include <vector>

#include "build/builder_keys.hpp"
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

  static constexpr std::string_view kind = "rubble";
  static constexpr std::string_view sentence = "irregular stones that fill a polygon";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<Rubble>;
    return std::tuple(
        K::Points{&Rubble::outline, "outline", "polygon to be filled"},
        K::Count{&Rubble::stones, "stones", "number of stones", 1, 10000},
        K::Count{&Rubble::relaxations, "relaxations", "number of relaxations; more give more even stones", 0, 1000},
        K::Number{&Rubble::aspect, "aspect", "1", "width of stones over height", {0.1, 10}},
        K::Number{
            &Rubble::least_edge, "least_edge", "m", "shorter edges are removed", any_number, {"a tenth of a stone"}},
        K::Number{&Rubble::joint, "joint", "m", "gap between stones", not_below_zero},
        K::Number{&Rubble::jitter, "jitter", "m", "largest random shift of points", not_below_zero},
        K::Count{&Rubble::seed, "seed", "of the random numbers"});
  }
  /// build_rubble.
  [[nodiscard]] std::vector<Part> parts() const;
};

/// Stones "r1", "r2", ... from the bottom up by their centroids, in group "stones" and the rubble's name. Without
/// joint, neighbours share the corners of their faces to the bit and the stones fill the outline. Most stones are
/// convex; a stone whose short faces were removed may be slightly concave. With a joint each stone is offset by half of
/// it from its neighbours, not from the outline. Throws InputError for an invalid outline (see check_polygon) and
/// numbers out of range.
std::vector<Part> build_rubble(const Rubble& rubble);

}  // namespace trilith
