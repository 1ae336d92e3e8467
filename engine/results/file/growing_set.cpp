#include "results/file/growing_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <functional>
#include <numeric>

namespace trilith::results {
namespace {

constexpr std::size_t least_chunk = 16 * 1024;
constexpr std::size_t most_chunk = 1024 * 1024;

// No time stamps in object headers, so that equal results have equal bytes.
h5::Handle timeless(hid_t property_class) {
  h5::Handle list(H5Pcreate(property_class), H5Pclose, "cannot make a property list");
  h5::check(H5Pset_obj_track_times(list.get(), false), "cannot switch time stamps off");
  return list;
}

h5::Handle make_dataset(hid_t file, const std::string& path, hid_t type, hid_t space, hid_t creation) {
  const hid_t id = H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  return h5::Handle(id, H5Dclose, "cannot create " + path);
}

void write_text_attributes(hid_t dataset, const SetText& text) {
  h5::write_attribute(dataset, "units", text.unit);
  h5::write_attribute(dataset, "description", text.description);
}

}  // namespace

void make_group(hid_t file, const std::string& path, const std::string& description) {
  const h5::Handle list = timeless(H5P_GROUP_CREATE);
  h5::check(H5Pset_link_creation_order(list.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED),
            "cannot track the order of creation");
  const h5::Handle group(H5Gcreate2(file, path.c_str(), H5P_DEFAULT, list.get(), H5P_DEFAULT), H5Gclose,
                         "cannot create " + path);
  h5::write_attribute(group.get(), "description", description);
}

void write_numbers(hid_t file, const SetText& text, Kind kind, const std::vector<hsize_t>& extents,
                   const void* values) {
  const h5::Handle list = timeless(H5P_DATASET_CREATE);
  const hid_t type = stored_type(kind);
  const h5::Handle dataset = make_dataset(file, text.path, type, h5::space(extents).get(), list.get());
  write_text_attributes(dataset.get(), text);
  const auto count = std::accumulate(extents.begin(), extents.end(), hsize_t{1}, std::multiplies<>());
  if (count == 0) return;
  h5::check(H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "cannot write " + text.path);
}

void write_text(hid_t file, const SetText& text, const std::string& value) {
  const h5::Handle list = timeless(H5P_DATASET_CREATE);
  const std::string cleaned = h5::clean(value);
  const h5::Handle type = h5::text_type(std::max<std::size_t>(1, cleaned.size()));
  const h5::Handle dataset = make_dataset(file, text.path, type.get(), h5::space({}).get(), list.get());
  write_text_attributes(dataset.get(), text);
  h5::check(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, cleaned.c_str()),
            "cannot write " + text.path);
}

void write_texts(hid_t file, const SetText& text, const std::vector<std::string>& texts) {
  std::size_t length = 1;
  const std::string packed = h5::pack_texts(texts, length);
  const h5::Handle list = timeless(H5P_DATASET_CREATE);
  const h5::Handle type = h5::text_type(length);
  const h5::Handle dataset = make_dataset(file, text.path, type.get(), h5::space({texts.size()}).get(), list.get());
  write_text_attributes(dataset.get(), text);
  if (texts.empty()) return;
  h5::check(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()),
            "cannot write " + text.path);
}

void write_table_attributes(hid_t dataset, const TableType& type, const std::string& description) {
  h5::write_attribute(dataset, "units", type.units());
  h5::write_attribute(dataset, "description", description);
  h5::write_attribute(dataset, "columns", type.descriptions());
}

void write_table(hid_t file, const SetText& text, const TableType& type, hsize_t rows, const void* records) {
  const h5::Handle list = timeless(H5P_DATASET_CREATE);
  const h5::Handle compound = type.hdf5();
  const h5::Handle dataset = make_dataset(file, text.path, compound.get(), h5::space({rows}).get(), list.get());
  write_table_attributes(dataset.get(), type, text.description);
  if (rows == 0) return;
  h5::check(H5Dwrite(dataset.get(), compound.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, records),
            "cannot write " + text.path);
}

