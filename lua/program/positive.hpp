// Numbers from 0 on the command line.
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>

namespace trilith::program {

/// "" or the error text, as CLI11 requires.
inline std::string is_positive(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool read = !text.empty() && *end == '\0';
  return read && value > 0 && std::isfinite(value) ? "" : "'" + text + "' is not a number above 0";
}

/// "" or the message for a number that must not be negative.
inline std::string is_not_negative(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool read = !text.empty() && *end == '\0';
  return read && value >= 0 && std::isfinite(value) ? "" : "'" + text + "' is not a number from 0 up";
}

/// "" or the error text for a number of objects.
inline std::string is_count(const std::string& text) {
  const bool whole = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  return whole && is_positive(text).empty() ? "" : "'" + text + "' is not a whole number above 0";
}

}  // namespace trilith::program
