#include "results/file/clean_copy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <system_error>

#include "base/fresh_file.hpp"
#include "results/file/file_driver.hpp"
#include "results/file/growing_set.hpp"

namespace trilith::results {
namespace {

constexpr std::size_t block_bytes = 1024 * 1024;  // read and written at once
constexpr std::size_t chunk_bytes = 64 * 1024;
constexpr std::size_t least_compressed = 4096;  // smaller data sets are stored contiguously and uncompressed
constexpr unsigned deflate_level = 3;

herr_t take_name(hid_t, const char* name, const H5A_info_t*, void* data) {
  static_cast<std::vector<std::string>*>(data)->push_back(name);
  return 0;
}

void copy_attribute(hid_t from, hid_t to, const std::string& name) {
  const h5::Handle source(H5Aopen(from, name.c_str(), H5P_DEFAULT), H5Aclose, "cannot open attribute " + name);
  const h5::Handle type(H5Aget_type(source.get()), H5Tclose, "cannot read the type of attribute " + name);
  const h5::Handle space(H5Aget_space(source.get()), H5Sclose, "cannot read the space of attribute " + name);
  const h5::Handle target(H5Acreate2(to, name.c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                          "cannot create attribute " + name);
  const auto count = static_cast<std::size_t>(std::max<hssize_t>(0, H5Sget_simple_extent_npoints(space.get())));
  std::vector<std::byte> values(count * H5Tget_size(type.get()));
  h5::check(H5Aread(source.get(), type.get(), values.data()), "cannot read attribute " + name);
  h5::check(H5Awrite(target.get(), type.get(), values.data()), "cannot write attribute " + name);
}

void copy_attributes(hid_t from, hid_t to, const std::vector<std::string>& but) {
  std::vector<std::string> names;
  hsize_t at = 0;
  h5::check(H5Aiterate2(from, H5_INDEX_NAME, H5_ITER_INC, &at, take_name, &names), "cannot list attributes");
  for (const std::string& name : names)
    if (std::find(but.begin(), but.end(), name) == but.end()) copy_attribute(from, to, name);
}

h5::Handle make_target(hid_t to, const std::string& name, hid_t type, const std::vector<hsize_t>& extent,
                       std::size_t row_bytes) {
  const h5::Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "cannot make a property list");
  H5Pset_obj_track_times(list.get(), false);
  if (!extent.empty() && extent[0] * row_bytes >= least_compressed) {
    std::vector<hsize_t> chunk = extent;
    chunk[0] = std::clamp<hsize_t>(chunk_bytes / row_bytes, 1, extent[0]);
    if (row_bytes > block_bytes && chunk.size() > 1)
      chunk[1] = std::max<hsize_t>(1, chunk[1] * block_bytes / row_bytes);
    H5Pset_chunk(list.get(), static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(list.get());
    H5Pset_deflate(list.get(), deflate_level);
    H5Pset_fletcher32(list.get());
  }
  return h5::Handle(H5Dcreate2(to, name.c_str(), type, h5::space(extent).get(), H5P_DEFAULT, list.get(), H5P_DEFAULT),
                    H5Dclose, "cannot create " + name);
}

h5::Handle select_rows(hid_t dataset, hsize_t first, std::vector<hsize_t> extent) {
  h5::Handle space(H5Dget_space(dataset), H5Sclose, "cannot get a space");
  std::vector<hsize_t> start(extent.size(), 0);
  start[0] = first;
  h5::check(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr),
            "cannot select rows");
  return space;
}

void copy_rows(hid_t source, hid_t to, const std::string& name, std::int64_t rows) {
  const h5::Handle type(H5Dget_type(source), H5Tclose, "cannot read the type of " + name);
  std::vector<hsize_t> extent = h5::extents(source);
  if (extent.empty() || static_cast<hsize_t>(rows) > extent[0])
    throw h5::Failure(fmt::format("{} has fewer rows than were flushed", name));
  const std::size_t row_bytes =
      std::accumulate(extent.begin() + 1, extent.end(), H5Tget_size(type.get()),
                      [](std::size_t a, hsize_t b) { return a * static_cast<std::size_t>(b); });
  if (row_bytes == 0) throw h5::Failure(fmt::format("{} is damaged: its rows have no width", name));
  extent[0] = static_cast<hsize_t>(rows);
  const h5::Handle target = make_target(to, name, type.get(), extent, row_bytes);
  copy_attributes(source, target.get(), {});
  // Blocks are whole chunks, so that no compressed chunk is written twice.
  const hsize_t chunk_rows = std::max<hsize_t>(1, chunk_bytes / row_bytes);
  const hsize_t block_rows = chunk_rows * std::max<hsize_t>(1, block_bytes / (chunk_rows * row_bytes));
  std::vector<std::byte> block(static_cast<std::size_t>(std::min<hsize_t>(block_rows, extent[0])) * row_bytes);
  for (hsize_t first = 0; first < static_cast<hsize_t>(rows); first += block_rows) {
    extent[0] = std::min<hsize_t>(block_rows, static_cast<hsize_t>(rows) - first);
    const h5::Handle memory = h5::space(extent);
    h5::check(
        H5Dread(source, type.get(), memory.get(), select_rows(source, first, extent).get(), H5P_DEFAULT, block.data()),
        "cannot read " + name);
    h5::check(H5Dwrite(target.get(), type.get(), memory.get(), select_rows(target.get(), first, extent).get(),
                       H5P_DEFAULT, block.data()),
              "cannot write " + name);
  }
}

void copy_scalar(hid_t source, hid_t to, const std::string& name) {
  const h5::Handle type(H5Dget_type(source), H5Tclose, "cannot read the type of " + name);
  const h5::Handle target = make_target(to, name, type.get(), {}, 0);
  copy_attributes(source, target.get(), {});
  std::vector<std::byte> value(H5Tget_size(type.get()));
  h5::check(H5Dread(source, type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()), "cannot read " + name);
  h5::check(H5Dwrite(target.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()), "cannot write " + name);
}

void copy_group(hid_t from, hid_t to, const Committed& committed);

void copy_member(hid_t from, hid_t to, const std::string& name, const Committed& committed) {
  const h5::Handle source(H5Oopen(from, name.c_str(), H5P_DEFAULT), H5Oclose, "cannot open " + name);
  if (H5Iget_type(source.get()) == H5I_GROUP) {
    make_group(to, name, h5::read_text(source.get(), "description"));
    const h5::Handle target(H5Gopen2(to, name.c_str(), H5P_DEFAULT), H5Gclose, "cannot open " + name);
    copy_attributes(source.get(), target.get(), {"description"});
    return copy_group(source.get(), target.get(), committed);
  }
  if (H5Iget_type(source.get()) != H5I_DATASET) throw h5::Failure(name + " is neither a group nor a data set");
  const std::vector<hsize_t> extent = h5::extents(source.get());
  if (extent.empty()) return copy_scalar(source.get(), to, name);
  const bool grows = h5::has_attribute(source.get(), rows_attribute);
  const auto rows =
      grows ? counter(committed, h5::read_text(source.get(), rows_attribute)) : static_cast<std::int64_t>(extent[0]);
  copy_rows(source.get(), to, name, rows);
}

void copy_group(hid_t from, hid_t to, const Committed& committed) {
  for (const std::string& name : h5::member_names(from)) copy_member(from, to, name, committed);
}

TableType committed_type() {
  return table_type<Committed>({}, 2);
}

}  // namespace

Committed read_committed(hid_t file) {
  const TableType type = committed_type();
  const h5::Handle compound = type.hdf5();
  const h5::Handle dataset(H5Dopen2(file, "/committed", H5P_DEFAULT), H5Dclose, "there are no row counters");
  if (!h5::extents(dataset.get()).empty()) throw h5::Failure("the row counters are not a scalar");
  const h5::Handle stored(H5Dget_type(dataset.get()), H5Tclose, "the row counters have no readable type");
  h5::require_plain(stored.get(), "the table of row counters");
  std::vector<std::byte> record(type.size);
  h5::check(H5Dread(dataset.get(), compound.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, record.data()),
            "cannot read the row counters");
  const auto committed = unpack<Committed>(type, 2, record.data());
  for (const std::int64_t rows :
       {committed.frames, committed.contacts, committed.histories, committed.events, committed.energy, committed.stages,
        committed.notes, committed.modes, committed.motions, committed.motion_samples})
    if (rows < 0) throw h5::Failure("a row counter is negative");
  return committed;
}

h5::Handle create_committed(hid_t file) {
  const TableType type = committed_type();
  const h5::Handle compound = type.hdf5();
  const h5::Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "cannot make a property list");
  H5Pset_obj_track_times(list.get(), false);
  h5::Handle dataset(
      H5Dcreate2(file, "/committed", compound.get(), h5::space({}).get(), H5P_DEFAULT, list.get(), H5P_DEFAULT),
      H5Dclose, "cannot create the row counters");
  write_table_attributes(dataset.get(), type, "rows that are safe to read; later ones may be half written");
  write_committed(dataset.get(), {});
  return dataset;
}

