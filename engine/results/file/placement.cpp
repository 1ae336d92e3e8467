#include "results/file/placement.hpp"

#include <cmath>
#include <limits>

#include "base/rotation_3d.hpp"

namespace trilith::results {
namespace {

/// Rotation matrix of a node; its columns are the rotated axes.
Eigen::Matrix3d turn_matrix(int dim, const std::vector<double>& rotation, int node) {
  Eigen::Matrix3d out = Eigen::Matrix3d::Identity();
  if (dim == 2) {
    const Turn turn(rotation[static_cast<std::size_t>(node)]);
    out << turn.c, -turn.s, 0, turn.s, turn.c, 0, 0, 0, 1;
    return out;
  }
  const Turn3 turn(quaternion_of(rotation, node));
  out << turn.x(), turn.y(), turn.z();
  return out;
}

}  // namespace

UnitQuaternion quaternion_of(const std::vector<double>& rows, int row) {
  const double* q = rows.data() + 4 * static_cast<std::size_t>(row);
  return {q[0], q[1], q[2], q[3]};
}

Frame start_frame(const Header& header) {
  Frame frame;
  frame.position = header.node_position;
  frame.rotation = header.node_rotation;
  return frame;
}

Placement::Placement(const Header& header, const Frame& frame) : header_(header), frame_(frame) {
  const int nodes = static_cast<int>(header.node_count());
  for (int n = 0; n < nodes; ++n) {
    place_.push_back(row_of(frame.position, n));
    turn_.push_back(turn_matrix(header.dim, frame.rotation, n));
  }
}

Vec3 Placement::row_of(const std::vector<double>& rows, int row) const {
  const double* from = rows.data() + static_cast<std::size_t>(header_.dim) * static_cast<std::size_t>(row);
  return {from[0], from[1], header_.dim == 3 ? from[2] : 0};
}

Vec3 Placement::vertex(int row) const {
  return at(header_.vertex_node[static_cast<std::size_t>(row)], row_of(header_.vertices, row));
}

Vec3 Placement::velocity(int node, const Vec3& arm) const {
  const Vec3 spin = header_.dim == 3 ? row_of(frame_.spin, node) : Vec3(0, 0, frame_.spin[node]);
  return row_of(frame_.velocity, node) + cross(spin, arm);
}

double Placement::turned(int node) const {
  if (header_.dim == 2) return frame_.rotation[node] - header_.node_rotation[node];
  return angle_of(quaternion_of(frame_.rotation, node) * inverse(quaternion_of(header_.node_rotation, node))).norm();
}

Vec3 Placement::end_of(const BodyRow& body, const double* point) const {
  const Vec3 from_first(point[0], point[1], header_.dim == 3 ? point[2] : 0);
  if (body.node_count == 1) return at(body.first_node, from_first);
  const Vec3 start = start_of(body.first_node) + from_first;
  int node = body.first_node;
  if (header_.dim == 3) {  // of a frame: the node that was nearest
    for (int n = node + 1; n < body.first_node + body.node_count; ++n)
      if ((start_of(n) - start).squaredNorm() < (start_of(node) - start).squaredNorm()) node = n;
    return at(node, turn_of(quaternion_of(header_.node_rotation, node)).undo(Vec3(start - start_of(node))));
  }
  double least = std::numeric_limits<double>::infinity();
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
    const int n = header_.vertex_node[v];
    const double distance = (start_of(n) + row_of(header_.vertices, v) - start).norm();
    if (distance < least) least = distance, node = n;
  }
  return at(node, start - start_of(node));
}

}  // namespace trilith::results
