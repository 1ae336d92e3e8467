// Receives the cells of a table row by row: a text of comma-separated values, or a sheet of a workbook.
#pragma once

#include <cstdint>
#include <string_view>

namespace trilith::results {

class TableSink {
 public:
  virtual ~TableSink() = default;
  virtual void text(std::string_view text) = 0;
  /// A missing value is NaN.
  virtual void number(double value) = 0;
  virtual void count(std::int64_t value) = 0;
  virtual void end_row() = 0;
};

}  // namespace trilith::results
