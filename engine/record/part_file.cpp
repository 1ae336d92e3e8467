#include "record/part_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "record/results.hpp"

namespace trilith::record {
namespace {

constexpr hsize_t memory_page = 4096;

std::string quoted(const std::filesystem::path& path) {
  return fmt::format("'{}'", path.string());
}

// A lock on one byte far behind the data: HDF5's own locks, which readers take, do not meet it.
struct flock writer_lock() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = off_t{1} << 62;
  lock.l_len = 1;
  return lock;
}

bool is_ours(const std::filesystem::path& path) {
  const h5::Quiet quiet;
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (id < 0) return false;
  const h5::Handle file(id, H5Fclose, "");
  try {
    return h5::read_text(file.get(), "format") == "trilith";
  } catch (const h5::Failure&) {
    return false;
  }
}

}  // namespace

std::filesystem::path part_path(const std::filesystem::path& name) {
  return name.string() + ".part";
}

void require_writable(const std::filesystem::path& name) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = name.has_parent_path() ? name.parent_path() : fs::path(".");
  if (name.filename().empty() || fs::is_directory(name, error))
    throw RecordError(fmt::format("results file {}: is a folder; give a file name, e.g. 'run.h5'", quoted(name)));
  if (!fs::is_directory(folder, error))
    throw RecordError(
        fmt::format("results file {}: there is no folder {}; make it first", quoted(name), quoted(folder)));
  if (!fs::exists(name, error)) return;
  if (!fs::is_regular_file(name, error))
    throw RecordError(fmt::format("results file {}: is not a regular file; choose another name", quoted(name)));
  if (!is_ours(name))
    throw RecordError(
        fmt::format("results file {}: exists and is not a Trilith results file, so it is not overwritten; "
                    "choose another name or remove it",
                    quoted(name)));
}

bool is_being_written(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  struct flock lock = writer_lock();
  const bool asked = ::fcntl(descriptor, F_OFD_GETLK, &lock) == 0;
  ::close(descriptor);
  return asked && lock.l_type != F_UNLCK;
}

void sync_file(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  for (const std::filesystem::path& each : {path, folder}) {
    const int descriptor = ::open(each.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) continue;
    const bool failed = ::fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS;
    const int code = errno;
    ::close(descriptor);
    if (failed) throw h5::Failure(fmt::format("cannot bring the file to the disk: {}", std::strerror(code)));
  }
}

PartFile::PartFile(const std::filesystem::path& path) : path_(path) {
  std::error_code error;
  if (std::filesystem::exists(path_, error) && !std::filesystem::is_regular_file(path_, error))
    throw RecordError(fmt::format("results file {}: is not a regular file; choose another name", quoted(path_)));
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    throw RecordError(fmt::format("results file {}: cannot be written: {}", quoted(path_), std::strerror(errno)));
  bool is_replaced = false;
  try {
    lock();
    require_replaceable();
    is_replaced = true;
    const h5::Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "cannot make a property list");
    const h5::Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "cannot make a property list");
    h5::use_driver(access.get(), status_);
    H5Pset_libver_bounds(access.get(), H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
    H5Pset_obj_track_times(creation.get(), false);
    // A kill can cut a write between two memory pages. With paged space no piece of metadata up to that size crosses
    // one: without, 1 kill in some 200 tore the header of a data set and lost it.
    h5::check(H5Pset_file_space_strategy(creation.get(), H5F_FSPACE_STRATEGY_PAGE, false, 1), "cannot use paged space");
    h5::check(H5Pset_file_space_page_size(creation.get(), memory_page), "cannot use paged space");
    H5Pset_link_creation_order(creation.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
    file_ = h5::Handle(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose,
                       fmt::format("results file {}: cannot be created", quoted(path_)));
  } catch (const std::runtime_error& failure) {
    if (is_replaced) ::unlink(path_.c_str());
    ::close(descriptor_);
    throw RecordError(failure.what());
  }
}

PartFile::~PartFile() {
  abandon();
  if (descriptor_ >= 0) ::close(descriptor_);
}

void PartFile::lock() {
  struct flock lock = writer_lock();
  if (::fcntl(descriptor_, F_OFD_SETLK, &lock) == 0) return;
  if (errno == EAGAIN || errno == EACCES)
    throw RecordError(
        fmt::format("results file {}: another run is writing it; choose another name or wait", quoted(path_)));
  // Any other reason: this file system knows no such locks, and the run goes on without.
}

// Replaces what a killed writer left (nothing yet, zeros, or HDF5), never a stranger's file.
void PartFile::require_replaceable() const {
  std::array<char, 8> head{};
  const ssize_t count = ::pread(descriptor_, head.data(), head.size(), 0);
  const bool zeros = std::all_of(head.begin(), head.end(), [](char c) { return c == 0; });
  static constexpr std::array<char, 8> signature = {'\x89', 'H', 'D', 'F', '\r', '\n', '\x1a', '\n'};
  if (count <= 0 || zeros || head == signature) return;
  throw RecordError(
      fmt::format("results file {}: exists and is not a Trilith results file, so it is not overwritten; "
                  "choose another name or remove it",
                  quoted(path_)));
}

void PartFile::start_swmr() {
  h5::check(H5Fstart_swmr_write(file_.get()), "cannot open the file to readers");
}

void PartFile::require_written() const {
  h5::require_written(status_, "cannot be written");
}

void PartFile::sync() {
  if (::fdatasync(descriptor_) != 0 && errno != EINVAL && errno != EROFS)
    throw h5::Failure(fmt::format("cannot bring the rows to the disk: {}", std::strerror(errno)));
}

void PartFile::close() {
  file_.close("cannot close the file");
}

void PartFile::abandon() {
  const h5::Quiet quiet;
  file_.reset();
}

void PartFile::remove() {
  abandon();
  ::unlink(path_.c_str());
}

}  // namespace trilith::record
