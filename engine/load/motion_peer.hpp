// Reader of PEER's AT2 form of ground motions; see motion_read.hpp for the form and the errors.
#pragma once

#include <string>
#include <string_view>

#include "load/motion.hpp"

namespace trilith {

/// A motion from AT2 text; `name` stands for the file in messages.
GroundMotion parse_peer_motion(std::string_view text, const std::string& name);

}  // namespace trilith
