// What two convex solids of few faces share, found from their edges.
//
// Comes in: two solids of at most eight corners and faces each, where they stand. Goes out: the corners of the shared
// solid, with their depths below all faces of both, and each of its faces as a loop of them. No solid is cut: a corner
// of the shared solid is one of either that lies in the other, or a place where an edge of one goes through a face of
// the other,
//
//   x = p + t (q - p),   t = d(p) / (d(p) - d(q)),   d(x) the depth of x below that face,
//
// and its edges are parts of such edges, and where a face of one meets a face of the other: from one such corner to the
// other that both faces have. Of most edges the signs of depths tell that both ends lie outside of one face.
//
// Where rounding has it that faces and edges do not close (an edge that runs through another one), there is no answer,
// and who asked takes the long way (geometry/space/overlap_3d.hpp).
#pragma once

#include <array>
#include <cstdint>

#include "base/simd/lane_vectors.hpp"
#include "geometry/space/convex_solid.hpp"

namespace trilith {

/// Most corners, and most faces, of a solid of few faces; it has at most as many edges as Euler's rule leaves.
inline constexpr int few_faces = 8, few_edges = 14;

/// Whether a polyhedron has few faces, no two of which look nearly the same way.
inline bool has_few_faces(const ConvexSolid& solid) {
  return !solid.may_repeat && solid.normals.size() - 1 < few_faces && solid.shape.corners.size() <= few_faces &&
         solid.edges.size() <= few_edges;
}

/// Depths of a point below eight planes; those that a solid has not are far away.
struct alignas(sizeof(Lanes)) DepthRow {
  std::array<double, few_faces> below;  ///< [m]
};

/// What two solids share. Solid 0 is a, 1 is b; face f of solid s is loop f + 8 s.
struct EdgeOverlap {
  static constexpr int most_points = 48, most_loops = 2 * few_faces;
  struct Loop {
    int count = 0;  ///< of its points; 0: the face has no part in it
    std::array<std::uint8_t, most_points> point;
  };
  Vec3 origin;                                             ///< a point of the shared solid, of which arms are [m]
  int points = 0;                                          ///< 0 where there is no answer
  std::array<Lanes, most_points> arm;                      ///< x, y, z, 0 [m]
  std::array<std::array<DepthRow, most_points>, 2> depth;  ///< [solid][point]
  std::array<Loop, most_loops> loop;                       ///< counter-clockwise as seen from outside
};

/// True where the solids share a part of which this is sure, all of whose faces close. Both have few faces.
bool edge_overlap(const PlacedSolid& a, const PlacedSolid& b, EdgeOverlap& out);

}  // namespace trilith
