// Solids bounded by plane polygons: what they are, their measures, and the check that makes one fit for use.
//
//              7 ________ 6
//              /|       /|        Each face is a loop of corners, counter-clockwise as seen from outside. So every edge
//            4/_|_____5/ |        belongs to two faces, which run through it in opposite directions.
//            |  3 - - |- 2
//            | /      | /         z |  / y
//            |/_______|/            | /
//            0        1             |/___ x
#pragma once

#include <Eigen/Core>

#include <span>
#include <string_view>
#include <vector>

#include "base/space.hpp"

namespace trilith {

/// A corner may lie this far off the plane of its face, or outside of a face of a convex solid, as a share of the
/// solid's size.
inline constexpr double kFlatFace = 1e-9;

/// Loops of indices, one after the other: those of the faces of a solid.
struct FaceLoops {
  std::vector<int> corner;    ///< loop after loop
  std::vector<int> start{0};  ///< [faces + 1] where each begins in `corner`, and the end of the last

  [[nodiscard]] int count() const { return static_cast<int>(start.size()) - 1; }
  [[nodiscard]] std::span<const int> operator[](int face) const {
    const auto from = start[static_cast<std::size_t>(face)], to = start[static_cast<std::size_t>(face) + 1];
    return {corner.data() + from, static_cast<std::size_t>(to - from)};
  }
  void add(std::span<const int> loop);
};

/// A solid bounded by plane polygons.
struct Polyhedron {
  std::vector<Vec3> corners;  ///< m
  FaceLoops faces;            ///< counter-clockwise as seen from outside
};

/// An edge and the two faces it parts.
struct SolidEdge {
  int from, to;     ///< corners
  int left, right;  ///< faces: the one whose loop runs from `from` to `to`, and the one that runs back
};

/// Edges in the order in which the faces first run through them, each in that direction; `right` is -1 where no face
/// runs back. Of a solid that check_polyhedron accepts each edge is there once.
std::vector<SolidEdge> solid_edges(const FaceLoops& faces);

/// Area of a loop times its unit normal, m2; of a loop that is not plane the same for any surface it bounds.
Vec3 area_vector(std::span<const Vec3> corners, std::span<const int> loop);

/// Outward unit normals of all faces, which must have an area.
std::vector<Vec3> face_normals(const Polyhedron& solid);

/// Diagonal of the axis-parallel box around at least 1 point, m: the size that tolerances refer to.
double solid_size(std::span<const Vec3> points);

/// Volume, centroid and inertia of a solid of density 1, each exact to rounding (taken about the first corner, so that
/// a solid far from the origin loses nothing). By the divergence theorem: sums over the tetrahedra between one point
/// and the triangles of the surface, with their signs.
struct SolidMoments {
  double volume;            ///< m3; negative where the solid is turned inside out
  Vec3 centroid;            ///< m; the first corner where the volume is zero
  Eigen::Matrix3d inertia;  ///< about the centroid: integral of |r|^2 I - r r^T, m5
};

/// Moments of a solid with a closed surface, convex or not.
SolidMoments solid_moments(const Polyhedron& solid);

/// Principal moments of inertia and the rotation from the world's axes to the principal ones.
struct PrincipalInertia {
  Vec3 moments;         ///< about the principal axes, in the unit of the tensor
  UnitQuaternion axes;  ///< turns the world's x, y, z to the first, second and third principal axis
};

/// Of a symmetric tensor, by Jacobi's rotations. Of the 24 right-handed ways to name and point the axes the one is
/// taken that turns the least, so that a tensor which is diagonal (a box along the axes) gives no rotation at all;
/// terms off the diagonal below 1e-14 of the largest moment count as 0, so that a cube's axes stay where they are.
PrincipalInertia principal_inertia(const Eigen::Matrix3d& inertia);

/// Axis-parallel box between two opposite corners, `low` below `high` in each coordinate, m.
Polyhedron box_solid(const Vec3& low, const Vec3& high);

/// What a plane polygon sweeps over as it moves by `along` [m], which must not lie in its plane. Corners: those of the
/// polygon, then those moved; faces: the polygon, it moved, then one for each of its edges. Either order of the polygon
/// serves.
Polyhedron extrusion(std::span<const Vec3> polygon, const Vec3& along);

/// Upright prism: a polygon of the x-y plane (either order, simple) from height `low` to `high`, m.
Polyhedron prism(std::span<const Vec2> outline, double low, double high);

/// `solid` turned about the origin, then moved by `shift` [m].
Polyhedron placed(const Polyhedron& solid, const UnitQuaternion& rotation, const Vec3& shift);

/// Refuses what bounds no solid, with an InputError that names face, edge or corner (counted from 1) and says by how
/// much and what to do: fewer than 4 faces or 3 corners of a face, a corner that is not there, is not finite, is named
/// twice by a face or belongs to none; an open edge; an edge that two faces run through in one direction; a face
/// without area or with a corner off its plane by more than `flat` times the size; a volume that is not above 0.
/// `owner` begins every message, e.g. "body 'pier 3'".
void check_polyhedron(const Polyhedron& solid, std::string_view owner, double flat = kFlatFace);

/// The same, and refuses a solid that is not convex: where a corner lies outside of a face by more than `flat` times
/// the size, it names the farthest.
void check_convex(const Polyhedron& solid, std::string_view owner, double flat = kFlatFace);

}  // namespace trilith
