#include "results/reading/set_reading.hpp"

#include <algorithm>

namespace trilith::results {
namespace {

h5::Handle open_set(hid_t file, const std::string& path) {
  return h5::Handle(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose, "there is no readable " + path);
}

// A damaged size must not allocate excessive memory: an uncompressed set stores its bytes.
void require_stored(hid_t dataset, std::size_t bytes, const std::string& path) {
  if (H5Dget_storage_size(dataset) < bytes) throw h5::Failure(path + " is damaged");
}

h5::Handle stored(const h5::Handle& dataset, const std::string& path) {
  return h5::Handle(H5Dget_type(dataset.get()), H5Tclose, "unreadable type of " + path);
}

}  // namespace

std::int64_t row_count(hid_t file, const std::string& path) {
  const h5::Handle dataset = open_set(file, path);
  const std::vector<hsize_t> extent = h5::extents(dataset.get());
  if (extent.empty()) throw h5::Failure(path + " has no rows");
  return static_cast<std::int64_t>(extent[0]);
}

void read_into(hid_t file, const std::string& path, std::int64_t first, std::int64_t count,
               const std::vector<hsize_t>& row_shape, hid_t type, void* out) {
  const h5::Handle dataset = open_set(file, path);
  std::vector<hsize_t> extent = h5::extents(dataset.get());
  if (extent.size() != row_shape.size() + 1 || !std::equal(row_shape.begin(), row_shape.end(), extent.begin() + 1))
    throw h5::Failure(path + " has another shape than the model requires");
  if (static_cast<hsize_t>(first + count) > extent[0]) throw h5::Failure(path + " has fewer rows than were flushed");
  if (count == 0) return;
  h5::require_plain(stored(dataset, path).get(), path);
  extent[0] = static_cast<hsize_t>(count);
  std::vector<hsize_t> start(extent.size(), 0);
  start[0] = static_cast<hsize_t>(first);
  const h5::Handle memory = h5::space(extent);
  const h5::Handle space(H5Dget_space(dataset.get()), H5Sclose, "unreadable space of " + path);
  h5::check(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr),
            "cannot select rows of " + path);
  h5::check(H5Dread(dataset.get(), type, memory.get(), space.get(), H5P_DEFAULT, out), "cannot read " + path);
}

void match_stored(hid_t file, const std::string& path, TableType& type) {
  const h5::Handle dataset = open_set(file, path);
  const h5::Handle table = stored(dataset, path);
  if (H5Tget_class(table.get()) != H5T_COMPOUND) throw h5::Failure(path + " is not a table");
  for (Column& column : type.columns) {
    const int index = H5Tget_member_index(table.get(), column.name.c_str());
    column.present = index >= 0;
    if (!column.present) continue;
    const h5::Handle member(H5Tget_member_type(table.get(), static_cast<unsigned>(index)), H5Tclose,
                            "unreadable column " + column.name);
    const bool is_text = H5Tget_class(member.get()) == H5T_STRING;
    if (is_text != (column.kind == Kind::text) || (is_text && H5Tis_variable_str(member.get()) > 0))
      throw h5::Failure(path + " has another kind of column " + column.name);
    if (is_text) column.length = H5Tget_size(member.get());
  }
  type.place();
}

std::string read_text_set(hid_t file, const std::string& path) {
  const h5::Handle dataset = open_set(file, path);
  const h5::Handle type = stored(dataset, path);
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0 ||
      !h5::extents(dataset.get()).empty())
    throw h5::Failure(path + " is not a text");
  const std::size_t length = H5Tget_size(type.get());
  require_stored(dataset.get(), length, path);
  std::string text(length, '\0');
  h5::check(H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "cannot read " + path);
  text.resize(std::min(text.find('\0'), length));
  return text;
}

std::vector<std::string> read_texts(hid_t file, const std::string& path) {
  const h5::Handle dataset = open_set(file, path);
  const h5::Handle type = stored(dataset, path);
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0)
    throw h5::Failure(path + " holds no text");
  const std::size_t length = H5Tget_size(type.get());
  const auto count = static_cast<std::size_t>(row_count(file, path));
  std::string packed(count * length, '\0');
  read_into(file, path, 0, static_cast<std::int64_t>(count), {}, type.get(), packed.data());
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) {
    const auto begin = packed.begin() + static_cast<std::ptrdiff_t>(i * length);
    texts.emplace_back(begin, std::find(begin, begin + static_cast<std::ptrdiff_t>(length), '\0'));
  }
  return texts;
}

}  // namespace trilith::results
