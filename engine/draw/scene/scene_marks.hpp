// Drawing of bodies, forces and bearings in a panel and in its legend.
#pragma once

#include "draw/scene/scene_view.hpp"

namespace trilith::draw {

/// Hatch and muted fill of ground within an outline on the page.
void draw_ground(Canvas& canvas, const std::vector<PagePoint>& outline, double hatch_degrees,
                 const Stroke& outline_stroke);

/// A dashed outline of an earlier configuration.
Stroke ghost_stroke();

/// An arrow (start to end) or a bar (centred between start and end) on the page.
void draw_force(Canvas& canvas, const PagePoint& start, const PagePoint& end, bool bar);

/// A broken joint, and its text in the legend.
void draw_crack(Canvas& canvas, const PagePoint& a, const PagePoint& b, CrackMark mark);
std::string crack_text(CrackMark mark);
/// The stroke of lines over the bodies.
Stroke line_stroke();

/// The symbol of a bearing's state, `radius` in pt.
inline constexpr double bearing_mark_radius = 2.1;
void draw_bearing_mark(Canvas& canvas, const PagePoint& at, BearingMark state, double radius = bearing_mark_radius);
/// A white disc that separates a symbol from the background.
void draw_bearing_halo(Canvas& canvas, const PagePoint& at, double radius);
std::string bearing_text(BearingMark state);

/// `points` moved apart along x, in the order of their x, until their distances are at least `least` [pt], as far as
/// some rounds achieve it: two bearings on one pier remain two symbols.
std::vector<PagePoint> spread(std::vector<PagePoint> points, double least);

/// Draws all of a scene except its texts. Returns the boxes of the marks, which texts should not cover.
std::vector<PageBox> draw_scene_content(Canvas& canvas, const Scene& scene, const SceneView& view,
                                        const PageView& page);

/// Luminance-based choice of ink for text on `fill`.
Colour ink_on(const Colour& fill);

}  // namespace trilith::draw
