// Which pairs of facing faces are worth the contact kernel at this step.
#pragma once

#include <cstddef>
#include <vector>

#include "broad_phase/face_line.hpp"
#include "model/work.hpp"

namespace trilith {

/// How many rows a list holds, and how many of them, which come first, touched at the last step or are crushed.
struct NearRows {
  std::size_t count, touched;
};

/// Of the `facing` rows those that touched at the last step or are crushed, and then those that may touch now: `rows`.
/// Beyond their count the list repeats its last row, so that it can be read by fours. `fresh`:
/// room. Rows that were of general shape at the last step, and are so now, go to Work::general_now at once. Threads
/// share it.
NearRows sort_out(const FaceLine& line, const ContactHistory& before, Work<2>& work, const std::vector<int>& facing,
                  std::vector<int>& rows, std::vector<int>& fresh);

}  // namespace trilith
