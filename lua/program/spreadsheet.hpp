// A workbook for spreadsheet programs, with a sheet for each table.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "results/tables/table_sink.hpp"

struct lxw_workbook;
struct lxw_worksheet;
struct lxw_format;

namespace trilith::program {

/// Rows of a sheet that spreadsheet programs can hold, with the header.
inline constexpr unsigned most_sheet_rows = 1048576;

/// Writes an Office Open XML workbook (ISO/IEC 29500) through libxlsxwriter. The first row of each sheet is a header.
/// A table with more rows than a sheet can hold goes on in further sheets. The file appears under its name when it is
/// complete.
class Spreadsheet : public results::TableSink {
 public:
  /// Throws InputError if the folder of `path` cannot be written. `most_rows`: rows of a sheet, at least 2.
  explicit Spreadsheet(const std::filesystem::path& path, unsigned most_rows = most_sheet_rows);
  Spreadsheet(const Spreadsheet&) = delete;
  Spreadsheet& operator=(const Spreadsheet&) = delete;
  ~Spreadsheet() override;

  /// Begins the sheet `name`, of at most 20 characters.
  void begin_sheet(const std::string& name);
  void text(std::string_view text) override;
  void number(double value) override;
  void count(std::int64_t value) override { number(static_cast<double>(value)); }
  void end_row() override;
  /// Completes the file. Throws InputError with the reason if it cannot be written; then there is no file.
  void close();

 private:
  void add_sheet();

  std::filesystem::path path_, unfinished_;
  std::string folder_, name_;
  unsigned most_rows_;
  lxw_workbook* book_ = nullptr;
  lxw_worksheet* sheet_ = nullptr;
  lxw_format* head_ = nullptr;
  std::vector<std::string> header_;
  unsigned row_ = 0, part_ = 1;
  unsigned short column_ = 0;
};

}  // namespace trilith::program
