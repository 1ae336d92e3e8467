// Reader of ground motions as columns of numbers, without a header that describes them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "load/motion.hpp"

namespace trilith {

/// Data that a file of plain columns does not contain.
struct PlainForm {
  std::string unit = {};            ///< of the acceleration: one of plain_units()
  std::optional<double> step = {};  ///< [s]; needed without a column of time; takes precedence over rounded times
  std::string column = {};       ///< of the acceleration: its number from 1, its name, or "rows" (samples line by line)
  std::optional<int> skip = {};  ///< lines of head before the numbers; 0 also means that there is none
  char decimal = 0;              ///< '.' or ','; 0: not given
};

/// "g", "m/s2", "cm/s2" (also "gal"), "mm/s2", "in/s2", "ft/s2"; as a list for messages.
std::string plain_units();

/// A motion from columns of numbers: time [s] and acceleration, or, if the step is given, accelerations alone, any
/// number per line. Columns are separated by blanks, commas or semicolons. Lines before the first number are the title,
/// and the last of them may name the columns; empty lines and lines that begin with '#' or '%' are skipped. For three
/// or more columns with names or with a time, the form specifies the acceleration. Each time may deviate from the mean
/// step by 10 % of it. A given step must agree with the times within their rounding; they may then also be in ms or
/// sample numbers. A file with a named format (motion_formats.hpp) is read as such, and must agree with the form.
/// Throws InputError with file and line for anything else, and as read_motion for the samples as a whole.
GroundMotion parse_plain_motion(std::string_view text, const std::string& name, const PlainForm& form);
GroundMotion read_plain_motion(const std::filesystem::path& path, const PlainForm& form);

}  // namespace trilith
