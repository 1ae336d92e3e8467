// The family of implicit schemes: Newmark, HHT-alpha, generalised alpha.
//
//   M ((1 - alpha_m) a' + alpha_m a) = (1 - alpha_f) F' + alpha_f F
//   x' = x + dt v + dt^2 ((1/2 - b) a + b a'),   v' = v + dt ((1 - g) a + g a')
//
// with ' at the end of the step. Order 2 and stable for any step of a linear system where made below. Newmark, "A
// method of computation for structural dynamics", J. Eng. Mech. Div. ASCE 85, 1959; Hilber, Hughes and Taylor,
// "Improved numerical dissipation for time integration algorithms in structural dynamics", Earthq. Eng. Struct. Dyn. 5,
// 1977; Chung and Hulbert, "A time integration algorithm for structural dynamics with improved numerical dissipation:
// the generalized-alpha method", J. Appl. Mech. 60, 1993.
#pragma once

namespace trilith {

struct AlphaScheme {
  double alpha_m = 0, alpha_f = 0, b = 0.25, g = 0.5;

  /// `alpha` from -1/3 to 0: HHT. At 0 it is Newmark's average acceleration, without numerical damping.
  static constexpr AlphaScheme hht(double alpha) { return {0, -alpha, 0.25 * (1 - alpha) * (1 - alpha), 0.5 - alpha}; }
  /// `radius` from 0 to 1: spectral radius at infinite frequency, Chung and Hulbert eqs. 17 and 25.
  static constexpr AlphaScheme from_radius(double radius) {
    const double m = (2 * radius - 1) / (radius + 1), f = radius / (radius + 1), e = 1 - m + f;
    return {m, f, 0.25 * e * e, 0.5 - m + f};
  }
};

}  // namespace trilith
