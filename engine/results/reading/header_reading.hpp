// Private to results/: reads the constant part of a results file, and single frames.
#pragma once

#include <cstddef>

#include "results/file/hdf5_handle.hpp"
#include "results/file/results.hpp"
#include "results/reading/table_rows.hpp"

namespace trilith::results {

/// Throws Failure or ResultsError if a part is missing or inconsistent with the others.
Header read_header(hid_t file);

/// Frame `index`, below committed.frames.
Frame read_frame(hid_t file, const Header& header, const Committed& committed, std::size_t index);

}  // namespace trilith::results
