// Unusual but allowed parameters of frames: of their sections, fibres and hinges.
#pragma once

#include <string>
#include <vector>

#include "model/builder/frame.hpp"
#include "model/space_builder/space_frame.hpp"

namespace trilith {

/// Adds a note for each kind of parameter, for the first member with it.
void add_frame_plausibility_notes(const FrameSpec& frame, const std::string& owner, std::vector<std::string>& notes);
void add_frame_plausibility_notes(const SpaceFrameSpec& frame, const std::string& owner,
                                  std::vector<std::string>& notes);

}  // namespace trilith
