#include "results/reading/table_columns.hpp"

#include <algorithm>
#include <cassert>

namespace trilith::results {

hid_t stored_type(Kind kind) {
  switch (kind) {
    case Kind::real:
      return H5T_IEEE_F64LE;
    case Kind::int64:
      return H5T_STD_I64LE;
    case Kind::int32:
      return H5T_STD_I32LE;
    case Kind::int8:
      return H5T_STD_I8LE;
    case Kind::text:
      break;
  }
  assert(false);
  return H5I_INVALID_HID;
}

std::size_t stored_size(Kind kind) {
  switch (kind) {
    case Kind::real:
    case Kind::int64:
      return 8;
    case Kind::int32:
      return 4;
    case Kind::int8:
      return 1;
    case Kind::text:
      break;
  }
  return 0;
}

void TableType::place() {
  size = 0;
  for (Column& column : columns) {
    column.offset = size;
    if (column.present) size += column.length;
  }
}

h5::Handle TableType::hdf5() const {
  h5::Handle type(H5Tcreate(H5T_COMPOUND, std::max<std::size_t>(size, 1)), H5Tclose, "cannot make a table type");
  for (const Column& column : columns) {
    if (!column.present) continue;
    h5::Handle text;
    if (column.kind == Kind::text) text = h5::text_type(column.length);
    const hid_t member = text ? text.get() : stored_type(column.kind);
    h5::check(H5Tinsert(type.get(), column.name.c_str(), column.offset, member), "cannot add column " + column.name);
  }
  return type;
}

std::vector<std::string> TableType::units() const {
  std::vector<std::string> result;
  for (const Column& column : columns) result.push_back(column.unit);
  return result;
}

std::vector<std::string> TableType::descriptions() const {
  std::vector<std::string> result;
  for (const Column& column : columns) result.push_back(column.description);
  return result;
}

TableType ColumnCollector::finish() && {
  type_.place();
  return std::move(type_);
}

void ColumnCollector::add(std::string name, const char* unit, const char* description, Kind kind, std::size_t length) {
  if (next_ == type_.columns.size()) type_.columns.push_back({std::move(name), unit, description, kind, length});
  Column& column = type_.columns[next_++];
  column.length = std::max(column.length, length);
}

void Packer::text(const char*, const std::string& value, std::size_t, const char*) {
  const Column& column = type_.columns[next_++];
  std::byte* out = out_ + column.offset;
  std::memset(out, 0, column.length);
  std::string text = h5::clean(value);
  if (text.size() > column.length) {
    static constexpr std::string_view ellipsis = "\xE2\x80\xA6";
    std::size_t keep = column.length < ellipsis.size() ? 0 : column.length - ellipsis.size();
    while (keep > 0 && (static_cast<unsigned char>(text[keep]) & 0xC0) == 0x80) --keep;
    text.resize(keep);
    if (column.length >= ellipsis.size()) text += ellipsis;
  }
  std::memcpy(out, text.data(), text.size());
}

void Unpacker::text(const char*, std::string& value, std::size_t, const char*) {
  const Column& column = type_.columns[next_++];
  if (!column.present) return;
  const char* begin = reinterpret_cast<const char*>(in_ + column.offset);
  value.assign(begin, std::find(begin, begin + column.length, '\0'));
}

}  // namespace trilith::results
