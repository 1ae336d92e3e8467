// Private to results/: how HDF5 reaches the disk when we write. HDF5 1.10 does not survive a write that fails: it tries
// again when the file closes and at exit, and then crashes. So this driver never lets it see one. The first failure is
// kept in a FileStatus; from then on nothing reaches the disk, further writes stay in memory where reads find them, and
// the file closes in order.
#pragma once

#include <string>

#include "results/file/hdf5_handle.hpp"

namespace trilith::results::h5 {

/// What became of the writes to a file; lives longer than the file is open.
struct FileStatus {
  int error = 0;  ///< errno of the first write that failed; 0: all reached the file
};

/// Throws Failure with the system's reason where a write has failed.
void require_written(const FileStatus& status, std::string_view what);

/// Lets a file opened with access list `access` be what `descriptor` has open, whatever its name leads to by then,
/// write through this driver and report to `status`. `descriptor` stays the caller's.
void use_driver(hid_t access, int descriptor, FileStatus& status);

}  // namespace trilith::results::h5
