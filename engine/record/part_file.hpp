// Private to record/: the file a running writer fills, `<name>.part`, and what may stand at `<name>`.
#pragma once

#include <filesystem>

#include "record/file_driver.hpp"
#include "record/hdf5_handle.hpp"

namespace trilith::record {

/// `<name>.part`: where the rows go until the run finishes.
std::filesystem::path part_path(const std::filesystem::path& name);

/// Throws RecordError where `name` may not be written: no such folder, a folder itself, no regular file, or a file that
/// is not a Trilith results file.
void require_writable(const std::filesystem::path& name);

/// True while another writer holds the part file at `path`.
bool is_being_written(const std::filesystem::path& path);

/// Makes a finished file durable: flushes it and its folder's entry to the disk.
void sync_file(const std::filesystem::path& path);

/// The part file, held open, locked against a second writer, and closed without fuss whatever happened before.
class PartFile {
 public:
  /// Creates the file, replacing one left by a killed run. Throws RecordError.
  explicit PartFile(const std::filesystem::path& path);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  hid_t file() const { return file_.get(); }
  /// Switches to single-writer-multiple-reader mode: from here on no new objects.
  void start_swmr();
  /// Throws Failure where a write has failed; the file on the disk is then as it was before that write.
  void require_written() const;
  /// Hands the written bytes to the disk, against loss of power.
  void sync();
  /// Closes the file in order; all its objects must be closed. Throws Failure.
  void close();
  /// Closes the file and says nothing of errors.
  void abandon();
  /// Abandons and removes the file.
  void remove();

 private:
  void lock();
  void require_replaceable() const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  h5::FileStatus status_;
  h5::Handle file_;
};

}  // namespace trilith::record
