// A point that moves with the nodes of a body: the end of a bearing, the point of a load, the edge of a seat.
//
//   x = sum of w_i (x_i + R_i r_i).
//
// The sum runs over the nodes; the weights w_i sum to 1, and the arm r_i rotates with a node (R_i). A rigid body has
// one node and one arm. A beam has the two nodes of an element and arms across the axis. A finite element whose nodes
// do not rotate has its shape functions as weights and no arms. The transpose gives node i the force w_i f, and the
// node that rotates its arm the moment w_i (R_i r_i x f + m): see pose_at and apply_force in model/pose.hpp.
#pragma once

#include <array>

#include "base/space.hpp"

namespace trilith {

template <int D>
struct Attachment {
  static constexpr int most_nodes = D == 2 ? 4 : 8;

  int nodes = 0;
  bool turns = true;                   ///< true: arms follow nodal rotations; false: the mean rotation of the positions
  std::array<int, most_nodes> node{};  ///< nodes whose positions have the weights w_i
  std::array<int, most_nodes> turn{};  ///< nodes whose rotations turn the arms; mostly the same nodes
  std::array<double, most_nodes> weight{};
  std::array<Vec<D>, most_nodes> arm = no_arms();  ///< [m], in the axes of `turn`

  /// Attached to one node, whose rotation turns the arm.
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
