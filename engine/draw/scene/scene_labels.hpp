// Names of bodies, set inside them where they fit, else beside them, never over anything else.
#pragma once

#include "draw/scene/scene_view.hpp"

namespace trilith::draw {

/// Writes the names of a scene's bodies into their panel; one that finds no free place is left out. `marks`: boxes that
/// no name may cover.
void draw_labels(Canvas& canvas, const Scene& scene, const SceneView& view, const PageView& page,
                 std::vector<PageBox> marks, const TextStyle& style);

}  // namespace trilith::draw
