#include "screen.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

#include "base/terminal_text.hpp"

namespace trilith::program {
namespace {

bool is_set(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

bool is_dumb() {
  const char* const term = std::getenv("TERM");
  return term == nullptr || std::string_view(term) == "dumb" || *term == '\0';
}

std::size_t columns_of(std::FILE* out) {
  winsize size{};
  return ::ioctl(::fileno(out), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

std::string cut_text(const std::string& text, std::size_t columns) {
  std::size_t at = 0;
  for (; at < text.size(); ++at)
    if ((static_cast<unsigned char>(text[at]) & 0xC0) != 0x80 && columns-- == 0) break;
  return text.substr(0, at);
}

Screen::Screen(std::FILE* out)
    : out_(out), terminal_(::isatty(::fileno(out)) != 0 && !is_dumb()), colours_(terminal_ && !is_set("NO_COLOR")) {}

Screen::~Screen() {
  clear();
}

void Screen::clear() {
  if (shown_) std::fputs("\r\033[K", out_);
  shown_ = false;
  std::fflush(out_);
}

void Screen::line(const std::string& text, bool strong) {
  if (shown_) std::fputs("\r\033[K", out_);
  shown_ = false;
  if (strong && colours_)
    std::fputs(fmt::format("\033[1m{}\033[0m\n", terminal_text(units_.message(text))).c_str(), out_);
  else
    std::fputs(fmt::format("{}\n", terminal_text(units_.message(text))).c_str(),
               out_);  // a closed pipe does not end the run
  std::fflush(out_);
}

void Screen::status(const std::string& text) {
  if (!terminal_) return;
  // One column less than available: a full line would move the cursor to the next line.
  std::fputs(fmt::format("\r{}\033[K", cut_text(terminal_text(units_.message(text)), columns_of(out_) - 1)).c_str(),
             out_);
  std::fflush(out_);
  shown_ = true;
}

}  // namespace trilith::program
