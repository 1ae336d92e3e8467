// Stress in an element, for recordings and scripts.
#pragma once

#include <array>

#include "law/material/list.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Stress in the co-rotating axes of the element.
struct ElementStress {
  int points = 0;
  std::array<Stress, 4> at_point;  ///< [Pa]
  Stress mean;                     ///< mean over the area [Pa]
  double plastic = 0;              ///< mean of PlasticMemory::measure
  double area = 0;                 ///< of the reference shape [m2]
  double axes_c = 1, axes_s = 0;   ///< cosine and sine of the angle of the element axes
};

/// Stress from the motion of the nodes and the plastic memory of `state`.
ElementStress element_stress(const Model<2>& model, const State<2>& state, int element);
/// The mean stress in world axes [Pa].
Stress in_world(const ElementStress& stress);

/// Stress of an element in space: xx, yy, zz, xy, yz, zx.
struct SpaceElementStress {
  int points = 0;
  std::array<SpaceVector, max_space_points> at_point;  ///< [Pa]
  SpaceVector mean = SpaceVector::Zero();              ///< over the volume [Pa]
  double plastic = 0;                                  ///< mean of SpaceMemory::measure
  double volume = 0;                                   ///< of the reference shape [m3]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< element axes, as columns
};
SpaceElementStress element_stress(const Model<3>& model, const State<3>& state, int element);
SpaceVector in_world(const SpaceElementStress& stress);

}  // namespace trilith
