// Private to results/: data sets that grow by rows while a file is written, and data sets written once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "results/file/hdf5_handle.hpp"
#include "results/reading/table_columns.hpp"

namespace trilith::results {

/// Attribute with the name of the counter in /committed that a growing data set uses.
inline constexpr const char* rows_attribute = "rows";

/// Name and attributes of a data set.
struct SetText {
  std::string path, unit, description;
};

/// Creates group `path` with its members in order of creation.
void make_group(hid_t file, const std::string& path, const std::string& description);

/// Creates a data set of `extents` numbers and writes `values` (none if an extent is 0).
void write_numbers(hid_t file, const SetText& text, Kind kind, const std::vector<hsize_t>& extents, const void* values);

/// Creates a scalar data set of one text.
void write_text(hid_t file, const SetText& text, const std::string& value);

/// Creates a data set of one text per entry.
void write_texts(hid_t file, const SetText& text, const std::vector<std::string>& texts);

/// Writes the attributes units, description and columns of a table.
void write_table_attributes(hid_t dataset, const TableType& type, const std::string& description);

/// Creates a table of the `rows` packed records at `records`.
void write_table(hid_t file, const SetText& text, const TableType& type, hsize_t rows, const void* records);

/// A chunked, uncompressed data set that grows along its first axis; rows are buffered until `write`. Without
/// compression a chunk rewritten after a flush keeps its place, so that flushed rows survive a kill.
class GrowingSet {
 public:
  /// Numbers: one row is a block of `row_shape` (empty: one number).
  GrowingSet(hid_t file, const SetText& text, const char* counter, Kind kind, std::vector<hsize_t> row_shape);
  /// A table: one row is one record.
  GrowingSet(hid_t file, const SetText& text, const char* counter, const TableType& type);

  /// Bytes of one row.
  std::size_t row_bytes() const { return row_bytes_; }
  /// Reserves `rows` further rows at the end of the buffer; the caller fills them.
  std::byte* add(std::size_t rows = 1);
  /// Replaces a row, buffered or written.
  void replace(std::int64_t row, const std::byte* record);
  /// Number of rows appended, including buffered ones.
  std::int64_t rows() const { return written_ + static_cast<std::int64_t>(buffer_.size() / row_bytes_); }
  std::size_t buffered_bytes() const { return buffer_.size(); }
  /// Extends, writes the buffered rows and flushes this data set.
  void write();

 private:
  void create(hid_t file, const SetText& text, const char* counter, hid_t type);
  void transfer(std::int64_t first, std::int64_t count, const std::byte* data);

  std::string path_;
  std::vector<hsize_t> row_shape_, chunk_;
  std::size_t row_bytes_ = 0;
  h5::Handle own_type_;
  hid_t type_ = H5I_INVALID_HID;
  h5::Handle dataset_;
  std::int64_t written_ = 0;
  std::vector<std::byte> buffer_;
};

}  // namespace trilith::results
