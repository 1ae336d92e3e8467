// Folders of ground motion records for the tests.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "source_dir.hpp"

namespace trilith::testing {

/// A record that is part of the project.
inline std::filesystem::path own_record(const std::string& name) {
  return std::filesystem::path(source_dir()) / "scripts" / "records" / name;
}

/// The folder of the larger set of records: $TRILITH_RECORDS, or next to the project. None, with a message, if it is
/// absent.
inline std::optional<std::filesystem::path> record_folder() {
  const char* given = std::getenv("TRILITH_RECORDS");
  const std::filesystem::path folder =
      given != nullptr ? std::filesystem::path(given)
                       : std::filesystem::path(source_dir()) / ".." / "shared" / "data" / "ground_motions";
  if (std::filesystem::exists(folder / "manifest.csv")) return folder;
  MESSAGE("skipped: no ground motion records in '", folder.string(), "'; set TRILITH_RECORDS to their folder");
  return std::nullopt;
}

}  // namespace trilith::testing
