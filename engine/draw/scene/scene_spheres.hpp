// Spheres among the polyhedra of a picture: their place in the painting order.
#pragma once

#include "draw/scene/paint_order.hpp"
#include "draw/scene/scene_picture.hpp"
#include "results/file/placement.hpp"

namespace trilith::draw {

/// A sphere of a body in its present position.
struct SeenSphere {
  int body;
  Vec3 centre;
  double radius;
};

/// The spheres of all bodies that are drawn.
std::vector<SeenSphere> seen_spheres(const results::Header& header, const results::Placement& at,
                                     const std::vector<bool>& left_out);

/// For each sphere, from the farthest to the nearest, the number of pieces that are painted before it; the pieces are
/// in painting order. All pieces behind it and visible with it are included, and all pieces before a farther sphere
/// that it covers. Exact unless a piece must be both before and after it.
struct SpherePlace {
  std::size_t sphere, pieces_before;
};
std::vector<SpherePlace> sphere_places(const std::vector<SeenSphere>& spheres, const std::vector<SolidPiece>& pieces,
                                       const ViewAxes& view);

/// A visible disc, shaded as a sphere.
SceneFace sphere_face(const SeenSphere& sphere, const ViewAxes& view);

}  // namespace trilith::draw
