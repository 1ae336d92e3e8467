// Elements of deformable bodies in space in their reference shape: bricks with eight nodes, tetrahedra with four and
// ten, wedges with six.
//
//        7 -------- 6          brick: natural coordinates from -1 to 1, node 0 at (-1, -1, -1), 6 at (1, 1, 1)
//       /|         /|          tetrahedron: its volume is positive, i.e. node 3 lies to the left of the face 0, 1, 2
//      4 -------- 5 |          seen from inside; with ten nodes, 4 to 9 lie on the edges 01, 12, 02, 03, 23, 13, as in
//      | 3 -------|-2          Gmsh
//      |/         |/           wedge: triangles 0, 1, 2 and 3, 4, 5 above it in the same order; two natural coordinates
//      0 -------- 1            of the triangle, the third from -1 to 1
//
// Strain is linear in the nodal deformation, in the element's co-rotating axes (element/corotation_3d.hpp): strain = B
// d at each Gauss point. A brick has 2 x 2 x 2 points, a tetrahedron one (four nodes) or four (ten nodes), a wedge 3 x
// 2.
//
// Plain strain: B of the isoparametric element. A brick with it locks in bending. Assumed strain: the brick has
// incompatible modes 1 - xi^2, 1 - eta^2, 1 - zeta^2 for each displacement (Wilson et al. 1973) in the form of Taylor,
// Beresford and Wilson (Int. J. Numer. Meth. Engng 10, 1976). They use the Jacobian at the centre times the ratio of
// determinants, so their mean strain is 0 and the patch test holds. Three more modes, xi eta, eta zeta and zeta xi,
// change the volume alone (Simo, Armero and Taylor, Comput. Methods Appl. Mech. Engng 110, 1993). Without them nearly
// incompressible bricks are too stiff where bending varies. All modes are condensed once with the elastic matrix, as in
// the plane (element/solid/plane_element.hpp). The wedge has 1 - zeta^2 for each displacement, so that its depth
// follows Poisson's ratio in bending. Over its triangle strain is constant, which is too stiff in bending.
//
// Mass is lumped by the integrals of the shape functions. For a tetrahedron with ten nodes these are negative at the
// corners. Its mass follows the diagonal of the consistent matrix, scaled to the total (Hinton, Rock and Zienkiewicz,
// Earthq. Engng Struct. Dyn. 4, 1976): 1/36 to each corner, 4/27 to each node of an edge.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/space.hpp"
#include "law/material/space_point.hpp"

namespace trilith {

enum class ElementShape : std::uint8_t { brick, tetrahedron, quadratic_tetrahedron, wedge };

inline constexpr int max_space_nodes = 10, max_space_points = 8, max_face_nodes = 6;

/// Topology of a shape, independent of node positions.
struct ElementShapeInfo {
  std::string_view name;
  int nodes, corners, points, faces;
  /// Nodes of each face, outward: its corners, counter-clockwise seen from outside, then the nodes on its edges.
  std::array<std::array<int, max_face_nodes>, 6> face;
  std::array<int, 6> face_corners, face_nodes;

  [[nodiscard]] std::span<const int> corners_of_face(int f) const {
    return std::span(face[static_cast<std::size_t>(f)])
        .first(static_cast<std::size_t>(face_corners[static_cast<std::size_t>(f)]));
  }
  [[nodiscard]] std::span<const int> nodes_of_face(int f) const {
    return std::span(face[static_cast<std::size_t>(f)])
        .first(static_cast<std::size_t>(face_nodes[static_cast<std::size_t>(f)]));
  }
};
const ElementShapeInfo& info_of(ElementShape shape);

using SpaceStrainMatrix = Eigen::Matrix<double, 6, 3 * max_space_nodes>;

struct SpaceElementStrain {
  int points = 0;
  std::array<SpaceStrainMatrix, max_space_points> matrix;  ///< columns of unused nodes are 0 [1/m]
  std::array<double, max_space_points> volume{};           ///< weight of each point [m3]
};

/// Least Jacobian determinant at the Gauss points and corners, relative to its value at the centre: not above 0 where
/// the element is inverted somewhere.
double least_jacobian(ElementShape shape, std::span<const Vec3> nodes);

/// `nodes`: as many as the shape has [m]. `elastic`: for the assumed strains [Pa].
SpaceElementStrain plain_strain(ElementShape shape, std::span<const Vec3> nodes);
SpaceElementStrain assumed_strain(ElementShape shape, std::span<const Vec3> nodes, const SpaceMatrix& elastic);

/// Shape functions of the nodes, a column each, at the points of both strains, a row each.
Eigen::MatrixXd shape_values(ElementShape shape);

/// Integral of B' C B over the volume, of size 3 times the number of nodes [N/m].
Eigen::MatrixXd element_stiffness(ElementShape shape, const SpaceElementStrain& strain, const SpaceMatrix& elastic);

/// Means over the volume of the gradients of the shape functions [1/m].
std::array<Vec3, max_space_nodes> mean_gradients(ElementShape shape, std::span<const Vec3> nodes);

/// Volume [m3], and the mass share of each node; all are above 0.
struct ElementVolume {
  double volume = 0;
  std::array<double, max_space_nodes> share{};
};
ElementVolume node_shares(ElementShape shape, std::span<const Vec3> nodes);

/// The plane fitted to the node positions of an element's face. A nodal field becomes the linear field
///
///     u(s) = sum of (mean_i + gradient_i . s) u_i,    s from the centroid, in the face's two axes at the start,
///
/// with the same integral and first moments over the face as the shape functions' field. So a linear pressure over the
/// whole face gives the nodes the element's consistent forces. Reference shape.
struct FaceFit {
  Vec3 middle, x, y, normal;                    ///< unit axes, the normal outward
  double area = 0;                              ///< [m2]
  std::array<double, max_face_nodes> mean{};    ///< the sum is 1
  std::array<Vec2, max_face_nodes> gradient{};  ///< [1/m]
};
FaceFit fit_face(ElementShape shape, std::span<const Vec3> nodes, int face);

/// Largest eigenvalue of a stiffness over the nodes' lumped masses [1/s2].
double largest_frequency2(const Eigen::MatrixXd& stiffness, std::span<const double> mass);

}  // namespace trilith
