// Folders of the project's own ground motions.
#include <dlfcn.h>

#include <algorithm>

#include "bindings/core/host.hpp"

namespace trilith::script {
namespace {

/// The file that contains this code: the module in an interpreter, otherwise the program.
std::filesystem::path own_file() {
  static const char here = 0;
  Dl_info about{};
  std::error_code error;
  const bool known = ::dladdr(&here, &about) != 0 && about.dli_fname != nullptr;
  if (known && std::filesystem::path(about.dli_fname).extension() == ".so")
    return std::filesystem::canonical(about.dli_fname, error);
  return std::filesystem::read_symlink("/proc/self/exe", error);
}

}  // namespace

std::filesystem::path installed_under() {
  for (std::filesystem::path at = own_file().parent_path(); at.has_relative_path(); at = at.parent_path())
    if (at.filename() == "bin" || at.filename() == "lib") return at.parent_path();
  return {};
}

std::vector<std::filesystem::path> record_folders() {
  std::vector<std::filesystem::path> folders;
  if (const std::filesystem::path prefix = installed_under(); !prefix.empty())
    folders.push_back(prefix / TRILITH_DATA / "trilith" / "records");
  for (const std::filesystem::path folder : {TRILITH_INSTALLED_RECORDS, TRILITH_SOURCE_RECORDS})
    if (std::ranges::find(folders, folder) == folders.end()) folders.push_back(folder);
  return folders;
}

}  // namespace trilith::script
