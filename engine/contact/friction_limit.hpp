// How much sliding and turning friction an area carries at once.
//
//      y                          An area under uniform pressure that slides with the force V and turns with the couple
//      T
//     1 |----._                   reaches its limit on a convex curve, and moves along the curve's normal (Goyal, Ruina
//       |       `.                and Papadopoulos, "Planar sliding with dry friction", Wear 143, 1991). With
//       |         \               x = V / mu N, y = T / mu N r, r the mean distance of the area from its middle,
//       |__________|_ x
//                  1                  x^2 + y^2 + k x^2 y^2 = 1
//
// With k = 0.57 this is right to .6 % for a square. (k = 0, the ellipse that is often used, is up to 5 % too strong.)
#pragma once

#include <utility>

namespace trilith {

/// x^2 + y^2 + k x^2 y^2.
double limit_measure(double x, double y);

/// The point of the curve nearest to a point outside of it; x, y and what is returned not below 0.
std::pair<double, double> nearest_on_limit(double x, double y);

}  // namespace trilith
