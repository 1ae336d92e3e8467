// Common data of the panels of a figure: the visible part of the world, the scale of the forces, the colours of groups.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "draw/scene/scene_picture.hpp"

namespace trilith::draw {

/// Bodies of one role and group, which share a colour.
using BodyGroup = std::pair<BodyRole, std::string>;

/// A corner of a panel.
enum class PanelCorner { lower_left, lower_right, upper_left, upper_right };

struct SceneView {
  WorldBox world;                              ///< m
  std::vector<BodyGroup> groups;               ///< in order of first appearance
  double largest_force = 0;                    ///< N; 0 without forces
  double longest_arrow = 0;                    ///< m in the world, for `largest_force`
  bool bars = false;                           ///< forces as bars, not arrows
  double largest_ordinate = 0;                 ///< largest magnitude of diagrams; 0 without diagrams
  double longest_ordinate = 0;                 ///< m in the world, for `largest_ordinate`
  bool has_values = false;                     ///< some body, patch, face or strip has a value
  bool has_faces = false;                      ///< of polyhedra: ground is shaded, not hatched
  PanelCorner axes = PanelCorner::lower_left;  ///< corner of the world axes in all panels
  double low = 0, high = 0;                    ///< range of the values' colours
  double farthest = 0;    ///< largest magnitude of a value, if values have both signs: 0 has the middle colour
  UnitSystem units = {};  ///< of numbers in texts
};

/// Checks all scenes and the style and computes their common data. Throws InputError as scene_canvas.
SceneView scene_view(const std::vector<Scene>& scenes, const PictureStyle& style);

/// Text of a group in the legend.
std::string group_text(const BodyGroup& group);

/// Fill of a body; ground has its own. `group_index` counts the free groups.
Colour body_fill(const SceneView& view, const SceneBody& body);
/// Colour of a value of the scenes.
Colour value_fill(const SceneView& view, double value);
/// Colour of a value at `share` of the range: stronger for values farther from 0.
Colour value_colour(const SceneView& view, double share);
Colour group_fill(const SceneView& view, const BodyGroup& group);

/// Direction of a ground's hatch in degrees; neighbouring ground groups differ.
double hatch_direction(const SceneView& view, const BodyGroup& group);

/// From the world to a panel on the page, one scale in both directions.
struct PageView {
  WorldBox world;
  PageBox box;
  double scale = 1;  ///< pt per m
  PagePoint place(const Vec2& p) const {
    return {box.x0 + scale * (p.x() - world.x0), box.y1 - scale * (p.y() - world.y0)};
  }
};

/// An outline on the page, clipped slightly beyond the panel (so that a very large ground can be drawn); empty if
/// outside.
std::vector<PagePoint> page_outline(const PageView& page, const std::vector<Vec2>& outline);

}  // namespace trilith::draw
