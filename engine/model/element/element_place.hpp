// Present position of a material point of a body of elements, and the nodes that define it.
#pragma once

#include <array>
#include <string>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// The element that contained a point at the start, or else the nearest one.
struct ElementShares {
  int element = -1;
  std::array<double, max_space_nodes> share{};  ///< shape functions of its nodes at the point; the sum is 1
  double outside = 0;                           ///< distance of the point from it in natural coordinates; 0: inside [1]
};

/// `at`: position at the start [m], in a body of elements.
ElementShares element_shares(const Model<3>& model, int body, const Vec3& at);
/// For a point inside the body; throws InputError, which begins with `owner`, where it is not.
ElementShares element_shares(const Model<3>& model, int body, const Vec3& at, const std::string& owner);

/// Present position of the point at `at` [m] at the start: by the shape functions of the element that contained it, or
/// else extrapolated from the nearest one. The body consists of elements.
Vec3 element_place(const Model<3>& model, const State<3>& state, int body, const Vec3& at);

}  // namespace trilith
