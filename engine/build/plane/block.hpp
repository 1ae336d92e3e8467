// Single parts: a rectangle in any pose, and a polygon of given points.
#pragma once

#include <string>
#include <vector>

#include "build/builder_keys.hpp"
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

  static constexpr std::string_view kind = "block";
  static constexpr std::string_view sentence = "a rectangle in any pose";
  static constexpr bool is_single = true;
  static constexpr auto keys() {
    using K = KeysOf<Block>;
    return std::tuple(
        Refused{"size", "'size' is for blocks in space, in models with dim = 3; in the plane give width and height"},
        K::Number{&Block::width, "width", "m", "size along its own x", above_zero, must_be_given},
        K::Number{&Block::height, "height", "m", "size along its own y", above_zero, must_be_given},
        K::Point{&Block::at, "at", "position of the anchor"},
        K::Choice<BlockAnchor, 2>{&Block::anchor, "anchor", "corner or centre", {"lower_left", "centre"}},
        K::Number{&Block::angle, "angle", "rad", "rotation, counter-clockwise"});
  }
  /// build_block.
  [[nodiscard]] std::vector<Part> parts() const;
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

/// build_polygon as a builder of scripts.
struct PolygonShape {
  std::string name = {};
  Polygon outline = {};

  static constexpr std::string_view kind = "polygon";
  static constexpr std::string_view sentence = "a polygon of given points";
  static constexpr bool is_single = true;
  static constexpr auto keys() {
    return std::tuple(KeysOf<PolygonShape>::Points{&PolygonShape::outline, "outline", "corners in order"});
  }
  [[nodiscard]] BuiltParts parts() const;
};

}  // namespace trilith
