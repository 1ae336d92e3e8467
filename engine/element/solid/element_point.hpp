// Points of elements in space: conversion between positions and natural coordinates.
#pragma once

#include <array>
#include <span>

#include "element/solid/space_element.hpp"

namespace trilith {

/// Shape functions at natural coordinates; extrapolated outside of the element.
std::array<double, max_space_nodes> shape_functions(ElementShape shape, const Vec3& natural);

/// Natural coordinates of a position [m], by Newton's method from the element's centre; `nodes`: as many as the shape
/// has.
Vec3 natural_coordinates(ElementShape shape, std::span<const Vec3> nodes, const Vec3& at);

/// Distance from the element in natural coordinates; 0 inside.
double outside_of(ElementShape shape, const Vec3& natural);

}  // namespace trilith
