// Opening of a file that may be damaged, or that another program writes.
#pragma once

#include <filesystem>

#include "results/file/hdf5_handle.hpp"

namespace trilith::results {

/// Opens a results file for reading as any HDF5 file. If a writer holds it, or died while holding it, opens it as a
/// reader in parallel with that writer. Throws Failure if neither works.
h5::Handle open_written(const std::filesystem::path& path);

}  // namespace trilith::results
