#include "results/file/part_file.hpp"
#include "results/file/open_written.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/fresh_file.hpp"
#include "results/file/results.hpp"
#include "results/reading/reader.hpp"

namespace trilith::results {
namespace {

constexpr hsize_t memory_page = 4096;

std::string quoted(const std::filesystem::path& path) {
  return fmt::format("'{}'", path.string());
}

// A lock on one byte far behind the data, which does not conflict with HDF5's own locks of readers.
struct flock writer_lock() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = off_t{1} << 62;
  lock.l_len = 1;
  return lock;
}

enum class Owner { ours, foreign, unreadable };

Owner owner_of(const std::filesystem::path& path) {
  const h5::Quiet quiet;
  h5::Handle file;
  try {
    file = open_written(path);
  } catch (const h5::Failure&) {
    return Owner::unreadable;
  }
  try {
    return h5::read_text(file.get(), "format") == "trilith" ? Owner::ours : Owner::foreign;
  } catch (const h5::Failure&) {
    return Owner::foreign;
  }
}

[[noreturn]] void refuse_foreign(const std::filesystem::path& path) {
  throw ResultsError(
      fmt::format("results file {}: exists and is not a Trilith results file, so it is not overwritten; "
                  "choose another name or remove it",
                  quoted(path)));
}

[[noreturn]] void refuse_second(const std::filesystem::path& path) {
  throw ResultsError(
      fmt::format("results file {}: another run is writing it; choose another name or wait", quoted(path)));
}

/// A file descriptor that closes automatically.
struct Descriptor {
  int number;
  explicit Descriptor(int n) : number(n) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

/// True for the first bytes that a killed writer may leave: empty, zeros, or HDF5.
bool may_be_ours(int descriptor) {
  std::array<char, 8> head{};
  const ssize_t count = ::pread(descriptor, head.data(), head.size(), 0);
  const bool zeros = std::all_of(head.begin(), head.end(), [](char c) { return c == 0; });
  static constexpr std::array<char, 8> signature = {'\x89', 'H', 'D', 'F', '\r', '\n', '\x1a', '\n'};
  return count <= 0 || zeros || head == signature;
}

/// Text: rows in the part file of a killed run; "" if there are none.
std::string rows_in(const std::filesystem::path& part) {
  try {
    const ResultsReader reader(part);
    const std::vector<double>& times = reader.frame_times();
    if (!times.empty())
      return fmt::format("{} frame{}, up to {:g} s", times.size(), times.size() == 1 ? "" : "s", times.back());
    return reader.events().empty() && reader.history_times().empty() ? "" : "no frame";
  } catch (const ResultsError&) {
    return "not readable without repair";
  }
}

/// "out/run.h5" -> "out/run.unfinished2.h5"
std::filesystem::path kept_path(const std::filesystem::path& name, int number) {
  return name.parent_path() / fmt::format("{}.unfinished{}{}", name.stem().string(), number, name.extension().string());
}

/// Renames, but never over another file. False if `to` exists.
bool rename_to_free(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno == EEXIST) return false;
  // This file system cannot guarantee it, so the target is checked first.
  struct stat about {};
  if ((errno == EINVAL || errno == ENOSYS) && ::lstat(to.c_str(), &about) == 0) return false;
  if (::rename(from.c_str(), to.c_str()) == 0) return true;
  throw ResultsError(fmt::format("results file {}: the unfinished one cannot be kept as {}: {}", quoted(from),
                                 quoted(to), std::strerror(errno)));
}

}  // namespace

std::filesystem::path part_path(const std::filesystem::path& name) {
  return name.string() + ".part";
}
std::filesystem::path replaced_part_path(const std::filesystem::path& name) {
  return part_path(name).string() + ".before";
}

void require_writable(const std::filesystem::path& name) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path target = past_links(name);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (name.filename().empty() || fs::is_directory(name, error))
    throw ResultsError(fmt::format("results file {}: is a folder; give a file name, e.g. 'run.h5'", quoted(name)));
  if (!fs::is_directory(folder, error))
    throw ResultsError(
        fmt::format("results file {}: there is no folder {}; make it first", quoted(name), quoted(folder)));
  if (!fs::exists(name, error)) return;
  if (!fs::is_regular_file(name, error))
    throw ResultsError(fmt::format("results file {}: is not a regular file; choose another name", quoted(name)));
  if (owner_of(name) != Owner::ours) refuse_foreign(name);
}

bool is_being_written(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  struct flock lock = writer_lock();
  const bool asked = ::fcntl(descriptor, F_OFD_GETLK, &lock) == 0;
  ::close(descriptor);
  return asked && lock.l_type != F_UNLCK;
}

