// Where a point of a body of elements in space is now, and which nodes it belongs to.
#pragma once

#include <array>
#include <string>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// The element that a place lay in at the start, or else the one that it lay nearest to.
struct ElementShares {
  int element = -1;
  std::array<double, max_space_nodes> share{};  ///< values of the shape functions of its nodes there, which sum to 1
  double outside = 0;  ///< how far the place lies outside of it, in natural coordinates; 0: it does not [1]
};

/// `at`: a place at the start [m], of a body of elements.
ElementShares element_shares(const Model<3>& model, int body, const Vec3& at);
/// The same of a place that lies in the body; throws InputError, begun with `owner`, where it does not.
ElementShares element_shares(const Model<3>& model, int body, const Vec3& at, const std::string& owner);

/// Of what was at `at` [m] at the start: by the shape functions of the element that it lay in, or else of the one that
/// it lay nearest to, which go on beyond it. The body is one of elements.
Vec3 element_place(const Model<3>& model, const State<3>& state, int body, const Vec3& at);

}  // namespace trilith