void write_committed(hid_t dataset, const Committed& committed) {
  const TableType type = committed_type();
  const h5::Handle compound = type.hdf5();
  std::vector<std::byte> record(type.size);
  pack(type, 2, committed, record.data());
  h5::check(H5Dwrite(dataset, compound.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, record.data()),
            "cannot write the row counters");
  h5::check(H5Dflush(dataset), "cannot flush the row counters");
}

std::int64_t counter(const Committed& committed, const std::string& name) {
  const TableType type = committed_type();
  std::vector<std::byte> record(type.size);
  pack(type, 2, committed, record.data());
  for (const Column& column : type.columns) {
    if (column.name != name) continue;
    std::int64_t rows = 0;
    std::memcpy(&rows, record.data() + column.offset, sizeof rows);
    return rows;
  }
  throw h5::Failure(fmt::format("there is no row counter '{}'", name));
}

// In the format of HDF5 1.8, which programs after 2008 can read, and whose headers have checksums.
void write_clean_copy(hid_t from, const std::filesystem::path& to, bool finished) try {
  FreshFile file(to);
  const h5::Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "cannot make a property list");
  const h5::Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "cannot make a property list");
  h5::FileStatus status;
  h5::use_driver(access.get(), file.descriptor(), status);
  h5::check(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V18, H5F_LIBVER_V18), "cannot set the format");
  H5Pset_obj_track_times(creation.get(), false);
  H5Pset_link_creation_order(creation.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  const hid_t id = H5Fcreate(file.path().c_str(), H5F_ACC_TRUNC, creation.get(), access.get());
  h5::require_written(status, "cannot create the file");
  h5::Handle target(id, H5Fclose, "cannot create the file");
  copy_attributes(from, target.get(), {"finished"});
  copy_group(from, target.get(), read_committed(from));
  h5::write_attribute(target.get(), "finished", finished ? 1 : 0);
  target.close("cannot close the file");
  h5::require_written(status, "cannot write the file");
  file.take_place();
} catch (const std::system_error& error) {
  throw h5::Failure(fmt::format("cannot write the file: {}", error.code().message()));
}

}  // namespace trilith::results
