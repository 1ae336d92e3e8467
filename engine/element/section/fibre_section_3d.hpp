// Fibre section in space: plane strain distribution, a uniaxial law for each fibre.
//
//   e(y, z) = e_0 - y k_z + z k_y,   N = sum s A,   M_y = sum s A z,   M_z = -sum s A y.
//
// Coordinates y up and z across start at the centroid of the whole shape. k_y and k_z are the rates of rotation of the
// section about y and about z along the beam (element/beam/beam_element_3d.hpp). The shape is cut by levels and by
// coordinates across. The part in each cell is four fibres with its area, centroid and second moments
// (geometry/plane/outline_moments.hpp), so the elastic section is exact for any number of cells. Covers, cores and bars
// follow element/section/fibre_section.hpp. Not modelled: shear and torsion and their influence on yielding, bar slip
// and buckling, warping of sections.
#pragma once

#include "element/section/fibre_section.hpp"

namespace trilith {

struct Fibre3 {
  double area = 0;            ///< [m2]
  double up = 0, across = 0;  ///< from the centroid [m]
};

struct FibreSection3 {
  std::vector<Fibre3> fibres;
  std::vector<FibrePart> parts;

  /// Size of its memory: the fibres' memories in order. A new section has zeros only.
  [[nodiscard]] int memory_size() const;
  /// N, M_y, M_z as functions of axial strain, k_y and k_z, with the largest stiffness of each law [N], [N m], [N m2].
  [[nodiscard]] Eigen::Matrix3d stiffest() const;
};

/// Cut by FibreSpec::cells. Throws InputError as make_fibres does, and for bars outside of the shape's width.
FibreSection3 make_fibres_in_space(const FibreSpec& spec);

struct SectionResponse3 {
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();  ///< N, tension positive [N]; M_y and M_z [N m]
  Eigen::Matrix3d tangent = Eigen::Matrix3d::Zero();
  double stored = 0;      ///< [J/m]
  double dissipated = 0;  ///< in this step [J/m]
  bool yielding = false;  ///< any fibre, in this step
};

/// `strain`: axial [1], k_y and k_z [1/m]. `before` and `after` have memory_size() numbers each and do not overlap.
SectionResponse3 respond(const FibreSection3& section, const Eigen::Vector3d& strain, std::span<const double> before,
                         std::span<double> after);

}  // namespace trilith
