// Private to view/: numbers packed for the page of `trilith view`: quantised, as differences, deflated, as text.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace trilith::view {

/// A table of whole numbers, row after row; a value is its number times `quantum`.
struct ViewBlock {
  std::string name;
  std::size_t columns = 1;
  double quantum = 1;
  std::vector<std::int32_t> values;
  std::size_t rows() const { return columns == 0 ? 0 : values.size() / columns; }
};

/// Stands for a sample that was not taken: the page makes NaN of it.
inline constexpr std::int32_t no_sample = std::numeric_limits<std::int32_t>::min();

/// The whole number nearest to value / quantum, held within 2^30 on both sides; 0 where `value` is not finite.
std::int32_t quantised(double value, double quantum);

/// Column after column, each value as the difference to the one above it, zigzag (0, -1, 1, -2, ...), seven bits a byte
/// with the low ones first and the high bit set on all but the last.
std::string packed(const ViewBlock& block);

/// The values back from packed(); asserts on bytes that are none of ours. Used by the tests; the page has its own.
std::vector<std::int32_t> unpacked(std::string_view bytes, std::size_t rows, std::size_t columns);

/// A gzip stream without name and clock, the same for the same bytes.
std::string gzipped(std::string_view bytes);
std::string gunzipped(std::string_view bytes);

std::string base64(std::string_view bytes);
std::string from_base64(std::string_view text);

}  // namespace trilith::view
