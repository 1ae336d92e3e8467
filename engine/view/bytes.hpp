// Private to view/: numbers packed for the page of `trilith view`: quantised, as differences, deflated, as text.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace trilith::view {

/// A table of integers, row after row; a value is its number times `quantum`.
struct ViewBlock {
  std::string name;
  std::size_t columns = 1;
  double quantum = 1;
  std::vector<std::int32_t> values;
  std::size_t rows() const { return columns == 0 ? 0 : values.size() / columns; }
};

/// Marks a missing sample, which the page converts to NaN.
inline constexpr std::int32_t no_sample = std::numeric_limits<std::int32_t>::min();

/// The integer nearest to value / quantum, limited to +-2^30; 0 if `value` is not finite.
std::int32_t quantised(double value, double quantum);

/// Column after column, each value as the difference to the one above it in zigzag code (0, -1, 1, -2, ...). Seven bits
/// per byte, low bits first, with the high bit set on all but the last byte.
std::string packed(const ViewBlock& block);

/// Inverse of packed(); asserts on invalid bytes. Used by the tests; the page has its own.
std::vector<std::int32_t> unpacked(std::string_view bytes, std::size_t rows, std::size_t columns);

/// A gzip stream without name and time, equal for equal bytes.
std::string gzipped(std::string_view bytes);
std::string gunzipped(std::string_view bytes);

std::string base64(std::string_view bytes);
std::string from_base64(std::string_view text);

}  // namespace trilith::view
