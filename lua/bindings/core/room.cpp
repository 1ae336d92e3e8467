#include "bindings/core/room.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "base/terminal_text.hpp"

namespace trilith::script {
namespace {

namespace files = std::filesystem;

constexpr const char* way_out = "`trilith run --trust SCRIPT` allows it for a script that you trust";

[[noreturn]] void refuse_path(const std::string& owner, const files::path& path, const std::string& why) {
  throw InputError(fmt::format("{}: '{}' is refused: {}; {}", owner, terminal_text(path.string()), why, way_out));
}

/// `path` without symbolic links, "." and ".."; a missing part remains at its end. Empty if a link on the way is
/// broken, or ".." follows a missing part: a file created there could be anywhere.
files::path real_path(const files::path& path) {
  std::error_code error;
  files::path known = files::absolute(path, error), rest;
  while (!error && !known.empty() && files::symlink_status(known, error).type() == files::file_type::not_found) {
    error.clear();
    const files::path last = known.filename();
    if (last == "..") return {};
    if (!last.empty() && last != ".") rest = rest.empty() ? last : last / rest;
    if (known == known.parent_path()) break;
    known = known.parent_path();
  }
  error.clear();
  const files::path found = files::canonical(known, error);
  if (error) return {};
  return rest.empty() ? found : found / rest;
}

/// Sets `rest` to the part of `path` below `folder`; false if it is not below.
bool lies_below(const files::path& path, const files::path& folder, files::path& rest) {
  const auto [at, end] = std::mismatch(path.begin(), path.end(), folder.begin(), folder.end());
  if (end != folder.end()) return false;
  rest.clear();
  for (auto part = at; part != path.end(); ++part) rest /= *part;
  return true;
}

bool has_hidden_name(const files::path& path) {
  return std::any_of(path.begin(), path.end(), [](const files::path& part) { return part.string().starts_with("."); });
}

/// True for files that other programs run or obey.
bool is_program(const files::path& path) {
  static constexpr std::array endings{".lua", ".so",      ".sh",  ".bash",  ".zsh", ".fish", ".py",
                                      ".pyc", ".pl",      ".rb",  ".js",    ".mjs", ".c",    ".cpp",
                                      ".h",   ".desktop", ".exe", ".cmake", ".mk",  ".toml", ".service"};
  static constexpr std::array names{"Makefile", "makefile", "GNUmakefile", "CMakeLists.txt", "Dockerfile"};
  const std::string ending = path.extension().string(), name = path.filename().string();
  return std::find(endings.begin(), endings.end(), ending) != endings.end() ||
         std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void Room::close(const files::path& script_folder) {
  closed_ = true;
  add(script_folder);
}

void Room::add(const files::path& folder) {
  files::path real = real_path(folder.empty() ? files::path(".") : folder);
  if (!real.empty() && std::find(folders_.begin(), folders_.end(), real) == folders_.end())
    folders_.push_back(std::move(real));
}

files::path Room::resolved(const files::path& path, const std::string& owner, const char* act) const {
  if (path.native().find('\0') != std::string::npos) refuse_path(owner, path, "its name holds a zero byte");
  const files::path real = real_path(path);
  if (real.empty()) refuse_path(owner, path, "its folder, or the target of a symbolic link on the way, does not exist");
  files::path rest;
  bool hidden = false;
  for (const files::path& folder : folders_) {
    if (!lies_below(real, folder, rest)) continue;
    if (!has_hidden_name(rest)) return real;
    hidden = true;
  }
  if (hidden) refuse_path(owner, path, fmt::format("a script may not {} files whose names begin with a dot", act));
  std::vector<std::string> names;
  for (const files::path& folder : folders_) names.push_back(terminal_text(folder.string()));
  refuse_path(owner, path, fmt::format("a script may {} files only below {}", act, fmt::join(names, " and ")));
}

files::path Room::readable(const files::path& path, const std::string& owner) const {
  if (!closed_) return path;
  files::path real = resolved(path, owner, "read");
  std::error_code error;
  const files::file_status status = files::status(real, error);
  if (files::exists(status) && !files::is_regular_file(status)) refuse_path(owner, path, "it is not a regular file");
  return real;
}

files::path Room::writable(const files::path& path, const std::string& owner) const {
  if (!closed_) return path;
  files::path real = resolved(path, owner, "write");
  if (is_program(real)) refuse_path(owner, path, "a script may not write files that programs run");
  std::error_code error;
  const files::file_status status = files::status(real, error);
  if (!files::exists(status)) return real;
  if (!files::is_regular_file(status)) refuse_path(owner, path, "it is not a regular file");
  using files::perms;
  if ((status.permissions() & (perms::owner_exec | perms::group_exec | perms::others_exec)) != perms::none)
    refuse_path(owner, path, "it is a program");
  if (files::hard_link_count(real, error) > 1) refuse_path(owner, path, "it is a file with a second name elsewhere");
  return real;
}

}  // namespace trilith::script
