// Single pieces: a rectangle in any pose, a polygon of the user's own points.
#pragma once

#include <string>
#include <vector>

#include "build/plane/part.hpp"

namespace trilith {

/// Which point of a block `at` gives; the block is turned about that point.
enum class BlockAnchor { lower_left, centre };

/// A rectangle.
struct Block {
  std::string name;
  double width = 0;        ///< m, above 0
  double height = 0;       ///< m, above 0
  Vec2 at = Vec2::Zero();  ///< position of the anchor, m
  BlockAnchor anchor = BlockAnchor::lower_left;
  double angle = 0;  ///< counter-clockwise about `at`, rad
  std::vector<std::string> groups = {};
};

/// Outline of `block`, beginning with its (unturned) lower left corner. Throws InputError for sizes that are not above
/// 0.
Part build_block(const Block& block);

/// A polygon part and what had to be repaired of the given points.
struct PolygonPart {
  Part part;
  std::vector<std::string> notes;  ///< one line each, see check_polygon
};

/// Part from a user's points; throws InputError where they make no simple polygon (see check_polygon).
PolygonPart build_polygon(const std::string& name, Polygon points, std::vector<std::string> groups = {});

}  // namespace trilith
