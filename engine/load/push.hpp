// Displacement control: a force whose size follows from a motion; model/pushes.hpp creates it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/space.hpp"
#include "load/motion.hpp"

namespace trilith {

/// A pushed point of a body, with its weight.
template <int D>
struct PushRow {
  int node = -1;                  ///< node of its position
  int turn = -1;                  ///< node whose rotation rotates `place`; usually the same node
  Vec<D> place = Vec<D>::Zero();  ///< in the axes of `turn`; 0 for a node that does not turn [m]
  double weight = 0;
};

/// Displacement control: points are pushed along one direction by forces in fixed proportion (their weights). The
/// forces have the size with which the weighted mean of their displacements follows a motion. All other motion of the
/// points is free.
template <int D>
struct Push {
  std::string name;
  std::vector<PushRow<D>> rows;        ///< weights sum to 1
  Vec<D> direction = Vec<D>::UnitX();  ///< unit vector
  double origin = 0;                   ///< weighted mean of the coordinates along `direction` at motion 0 [m]
  double start = 0;                    ///< time at which the motion begins [s]
  std::shared_ptr<const GroundMotion> motion;
};

}  // namespace trilith
