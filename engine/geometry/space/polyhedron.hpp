// Solids bounded by plane polygons: data, measures and checks.
//
//              7 ________ 6
//              /|       /|
//            4/_|_____5/ |
//            |  3 - - |- 2
//            | /      | /         z |  / y
//            |/_______|/            | /
//            0        1             |/___ x
//
// Each face is a loop of corners, counter-clockwise seen from outside. So every edge belongs to two faces, which run
// along it in opposite directions.
#pragma once

#include <Eigen/Core>

#include <span>
#include <string_view>
#include <vector>

#include "base/space.hpp"

namespace trilith {

/// Tolerance of a corner's distance from its face's plane, relative to the solid's size. For a convex solid it is also
/// the tolerance of a corner's height over another face.
inline constexpr double kFlatFace = 1e-9;

/// Loops of indices, one after the other: the faces of a solid.
struct FaceLoops {
  std::vector<int> corner;    ///< loop after loop
  std::vector<int> start{0};  ///< [faces + 1] start of each loop in `corner`, and the end of the last one

  [[nodiscard]] int count() const { return static_cast<int>(start.size()) - 1; }
  [[nodiscard]] std::span<const int> operator[](int face) const {
    const auto from = start[static_cast<std::size_t>(face)], to = start[static_cast<std::size_t>(face) + 1];
    return {corner.data() + from, static_cast<std::size_t>(to - from)};
  }
  void add(std::span<const int> loop);
};

/// A solid bounded by plane polygons.
struct Polyhedron {
  std::vector<Vec3> corners;  ///< [m]
  FaceLoops faces;            ///< counter-clockwise seen from outside
};

/// An edge and its two faces.
struct SolidEdge {
  int from, to;     ///< corners
  int left, right;  ///< faces: `left` runs from `from` to `to`, `right` runs back
};

/// Edges in the order and direction in which the faces first run along them; `right` is -1 where no face runs back. A
/// solid that check_polyhedron accepts has each edge once.
std::vector<SolidEdge> solid_edges(const FaceLoops& faces);

/// Area of a loop times its unit normal [m2]; for a loop that is not plane, the vector area of any surface that it
/// bounds.
Vec3 area_vector(std::span<const Vec3> corners, std::span<const int> loop);

/// Outward unit normals of all faces, which must have an area.
std::vector<Vec3> face_normals(const Polyhedron& solid);

/// Diagonal of the axis-aligned box around at least 1 point [m]: the reference size of tolerances.
double solid_size(std::span<const Vec3> points);

/// Volume, centroid and inertia of a solid of density 1, each exact to rounding. Computed about the first corner, so a
/// solid far from the origin loses no digits. By the divergence theorem: signed sums over tetrahedra between one point
/// and the triangles of the surface.
struct SolidMoments {
  double volume;            ///< [m3]; negative where the faces are reversed
  Vec3 centroid;            ///< [m]; the first corner where the volume is zero
  Eigen::Matrix3d inertia;  ///< about the centroid: integral of |r|^2 I - r r^T [m5]
};

/// Moments of a solid with a closed surface, convex or not.
SolidMoments solid_moments(const Polyhedron& solid);

/// Principal moments of inertia and the rotation from world axes to principal axes.
struct PrincipalInertia {
  Vec3 moments;         ///< about the principal axes, in the unit of the tensor
  UnitQuaternion axes;  ///< rotates the world's x, y, z to the first, second and third principal axis
};

/// Eigenvalues of a symmetric tensor by Jacobi rotations. There are 24 right-handed ways to name and direct the axes;
/// the smallest rotation is returned. So a diagonal tensor (an axis-aligned box) gives no rotation. Off-diagonal terms
/// below 1e-14 of the largest moment count as 0, so a cube keeps its axes.
PrincipalInertia principal_inertia(const Eigen::Matrix3d& inertia);

/// Axis-aligned box between two opposite corners [m], `low` below `high` in each coordinate.
Polyhedron box_solid(const Vec3& low, const Vec3& high);

/// The solid swept by a plane polygon that moves by `along` [m], which must not lie in its plane. Corners: the
/// polygon's, then the moved ones. Faces: the polygon, the moved polygon, then one for each edge. The polygon may have
/// either orientation.
Polyhedron extrusion(std::span<const Vec3> polygon, const Vec3& along);

/// Upright prism: a polygon of the x-y plane (either orientation, simple) from height `low` to `high` [m].
Polyhedron prism(std::span<const Vec2> outline, double low, double high);

/// `solid` rotated about the origin, then moved by `shift` [m].
Polyhedron placed(const Polyhedron& solid, const UnitQuaternion& rotation, const Vec3& shift);

/// Throws InputError where the faces bound no solid. The message names the face, edge or corner (counted from 1), the
/// amount and a remedy. Cases: fewer than 4 faces or 3 corners of a face, a corner that does not exist, is not finite,
/// occurs twice in a face or is unused. Further an open edge, and an edge that two faces run along in the same
/// direction. Also a face without area or with a corner off its plane by more than `flat` times the size, and a volume
/// that is not above 0. `owner` begins every message, e.g. "body 'pier 3'".
void check_polyhedron(const Polyhedron& solid, std::string_view owner, double flat = kFlatFace);

/// Like check_polyhedron, and throws if the solid is not convex: if corners lie outside of a face by more than `flat`
/// times the size, the message names the farthest one.
void check_convex(const Polyhedron& solid, std::string_view owner, double flat = kFlatFace);

}  // namespace trilith
