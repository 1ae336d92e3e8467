#include "program/spreadsheet.hpp"

#include <fmt/format.h>
#include <xlsxwriter.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "base/error.hpp"

namespace trilith::program {
namespace {

constexpr double column_width = 16;          ///< [characters]
constexpr std::size_t longest_text = 32767;  ///< of a cell [characters]; in bytes, to be on the safe side

/// The text that a cell can hold. A longer one is cut before a character of UTF-8.
std::string cell_text(std::string_view text) {
  std::size_t end = std::min<std::size_t>(text.size(), longest_text);
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return std::string(text.substr(0, end));
}

}  // namespace

Spreadsheet::Spreadsheet(const std::filesystem::path& path, unsigned most_rows)
    : path_(path), unfinished_(path.string() + ".part"), folder_(path.parent_path().string()), most_rows_(most_rows) {
  if (folder_.empty()) folder_ = ".";
  // Rows go to temporary files in the folder of the result, so that long histories need no memory.
  lxw_workbook_options options{};
  options.constant_memory = LXW_TRUE;
  options.tmpdir = folder_.data();
  book_ = workbook_new_opt(unfinished_.c_str(), &options);
  if (book_ == nullptr) throw InputError(fmt::format("'{}' cannot be written", path_.string()));
  head_ = workbook_add_format(book_);
  format_set_bold(head_);
}

Spreadsheet::~Spreadsheet() {
  if (book_ == nullptr) return;
  workbook_close(book_);  // frees it; the incomplete file is removed
  std::error_code ignored;
  std::filesystem::remove(unfinished_, ignored);
}

void Spreadsheet::begin_sheet(const std::string& name) {
  name_ = name, part_ = 1;
  header_.clear();
  add_sheet();
}

void Spreadsheet::add_sheet() {
  const std::string title = part_ == 1 ? name_ : fmt::format("{} {}", name_, part_);
  sheet_ = workbook_add_worksheet(book_, title.c_str());
  if (sheet_ == nullptr)
    throw InputError(
        fmt::format("'{}' cannot be written: no room for sheet '{}' in folder '{}'", path_.string(), title, folder_));
  worksheet_freeze_panes(sheet_, 1, 0);
  worksheet_set_column(sheet_, 0, 63, column_width, nullptr);
  row_ = 0, column_ = 0;
}

void Spreadsheet::text(std::string_view text) {
  const std::string cell = cell_text(text);
  if (row_ == 0 && part_ == 1) header_.push_back(cell);
  if (!cell.empty()) worksheet_write_string(sheet_, row_, column_, cell.c_str(), row_ == 0 ? head_ : nullptr);
  ++column_;
}

void Spreadsheet::number(double value) {
  if (std::isinf(value)) return text(value > 0 ? "inf" : "-inf");
  if (!std::isnan(value)) worksheet_write_number(sheet_, row_, column_, value, nullptr);
  ++column_;
}

void Spreadsheet::end_row() {
  column_ = 0;
  if (++row_ < most_rows_) return;
  ++part_;
  add_sheet();
  for (const std::string& head : header_) text(head);
  ++row_, column_ = 0;
}

void Spreadsheet::close() {
  const lxw_error error = workbook_close(book_);
  book_ = nullptr;
  std::error_code failed;
  if (error == LXW_NO_ERROR) std::filesystem::rename(unfinished_, path_, failed);
  if (error == LXW_NO_ERROR && !failed) return;
  std::error_code ignored;
  std::filesystem::remove(unfinished_, ignored);
  throw InputError(fmt::format("'{}' cannot be written: {}", path_.string(),
                               failed ? failed.message() : std::string(lxw_strerror(error))));
}

}  // namespace trilith::program
