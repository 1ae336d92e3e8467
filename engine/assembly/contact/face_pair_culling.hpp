// Culling of face pairs: selects the pairs of opposed faces that need the contact kernel in this step.
#pragma once

#include <cstddef>
#include <vector>

#include "broad_phase/face_line.hpp"
#include "model/work.hpp"

namespace trilith {

/// Number of rows in a list, and number of the first ones, which touched in the last step or are crushed.
struct NearRows {
  std::size_t count, touched;
};

/// Selects `facing` rows into `rows`: first the rows that touched in the last step or are crushed, then the rows that
/// may touch now. Beyond its end the list repeats its last row, so that it can be read in groups of four. `fresh`:
/// buffer. Rows that were and remain of general shape are written to Work::general_now directly. Threads share the
/// loop.
NearRows sort_out(const FaceLine& line, const ContactHistory& before, Work<2>& work, const std::vector<int>& facing,
                  std::vector<int>& rows, std::vector<int>& fresh);

}  // namespace trilith
