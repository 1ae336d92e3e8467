// The shape of a section for fibres: exact moments of the part between two levels.
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

/// Moments, about the bottom, of the part between the levels `low` and `high` above the bottom of the shape [m].
StripMoments strip_of(const FibreShape& shape, double low, double high);

/// Levels above the bottom where its width is discontinuous, including bottom and top [m].
std::vector<double> borders_of(const FibreShape& shape);

/// The core within a cover of constant thickness [m] on all faces, inner ones too. Throws InputError where nothing
/// remains, and for an outline, whose core must be given.
FibreShape core_of(const FibreShape& shape, double cover);

}  // namespace trilith
