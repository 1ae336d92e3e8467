#include "base/terminal_text.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace trilith {
namespace {

/// Length of the control character at `i` [bytes]; 0 if there is none.
std::size_t control_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U; };
  if (byte(i) < 0x20 || byte(i) == 0x7F) return 1;
  return byte(i) == 0xC2 && byte(i + 1) >= 0x80 && byte(i + 1) <= 0x9F ? 2 : 0;
}

/// Escapes bytes as Lua does, such as \27.
std::string escaped(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) text += fmt::format("\\{}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  return text;
}

// Control characters are the bytes below a blank, 127, and in UTF-8 U+0080 to U+009F (0xC2 0x80 to 0x9F). A terminal
// may execute them, so a name or message could move its cursor or change its title.
std::string without_control(std::string_view text, bool keep_lines) {
  std::string out;
  std::size_t done = 0;
  for (std::size_t at = find_control(text); at != std::string_view::npos; at = find_control(text, done)) {
    const std::size_t length = control_length(text, at);
    out += text.substr(done, at - done);
    if (keep_lines && (text[at] == '\n' || text[at] == '\t'))
      out += text[at];
    else
      out += escaped(text.substr(at, length));
    done = at + length;
  }
  return out += text.substr(done);
}

/// The first `most` bytes of UTF-8 `text`, shortened to whole characters.
std::string_view first_characters(std::string_view text, std::size_t most) {
  const auto continues = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U; };
  while (most > 0 && most < text.size() && continues(most)) --most;
  return text.substr(0, most);
}

}  // namespace

std::size_t find_control(std::string_view text, std::size_t from) {
  for (std::size_t i = from; i < text.size(); ++i)
    if (control_length(text, i) > 0) return i;
  return std::string_view::npos;
}

std::string terminal_text(std::string_view text) {
  return without_control(text, true);
}

std::string one_line(std::string_view text) {
  return without_control(text, false);
}

void require_printable(std::string_view name, std::string_view what, std::size_t longest) {
  if (name.size() > longest)
    throw InputError(fmt::format("{} '{}...' is {} bytes long, must be at most {}; give a shorter one", what,
                                 one_line(first_characters(name, 20)), name.size(), longest));
  const std::size_t at = find_control(name);
  if (at == std::string_view::npos) return;
  throw InputError(fmt::format("{} '{}' holds the control character {}; leave it out", what, one_line(name),
                               escaped(name.substr(at, control_length(name, at)))));
}

}  // namespace trilith
