// Drawing of polyhedra and of the world axes in a panel.
#pragma once

#include "draw/scene/scene_view.hpp"

namespace trilith::draw {

/// Rows of Scene::faces.
struct FaceRange {
  std::size_t begin = 0, end = 0;
};

/// Draws faces of the scene, shaded, with their edges, in their order. `edge_width` in pt.
void draw_faces(Canvas& canvas, const Scene& scene, FaceRange range, const SceneView& view, const PageView& page,
                double edge_width);

/// The faces of ground before the first face of a free body.
FaceRange leading_ground(const Scene& scene);

/// Draws arrows along the axes in a corner of the panel; an axis towards the eye is a dot.
void draw_axes(Canvas& canvas, const Scene& scene, PanelCorner corner, const PageView& page);

/// The first corner in which the axes cover no body of any scene, otherwise the lower left one. `page`: of any panel.
PanelCorner corner_for_axes(const std::vector<Scene>& scenes, const PageView& page);

/// `fill` with more or less light, from 0 to 1; down to -0.5 at the rim of spheres.
Colour lit(const Colour& fill, double light);

}  // namespace trilith::draw
