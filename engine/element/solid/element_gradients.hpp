// Gradients of the shape functions of elements in space at the points where an element inverts first.
#pragma once

#include <span>
#include <vector>

#include "element/solid/space_element.hpp"

namespace trilith {

/// Gradients of each node at the corners and Gauss points of a reference shape [1/m].
std::vector<std::array<Vec3, max_space_nodes>> watched_gradients(ElementShape shape, std::span<const Vec3> nodes);

}  // namespace trilith
