// Comparison of numbers: a tolerance relative to the expected value, and an absolute one for an expected 0.
#pragma once

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

namespace trilith::testing {

/// Outcome of a comparison: true or false for CHECK; on failure it prints the figures.
struct Nearness {
  bool holds;
  double value, expected, allowed;
  explicit operator bool() const { return holds; }
};

inline doctest::String toString(const Nearness& n) {
  const std::string off = n.expected == 0 ? fmt::format("allowed {:.4g}", n.allowed)
                                          : fmt::format("off by {:.4g} of it, allowed {:.4g}",
                                                        std::abs((n.value - n.expected) / n.expected), n.allowed);
  return fmt::format("{}, expected {}: {}", n.value, n.expected, off).c_str();
}

/// Whether `value` differs from `expected` by at most `relative` times the size of `expected`, however small. False if
/// either is not finite. For an expected 0 only 0 is near: see near_zero.
inline Nearness near(double value, double expected, double relative) {
  const double difference = std::abs(value - expected), size = std::abs(expected);
  return {std::isfinite(size) && difference <= relative * size, value, expected, relative};
}

/// Whether `value` is 0 to the absolute tolerance `within`, in its unit. False if it is not finite.
inline Nearness near_zero(double value, double within) {
  return {std::isfinite(value) && std::abs(value) <= within, value, 0, within};
}

}  // namespace trilith::testing
