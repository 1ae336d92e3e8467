// The intersection of two convex solids: volume, centroid, and derivative of the volume with respect to motion.
//
//            _________
//           |   a     |
//           |     ____|____
//           |    |////|    |
//           |____|////|    |
//                |    b    |
//                |_________|
//
// The surface of the shared solid consists of a's surface inside b and b's surface inside a. As b moves by t and
// rotates by w about the centroid, the volume changes by -t . area_vector - w . area_moment. So an energy W that
// depends on the volume V gives the force (dW/dV) area_vector on b. The two parts of the surface form a closed one, so
// b's part has the opposite vectors.
#pragma once

#include <array>
#include <vector>

#include "geometry/plane/depth_table.hpp"
#include "geometry/space/convex_solid.hpp"
#include "geometry/space/triangle_lanes.hpp"

namespace trilith {

/// Scratch buffer for the shared solid, kept by the caller so that repeated calls allocate nothing. Its faces are
/// unordered sets of edges.
struct SolidOverlapBuffer {
  struct Edge {
    int from, to;  ///< points; counter-clockwise around the face seen from outside
  };
  struct Face {
    int of;   ///< k: in face k of a; -1 - k: in face k of b
    int end;  ///< one past its last edge; the first edge follows the previous face's last one
  };
  struct Cut {
    int inner, outer;  ///< ends of an edge
    int point;         ///< the cut point
  };
  std::vector<Vec3> points;  ///< [m]
  std::vector<Edge> edges;
  std::vector<Face> faces;  ///< unordered; empty where nothing is shared
  // scratch
  std::vector<Vec3> points_before;
  std::vector<Edge> edges_before, lid;
  std::vector<Face> faces_before;
  std::vector<double> height;
  std::vector<int> number;
  std::vector<Cut> cuts;
  // scratch of later passes over the points
  std::array<DepthRoom, 2> depths;
  std::vector<Vec3> arm;
  std::vector<FourTriangles> triangles;
};

/// The half-space normal . x <= offset. The normal may have any length.
struct HalfSpace {
  Vec3 normal;
  double offset;
  int face;  ///< face number of the cut, see SolidOverlapBuffer::Face::of
};

/// Clips the solid in `buffer` to a half-space; the cut becomes a face. False where nothing is left.
bool cut(const HalfSpace& half, SolidOverlapBuffer& buffer);

/// Volume [m3] and centroid [m] of the solid in `buffer`, which has at least one face.
struct SolidMeasure {
  double volume;
  Vec3 centroid;
};
SolidMeasure measured(const SolidOverlapBuffer& buffer);

/// Volume shared by two convex solids.
struct SolidOverlap {
  double volume = 0;                ///< [m3], never below 0
  Vec3 centroid = Vec3::Zero();     ///< of the shared volume [m]; zero if there is none
  Vec3 area_vector = Vec3::Zero();  ///< integral of the outward normal over the surface of `a` inside `b` [m2]
  Vec3 area_moment = Vec3::Zero();  ///< integral of (x - centroid) x normal over the same surface [m3]
};

/// Clips one solid by the half-spaces of the other's faces, one after the other. The surface stays closed to the bit
/// whatever the rounding, because each cut point is computed from its inner end in both faces of the edge. So faces
/// that are flush or nearly flush do no harm. Of two flush faces with the same normal, rounding decides which solid
/// owns the surface. Exact to rounding about a point of the shared solid, so a position far from the origin costs no
/// digits beyond the corners'.
SolidOverlap solid_overlap(const PlacedSolid& a, const PlacedSolid& b, SolidOverlapBuffer& buffer);

/// The volume alone, with the same bits and the same contents of `buffer`.
double shared_volume(const PlacedSolid& a, const PlacedSolid& b, SolidOverlapBuffer& buffer);

/// Area of one face of the shared solid and its centroid.
struct SharedFace {
  double area;    ///< [m2]
  Vec3 centroid;  ///< [m]; a point of the face where its area is zero
};

/// Face `f` of `buffer.faces`, whose outward unit normal is `normal`.
SharedFace shared_face(const SolidOverlapBuffer& buffer, int f, const Vec3& normal);

}  // namespace trilith
