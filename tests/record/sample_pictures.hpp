// Where tests put the pictures they draw, to be looked at after a run.
#pragma once

#include <filesystem>

namespace trilith::sample {

/// build/.../tests/pictures below the directory the tests run in.
inline std::filesystem::path picture_path(const char* name) {
  const std::filesystem::path folder = std::filesystem::current_path() / "pictures";
  std::filesystem::create_directories(folder);
  return folder / name;
}

}  // namespace trilith::sample
