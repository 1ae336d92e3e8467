// Elementary functions with the same bits on every processor. The C library selects variants at start for the processor
// at hand, with or without fused multiply-add, and these differ in the last bit. So every computation of a model, a
// load or a step calls these functions. They use sums, products, quotients and square roots alone, each rounded as IEEE
// 754 states, in a fixed order. `tests/rooms/check` finds calls of the C library's functions. Errors are below 1 ulp
// unless stated.
#pragma once

#include <cmath>

namespace trilith::portable {

struct SineCosine {
  double sine, cosine;
};

/// For any angle [rad]; NaN where it is not finite. The sine is odd and the cosine even to the bit.
SineCosine sine_cosine(double angle);
inline double sin(double angle) {
  return sine_cosine(angle).sine;
}
inline double cos(double angle) {
  return sine_cosine(angle).cosine;
}
double tan(double angle);

/// Angle of (x, y) from the x axis, -pi to pi [rad]; signs of zeros and infinite values as in C.
double atan2(double y, double x);
/// -pi/2 to pi/2 [rad]; NaN outside of -1 to 1.
double asin(double x);
/// 0 to pi [rad]; NaN outside of -1 to 1.
double acos(double x);

double exp(double x);
/// Natural logarithm; minus infinity at 0, NaN below.
double log(double x);
/// base^exponent; special values as in C.
double pow(double base, double exponent);

/// Equals `hypot` for arguments of any magnitude.
double hypot_of_extremes(double x, double y);
/// Length of (x, y), to 1 part in 2^52; special values as in C.
inline double hypot(double x, double y) {
  const double square = x * x + y * y;
  if (square > 0x1p-960 && square <= 0x1p1000) return std::sqrt(square);
  return hypot_of_extremes(x, y);
}

}  // namespace trilith::portable
