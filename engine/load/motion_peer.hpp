// Reader of PEER's AT2 form of ground motions; see motion_read.hpp for the form and the errors.
#pragma once

#include <string>
#include <string_view>

#include "load/motion.hpp"

namespace trilith {

/// A motion from AT2 text; `name` stands for the file in messages.
GroundMotion parse_peer_motion(std::string_view text, const std::string& name);

/// Does the fourth line name the number of samples? With `skip_empty` the fourth after empty lines at the start.
bool names_samples_in_fourth_line(std::string_view text, bool skip_empty);

}  // namespace trilith
