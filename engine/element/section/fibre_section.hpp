// A section as fibres: strain that is plane over its depth, each fibre with its own law.
//
//   e(y) = e_0 - y k,   N = sum s A,   M = -sum s A y,   y up from the centroid of the whole shape
//
// k is the second derivative of the deflection to the left of the axis (element/beam/beam_element.hpp), so M > 0 pulls
// the bottom. The shape is cut into layers; a layer is two fibres, a radius of gyration above and below its centroid
// with half of its area each: area, centroid and second moment of each layer are exact, and with them the elastic
// section. A cover is what lies outside of a core of the same shape; bars are further fibres (the concrete they stand
// in is not taken off). Left out: shear and its part in yield, bars that slip or buckle, sections that do not stay
// plane.
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
  double area = 0;    ///< of all at one height [m2]
  double height = 0;  ///< above the bottom of the section [m]
  // Where they stand in space:
  int count = 1;      ///< so many, evenly over `spread`
  double across = 0;  ///< their middle, from that of the section's width [m]
  double spread = 0;  ///< from the first to the last [m]
};

/// What fibres are made from.
struct FibreSpec {
  FibreShape shape;
  UniaxialLaw law;
  int layers = 20;  ///< of even depth, cut further where the width changes at once
  double cover = 0;
  UniaxialLaw cover_law = {};           ///< where there is a cover
  std::optional<FibreShape> core = {};  ///< in place of what `cover` leaves; its bottom is `cover` above the shape's
  std::vector<FibreBars> bars = {};
  UniaxialLaw bar_law = {};
  std::array<int, 2>
      cells{};  ///< of sections in space: up and across; 0: chosen, see element/section/fibre_section_3d.hpp
};

struct Fibre {
  double area = 0;    ///< [m2]
  double height = 0;  ///< above the centroid [m]
};

/// Fibres of one law, one after the other.
struct FibrePart {
  UniaxialLaw law;
  int first = 0, count = 0;
};

struct FibreSection {
  std::vector<Fibre> fibres;
  std::vector<FibrePart> parts;

  /// Numbers that it remembers: those of each fibre in order. A new section remembers 0 alone.
  [[nodiscard]] int memory_size() const;
  /// N, M over axial strain, curvature, of the stiffest that the laws can be [N], [N m], [N m2].
  [[nodiscard]] Eigen::Matrix2d stiffest() const;
};

/// Throws InputError where layers, cover, bars or a law are not sound.
FibreSection make_fibres(const FibreSpec& spec);

struct SectionStrain {
  double axial = 0;      ///< [1]
  double curvature = 0;  ///< [1/m]
};

struct SectionResponse {
  double normal = 0;  ///< tension above 0 [N]
  double moment = 0;  ///< above 0 where the bottom is in tension [N m]
  Eigen::Matrix2d tangent = Eigen::Matrix2d::Zero();
  double stored = 0;      ///< [J/m]
  double dissipated = 0;  ///< in this step [J/m]
  bool yielding = false;  ///< any fibre, in this step
};

/// `before` and `after` have memory_size() numbers each and do not overlap.
SectionResponse respond(const FibreSection& section, const SectionStrain& strain, std::span<const double> before,
                        std::span<double> after);

}  // namespace trilith
