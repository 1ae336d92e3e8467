// Private to results/: the unchanging part of a results file, and single frames, back as values.
#pragma once

#include <cstddef>

#include "results/file/hdf5_handle.hpp"
#include "results/file/results.hpp"
#include "results/reading/table_rows.hpp"

namespace trilith::results {

/// Throws Failure or ResultsError where a part is missing or does not fit the others.
Header read_header(hid_t file);

/// Frame `index`, below committed.frames.
Frame read_frame(hid_t file, const Header& header, const Committed& committed, std::size_t index);

}  // namespace trilith::results
