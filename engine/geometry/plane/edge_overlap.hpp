// The intersection of two convex solids with few faces, found from their edges.
//
// Input: two placed solids of at most eight corners and faces each. Output: the corners of the shared solid, with their
// depths below all faces of both, and the faces of the shared solid as loops of these corners. No solid is clipped. A
// corner of the shared solid is either a corner of one solid inside the other, or the point x where an edge of one
// passes through a face of the other. With the depth d(x) of a point below that face:
//
//   x = p + t (q - p),   t = d(p) / (d(p) - d(q)).
//
// Edges of the shared solid are parts of the solids' edges and intersections of two faces. Such an intersection joins
// the two corners that lie on both faces. Most edges are rejected by signs alone: both ends lie outside of one face.
//
// There is no result if rounding leaves loops open, e.g. where an edge passes through another one. The caller then
// clips (geometry/space/overlap_3d.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/simd/lane_vectors.hpp"
#include "geometry/space/convex_solid.hpp"

namespace trilith {

/// Largest number of corners, and of faces, of a solid with few faces. Its number of edges follows from Euler's
/// formula.
inline constexpr int few_faces = 8, few_edges = 14;

/// True for a polyhedron with few faces, no two of them nearly parallel and alike in direction.
inline bool has_few_faces(const ConvexSolid& solid) {
  return !solid.may_repeat && solid.normals.size() - 1 < few_faces && solid.shape.corners.size() <= few_faces &&
         solid.edges.size() <= few_edges;
}

/// Depths of a point below eight planes; unused planes are far away.
struct alignas(sizeof(Lanes)) DepthRow {
  std::array<double, few_faces> below;  ///< [m]
};

/// The intersection of two solids. Solid 0 is a, 1 is b; face f of solid s is loop f + 8 s.
struct EdgeOverlap {
  static constexpr int most_points = 48, most_loops = 2 * few_faces;
  struct Loop {
    int count;  ///< number of points
    std::array<std::uint8_t, most_points> point;
  };
  Vec3 origin;                                             ///< a point of the shared solid; arms start here [m]
  int points = 0;                                          ///< 0: no result
  std::array<Lanes, most_points> arm;                      ///< x, y, z, 0 [m]
  std::array<std::array<DepthRow, most_points>, 2> depth;  ///< [solid][point]
  unsigned faces = 0;                                      ///< bit l: loop l has points; the others are not set
  std::array<Loop, most_loops> loop;                       ///< counter-clockwise as seen from outside
};

/// How the intersection of two solids is put together: which edges pass through which faces. It stays the same over
/// many steps while the coordinates change.
struct OverlapTopology {
  static constexpr std::size_t most_parts = 16, most_points = 16, most_rims = 12, most_on_rim = 8;
  /// The part of an edge inside the other solid.
  struct Part {
    std::array<std::uint8_t, 4> joins;  ///< its edge's corners and faces: from, to, left, right
    std::uint8_t solid, edge;
    std::int8_t enters, leaves;  ///< faces of the other solid; -1: at an end of the edge
    std::uint8_t from, to;       ///< points at its ends
  };
  struct Rim {
    std::uint8_t loop, count;
    std::array<std::uint8_t, most_on_rim> point;
  };
  const PlacedSolid *a = nullptr, *b = nullptr;  ///< the solids; nullptr: empty
  std::size_t parts = 0, points = 0, rims = 0;
  std::array<Part, most_parts> part;                ///< in the order in which they make points
  std::array<std::uint16_t, most_points> on_faces;  ///< bit f: the point lies on face f of a; bit 8 + f: of b
  std::array<Rim, most_rims> rim;                   ///< faces of the intersection
};

/// True where the solids share a part, all faces of the part close, and the result is safe against rounding. Both
/// solids have few faces. `known`: topology of an earlier call, or nullptr. It is used if all its points, in the
/// present coordinates, lie inside of all other faces of both solids by more than rounding. Their hull is then the
/// intersection, because each of its faces lies in a face of one solid. Otherwise the topology is replaced. The result
/// has the same bits with and without it.
bool edge_overlap(const PlacedSolid& a, const PlacedSolid& b, EdgeOverlap& out, OverlapTopology* known = nullptr);

/// Topologies of recent intersections, for one thread. No result depends on them. The memory grows with the number of
/// pairs in use. When it is full of pairs that are out of use, it is emptied.
class OverlapMemory {
 public:
  /// The topology of a pair, empty for a new one; valid until the next call.
  OverlapTopology& of(const PlacedSolid& a, const PlacedSolid& b);

 private:
  static constexpr std::size_t least = 256, most = 16384;
  struct Entry {
    const PlacedSolid *a = nullptr, *b = nullptr;
    std::size_t place = 0;
  };
  void begin(std::size_t size);

  std::vector<Entry> entry_;  // hash table with open addressing, at most half full
  std::vector<OverlapTopology> topology_;
  std::size_t used_ = 0, asked_ = 0;  // topologies in use, calls since the last begin()
};

}  // namespace trilith
