// The shape of a section as fibres need it: what of it lies between two levels, exactly.
#pragma once

#include <variant>
#include <vector>

#include "element/section/section.hpp"
#include "geometry/plane/polygon.hpp"

namespace trilith {

/// A simple polygon in its own axes: x out of plane, y up [m].
struct SectionOutline {
  Polygon outline;
};
using FibreShape = std::variant<RectangleSection, CircleSection, ISection, TSection, BoxSection, SectionOutline>;

/// Moments of an area about a level.
struct StripMoments {
  double area = 0;    ///< [m2]
  double first = 0;   ///< [m3]
  double second = 0;  ///< [m4]
  StripMoments& operator+=(const StripMoments& o) {
    return area += o.area, first += o.first, second += o.second, *this;
  }
  StripMoments& operator-=(const StripMoments& o) {
    return area -= o.area, first -= o.first, second -= o.second, *this;
  }
};

Section section_of(const FibreShape& shape);

/// Of what lies between `low` and `high`, levels above the bottom of the shape [m], about the bottom.
StripMoments strip_of(const FibreShape& shape, double low, double high);

/// Levels above the bottom where its width changes at once, the bottom and the top among them [m].
std::vector<double> borders_of(const FibreShape& shape);

/// What is left within a cover of even thickness [m] on all its faces, inner ones too. Throws InputError where nothing
/// is, and for an outline, whose core has to be given.
FibreShape core_of(const FibreShape& shape, double cover);

}  // namespace trilith
