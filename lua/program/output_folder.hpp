// Output folders of the program.
#pragma once

#include <fmt/format.h>

#include <filesystem>

namespace trilith::program {

/// Creates the folder of an output if necessary, and reports it, because the name may be mistyped. If it cannot be
/// created, the writer of the output reports the error.
inline void make_folder_for(const std::filesystem::path& out) {
  const std::filesystem::path folder = out.parent_path();
  std::error_code error;
  if (!folder.empty() && std::filesystem::create_directories(folder, error))
    fmt::print(stderr, "note: made folder {}\n", folder.string());
}

}  // namespace trilith::program
