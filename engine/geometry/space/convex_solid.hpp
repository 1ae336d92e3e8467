// A convex solid with what contact asks of it again and again, and the same where it stands.
//
// A sphere is one corner with a radius around it: no faces, no edges.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/rotation_3d.hpp"
#include "geometry/space/polyhedron.hpp"
#include "geometry/space/sphere.hpp"

namespace trilith {

/// A convex solid in the axes of its body, made once.
struct ConvexSolid {
  Polyhedron shape;           ///< corners in the axes of the body [m]
  std::vector<Vec3> normals;  ///< [faces] outward, of length 1
  std::vector<SolidEdge> edges;
  /// [faces] 1: part of the surface of the body, 0: an inner cut; empty: all are surface
  std::vector<std::uint8_t> surface;
  /// [corners of shape.faces] by how much the surface of the body goes on in the plane of a face beyond its edge from
  /// this corner to the next, in the next piece of a mesh [m]; empty: nowhere
  std::vector<double> goes_on;
  double size = 0;         ///< see solid_size [m]
  bool may_repeat = true;  ///< false where no two faces look nearly the same way, see has_first_like
  double inner_radius =
      0;              ///< of a ball about the mean of its corners that it holds [m]: nowhere thinner than twice it
  double radius = 0;  ///< of a sphere about its one corner; 0 of a polyhedron [m]
  /// [faces] 1: an inner cut that is pressed like a face of the surface, see is_pressed; empty: none is
  std::vector<std::uint8_t> pressed_cuts = {};

  [[nodiscard]] bool is_sphere() const { return radius > 0; }
  [[nodiscard]] bool is_surface(int face) const {
    return surface.empty() || surface[static_cast<std::size_t>(face)] != 0;
  }
  /// Whether contact presses a face. What presses both sides of an inner cut presses neither in sum, so they are left
  /// out, but only together: a cut against a part of a face, or in the plane of a face that is surface, is pressed.
  [[nodiscard]] bool is_pressed(int face) const {
    return is_surface(face) || (!pressed_cuts.empty() && pressed_cuts[static_cast<std::size_t>(face)] != 0);
  }
  /// [corners of the face] see goes_on; empty where it goes on nowhere at all
  [[nodiscard]] std::span<const double> goes_on_from(int face) const {
    if (goes_on.empty()) return {};
    const auto f = static_cast<std::size_t>(face);
    const auto from = static_cast<std::size_t>(shape.faces.start[f]);
    return std::span(goes_on).subspan(from, static_cast<std::size_t>(shape.faces.start[f + 1]) - from);
  }
};

/// Refuses what check_convex refuses, with the same messages.
ConvexSolid convex_solid(const Polyhedron& shape, std::string_view owner, double flat = kFlatFace);

/// A sphere as a convex solid.
ConvexSolid convex_sphere(const Sphere& sphere);

/// A plane that bounds a body, its normal outward, of length 1.
struct BoundingPlane {
  Vec3 normal, point;
};

/// Where a solid stands in the world. Filled anew in each step, it allocates nothing after the first time.
struct PlacedSolid {
  const ConvexSolid* solid = nullptr;
  std::vector<Vec3> corners;  ///< [m]
  std::vector<Vec3> normals;  ///< [faces]
  /// Of a piece of a mesh: faces of the pieces next to it that bound the body where it lies, see Model::piece_bounds.
  std::vector<BoundingPlane> beside;
};

/// `solid` turned about the origin of its body, which stands at `at` [m]. The solid must outlive `out`.
void place(const ConvexSolid& solid, const Turn3& turn, const Vec3& at, PlacedSolid& out);

/// The same of all but the corners, which are there.
void place_faces(const ConvexSolid& solid, const Turn3& turn, PlacedSolid& out);

/// How deep a point lies below the plane of a face [m]; negative outside.
inline double depth_below(const PlacedSolid& solid, int face, const Vec3& x) {
  const auto f = static_cast<std::size_t>(face);
  return solid.normals[f].dot(solid.corners[static_cast<std::size_t>(solid.solid->shape.faces[face][0])] - x);
}

/// True of a surface face that lies in the plane of one before it, which stands for both.
bool has_first_like(const PlacedSolid& solid, int face);

}  // namespace trilith
