#include "contact/friction_limit.hpp"

#include <cmath>

namespace trilith {
namespace {

constexpr double rounder = 0.57;  // k

/// The curve's y at x.
double on_curve(double x) {
  return x < 1 ? std::sqrt((1 - x * x) / (1 + rounder * x * x)) : 0;
}

}  // namespace

double limit_measure(double x, double y) {
  return x * x + y * y + rounder * x * x * y * y;
}

/// At the nearest point (a, b) the way to (x, y) goes along the curve's normal, which is that of
/// (a (1 + k b^2), b (1 + k a^2)). Left of it `gap` is above 0, right of it below: regula falsi between 0 and 1, with
/// the standing end's value halved (Illinois).
std::pair<double, double> nearest_on_limit(double x, double y) {
  if (!(y > 1e-9 * x)) return {1, 0};
  if (!(x > 1e-9 * y)) return {0, 1};
  const auto gap = [&](double a, double b) {
    return (x - a) * b * (1 + rounder * a * a) - (y - b) * a * (1 + rounder * b * b);
  };
  double low = 0, high = 1, at_low = gap(0, 1), at_high = gap(1, 0);
  double a = x / std::sqrt(x * x + y * y), b = on_curve(a);
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
