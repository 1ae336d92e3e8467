// Integrals of the shape functions over a face of an element in space, for stresses that are distributed over it.
#pragma once

#include <Eigen/Core>

#include <span>

#include "element/solid/space_element.hpp"

namespace trilith {

struct FaceProducts {
  /// Second moments of area about the centroid of the face, along the axes of its FaceFit [m4].
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  /// Integrals of the products N_i N_j of the face's nodes; rows of unused nodes are 0 [m2].
  Eigen::Matrix<double, max_face_nodes, max_face_nodes> products =
      Eigen::Matrix<double, max_face_nodes, max_face_nodes>::Zero();
};

/// Of a face in its reference shape, with nodes in the order of ElementShapeInfo::nodes_of_face.
FaceProducts face_products(ElementShape shape, std::span<const Vec3> nodes, int face);

}  // namespace trilith
