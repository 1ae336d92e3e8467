// Words of a command line of the shell.
#pragma once

#include <string>

namespace trilith {

/// The word as a shell reads it back, in quotes where it needs them.
inline std::string shell_word(const std::string& word) {
  if (!word.empty() && word.find_first_of(" '\"$&|;<>()*?\\`#~[]{}!\n\t") == std::string::npos) return word;
  std::string out(1, '\'');
  for (const char c : word) {
    if (c == '\'') out += "'\\'";
    out += c;
  }
  out += '\'';
  return out;
}

}  // namespace trilith
