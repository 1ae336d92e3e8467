// Legend of a figure of scenes below its panels: scale, groups of bodies, bearings, forces, values.
#pragma once

#include "draw/legend.hpp"
#include "draw/scene/scene_view.hpp"

namespace trilith::draw {

/// Entries for all that occurs in the scenes; `scale` in pt per m.
std::vector<LegendItem> scene_legend(const std::vector<Scene>& scenes, const SceneView& view, double scale,
                                     const PictureStyle& style);

}  // namespace trilith::draw
