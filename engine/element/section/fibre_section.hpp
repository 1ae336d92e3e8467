// Fibre section: plane strain distribution over the depth, a uniaxial law for each fibre.
//
//   e(y) = e_0 - y k,   N = sum s A,   M = -sum s A y,   y up from the centroid of the whole shape.
//
// Curvature k is the second derivative of the deflection to the left of the axis (element/beam/beam_element.hpp), so M
// > 0 puts the bottom in tension. The shape is cut into layers. A layer is two fibres with half of its area each, a
// radius of gyration above and below its centroid. So area, centroid and second moment of each layer are exact, and
// with them the elastic section.
//
// A cover is the part outside of a core with the same shape. Bars are additional fibres; the concrete area that they
// displace is not subtracted. Not modelled: shear and its influence on yielding, bar slip and buckling, warping of
// sections.
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "element/section/fibre_shape.hpp"
#include "law/fibre/list.hpp"

namespace trilith {

struct FibreBars {
  double area = 0;    ///< total area at this height [m2]
  double height = 0;  ///< above the bottom of the section [m]
  // Distribution across the section, in space:
  int count = 1;      ///< number of bars, evenly over `spread`
  double across = 0;  ///< their centre, from the centre of the section's width [m]
  double spread = 0;  ///< distance from the first to the last [m]
};

/// Specification of the fibres.
struct FibreSpec {
  FibreShape shape;
  UniaxialLaw law;
  int layers = 20;  ///< of equal depth, cut further where the width is discontinuous
  double cover = 0;
  UniaxialLaw cover_law = {};           ///< if there is a cover
  std::optional<FibreShape> core = {};  ///< replaces the core by `cover`; bottom at height `cover`
  std::vector<FibreBars> bars = {};
  UniaxialLaw bar_law = {};
  std::array<int, 2>
      cells{};  ///< sections in space: up and across; 0: default, see element/section/fibre_section_3d.hpp
};

/// Whether a law has a fracture energy, so that the section of a beam depends on its length.
bool depends_on_length(const FibreSpec& spec);
/// The specification of a beam of `length` [m], see law_for_length; its laws are checked. Throws InputError.
FibreSpec for_length(FibreSpec spec, double length);

struct Fibre {
  double area = 0;    ///< [m2]
  double height = 0;  ///< above the centroid [m]
};

/// Consecutive fibres with one law.
struct FibrePart {
  UniaxialLaw law;
  int first = 0, count = 0;
};

struct FibreSection {
  std::vector<Fibre> fibres;
  std::vector<FibrePart> parts;

  /// Size of its memory: the fibres' memories in order. A new section has zeros only.
  [[nodiscard]] int memory_size() const;
  /// N, M as functions of axial strain, curvature, with the largest stiffness of each law [N], [N m], [N m2].
  [[nodiscard]] Eigen::Matrix2d stiffest() const;
};

/// Throws InputError where layers, cover, bars or a law are invalid.
FibreSection make_fibres(const FibreSpec& spec);

struct SectionStrain {
  double axial = 0;      ///< [1]
  double curvature = 0;  ///< [1/m]
};

struct SectionResponse {
  double normal = 0;  ///< tension positive [N]
  double moment = 0;  ///< positive where the bottom is in tension [N m]
  Eigen::Matrix2d tangent = Eigen::Matrix2d::Zero();
  double stored = 0;      ///< [J/m]
  double dissipated = 0;  ///< in this step [J/m]
  bool yielding = false;  ///< any fibre, in this step
};

/// `before` and `after` have memory_size() numbers each and do not overlap.
SectionResponse respond(const FibreSection& section, const SectionStrain& strain, std::span<const double> before,
                        std::span<double> after);

}  // namespace trilith
