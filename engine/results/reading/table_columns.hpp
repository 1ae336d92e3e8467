// Private to results/: table rows as packed records. `describe` (table_rows.hpp) names the columns of a row type once;
// the three archives here convert that declaration into the table's type, into bytes, and back into values.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "results/file/hdf5_handle.hpp"

namespace trilith::results {

// Packed records and the stored types are both little-endian.
static_assert(std::endian::native == std::endian::little);

enum class Kind { real, int64, int32, int8, text };

/// HDF5's little-endian type of one number; not for text.
hid_t stored_type(Kind kind);
/// Bytes of one number; 0 for text.
std::size_t stored_size(Kind kind);

struct Column {
  std::string name, unit, description;
  Kind kind = Kind::real;
  std::size_t length = 0;  ///< bytes
  std::size_t offset = 0;  ///< bytes from the start of the record
  bool present = true;     ///< false: the file has no such column
};

/// The columns of a table, packed without gaps.
struct TableType {
  std::vector<Column> columns;
  std::size_t size = 0;  ///< bytes per record

  void place();  ///< sets the offsets and the size from the lengths of the present columns
  h5::Handle hdf5() const;
  std::vector<std::string> units() const;
  std::vector<std::string> descriptions() const;
};

/// Common part of the archives: the dimension and the columns of x, y, z.
struct Archive {
  explicit Archive(int dimension) : dim(dimension) {}
  int dim;
  static constexpr const char* axis[3] = {"x", "y", "z"};
};

/// Collects the columns; if called for several rows, text columns grow to the longest.
class ColumnCollector : public Archive {
 public:
  template <class T>
  using Of = const T;

  explicit ColumnCollector(int dimension) : Archive(dimension) {}
  void start_row() { next_ = 0; }
  TableType finish() &&;

  void number(const char* name, double, const char* unit, const char* description) {
    add(name, unit, description, Kind::real, sizeof(double));
  }
  void number(const char* name, std::int64_t, const char* unit, const char* description) {
    add(name, unit, description, Kind::int64, sizeof(std::int64_t));
  }
  void number(const char* name, std::int32_t, const char* unit, const char* description) {
    add(name, unit, description, Kind::int32, sizeof(std::int32_t));
  }
  template <class Code>
  void code(const char* name, Code, const char* description) {
    add(name, "1", description, Kind::int8, 1);
  }
  void vector(const char* prefix, const double (&)[3], const char* unit, const char* description) {
    for (int i = 0; i < dim; ++i) add(std::string(prefix) + axis[i], unit, description, Kind::real, sizeof(double));
  }
  void text(const char* name, const std::string& value, std::size_t least, const char* description) {
    add(name, "", description, Kind::text, std::max({least, value.size(), std::size_t{1}}));
  }

 private:
  void add(std::string name, const char* unit, const char* description, Kind kind, std::size_t length);

  TableType type_;
  std::size_t next_ = 0;
};

/// Writes one row as a record.
class Packer : public Archive {
 public:
  template <class T>
  using Of = const T;

  Packer(const TableType& type, int dimension, std::byte* out) : Archive(dimension), type_(type), out_(out) {}

  void number(const char*, double value, const char*, const char*) { put(value); }
  void number(const char*, std::int64_t value, const char*, const char*) { put(value); }
  void number(const char*, std::int32_t value, const char*, const char*) { put(value); }
  template <class Code>
  void code(const char*, Code value, const char*) {
    put(static_cast<std::int8_t>(value));
  }
  void vector(const char*, const double (&values)[3], const char*, const char*) {
    for (int i = 0; i < dim; ++i) put(values[i]);
  }
  void text(const char*, const std::string& value, std::size_t, const char*);

 private:
  template <class T>
  void put(T value) {
    std::memcpy(out_ + type_.columns[next_++].offset, &value, sizeof value);
  }

  const TableType& type_;
  std::byte* out_;
  std::size_t next_ = 0;
};

/// Reads one row from a record; columns missing in the file keep their default.
class Unpacker : public Archive {
 public:
  template <class T>
  using Of = T;

  Unpacker(const TableType& type, int dimension, const std::byte* in) : Archive(dimension), type_(type), in_(in) {}

  template <class Number>
  void number(const char*, Number& value, const char*, const char*) {
    take(value);
  }
  template <class Code>
  void code(const char*, Code& value, const char*) {
    auto raw = static_cast<std::int8_t>(value);
    take(raw);
    value = static_cast<Code>(raw);
  }
  void vector(const char*, double (&values)[3], const char*, const char*) {
    for (int i = 0; i < dim; ++i) take(values[i]);
  }
  void text(const char*, std::string& value, std::size_t, const char*);

 private:
  template <class T>
  void take(T& value) {
    const Column& column = type_.columns[next_++];
    if (column.present) std::memcpy(&value, in_ + column.offset, sizeof value);
  }

  const TableType& type_;
  const std::byte* in_;
  std::size_t next_ = 0;
};

}  // namespace trilith::results
