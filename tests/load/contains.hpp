// Searches words in a message.
#pragma once

#include <doctest/doctest.h>

#include <string>

namespace trilith::testing {

/// True if `part` is in `text`; otherwise it prints the text.
inline bool contains(const std::string& text, const std::string& part) {
  const bool found = text.find(part) != std::string::npos;
  if (!found) MESSAGE("'", text, "' does not contain '", part, "'");
  return found;
}

}  // namespace trilith::testing
