// Solids and the axes of the world as they are drawn in a panel.
#pragma once

#include "draw/scene/scene_view.hpp"

namespace trilith::draw {

/// Rows of Scene::faces.
struct FaceRange {
  std::size_t begin = 0, end = 0;
};

/// Faces of the scene, shaded, with their edges, in their order. `edge_width` in pt.
void draw_faces(Canvas& canvas, const Scene& scene, FaceRange range, const SceneView& view, const PageView& page,
                double edge_width);

/// The faces of ground that come before all of free bodies.
FaceRange leading_ground(const Scene& scene);

/// Arrows along the axes in a corner of the panel; one that points at the eye is a dot.
void draw_axes(Canvas& canvas, const Scene& scene, PanelCorner corner, const PageView& page);

/// The first corner in which the axes lie over no body of any scene, else the lower left one. `page`: of any panel.
PanelCorner corner_for_axes(const std::vector<Scene>& scenes, const PageView& page);

/// `fill` in more or less light, 0 to 1; down to -.5 at the rim of balls.
Colour lit(const Colour& fill, double light);

}  // namespace trilith::draw
