// Folders for what the program writes.
#pragma once

#include <fmt/format.h>

#include <filesystem>

namespace trilith::program {

/// Makes the folder of an output where there is none, and says so: it may have been mistyped. Where it cannot be made,
/// whoever writes the output says what is wrong.
inline void make_folder_for(const std::filesystem::path& out) {
  const std::filesystem::path folder = out.parent_path();
  std::error_code error;
  if (!folder.empty() && std::filesystem::create_directories(folder, error))
    fmt::print(stderr, "note: made folder {}\n", folder.string());
}

}  // namespace trilith::program
