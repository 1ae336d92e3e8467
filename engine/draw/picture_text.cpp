#include "draw/picture_text.hpp"

#include <cstddef>

namespace trilith::draw {
namespace {

unsigned byte_at(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
}

bool follows(std::string_view text, std::size_t i, unsigned low = 0x80, unsigned high = 0xBF) {
  const unsigned b = byte_at(text, i);
  return b >= low && b <= high;
}

/// Length of the valid sequence at `i`, 0 where there is none (table 3-7 of the Unicode standard).
std::size_t sequence_length(std::string_view text, std::size_t i) {
  const unsigned b = byte_at(text, i);
  if (b < 0x80) return 1;
  if (b >= 0xC2 && b <= 0xDF) return follows(text, i + 1) ? 2 : 0;
  if (b >= 0xE0 && b <= 0xEF) {
    const bool second = follows(text, i + 1, b == 0xE0 ? 0xA0 : 0x80, b == 0xED ? 0x9F : 0xBF);
    return second && follows(text, i + 2) ? 3 : 0;
  }
  if (b >= 0xF0 && b <= 0xF4) {
    const bool second = follows(text, i + 1, b == 0xF0 ? 0x90 : 0x80, b == 0xF4 ? 0x8F : 0xBF);
    return second && follows(text, i + 2) && follows(text, i + 3) ? 4 : 0;
  }
  return 0;
}

}  // namespace

std::string printable_utf8(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text, i);
    const unsigned b = byte_at(text, i);
    if (length == 0)
      out += '?';
    else if (b < 0x20 || b == 0x7F)
      out += ' ';
    else
      out += text.substr(i, length);
    i += length == 0 ? 1 : length;
  }
  return out;
}

}  // namespace trilith::draw
