// Cuts a convex solid by planes; the remainder is a closed solid with plane faces.
//
//          _______
//         /|     /|
//        /_|_ _ /_|_ _ _  plane
//       | /    | /
//       |/_____|/
//
// Corners below the plane do not change; corners within `same` of it count as on it. Where an edge passes through it
// a new corner is made, once for both faces of the edge. A new face, the lid, closes the opening.
#pragma once

#include <optional>
#include <span>

#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// The half-space normal . x <= offset.
struct CuttingPlane {
  Vec3 normal;    ///< unit normal
  double offset;  ///< [m]
};

/// The part of a convex solid in a half-space. Empty where no corner is deeper in it than `same` [m]; the solid itself
/// where no corner stands out by more. The lid is the last face. Time grows as the number of edges times its logarithm,
/// and as the square of the lid's corners.
std::optional<Polyhedron> cut_solid(const Polyhedron& solid, const CuttingPlane& plane, double same);

/// The intersection of all half-spaces with the convex solid `around`: cut one after the other.
std::optional<Polyhedron> cut_solid(Polyhedron around, std::span<const CuttingPlane> planes, double same);

/// A nearly convex solid rebuilt with exactly plane faces. Each face keeps its mean plane (through the mean of its
/// corners, normal to its area vector), and corners are intersections of planes. A corner of more than three faces may
/// become several corners near each other. `moved` [m]: largest distance of an original corner from the nearest new
/// one.
struct PlanarSolid {
  Polyhedron solid;
  double moved;
};
PlanarSolid with_plane_faces(const Polyhedron& solid);

}  // namespace trilith
