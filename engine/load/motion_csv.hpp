// Reader of the project's CSV form of ground motions; see motion_read.hpp for the form and the errors.
#pragma once

#include <string>
#include <string_view>

#include "load/motion.hpp"

namespace trilith {

/// A motion from CSV text; `name` is the file name in messages.
GroundMotion parse_csv_motion(std::string_view text, const std::string& name);

}  // namespace trilith
