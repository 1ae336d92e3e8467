// Elements of deformable bodies in their reference shape: quadrilaterals of four nodes, triangles of three.
//
// Strain is linear in the deformation of the nodes, in the element's own turning axes (element/corotation.hpp):
// strain = B d at each Gauss point, 2 x 2 of them in a quadrilateral, one in a triangle.
//   plain     B of the isoparametric element. It locks in bending.
//   assumed   B with the incompatible modes 1 - xi^2 and 1 - eta^2 of Wilson et al., made to pass the patch test by
//             Taylor, Beresford and Wilson ("A non-conforming element for stress analysis", Int. J. Numer. Meth. Engng
//             10, 1976) with the Jacobian at the centre. The modes are condensed with the elastic matrix once and for
//             all, which leaves an assumed strain field B - G (G'CG)^-1 (G'CB) without inner unknowns. For a triangle
//             the two are the same.
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <span>

#include "base/space.hpp"

namespace trilith {

inline constexpr int max_element_nodes = 4;
inline constexpr int max_element_points = 4;

/// Strain (xx, yy, xy engineering) of unit deformations of the nodes (x0, y0, x1, ...); a triangle's last two columns
/// are 0 [1/m].
using StrainMatrix = Eigen::Matrix<double, 3, 2 * max_element_nodes>;
using ElementMatrix = Eigen::Matrix<double, 2 * max_element_nodes, 2 * max_element_nodes>;

struct ElementStrain {
  int points = 0;
  std::array<StrainMatrix, max_element_points> matrix;
  std::array<double, max_element_points> area{};  ///< that each point stands for [m2]
};

/// `corners`: three or four, counter-clockwise, convex [m]. `elastic`: for the assumed strains [Pa].
ElementStrain plain_strain(std::span<const Vec2> corners);
ElementStrain assumed_strain(std::span<const Vec2> corners, const Eigen::Matrix3d& elastic);

/// Integral of B' C B over the area: stiffness for a thickness of 1 m [Pa].
ElementMatrix element_stiffness(const ElementStrain& strain, const Eigen::Matrix3d& elastic);

/// Means over the area of the gradients of the shape functions, 0 beyond the nodes [1/m].
std::array<Vec2, max_element_nodes> mean_gradients(std::span<const Vec2> corners);

/// Area that each node stands for, the integral of its shape function [m2].
std::array<double, max_element_nodes> node_areas(std::span<const Vec2> corners);

/// Shape functions at a point in natural coordinates: xi, eta from -1 to 1 in a quadrilateral, from 0 with
/// xi + eta <= 1 in a triangle.
std::array<double, max_element_nodes> shape_functions(std::size_t nodes, const Vec2& natural);

/// Natural coordinates of the point of the element nearest to `x` [m], and how far that is from it [m].
struct ElementPoint {
  Vec2 natural;
  double distance;
};
ElementPoint nearest_in_element(std::span<const Vec2> corners, const Vec2& x);

/// Largest eigenvalue of `stiffness` over the diagonal `mass` of the nodes [1/s2].
double largest_frequency2(const ElementMatrix& stiffness, std::span<const double> mass);

}  // namespace trilith