GrowingSet::GrowingSet(hid_t file, const SetText& text, const char* counter, Kind kind, std::vector<hsize_t> row_shape)
    : path_(text.path), row_shape_(std::move(row_shape)), type_(stored_type(kind)) {
  row_bytes_ = std::accumulate(row_shape_.begin(), row_shape_.end(), stored_size(kind),
                               [](std::size_t bytes, hsize_t n) { return bytes * static_cast<std::size_t>(n); });
  create(file, text, counter, type_);
  write_text_attributes(dataset_.get(), text);
}

GrowingSet::GrowingSet(hid_t file, const SetText& text, const char* counter, const TableType& type)
    : path_(text.path), row_bytes_(type.size), own_type_(type.hdf5()), type_(own_type_.get()) {
  create(file, text, counter, type_);
  write_table_attributes(dataset_.get(), type, text.description);
}

void GrowingSet::create(hid_t file, const SetText& text, const char* counter, hid_t type) {
  assert(row_bytes_ > 0);
  std::vector<hsize_t> extent = row_shape_, most = row_shape_;
  chunk_ = row_shape_;
  extent.insert(extent.begin(), 0);
  most.insert(most.begin(), H5S_UNLIMITED);
  chunk_.insert(chunk_.begin(), std::max<hsize_t>(1, least_chunk / row_bytes_));
  if (row_bytes_ > most_chunk) chunk_[1] = std::max<hsize_t>(1, chunk_[1] * most_chunk / row_bytes_);
  const h5::Handle list = timeless(H5P_DATASET_CREATE);
  h5::check(H5Pset_chunk(list.get(), static_cast<int>(chunk_.size()), chunk_.data()), "cannot set chunks");
  const h5::Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), most.data()), H5Sclose,
                         "cannot make a data space");
  dataset_ = make_dataset(file, text.path, type, space.get(), list.get());
  h5::write_attribute(dataset_.get(), rows_attribute, counter);
}

std::byte* GrowingSet::add(std::size_t rows) {
  const std::size_t before = buffer_.size();
  buffer_.resize(before + rows * row_bytes_);
  return buffer_.data() + before;
}

void GrowingSet::replace(std::int64_t row, const std::byte* record) {
  assert(row >= 0 && row < rows());
  if (row < written_) return transfer(row, 1, record);
  std::copy_n(record, row_bytes_, buffer_.data() + static_cast<std::size_t>(row - written_) * row_bytes_);
}

void GrowingSet::write() {
  if (buffer_.empty()) return;
  const auto count = static_cast<std::int64_t>(buffer_.size() / row_bytes_);
  std::vector<hsize_t> extent = row_shape_;
  extent.insert(extent.begin(), static_cast<hsize_t>(written_ + count));
  h5::check(H5Dset_extent(dataset_.get(), extent.data()), "cannot extend " + path_);
  transfer(written_, count, buffer_.data());
  written_ += count;
  buffer_.clear();
}

void GrowingSet::transfer(std::int64_t first, std::int64_t count, const std::byte* data) {
  std::vector<hsize_t> start(row_shape_.size() + 1, 0), extent = row_shape_;
  start[0] = static_cast<hsize_t>(first);
  extent.insert(extent.begin(), static_cast<hsize_t>(count));
  const h5::Handle memory = h5::space(extent);
  const h5::Handle file(H5Dget_space(dataset_.get()), H5Sclose, "cannot get the space of " + path_);
  h5::check(H5Sselect_hyperslab(file.get(), H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr),
            "cannot select rows of " + path_);
  h5::check(H5Dwrite(dataset_.get(), type_, memory.get(), file.get(), H5P_DEFAULT, data), "cannot write " + path_);
}

}  // namespace trilith::results
