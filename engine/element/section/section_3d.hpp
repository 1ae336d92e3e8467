// Cross-sections of beams in space: constants of bending about two axes and of torsion, and the profile.
//
// Axes of a section: y up, from its bottom to its top; z across; x along the beam. For bending in the plane of x and y
// the constants equal those in element/section/section.hpp.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "element/section/section.hpp"

namespace trilith {

/// Section constants of a beam in space.
struct Section3 {
  double area = 0;                        ///< [m2]
  std::array<double, 2> second_moment{};  ///< about y (bending across) and about z (bending up and down) [m4]
  double torsion = 0;                     ///< torsion constant J [m4]
  std::array<double, 2> shear_area{};     ///< area times shear coefficient, for bending about y and about z [m2]
  /// Convex polygons of points (across, up) from the centroid; they share edges or nothing [m]
  std::vector<std::vector<Vec2>> profile;
};

/// Torsion constant of a solid rectangle [m4] by Saint-Venant's series (S. Timoshenko and J. N. Goodier, "Theory of
/// elasticity", 3rd ed. 1970, art. 109): a b^3 (1/3 - 64/pi^5 b/a sum of tanh(n pi a / 2b) / n^5, n odd), a >= b.
double rectangle_torsion(double width, double depth);

// Constants of each shape. Torsion of open thin walls is the sum of width times thickness cubed over 3 (Timoshenko and
// Goodier, art. 112). For closed ones it is 4 A^2 over the sum of length over thickness along the middle line (R. Bredt
// 1896; Timoshenko and Goodier, art. 116). Warping is free.
Section3 section_in_space(const RectangleSection& s);
Section3 section_in_space(const CircleSection& s);
Section3 section_in_space(const ISection& s);
Section3 section_in_space(const TSection& s);
Section3 section_in_space(const BoxSection& s);
/// Its torsion constant, second moment across and width may be 0 if they were not given.
Section3 section_in_space(const GivenSection& s);

/// A simple polygon, given in its own axes: x across, y up [m]. Torsion by Saint-Venant's rule for compact sections,
/// A^4 / (40 Ip), with the polar second moment Ip: within 2 % for ellipses, within 7 % for rectangles (Timoshenko and
/// Goodier, art. 110). Throws InputError where y is not one of its principal axes.
Section3 polygon_section_in_space(std::span<const Vec2> outline);

}  // namespace trilith
