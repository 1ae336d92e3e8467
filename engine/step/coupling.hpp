// Which degrees of freedom there are, and which of them forces couple: the pattern of the tangent.
#pragma once

#include <array>
#include <vector>

#include "world/model.hpp"
#include "world/work.hpp"

namespace trilith {

/// A degree of freedom: 0, 1 a displacement, 2 the rotation of a node.
struct Freedom {
  int node, k;
};

/// Nodes that are free to move, and what couples them: elements, beams, bearings, loads that follow, and every pair of
/// pieces that may come to touch before pairs are found anew.
struct Coupling {
  std::vector<Freedom> freedom;             ///< [unknown] by node, then by k
  std::vector<std::array<int, 3>> unknown;  ///< [node] index into `freedom`, or -1
  std::vector<std::vector<int>> near;       ///< [node] free nodes that its forces depend on, itself too; sorted
  std::vector<std::vector<int>> colour;     ///< nodes no two of which act on the same node, but by beams

  [[nodiscard]] int size() const { return static_cast<int>(freedom.size()); }
};

/// Of the pairs that `work` holds.
Coupling coupling_of(const Model<2>& model, const Work<2>& work);

}  // namespace trilith
