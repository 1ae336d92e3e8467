// Where points of bodies are in a frame, in the plane and in space alike.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/space.hpp"
#include "results/file/results.hpp"

namespace trilith::results {

/// The frame before all others: where the nodes start. Motion and place alone.
Frame start_frame(const Header& header);

/// Places of a frame, m, world axes; in the plane z is 0. Keeps references to what it is made of.
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
  /// Velocity of the point that is `arm` away from a node, world axes, m/s. The frame must hold velocities.
  [[nodiscard]] Vec3 velocity(int node, const Vec3& arm) const;
  /// By how much a node has turned since the start, rad; at most pi in space.
  [[nodiscard]] double turned(int node) const;
  /// Where the end of a bearing is: `point` [dim] is where it was from the body's first node at the start. On a body of
  /// several nodes it goes with the one whose outline point was nearest.
  [[nodiscard]] Vec3 end_of(const BodyRow& body, const double* point) const;

 private:
  [[nodiscard]] Vec3 start_of(int node) const { return row_of(header_.node_position, node); }
  [[nodiscard]] Vec3 row_of(const std::vector<double>& rows, int row) const;

  const Header& header_;
  const Frame& frame_;
  std::vector<Vec3> place_;
  std::vector<Eigen::Matrix3d> turn_;
};

/// A row of numbers as the rotation it stands for (dim 3).
UnitQuaternion quaternion_of(const std::vector<double>& rows, int row);

}  // namespace trilith::results
