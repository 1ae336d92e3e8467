// Private to results/: file driver of HDF5 for writing. HDF5 1.10 does not survive a failed write: it repeats the write
// when the file closes and at exit, and then crashes. This driver hides write failures from HDF5. The first failure is
// stored in a FileStatus. From then on nothing is written to disk, further writes remain in memory for later reads, and
// the file closes without error.
#pragma once

#include <string>

#include "results/file/hdf5_handle.hpp"

namespace trilith::results::h5 {

/// Status of the writes to a file; must outlive the open file.
struct FileStatus {
  int error = 0;  ///< errno of the first write that failed; 0: all succeeded
};

/// Throws Failure with the system's message if a write has failed.
void require_written(const FileStatus& status, std::string_view what);

/// Makes a file opened with access list `access` use this driver and the open `descriptor`, independent of its name,
/// and report to `status`. The caller keeps ownership of `descriptor`.
void use_driver(hid_t access, int descriptor, FileStatus& status);

}  // namespace trilith::results::h5
