#include "contact/friction_limit.hpp"

#include <cmath>

#include "base/portable.hpp"

namespace trilith {
namespace {

/// x^0.75: p - 1, the slope of x^p but for p.
double slope_power(double x) {
  const double root = std::sqrt(x);
  return root * std::sqrt(root);
}

/// The curve's y at x.
double on_curve(double x) {
  const double left = 1 - x * slope_power(x);
  return left > 0 ? portable::pow(left, 1 / 1.75) : 0;
}

}  // namespace

double limit_measure(double x, double y) {
  return x * slope_power(x) + y * slope_power(y);
}

/// At the nearest point (a, b) the way to (x, y) goes along the curve's normal: (x - a) b^(p-1) = (y - b) a^(p-1).
/// Left of it the left side is the greater one, right of it the right side: regula falsi between 0 and 1, with the
/// standing end's value halved (Illinois).
std::pair<double, double> nearest_on_limit(double x, double y) {
  if (!(y > 1e-9 * x)) return {1, 0};
  if (!(x > 1e-9 * y)) return {0, 1};
  const auto gap = [&](double a, double b) { return (x - a) * slope_power(b) - (y - b) * slope_power(a); };
  double low = 0, high = 1, at_low = gap(0, 1), at_high = gap(1, 0);
  double a = x / (x + y), b = on_curve(a);
  for (int i = 0; i < 60; ++i) {
    const double value = gap(a, b);
    if (value > 0) {
      if (low > 0) at_high *= 0.5;
      low = a, at_low = value;
    } else {
      if (high < 1) at_low *= 0.5;
      high = a, at_high = value;
    }
    const double next = low + (high - low) * at_low / (at_low - at_high);
    if (std::abs(next - a) < 1e-13 || high - low < 1e-13) break;
    a = next, b = on_curve(a);
  }
  return {a, b};
}

}  // namespace trilith
