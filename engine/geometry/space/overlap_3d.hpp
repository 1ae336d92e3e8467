// What two convex solids share: volume, centroid, and how the volume changes as one of them moves.
//
//            _________                 The surface of the shared solid is made of a's surface inside of b and of b's
//           |   a     |                inside of a. As b moves by t and turns by w about the centroid, its volume
//           |     ____|____            changes by
//           |    |////|    |
//           |____|////|    |             -t . area_vector - w . area_moment
//                |    b    |
//                |_________|           so that an energy that goes by the volume V pushes b by (dW/dV) area_vector.
//
// The two parts of the surface close it, so b's part has the opposite vectors.
#pragma once

#include <array>
#include <vector>

#include "geometry/plane/depth_table.hpp"
#include "geometry/space/convex_solid.hpp"
#include "geometry/space/triangle_lanes.hpp"

namespace trilith {

/// Room for the shared solid, kept by the caller so that repeated calls allocate nothing. Its faces are sets of edges
/// in no order.
struct SolidOverlapBuffer {
  struct Edge {
    int from, to;  ///< points; counter-clockwise about the face as seen from outside
  };
  struct Face {
    int of;   ///< k: in face k of a; -1 - k: in face k of b
    int end;  ///< one past its last edge; the first follows on the face before
  };
  struct Cut {
    int inner, outer;  ///< ends of an edge
    int point;         ///< where it was cut
  };
  std::vector<Vec3> points;  ///< m
  std::vector<Edge> edges;
  std::vector<Face> faces;  ///< in no order; empty where nothing is shared
  // scratch
  std::vector<Vec3> points_before;
  std::vector<Edge> edges_before, lid;
  std::vector<Face> faces_before;
  std::vector<double> height;
  std::vector<int> number;
  std::vector<Cut> cuts;
  // scratch of what goes over the points afterwards
  std::array<DepthRoom, 2> depths;
  std::vector<Vec3> arm;
  std::vector<FourTriangles> triangles;
};

/// A half-space: where normal . x <= offset. The normal may be of any length.
struct HalfSpace {
  Vec3 normal;
  double offset;
  int face;  ///< what the cut counts as, see SolidOverlapBuffer::Face::of
};

/// Keeps what of the solid in `buffer` lies in a half-space; the cut becomes a face. False where nothing is left.
bool cut(const HalfSpace& half, SolidOverlapBuffer& buffer);

/// Volume [m3] and centroid [m] of the solid in `buffer`, which has at least one face.
struct SolidMeasure {
  double volume;
  Vec3 centroid;
};
SolidMeasure measured(const SolidOverlapBuffer& buffer);

/// Volume shared by two convex solids.
struct SolidOverlap {
  double volume = 0;                ///< m3, never below 0
  Vec3 centroid = Vec3::Zero();     ///< of the shared volume, m; zero where there is none
  Vec3 area_vector = Vec3::Zero();  ///< integral of the outward normal over the surface of `a` inside `b`, m2
  Vec3 area_moment = Vec3::Zero();  ///< ... of (x - centroid) x normal over it, m3
};

/// Cuts one by the half-spaces of the other's faces, in turn. The surface stays closed to the bit whatever
/// rounding does (each cut point is found from its inner end in both faces it belongs to), so faces that are flush or
/// nearly so do no harm; of two that are flush and look the same way, the surface counts as a's or b's as rounding has
/// it. Exact to rounding, about a point of the shared solid, so that nothing is lost far from the origin but what the
/// corners have lost.
SolidOverlap solid_overlap(const PlacedSolid& a, const PlacedSolid& b, SolidOverlapBuffer& buffer);

/// The same volume alone, to the bit; leaves the same in `buffer`.
double shared_volume(const PlacedSolid& a, const PlacedSolid& b, SolidOverlapBuffer& buffer);

/// Area of one face of the shared solid and its centroid.
struct SharedFace {
  double area;    ///< m2
  Vec3 centroid;  ///< m; a point of the face where its area is zero
};

/// Of face `f` of `buffer.faces`, whose outward unit normal is `normal`.
SharedFace shared_face(const SolidOverlapBuffer& buffer, int f, const Vec3& normal);

}  // namespace trilith
