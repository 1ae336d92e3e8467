// Spheres among the solids of a picture: where each of them comes in the order of painting.
#pragma once

#include "draw/scene/paint_order.hpp"
#include "draw/scene/scene_picture.hpp"
#include "results/file/placement.hpp"

namespace trilith::draw {

/// A sphere of a body where it stands.
struct SeenSphere {
  int body;
  Vec3 centre;
  double radius;
};

/// Those of the bodies that are not left out.
std::vector<SeenSphere> seen_spheres(const results::Header& header, const results::Placement& at,
                                     const std::vector<bool>& left_out);

/// For each sphere, from the farthest to the nearest, how many of the pieces, which are in the order of painting, come
/// before it: all that lie behind it where both are seen, and no fewer than of a farther sphere that it covers. Exact
/// where no piece must come both before and after it.
struct SpherePlace {
  std::size_t sphere, pieces_before;
};
std::vector<SpherePlace> sphere_places(const std::vector<SeenSphere>& spheres, const std::vector<SolidPiece>& pieces,
                                       const ViewAxes& view);

/// A disc as it is seen, shaded as a ball.
SceneFace sphere_face(const SeenSphere& sphere, const ViewAxes& view);

}  // namespace trilith::draw
