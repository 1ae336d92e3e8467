// Private to results/: copies the committed rows of a results file into a clean one that every HDF5 reader opens.
#pragma once

#include <filesystem>

#include "results/file/hdf5_handle.hpp"
#include "results/reading/table_rows.hpp"

namespace trilith::results {

/// The counters of an open results file; throws Failure if they are missing or invalid.
Committed read_committed(hid_t file);

/// Creates the counters' data set.
h5::Handle create_committed(hid_t file);
void write_committed(hid_t dataset, const Committed& committed);

/// The counter of the given name, e.g. "frames"; throws Failure if there is none.
std::int64_t counter(const Committed& committed, const std::string& name);

/// Writes every object of `from` to a new file that replaces `to`: growing data sets are cut to their committed rows
/// and compressed, attribute `finished` as given. The bytes depend on the rows alone, not on the flushes. Throws
/// Failure, and leaves `to` unchanged then.
void write_clean_copy(hid_t from, const std::filesystem::path& to, bool finished);

}  // namespace trilith::results
