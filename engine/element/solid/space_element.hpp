// Elements of deformable bodies in space in their reference shape: bricks of eight nodes, tetrahedra of four and of
// ten, wedges of six.
//
//        7 -------- 6          brick: natural coordinates from -1 to 1, node 0 at (-1, -1, -1), 6 at (1, 1, 1)
//       /|         /|          tetrahedron: node 3 lies to the left of the face 0, 1, 2 as seen from inside, its
//      4 -------- 5 |          volume is above 0; of one of ten nodes 4 to 9 lie on the edges 01, 12, 02, 03, 23, 13,
//      | 3 -------|-2          as Gmsh has them
//      |/         |/           wedge: triangles 0, 1, 2 and 3, 4, 5 above it, in the order of the first; two natural
//      0 -------- 1            coordinates of the triangle, the third from -1 to 1
//
// Strain is linear in the deformation of the nodes, in the element's own turning axes (element/corotation_3d.hpp):
// strain = B d at each point of Gauss, 2 x 2 x 2 in a brick, one in a tetrahedron of four nodes, four in one of ten, 3
// x 2 in a wedge.
//   plain     B of the isoparametric element. A brick of it locks in bending.
//   assumed   the brick with the incompatible modes 1 - xi^2, 1 - eta^2, 1 - zeta^2 of each displacement (Wilson et al.
//             1973) in the form of Taylor, Beresford and Wilson (Int. J. Numer. Meth. Engng 10, 1976): with the
//             Jacobian at the centre, times the ratio of determinants, their strains have no mean, and the patch test
//             holds. Three more are changes of volume alone, xi eta, eta zeta and zeta xi (Simo, Armero and Taylor,
//             Comput. Methods Appl. Mech. Engng 110, 1993), without which bricks of a volume that can hardly change
//             are stiff where bending varies. All are condensed with the elastic matrix once, as in the plane
//             (element/solid/plane_element.hpp). The wedge has 1 - zeta^2 of each displacement, so that its depth
//             follows Poisson's ratio where it bends; over a triangle strain is constant, which is stiff in bending.
//
// Mass is lumped. All but a tetrahedron of ten: the integrals of the shape functions. Those of a tetrahedron of ten
// are below 0 at its corners, so its mass goes by the diagonal of the consistent matrix, scaled to the whole (Hinton,
// Rock and Zienkiewicz, Earthq. Engng Struct. Dyn. 4, 1976): 1/36 to each corner, 4/27 to each node of an edge.
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

/// What there is to know of a shape before it has a place.
struct ElementShapeInfo {
  std::string_view name;
  int nodes, corners, points, faces;
  /// Nodes of each face, outward: its corners, counter-clockwise as seen from outside, then the nodes of its edges.
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
  std::array<SpaceStrainMatrix, max_space_points> matrix;  ///< columns of nodes that are not there are 0 [1/m]
  std::array<double, max_space_points> volume{};           ///< that each point stands for [m3]
};

/// Least determinant of the Jacobian at the points of Gauss and the corners over that of the middle: at most 0 where
/// the element is turned inside out somewhere.
double least_jacobian(ElementShape shape, std::span<const Vec3> nodes);

/// `nodes`: as many as the shape has [m]. `elastic`: for the assumed strains [Pa].
SpaceElementStrain plain_strain(ElementShape shape, std::span<const Vec3> nodes);
SpaceElementStrain assumed_strain(ElementShape shape, std::span<const Vec3> nodes, const SpaceMatrix& elastic);

/// Integral of B' C B over the volume, of 3 x 3 times as many nodes as there are [N/m].
Eigen::MatrixXd element_stiffness(ElementShape shape, const SpaceElementStrain& strain, const SpaceMatrix& elastic);

/// Means over the volume of the gradients of the shape functions [1/m].
std::array<Vec3, max_space_nodes> mean_gradients(ElementShape shape, std::span<const Vec3> nodes);

/// Volume [m3], and the share of the mass that each node has; all are above 0.
struct ElementVolume {
  double volume = 0;
  std::array<double, max_space_nodes> share{};
};
ElementVolume node_shares(ElementShape shape, std::span<const Vec3> nodes);

/// The plane that a face of an element keeps, which fits the places of its nodes: a field of the nodes becomes
///
///     u(s) = sum of (mean_i + gradient_i . s) u_i,    s from the middle, in the face's two axes at the start
///
/// the linear field that has the same integral and first moments over the face as the one of the shape functions. So a
/// linear pressure over all of the face gives the nodes the forces of the element itself. Reference shape.
struct FaceFit {
  Vec3 middle, x, y, normal;                    ///< axes of length 1, the normal outward
  double area = 0;                              ///< [m2]
  std::array<double, max_face_nodes> mean{};    ///< sum to 1
  std::array<Vec2, max_face_nodes> gradient{};  ///< [1/m]
};
FaceFit fit_face(ElementShape shape, std::span<const Vec3> nodes, int face);

/// Largest eigenvalue of a stiffness over the lumped masses of the nodes [1/s2].
double largest_frequency2(const Eigen::MatrixXd& stiffness, std::span<const double> mass);

}  // namespace trilith
