// Single parts: a rectangle in any pose, and a polygon of given points.
#pragma once

#include <string>
#include <vector>

#include "build/plane/part.hpp"

namespace trilith {

/// The point of a block that `at` refers to; the block is rotated about it.
enum class BlockAnchor { lower_left, centre };

/// A rectangle.
struct Block {
  std::string name;
  double width = 0;        ///< [m], above 0
  double height = 0;       ///< [m], above 0
  Vec2 at = Vec2::Zero();  ///< position of the anchor [m]
  BlockAnchor anchor = BlockAnchor::lower_left;
  double angle = 0;  ///< counter-clockwise about `at` [rad]
  std::vector<std::string> groups = {};
};

/// Outline of `block`, beginning with its lower left corner before rotation. Throws InputError for sizes that are not
/// above 0.
Part build_block(const Block& block);

/// A polygon part and the repairs of the given points.
struct PolygonPart {
  Part part;
  std::vector<std::string> notes;  ///< one line each, see check_polygon
};

/// Part from given points; throws InputError if they form no simple polygon (see check_polygon).
PolygonPart build_polygon(const std::string& name, Polygon points, std::vector<std::string> groups = {});

}  // namespace trilith
