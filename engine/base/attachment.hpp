// A point that goes with the nodes of a body: the end of a bearing, the place of a load, the edge of a seat.
//
//   x = sum of w_i (x_i + R_i r_i)
//
// over its nodes, where w_i are weights that sum to 1 and r_i is an arm that turns with a node (R_i). On a rigid body
// that is one node and one arm; on a beam the two nodes of an element, with arms across it; in a finite element of
// nodes without rotation its shape functions, and no arms. The transpose gives node i the force w_i f and the node it
// turns with the moment w_i (R_i r_i x f + m): see model/pose.hpp, pose_at and apply_force.
#pragma once

#include <array>

#include "base/space.hpp"

namespace trilith {

template <int D>
struct Attachment {
  static constexpr int most_nodes = D == 2 ? 4 : 8;

  int nodes = 0;
  bool turns = true;                   ///< with rotations of nodes; else as its nodes go round their mean
  std::array<int, most_nodes> node{};  ///< whose places count
  std::array<int, most_nodes> turn{};  ///< whose rotation turns the arm; mostly the same node
  std::array<double, most_nodes> weight{};
  std::array<Vec<D>, most_nodes> arm = no_arms();  ///< [m], in the axes of `turn`

  /// To one node that it turns with.
  static Attachment to_node(int node, const Vec<D>& arm) {
    Attachment attachment;
    attachment.nodes = 1, attachment.node[0] = attachment.turn[0] = node, attachment.weight[0] = 1,
    attachment.arm[0] = arm;
    return attachment;
  }
  [[nodiscard]] bool is_rigid() const { return nodes == 1; }

 private:
  static std::array<Vec<D>, most_nodes> no_arms() {
    std::array<Vec<D>, most_nodes> out;
    out.fill(Vec<D>::Zero());
    return out;
  }
};

}  // namespace trilith
