// A convex solid cut by planes: what is left stays a closed solid of plane faces.
//
//          _______                 Corners below the plane stay to the bit, those within `same` of it count as on it;
//         /|     /|                where an edge goes through it there is a new corner, found once for both faces of
//        /_|_ _ /_|_ _ _  plane    the edge. What the faces leave open is closed by a lid.
//       | /    | /
//       |/_____|/
//
#pragma once

#include <optional>
#include <span>

#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// The half-space where normal . x <= offset.
struct CuttingPlane {
  Vec3 normal;    ///< of length 1
  double offset;  ///< m
};

/// What of a convex solid lies in a half-space; nothing where no corner is deeper in it than `same` [m], the solid
/// itself where none stands out by more. The lid is the last face. Time goes as the number of edges times its
/// logarithm, and as the corners of the lid squared.
std::optional<Polyhedron> cut_solid(const Polyhedron& solid, const CuttingPlane& plane, double same);

/// What all half-spaces have in common within `around`, a convex solid: cut one after the other.
std::optional<Polyhedron> cut_solid(Polyhedron around, std::span<const CuttingPlane> planes, double same);

/// A nearly convex solid with exactly plane faces: each face keeps its mean plane (through the mean of its corners, at
/// right angles to its area vector), and corners are where planes meet. A corner of more than three faces may come out
/// as several that lie near each other. `moved` [m]: how far a corner of the first is from the nearest of the second,
/// at most.
struct PlanarSolid {
  Polyhedron solid;
  double moved;
};
PlanarSolid with_plane_faces(const Polyhedron& solid);

}  // namespace trilith
