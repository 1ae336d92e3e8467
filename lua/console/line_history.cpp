#include "line_history.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <utility>

namespace trilith::program {
namespace {

constexpr std::size_t most_lines = 2000;

std::filesystem::path folder_of(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr ? value : "";
}

}  // namespace

std::filesystem::path history_path() {
  if (const char* given = std::getenv("TRILITH_HISTORY")) return given;
  std::filesystem::path state = folder_of("XDG_STATE_HOME");
  if (!state.is_absolute()) {
    const std::filesystem::path home = folder_of("HOME");
    if (home.empty()) return "";
    state = home / ".local" / "state";
  }
  return state / "trilith" / "console_history";
}

LineHistory::LineHistory(std::filesystem::path path) : path_(std::move(path)) {
  if (path_.empty()) return;
  std::ifstream in(path_);
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines_.push_back(line);
  if (lines_.size() <= most_lines) return;
  const bool much = lines_.size() > 2 * most_lines;
  lines_.erase(lines_.begin(), lines_.end() - most_lines);
  if (!much) return;
  in.close();
  std::ofstream out(path_);
  for (const std::string& line : lines_) out << line << '\n';
}

bool LineHistory::add(const std::string& line) {
  if (line.empty() || line.front() == ' ' || (!lines_.empty() && lines_.back() == line)) return false;
  lines_.push_back(line);
  if (path_.empty()) return true;
  std::error_code error;
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), error);
  const bool fresh = !std::filesystem::exists(path_, error);
  std::ofstream out(path_, std::ios::app);
  out << line << '\n' << std::flush;
  if (!out) {
    complaint_ = fmt::format("the history of this console is not saved: cannot write {} ({})", path_.string(),
                             std::strerror(errno));
    path_.clear();
  } else if (fresh) {
    using std::filesystem::perms;
    std::filesystem::permissions(path_, perms::owner_read | perms::owner_write, error);  // readable by the user only
  }
  return true;
}

std::string LineHistory::take_complaint() {
  return std::exchange(complaint_, "");
}

}  // namespace trilith::program
