// Private to results/: the file a running writer fills, `<name>.part`, and what may stand at `<name>`.
#pragma once

#include <filesystem>
#include <string>

#include "results/file/file_driver.hpp"
#include "results/file/hdf5_handle.hpp"

namespace trilith::results {

/// `<name>.part`: where the rows go until the run finishes.
std::filesystem::path part_path(const std::filesystem::path& name);

/// Throws ResultsError where `name` may not be written: no such folder, a folder itself, no regular file, or a file
/// that is not a Trilith results file.
void require_writable(const std::filesystem::path& name);

/// True while another writer holds the part file at `path`.
bool is_being_written(const std::filesystem::path& path);

/// The part file, held open, locked against a second writer, and closed without fuss whatever happened before.
class PartFile {
 public:
  /// Creates the part of the results file `name`. What an earlier run left there gets a name of its own, as
  /// "run.unfinished1.h5", unless it holds no row. Throws ResultsError: unwritable, another run is writing it, a file
  /// that is not ours.
  explicit PartFile(const std::filesystem::path& name);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// See ResultsWriter.
  std::string kept_from_before() const;
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
  /// The same, and what an earlier run left gets its name back: as if this had never been.
  void undo();

 private:
  bool open_new();
  void set_aside();
  void lock(int descriptor) const;
  void create();

  std::filesystem::path name_, path_;
  std::filesystem::path kept_;  // what an earlier run left; "": nothing
  std::string left_;            // what it holds
  int descriptor_ = -1;
  h5::FileStatus status_;
  h5::Handle file_;
};

}  // namespace trilith::results
