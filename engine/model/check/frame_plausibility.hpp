// Unusual but allowed parameters of frames: of their sections, fibres and hinges.
#pragma once

#include <string>
#include <vector>

#include "model/builder/frame.hpp"

namespace trilith {

/// Adds a note for each kind of parameter, for the first member with it.
template <int D>
void add_frame_plausibility_notes(const FrameSpecOf<D>& frame, const std::string& owner,
                                  std::vector<std::string>& notes);

}  // namespace trilith
