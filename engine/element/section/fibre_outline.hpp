// The shape of a section as polygons in height and width, for fibres with both coordinates.
#pragma once

#include <vector>

#include "element/section/fibre_shape.hpp"

namespace trilith {

/// A simple polygon, counter-clockwise: (across, up) from the centre of the shape's width and from its bottom [m].
struct SectionPart {
  Polygon outline;
  double sign = 1;  ///< -1: a hole in the other parts
};

/// The parts of a shape. A circle becomes a polygon with 96 sides of equal area, whose second moments are exact to
/// 1e-6.
std::vector<SectionPart> parts_of(const FibreShape& shape);

/// Coordinates across where its width is discontinuous or where it ends, increasing [m].
std::vector<double> borders_across(const std::vector<SectionPart>& parts);

}  // namespace trilith
