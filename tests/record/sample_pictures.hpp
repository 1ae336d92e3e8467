// Where tests put the pictures they draw, to be looked at after a run.
#pragma once

#include <filesystem>

namespace trilith::sample {

/// A file in the folder `pictures` beside the test program, in the build tree wherever the tests are started from.
inline std::filesystem::path picture_path(const char* name) {
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "pictures";
  std::filesystem::create_directories(folder);
  return folder / name;
}

}  // namespace trilith::sample
