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
  std::string unit = {};            ///< of the acceleration: one of plain_units()
  std::optional<double> step = {};  ///< [s]; needed where there is no column of time, and rules where that is rounded
  std::string column = {};       ///< of the acceleration: its number from 1, its name, or "rows" (samples line by line)
  std::optional<int> skip = {};  ///< lines of head before the numbers; 0 also says that there is none
  char decimal = 0;              ///< '.' or ','; 0: not said
};

/// "g", "m/s2", "cm/s2" (also "gal"), "mm/s2", "in/s2", "ft/s2"; as a list for messages.
std::string plain_units();

/// A motion from columns of numbers: time [s] and acceleration, or, where the step is given, accelerations alone, any
/// number to a line. Columns are parted by blanks, commas or semicolons. Lines before the first number are the title,
/// the last of them may name the columns; empty ones and those that begin with '#' or '%' are left out. Of three
/// columns or more with names or with a time the form says which is the acceleration. Each time may be off the mean
/// step by a tenth of it. A step that is given agrees with the times within their rounding; they may then also be in ms
/// or numbers of samples. A file whose format has a name (motion_formats.hpp) is read as such, and must agree with the
/// form. Throws InputError with file and line for anything else, and as read_motion for the samples as a whole.
GroundMotion parse_plain_motion(std::string_view text, const std::string& name, const PlainForm& form);
GroundMotion read_plain_motion(const std::filesystem::path& path, const PlainForm& form);

}  // namespace trilith
