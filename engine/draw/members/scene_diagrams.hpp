// Diagrams of section forces and marks of plastic hinges in a panel and in its legend.
#pragma once

#include <string>
#include <vector>

#include "draw/scene/scene_view.hpp"

namespace trilith::draw {

/// Draws the diagrams of a scene, with their extreme values as texts where there is space. Adds the boxes of the texts
/// to `marks`.
void draw_diagrams(Canvas& canvas, const Scene& scene, const SceneView& view, const PageView& page,
                   std::vector<PageBox>& marks);

/// Colours of values of a sign.
Colour diagram_fill(double sign);
Colour diagram_line(double sign);

/// Draws the hinges of a scene, slightly inside their members.
void draw_hinges(Canvas& canvas, const Scene& scene, const PageView& page, std::vector<PageBox>& marks);
/// The symbol of a state, and its text in the legend.
void draw_hinge_mark(Canvas& canvas, const PagePoint& at, HingeMark state);
std::string hinge_text(HingeMark state);

}  // namespace trilith::draw
