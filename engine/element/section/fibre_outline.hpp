// What the shape of a section covers up and across, as polygons: for fibres that know both.
#pragma once

#include <vector>

#include "element/section/fibre_shape.hpp"

namespace trilith {

/// A simple polygon, counter-clockwise: (across, up) from the middle of the shape's width and from its bottom [m].
struct SectionPart {
  Polygon outline;
  double sign = 1;  ///< -1: a hole in what is beside it
};

/// The parts that a shape is made of. A circle is a polygon of 96 sides of its area, whose second moments are right to
/// 1e-6.
std::vector<SectionPart> parts_of(const FibreShape& shape);

/// Places across where its width changes at once or where it ends, rising [m].
std::vector<double> borders_across(const std::vector<SectionPart>& parts);

}  // namespace trilith
