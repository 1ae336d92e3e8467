// What a figure of scenes explains below its panels: scale, groups of bodies, bearings, forces, values.
#pragma once

#include "record/legend.hpp"
#include "record/scene_view.hpp"

namespace trilith {

/// Entries for all that occurs in the scenes; `scale` in pt per m.
std::vector<LegendItem> scene_legend(const std::vector<Scene>& scenes, const SceneView& view, double scale,
                                     const PictureStyle& style);

}  // namespace trilith
