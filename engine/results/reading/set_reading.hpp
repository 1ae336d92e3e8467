// Private to results/: reads rows of data sets as values, and checks them against the caller's expectations.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "results/file/hdf5_handle.hpp"
#include "results/reading/table_rows.hpp"

namespace trilith::results {

/// Reads rows [first, first + count) of data set `path` as `type` into `out`. Throws Failure if the set is missing, its
/// rows have another shape than `row_shape`, or it has fewer rows.
void read_into(hid_t file, const std::string& path, std::int64_t first, std::int64_t count,
               const std::vector<hsize_t>& row_shape, hid_t type, void* out);

/// Number of rows of data set `path`.
std::int64_t row_count(hid_t file, const std::string& path);

/// Narrows `type` to the columns of table `path`, text columns to the widths stored there.
void match_stored(hid_t file, const std::string& path, TableType& type);

/// The text of a scalar data set.
std::string read_text_set(hid_t file, const std::string& path);
/// The entries of a data set of texts.
std::vector<std::string> read_texts(hid_t file, const std::string& path);

template <class T>
hid_t native_type();
template <>
inline hid_t native_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t native_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
inline hid_t native_type<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
inline hid_t native_type<std::int8_t>() {
  return H5T_NATIVE_INT8;
}

/// Rows of numbers, flat.
template <class T>
std::vector<T> read_rows(hid_t file, const std::string& path, std::int64_t first, std::int64_t count,
                         const std::vector<hsize_t>& row_shape) {
  // Checked first, so that a damaged counter does not allocate excessive memory.
  if (first < 0 || count < 0 || first > row_count(file, path) - count)
    throw h5::Failure(path + " has fewer rows than were flushed");
  std::size_t size = static_cast<std::size_t>(count);
  for (const hsize_t extent : row_shape) size *= static_cast<std::size_t>(extent);
  std::vector<T> values(size);
  read_into(file, path, first, count, row_shape, native_type<T>(), values.data());
  return values;
}

/// Rows of a table.
template <class Row>
std::vector<Row> read_table(hid_t file, const std::string& path, std::int64_t first, std::int64_t count, int dim) {
  if (first < 0 || count < 0 || first > row_count(file, path) - count)
    throw h5::Failure(path + " has fewer rows than were flushed");
  TableType type = table_type<Row>({}, dim);
  match_stored(file, path, type);
  const h5::Handle compound = type.hdf5();
  std::vector<std::byte> records(type.size * static_cast<std::size_t>(count));
  read_into(file, path, first, count, {}, compound.get(), records.data());
  std::vector<Row> rows;
  rows.reserve(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    rows.push_back(unpack<Row>(type, dim, records.data() + i * type.size));
  return rows;
}

/// All rows of a table.
template <class Row>
std::vector<Row> read_table(hid_t file, const std::string& path, int dim) {
  return read_table<Row>(file, path, 0, row_count(file, path), dim);
}

}  // namespace trilith::results
