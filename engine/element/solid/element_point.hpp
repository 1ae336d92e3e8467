// Points of elements in space: natural coordinates of a place, and the place of natural coordinates.
#pragma once

#include <array>
#include <span>

#include "element/solid/space_element.hpp"

namespace trilith {

/// Values of the shape functions at natural coordinates; beyond the element too, where they go on.
std::array<double, max_space_nodes> shape_functions(ElementShape shape, const Vec3& natural);

/// Natural coordinates of a place [m], by Newton's method from the element's middle; `nodes`: as many as the shape has.
Vec3 natural_coordinates(ElementShape shape, std::span<const Vec3> nodes, const Vec3& at);

/// How far outside of the element they are, in natural coordinates; 0 within.
double outside_of(ElementShape shape, const Vec3& natural);

}  // namespace trilith