PartFile::PartFile(const std::filesystem::path& name) : name_(name), path_(part_path(name)) {
  if (!open_new()) {
    set_aside();
    if (!open_new()) refuse_second(path_);
  }
  try {
    lock(descriptor_);
    create();
  } catch (const std::runtime_error& failure) {
    undo();
    ::close(descriptor_);
    throw ResultsError(failure.what());
  }
}

/// False if a file of that name exists.
bool PartFile::open_new() {
  descriptor_ = above_standard(::open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (descriptor_ >= 0) return true;
  if (errno == EEXIST) return false;
  throw ResultsError(fmt::format("results file {}: cannot be written: {}", quoted(path_), std::strerror(errno)));
}

/// Renames the part file of an earlier run. It is locked meanwhile: of two runs that begin together, one renames it,
/// and the other finds it locked.
void PartFile::set_aside() {
  const Descriptor left(above_standard(::open(path_.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)));
  struct stat about {
  }, there{};
  if (left.number < 0 ? errno == ELOOP || errno == EISDIR || errno == ENXIO
                      : ::fstat(left.number, &about) == 0 && !S_ISREG(about.st_mode))
    throw ResultsError(fmt::format("results file {}: is not a regular file; choose another name", quoted(path_)));
  if (left.number < 0)
    throw ResultsError(fmt::format("results file {}: cannot be written: {}", quoted(path_), std::strerror(errno)));
  lock(left.number);
  if (::lstat(path_.c_str(), &there) != 0 || there.st_ino != about.st_ino || there.st_dev != about.st_dev)
    refuse_second(path_);  // another run has started meanwhile
  if (!may_be_ours(left.number) || owner_of(path_) == Owner::foreign) refuse_foreign(path_);
  left_ = about.st_size == 0 ? "" : rows_in(path_);
  if (left_.empty()) {
    ::unlink(path_.c_str());
    return;
  }
  for (int number = 1;; ++number) {
    kept_ = kept_path(name_, number);
    if (rename_to_free(path_, kept_)) return;
  }
}

std::string PartFile::kept_from_before() const {
  if (kept_.empty()) return "";
  return fmt::format("the unfinished results of an earlier run ({}) are kept in {}", left_, kept_.string());
}

void PartFile::create() {
  const h5::Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "cannot make a property list");
  const h5::Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "cannot make a property list");
  h5::use_driver(access.get(), descriptor_, status_);
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
  H5Pset_obj_track_times(creation.get(), false);
  // A kill can cut a write between two memory pages. With paged space no piece of metadata up to that size crosses a
  // page; without it, 1 kill in about 200 destroyed the header of a data set.
  h5::check(H5Pset_file_space_strategy(creation.get(), H5F_FSPACE_STRATEGY_PAGE, false, 1), "cannot use paged space");
  h5::check(H5Pset_file_space_page_size(creation.get(), memory_page), "cannot use paged space");
  H5Pset_link_creation_order(creation.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  file_ = h5::Handle(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose,
                     fmt::format("results file {}: cannot be created", quoted(path_)));
}

PartFile::~PartFile() {
  abandon();
  if (descriptor_ >= 0) ::close(descriptor_);
}

void PartFile::lock(int descriptor) const {
  struct flock lock = writer_lock();
  if (::fcntl(descriptor, F_OFD_SETLK, &lock) == 0) return;
  if (errno == EAGAIN || errno == EACCES) refuse_second(path_);
  // Any other error: this file system has no such locks, and the run continues without.
}

void PartFile::start_swmr() {
  h5::check(H5Fstart_swmr_write(file_.get()), "cannot open the file to readers");
}

void PartFile::require_written() const {
  h5::require_written(status_, "cannot be written");
}

void PartFile::sync() {
  if (::fdatasync(descriptor_) != 0 && errno != EINVAL && errno != EROFS)
    throw h5::Failure(fmt::format("cannot write the rows to the disk: {}", std::strerror(errno)));
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
  struct stat ours {
  }, there{};
  const bool is_there = ::fstat(descriptor_, &ours) == 0 && ::lstat(path_.c_str(), &there) == 0 &&
                        ours.st_ino == there.st_ino && ours.st_dev == there.st_dev;
  if (is_there) ::unlink(path_.c_str());
}

void PartFile::undo() {
  remove();
  if (!kept_.empty()) ::rename(kept_.c_str(), path_.c_str());
  kept_.clear();
}

}  // namespace trilith::results
