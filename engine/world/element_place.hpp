// Where a point of a body of elements in space is now.
#pragma once

#include "world/model.hpp"
#include "world/state.hpp"

namespace trilith {

/// Of what was at `at` [m] at the start: by the shape functions of the element that it lay in, or else of the one that
/// it lay nearest to, which go on beyond it. The body is one of elements.
Vec3 element_place(const Model<3>& model, const State<3>& state, int body, const Vec3& at);

}  // namespace trilith
