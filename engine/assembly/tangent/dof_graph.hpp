// Degrees of freedom and their coupling by forces: the sparsity pattern of the tangent.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// A degree of freedom of a node. In the plane k is 0, 1 for a displacement and 2 for the rotation. In space k is 0 to
/// 2 for a displacement and 3 to 5 for a rotation about a world axis.
struct Freedom {
  int node, k;
};
/// True for a rotation.
template <int D>
constexpr bool is_turn(const Freedom& f) {
  return f.k >= Space<D>::translations;
}

/// Calls f(node) for a node, or in space for all nodes of a fit (model/contact/contact_frame.hpp).
template <int D, class F>
void for_nodes_of(const Model<D>& model, int contact_frame, F&& f) {
  if (contact_frame >= 0) return f(contact_frame);
  const Fit& fit = model.fits[static_cast<std::size_t>(-1 - contact_frame)];
  for (int i = 0; i < fit.nodes; ++i) f(fit.node[static_cast<std::size_t>(i)]);
}

/// Calls f(node), for some nodes more than once, for all nodes that determine the position and motion of a piece in
/// space.
template <int D, class F>
void for_nodes_of_piece(const Model<D>& model, int piece, F&& f) {
  for_nodes_of(model, model.carrier_of(piece), f);
  if (!model.is_fitted(piece) || model.piece_bounds.empty()) return;
  // Additional faces that bound its body there.
  for (const int fit : model.piece_bounds[static_cast<std::size_t>(piece)]) for_nodes_of(model, -1 - fit, f);
}

/// Nodes that are free to move, and their coupling: elements, beams, bearings, following loads, and every pair of
/// pieces that may touch before the pairs are updated.
template <int D>
struct DofGraph {
  std::vector<Freedom> freedom;                          ///< [unknown] by node, then by k
  std::vector<std::array<int, Space<D>::dofs>> unknown;  ///< [node] index into `freedom`, or -1
  std::vector<std::vector<int>> near;    ///< [node] free nodes that its forces depend on, itself included; sorted
  std::vector<std::vector<int>> colour;  ///< nodes of which no two act on the same node

  [[nodiscard]] int size() const { return static_cast<int>(freedom.size()); }
};

/// Graph for the pairs in `work`.
template <int D>
DofGraph<D> dof_graph_of(const Model<D>& model, const Work<D>& work);

}  // namespace trilith
