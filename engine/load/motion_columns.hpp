// Columns of numbers in a text file, and the identification of time and acceleration among them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "load/motion_plain.hpp"
#include "load/text_lines.hpp"

namespace trilith {

/// The numbers of a file, row by row, with the lines before them.
struct NumberTable {
  std::vector<double> values;      ///< row by row
  std::size_t width = 0;           ///< numbers in a row; the last row may have fewer
  std::vector<double> resolution;  ///< of each column: the smallest decimal of its numbers as written
  std::vector<std::string> names;  ///< of the columns, from the last line of the head; empty if it contains none
  std::string title;

  [[nodiscard]] std::size_t rows() const { return width == 0 ? 0 : values.size() / width; }
  [[nodiscard]] bool ragged() const { return width != 0 && values.size() % width != 0; }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const { return values[row * width + column]; }
  [[nodiscard]] std::vector<double> column(std::size_t index) const;
  [[nodiscard]] std::string name(std::size_t column) const { return names.empty() ? "" : names[column]; }
};

/// Reads head and numbers of `text`. Fails through `lines` for a row with another number of columns than the first one,
/// and for a line without numbers among the rows. It also fails for numbers with decimal commas that the form does not
/// name.
NumberTable read_number_table(TextLines& lines, std::string_view text, const PlainForm& form);

/// Columns of the record.
struct RecordColumns {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t time = none;          ///< none: the step is given
  std::size_t acceleration = none;  ///< none: all numbers are samples, row by row
};

/// From the form's `column`, or from the numbers themselves; fails with the list of columns if more than one is
/// possible.
RecordColumns find_record_columns(const NumberTable& table, const PlainForm& form, const TextLines& lines);

}  // namespace trilith
