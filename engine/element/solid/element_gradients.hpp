// Gradients of the shape functions of elements in space where an element turns inside out first.
#pragma once

#include <span>
#include <vector>

#include "element/solid/space_element.hpp"

namespace trilith {

/// At the corners and the points of Gauss of a reference shape: of each node [1/m].
std::vector<std::array<Vec3, max_space_nodes>> watched_gradients(ElementShape shape, std::span<const Vec3> nodes);

}  // namespace trilith
