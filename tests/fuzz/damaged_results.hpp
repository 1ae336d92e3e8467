// Results files that are damaged within the rules of HDF5, so that only Trilith's own checks can find the damage.
#pragma once

#include <string_view>

namespace trilith::fuzz {

/// Damages a results file and reads all of it. The first byte of `text` chooses a file of the environment variable
/// TRILITH_BASES (paths, separated by colons). Each further 12 bytes are one change: the object, the kind of change,
/// two bytes for the place and eight for the value. The reader may refuse the file.
void read_damaged_results(std::string_view text);

}  // namespace trilith::fuzz
