// Reader of ground motions as columns of numbers, with no header that says what they are.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "load/motion.hpp"

namespace trilith {

/// What a file of plain columns does not say itself.
struct PlainForm {
  std::string unit;            ///< of the acceleration: one of plain_units()
  std::optional<double> step;  ///< [s]; needed where there is no column of time
};

/// "g", "m/s2", "cm/s2" (also "gal"), "mm/s2", "in/s2", "ft/s2"; as a list for messages.
std::string plain_units();

/// A motion from lines of two columns, time [s] and acceleration, or, where the step is given, of any number of
/// accelerations, one after the other. Columns are parted by blanks, commas or semicolons. Lines before the first
/// number are its title; empty ones and those that begin with '#' or '%' are left out. With a column of time the step
/// is the mean one; each time may be off by a tenth of it, and a step that is given as well must agree. Throws
/// InputError with file and line for anything else, and as read_motion for the samples as a whole.
GroundMotion parse_plain_motion(std::string_view text, const std::string& name, const PlainForm& form);
GroundMotion read_plain_motion(const std::filesystem::path& path, const PlainForm& form);

}  // namespace trilith
