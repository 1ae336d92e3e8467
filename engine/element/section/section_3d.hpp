// Cross-sections of beams in space: what bending about two axes and torsion need of them, and their profile.
//
// Axes of a section: y up, from its bottom to its top; z across; x along the beam. Numbers of bending in the plane of x
// and y are those of element/section/section.hpp.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "element/section/section.hpp"

namespace trilith {

/// A section as a beam in space uses it.
struct Section3 {
  double area = 0;                        ///< [m2]
  std::array<double, 2> second_moment{};  ///< about y (bending across) and about z (bending up and down) [m4]
  double torsion = 0;                     ///< torsion constant J [m4]
  std::array<double, 2> shear_area{};     ///< area times shear coefficient, of bending about y and about z [m2]
  /// Convex polygons of points (across, up) from the centroid that share edges or nothing [m]
  std::vector<std::vector<Vec2>> profile;
};

/// Torsion constant of a solid rectangle, by Saint-Venant's series (S. Timoshenko and J. N. Goodier, "Theory of
/// elasticity", 3rd ed. 1970, art. 109) [m4]: a b^3 (1/3 - 64/pi^5 b/a sum of tanh(n pi a / 2b) / n^5, n odd), a >= b.
double rectangle_torsion(double width, double depth);

// Of each shape. Open thin walls carry torsion as the sum of width times thickness cubed over 3 (the same, art. 112),
// closed ones as 4 A^2 over the sum of length over thickness round their middle (R. Bredt 1896; the same, art. 116).
// Warping is free everywhere.
Section3 section_in_space(const RectangleSection& s);
Section3 section_in_space(const CircleSection& s);
Section3 section_in_space(const ISection& s);
Section3 section_in_space(const TSection& s);
Section3 section_in_space(const BoxSection& s);
/// Its torsion constant, second moment across and width may be 0, where they were not given.
Section3 section_in_space(const GivenSection& s);

/// Of a simple polygon, given in its own axes: x across, y up [m]. Torsion by Saint-Venant's rule for compact sections,
/// A^4 / (40 Ip), Ip the polar second moment: within 2 % for ellipses, within 7 % for rectangles (the same, art. 110).
/// Throws InputError where y is not one of its principal axes.
Section3 polygon_section_in_space(std::span<const Vec2> outline);

}  // namespace trilith
