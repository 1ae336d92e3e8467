// Plane elements of deformable bodies in their reference shape: quadrilaterals with four nodes, triangles with three.
//
// Strain is linear in the nodal deformation, in the element's co-rotating axes (element/corotation.hpp): strain = B d
// at each Gauss point, 2 x 2 in a quadrilateral, one in a triangle.
//
// Plain strain: B of the isoparametric element. It locks in bending. Assumed strain: B with the incompatible modes 1 -
// xi^2 and 1 - eta^2, due to Wilson and others. The modified form with the Jacobian at the centre passes the patch
// test: Taylor, Beresford and Wilson, "A non-conforming element for stress analysis", Int. J. Numer. Meth. Engng 10,
// 1976. The modes are condensed once with the elastic matrix. This leaves an assumed strain field B - G (G'CG)^-1
// (G'CB) without internal unknowns. For a triangle both forms are equal.
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <span>

#include "base/space.hpp"

namespace trilith {

inline constexpr int max_element_nodes = 4;
inline constexpr int max_element_points = 4;

/// Strain (xx, yy, xy engineering) per unit nodal displacement (x0, y0, x1, ...); a triangle's last two columns are 0
/// [1/m].
using StrainMatrix = Eigen::Matrix<double, 3, 2 * max_element_nodes>;
using ElementMatrix = Eigen::Matrix<double, 2 * max_element_nodes, 2 * max_element_nodes>;

struct ElementStrain {
  int points = 0;
  std::array<StrainMatrix, max_element_points> matrix;
  std::array<double, max_element_points> area{};  ///< weight of each point [m2]
};

/// `corners`: three or four, counter-clockwise, convex [m]. `elastic`: for the assumed strains [Pa].
ElementStrain plain_strain(std::span<const Vec2> corners);
ElementStrain assumed_strain(std::span<const Vec2> corners, const Eigen::Matrix3d& elastic);

/// Integral of B' C B over the area: stiffness for a thickness of 1 m [Pa].
ElementMatrix element_stiffness(const ElementStrain& strain, const Eigen::Matrix3d& elastic);

/// Means over the area of the gradients of the shape functions, 0 beyond the nodes [1/m].
std::array<Vec2, max_element_nodes> mean_gradients(std::span<const Vec2> corners);

/// Integral of each node's shape function [m2].
std::array<double, max_element_nodes> node_areas(std::span<const Vec2> corners);

/// Shape functions at natural coordinates: xi, eta from -1 to 1 in a quadrilateral, from 0 with xi + eta <= 1 in a
/// triangle.
std::array<double, max_element_nodes> shape_functions(std::size_t nodes, const Vec2& natural);

/// Natural coordinates of the point of the element nearest to `x` [m], and its distance from `x` [m].
struct ElementPoint {
  Vec2 natural;
  double distance;
};
ElementPoint nearest_in_element(std::span<const Vec2> corners, const Vec2& x);

/// Largest eigenvalue of `stiffness` over the diagonal `mass` of the nodes [1/s2].
double largest_frequency2(const ElementMatrix& stiffness, std::span<const double> mass);

}  // namespace trilith
