// "NAME=VALUE" on the command line.
#pragma once

#include <string>

namespace trilith::program {

/// "" or the error text, as CLI11 requires.
inline std::string is_assignment(const std::string& text) {
  const std::size_t at = text.find('=');
  return at == std::string::npos || at == 0 ? "'" + text + "' is not NAME=VALUE" : "";
}

}  // namespace trilith::program
