// Reader of PEER's AT2 form of ground motions; see motion_read.hpp for the form and the errors.
#pragma once

#include <string>
#include <string_view>

#include "load/motion.hpp"

namespace trilith {

/// A motion from AT2 text; `name` is the file name in messages.
GroundMotion parse_peer_motion(std::string_view text, const std::string& name);

/// True if the fourth line names the number of samples. With `skip_empty` lines count after empty ones at the start.
bool names_samples_in_fourth_line(std::string_view text, bool skip_empty);

}  // namespace trilith
