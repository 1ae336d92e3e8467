// Private to record/: the unchanging part of a results file, and single frames, back as values.
#pragma once

#include <cstddef>

#include "record/hdf5_handle.hpp"
#include "record/record_rows.hpp"
#include "record/results.hpp"

namespace trilith::record {

/// Throws Failure or RecordError where a part is missing or does not fit the others.
Header read_header(hid_t file);

/// Frame `index`, below committed.frames.
Frame read_frame(hid_t file, const Header& header, const Committed& committed, std::size_t index);

}  // namespace trilith::record
