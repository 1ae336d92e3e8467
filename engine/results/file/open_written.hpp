// Opening a file that may be damaged, or that another program writes.
#pragma once

#include <filesystem>

#include "results/file/hdf5_handle.hpp"

namespace trilith::results {

/// Opens a results file for reading as any HDF5 file; where a writer holds it or died holding it, as a reader beside
/// that writer. Throws Failure where neither works.
h5::Handle open_written(const std::filesystem::path& path);

}  // namespace trilith::results
