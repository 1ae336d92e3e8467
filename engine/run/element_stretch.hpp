// The largest strain of finite elements, and the travel before one reaches the limit of its material.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Largest principal strain of an element, from the deformation gradient at its corners.
struct ElementStretch {
  int element = -1;
  double strain = 0;  ///< stretch minus 1; at -1 and below a corner has no area left, or is inverted [1]
  double spare = 0;   ///< remaining strain up to the limit of the material; 0 or negative beyond it [1]
};

/// The worst element of all active bodies. `room` is reduced to the travel of all points before any element may reach
/// its limit.
template <int D>
ElementStretch worst_element(const Model<D>& model, const State<D>& state, double& room);

}  // namespace trilith
