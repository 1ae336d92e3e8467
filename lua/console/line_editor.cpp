#include "line_editor.hpp"

#include <fmt/format.h>
#include <histedit.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace trilith::program {
namespace {

bool is_dumb() {
  const char* const term = std::getenv("TERM");
  return term == nullptr || *term == '\0' || std::strcmp(term, "dumb") == 0;
}

std::size_t terminal_width() {
  winsize size{};
  return ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/// libedit reads multibyte characters by the locale. Numbers are independent of it.
void choose_letters() {
  const char* now = std::setlocale(LC_CTYPE, "");
  if (now == nullptr || std::strcmp(now, "C") == 0 || std::strcmp(now, "POSIX") == 0)
    std::setlocale(LC_CTYPE, "C.UTF-8");
}

}  // namespace

std::string common_start(const std::vector<std::string>& names) {
  if (names.empty()) return "";
  std::string start = names.front();
  for (const std::string& name : names) {
    const auto end = std::mismatch(start.begin(), start.end(), name.begin(), name.end()).first;
    start.erase(end, start.end());
  }
  return start;
}

std::string in_columns(const std::vector<std::string>& names, std::size_t width) {
  constexpr std::size_t most = 200;
  const std::size_t count = std::min(names.size(), most);
  std::size_t wide = 1;
  for (std::size_t i = 0; i < count; ++i) wide = std::max(wide, names[i].size() + 2);
  const std::size_t columns = std::max<std::size_t>(1, width / wide), rows = (count + columns - 1) / columns;
  std::string text;
  for (std::size_t row = 0; row < rows; ++row) {
    std::string line;
    for (std::size_t i = row; i < count; i += rows) line += fmt::format("{:<{}}", names[i], wide);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  if (names.size() > most) text += fmt::format("and {} more\n", names.size() - most);
  return text;
}

/// libedit's objects, and the argument of its C callbacks.
class LineEditor::Edited {
 public:
  explicit Edited(const LineHistory& known)
      : history_(history_init()), edit_(el_init("trilith", stdin, stdout, stderr)) {
    HistEvent event;
    history(history_, &event, H_SETSIZE, 4000);
    for (const std::string& line : known.lines()) history(history_, &event, H_ENTER, line.c_str());
    el_set(edit_, EL_CLIENTDATA, this);
    el_set(edit_, EL_PROMPT, &Edited::prompt_of);
    el_set(edit_, EL_EDITOR, "emacs");
    el_set(edit_, EL_HIST, history, history_);
    // While a line is typed, Ctrl-C is a key that cancels the line. While Lua runs, it is a signal.
    el_set(edit_, EL_SETTY, "-d", "-isig", nullptr);
    el_set(edit_, EL_ADDFN, "trilith-complete", "Complete the name", &Edited::complete);
    el_set(edit_, EL_ADDFN, "trilith-cancel", "Drop the line", &Edited::cancel);
    el_set(edit_, EL_BIND, "^I", "trilith-complete", nullptr);
    el_set(edit_, EL_BIND, "^C", "trilith-cancel", nullptr);
    el_set(edit_, EL_BIND, "^R", "em-inc-search-prev", nullptr);
    el_source(edit_, nullptr);  // ~/.editrc
  }
  Edited(const Edited&) = delete;
  Edited& operator=(const Edited&) = delete;
  ~Edited() {
    el_end(edit_);
    history_end(history_);
  }

  Read read(const std::string& prompt, std::string& line) {
    prompt_ = prompt;
    cancelled_ = false;
    int count = 0;
    el_set(edit_, EL_PREP_TERM, 1);  // before the prompt: a key pressed at its sight is a key, not a signal
    const char* text = el_gets(edit_, &count);
    if (cancelled_) return Read::cancelled;
    if (text == nullptr || count <= 0) return Read::end;
    line.assign(text, static_cast<std::size_t>(count));
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    return Read::line;
  }

  void remember(const std::string& line) {
    HistEvent event;
    history(history_, &event, H_ENTER, line.c_str());
  }

  std::function<Completion(const std::string&)> completer;

 private:
  static Edited& of(EditLine* edit) {
    void* self = nullptr;
    el_get(edit, EL_CLIENTDATA, &self);
    return *static_cast<Edited*>(self);
  }
  static const char* prompt_of(EditLine* edit) { return of(edit).prompt_.c_str(); }

  static unsigned char cancel(EditLine* edit, int) {
    Edited& self = of(edit);
    self.cancelled_ = true;
    const LineInfo* line = el_line(edit);
    el_cursor(edit, static_cast<int>(line->lastchar - line->cursor));
    fmt::print("^C\n");
    std::fflush(stdout);
    return CC_NEWLINE;
  }

  static unsigned char complete(EditLine* edit, int) {
    Edited& self = of(edit);
    const LineInfo* line = el_line(edit);
    const std::string before(line->buffer, line->cursor);
    if (before.find_first_not_of(" \t") == std::string::npos) {
      el_insertstr(edit, "  ");
      return CC_REFRESH;
    }
    const Completion found = self.completer ? self.completer(before) : Completion{};
    if (found.names.empty() || found.from > before.size()) return CC_REFRESH_BEEP;
    const std::string typed = before.substr(found.from), start = common_start(found.names);
    if (start.size() > typed.size() && start.starts_with(typed)) {
      el_insertstr(edit, start.c_str() + typed.size());
      return CC_REFRESH;
    }
    if (found.names.size() == 1) return CC_REFRESH;
    fmt::print("\n{}", in_columns(found.names, terminal_width()));
    std::fflush(stdout);
    return CC_REDISPLAY;
  }

  History* history_;
  EditLine* edit_;
  std::string prompt_;
  bool cancelled_ = false;
};

LineEditor::LineEditor()
    : terminal_(::isatty(STDIN_FILENO) != 0 && ::isatty(STDOUT_FILENO) != 0),
      shown_(terminal_),
      history_(terminal_ ? history_path() : "") {
  if (!terminal_ || is_dumb()) return;
  choose_letters();
  edited_ = std::make_unique<Edited>(history_);
}

LineEditor::~LineEditor() = default;

void LineEditor::complete_with(std::function<Completion(const std::string&)> complete) {
  if (edited_) edited_->completer = std::move(complete);
}

namespace {

/// Longer than any line of Lua: unterminated input must not fill the memory.
constexpr std::size_t longest_line = 1U << 20;

}  // namespace

LineEditor::Read LineEditor::read_plain(const std::string& prompt, std::string& line) const {
  if (shown_) fmt::print("{}", prompt);
  std::fflush(stdout);
  line.clear();
  for (int c = std::getchar(); c != '\n'; c = std::getchar()) {
    if (c == EOF) {
      std::clearerr(stdin);
      return line.empty() ? Read::end : Read::line;
    }
    if (line.size() == longest_line)
      throw std::length_error("a line of the input is longer than 1 MB; the console reads lines of Lua");
    line.push_back(static_cast<char>(c));
  }
  return Read::line;
}

LineEditor::Read LineEditor::read(const std::string& prompt, std::string& line) {
  if (!edited_) return read_plain(prompt, line);
  std::fflush(stdout);
  const Read was = edited_->read(prompt, line);
  if (was == Read::end) fmt::print("\n");
  if (was == Read::line && history_.add(line)) edited_->remember(line);
  const std::string complaint = history_.take_complaint();
  if (!complaint.empty()) fmt::print(stderr, "{}\n", complaint);
  return was;
}

}  // namespace trilith::program
