// A convex solid with the data that contact detection needs repeatedly, and the same solid placed in the world.
//
// A sphere is one corner with a radius: no faces, no edges.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/rotation_3d.hpp"
#include "geometry/space/polyhedron.hpp"
#include "geometry/space/sphere.hpp"

namespace trilith {

/// A convex solid in the axes of its body, built once.
struct ConvexSolid {
  Polyhedron shape;           ///< corners in the axes of the body [m]
  std::vector<Vec3> normals;  ///< [faces] outward unit normals
  std::vector<SolidEdge> edges;
  /// [faces] 1: part of the body's surface, 0: an inner cut; empty: all are surface
  std::vector<std::uint8_t> surface;
  /// [corners of shape.faces] length by which the body's surface continues in the face's plane beyond the edge from
  /// this corner to the next, in the next piece of a mesh [m]; empty: nowhere
  std::vector<double> goes_on;
  double size = 0;          ///< see solid_size [m]
  bool may_repeat = true;   ///< false if no two faces have nearly the same normal, see has_first_like
  double inner_radius = 0;  ///< radius of a ball inside the solid, centred at the mean of the corners [m]; twice it is
                            ///< a lower bound of the thickness
  double radius = 0;        ///< radius of a sphere about its one corner; 0 for a polyhedron [m]
  /// [faces] 1: an inner cut that carries pressure like a surface face, see is_pressed; empty: none
  std::vector<std::uint8_t> pressed_cuts = {};

  [[nodiscard]] bool is_sphere() const { return radius > 0; }
  [[nodiscard]] bool is_surface(int face) const {
    return surface.empty() || surface[static_cast<std::size_t>(face)] != 0;
  }
  /// Whether contact pressure acts on a face. Pressure on both sides of an inner cut cancels, so both sides are left
  /// out, but only together. A cut that faces only part of a face, or that is coplanar with a surface face, carries
  /// pressure.
  [[nodiscard]] bool is_pressed(int face) const {
    return is_surface(face) || (!pressed_cuts.empty() && pressed_cuts[static_cast<std::size_t>(face)] != 0);
  }
  /// [corners of the face] see goes_on; empty where the surface continues nowhere
  [[nodiscard]] std::span<const double> goes_on_from(int face) const {
    if (goes_on.empty()) return {};
    const auto f = static_cast<std::size_t>(face);
    const auto from = static_cast<std::size_t>(shape.faces.start[f]);
    return std::span(goes_on).subspan(from, static_cast<std::size_t>(shape.faces.start[f + 1]) - from);
  }
};

/// Throws in the cases of check_convex, with the same messages.
ConvexSolid convex_solid(const Polyhedron& shape, std::string_view owner, double flat = kFlatFace);

/// A sphere as a convex solid.
ConvexSolid convex_sphere(const Sphere& sphere);

/// A plane that bounds a body; outward unit normal.
struct BoundingPlane {
  Vec3 normal, point;
};

/// A solid placed in the world. Updated in each step without allocation after the first time.
struct PlacedSolid {
  const ConvexSolid* solid = nullptr;
  std::vector<Vec3> corners;  ///< [m]
  std::vector<Vec3> normals;  ///< [faces] unit normals
  /// For a piece of a mesh: faces of the neighbouring pieces that bound the body here, see Model::piece_bounds.
  std::vector<BoundingPlane> beside;
};

/// Places `solid`, rotated about the origin of its body, which is at `at` [m]. The solid must outlive `out`.
void place(const ConvexSolid& solid, const Turn3& turn, const Vec3& at, PlacedSolid& out);

/// Like place(), for all data but the corners, which are already placed.
void place_faces(const ConvexSolid& solid, const Turn3& turn, PlacedSolid& out);

/// Depth of a point below the plane of a face [m]; negative outside.
inline double depth_below(const PlacedSolid& solid, int face, const Vec3& x) {
  const auto f = static_cast<std::size_t>(face);
  return solid.normals[f].dot(solid.corners[static_cast<std::size_t>(solid.solid->shape.faces[face][0])] - x);
}

/// True for a surface face that is coplanar with an earlier one, which represents both.
bool has_first_like(const PlacedSolid& solid, int face);

}  // namespace trilith
