// Positions of points of bodies in a frame, in the plane and in space.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/space.hpp"
#include "results/file/results.hpp"

namespace trilith::results {

/// The frame before all others: initial positions of the nodes, without other data.
Frame start_frame(const Header& header);

/// Positions in a frame [m], world axes; in the plane z is 0. Keeps references to its arguments.
class Placement {
 public:
  Placement(const Header& header, const Frame& frame);

  /// A point in the axes of a node.
  [[nodiscard]] Vec3 at(int node, const Vec3& point) const {
    return place_[static_cast<std::size_t>(node)] + turn_[static_cast<std::size_t>(node)] * point;
  }
  /// A row of Header::vertices.
  [[nodiscard]] Vec3 vertex(int row) const;
  [[nodiscard]] const Vec3& node(int row) const { return place_[static_cast<std::size_t>(row)]; }
  /// Velocity of the point at `arm` from a node, world axes [m/s]. The frame must contain velocities.
  [[nodiscard]] Vec3 velocity(int node, const Vec3& arm) const;
  /// Rotation angle of a node from the start [rad]; at most pi in space.
  [[nodiscard]] double turned(int node) const;
  /// Position of the end of a bearing: `point` [dim] is its initial offset from the body's first node. On a body of
  /// several nodes it moves with the node whose outline point was nearest.
  [[nodiscard]] Vec3 end_of(const BodyRow& body, const double* point) const;

 private:
  [[nodiscard]] Vec3 start_of(int node) const { return row_of(header_.node_position, node); }
  [[nodiscard]] Vec3 row_of(const std::vector<double>& rows, int row) const;

  const Header& header_;
  const Frame& frame_;
  std::vector<Vec3> place_;
  std::vector<Eigen::Matrix3d> turn_;
};

/// A row of numbers as a rotation (dim 3).
UnitQuaternion quaternion_of(const std::vector<double>& rows, int row);

}  // namespace trilith::results
