// Names of bodies, placed inside them if they fit, otherwise next to them, without covering anything else.
#pragma once

#include "draw/scene/scene_view.hpp"

namespace trilith::draw {

/// Draws the names of a scene's bodies in their panel; a name without a free position is omitted. `marks`: boxes that
/// no name may cover.
void draw_labels(Canvas& canvas, const Scene& scene, const SceneView& view, const PageView& page,
                 std::vector<PageBox> marks, const TextStyle& style);

}  // namespace trilith::draw
