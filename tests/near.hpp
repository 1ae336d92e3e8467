// Comparing numbers: a relative tolerance that is true to scale, and an absolute one for what should be 0.
#pragma once

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

namespace trilith::testing {

/// Outcome of a comparison: true or false for CHECK, and where that fails the figures it prints.
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

/// Whether `value` differs from `expected` by no more than `relative` times the size of `expected`, however small that
/// is. Never so for what is not finite. Where 0 is expected nothing but 0 is near: see near_zero.
inline Nearness near(double value, double expected, double relative) {
  const double difference = std::abs(value - expected), size = std::abs(expected);
  return {std::isfinite(size) && difference <= relative * size, value, expected, relative};
}

/// Whether `value` is 0 within `within`, which has its unit. Never so for what is not finite.
inline Nearness near_zero(double value, double within) {
  return {std::isfinite(value) && std::abs(value) <= within, value, 0, within};
}

}  // namespace trilith::testing
