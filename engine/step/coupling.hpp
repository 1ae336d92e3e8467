// Which degrees of freedom there are, and which of them forces couple: the pattern of the tangent.
#pragma once

#include <array>
#include <vector>

#include "world/model.hpp"
#include "world/work.hpp"

namespace trilith {

/// A degree of freedom of a node: in the plane k is 0, 1 for a displacement and 2 for the rotation, in space 0 to 2 and
/// 3 to 5, about the axes of the world.
struct Freedom {
  int node, k;
};
/// Whether that is a rotation.
template <int D>
constexpr bool is_turn(const Freedom& f) {
  return f.k >= Space<D>::translations;
}

/// Nodes that are free to move, and what couples them: elements, beams, bearings, loads that follow, and every pair of
/// pieces that may come to touch before pairs are found anew.
template <int D>
struct Coupling {
  std::vector<Freedom> freedom;                          ///< [unknown] by node, then by k
  std::vector<std::array<int, Space<D>::dofs>> unknown;  ///< [node] index into `freedom`, or -1
  std::vector<std::vector<int>> near;    ///< [node] free nodes that its forces depend on, itself too; sorted
  std::vector<std::vector<int>> colour;  ///< nodes no two of which act on the same node, but by beams

  [[nodiscard]] int size() const { return static_cast<int>(freedom.size()); }
};

/// Of the pairs that `work` holds.
template <int D>
Coupling<D> coupling_of(const Model<D>& model, const Work<D>& work);

}  // namespace trilith
