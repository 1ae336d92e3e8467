// Private to results/: the file of a running writer, `<name>.part`, and checks of `<name>`.
#pragma once

#include <filesystem>
#include <string>

#include "results/file/file_driver.hpp"
#include "results/file/hdf5_handle.hpp"
#include "results/file/part_path.hpp"

namespace trilith::results {

/// Throws ResultsError if `name` may not be written: the folder does not exist, it is a folder or not a regular file,
/// or it is not a Trilith results file.
void require_writable(const std::filesystem::path& name);

/// The part file, held open, locked against a second writer, and closed without errors in any state.
class PartFile {
 public:
  /// Creates the part file of the results file `name`. A part file of an earlier run is renamed, such as to
  /// "run.unfinished1.h5", unless it holds no row. Throws ResultsError: unwritable, written by another run, or a
  /// foreign file.
  explicit PartFile(const std::filesystem::path& name);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// See ResultsWriter.
  std::string kept_from_before() const;
  hid_t file() const { return file_.get(); }
  /// Switches to single-writer-multiple-reader mode: no new objects can be created from here on.
  void start_swmr();
  /// Throws Failure if a write has failed; the file on the disk is then as before that write.
  void require_written() const;
  /// Synchronises the written bytes to the disk, against loss of power.
  void sync();
  /// Closes the file; all its objects must be closed. Throws Failure.
  void close();
  /// Closes the file and ignores errors.
  void abandon();
  /// Abandons and removes the file.
  void remove();
  /// Abandons and removes the file, and restores the name of the earlier part file.
  void undo();

 private:
  bool open_new();
  void set_aside();
  void lock(int descriptor) const;
  void create();

  std::filesystem::path name_, path_;
  std::filesystem::path kept_;  // renamed part file of an earlier run; "": none
  std::string left_;            // text: its rows
  int descriptor_ = -1;
  h5::FileStatus status_;
  h5::Handle file_;
};

}  // namespace trilith::results
