// Words of a shell command line.
#pragma once

#include <string>

namespace trilith {

/// Quotes the word where the shell needs it.
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
