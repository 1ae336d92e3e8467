// How much sliding and turning friction an area carries at once.
//
//      T / mu N r                 An area under uniform pressure that slides with the force V and turns with the couple
//      T
//     1 |----._                   reaches its limit on a convex curve, and moves along the curve's normal (Goyal, Ruina
//       |       `.                and Papadopoulos, "Planar sliding with dry friction", Wear 143, 1991). Of a square
//       |         \               the curve is, to 1.3 %,
//       |__________|_ V / mu N
//                  1                  (V / mu N)^p + (T / mu N r)^p = 1,  p = 1.75,
//
// r being the mean distance of the area from its middle. (p = 2 is the ellipse that is often used; it is up to 5 % too
// strong.)
#pragma once

#include <utility>

namespace trilith {

/// The point of the curve x^p + y^p = 1 nearest to a point outside of it; x, y and what is returned not below 0.
std::pair<double, double> nearest_on_limit(double x, double y);

/// x^p + y^p.
double limit_measure(double x, double y);

}  // namespace trilith
