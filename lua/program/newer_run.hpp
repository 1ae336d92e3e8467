// Warning about results that are not the latest.
#pragma once

#include <fmt/format.h>

#include "results/reading/info.hpp"

namespace trilith::program {

/// Prints a warning to standard error if a later run has left, or is writing, newer results.
inline void tell_of_newer_run(const results::ResultsReader& reader) {
  const std::string text = results::newer_run_text(reader);
  if (!text.empty()) fmt::print(stderr, "note: {}: {}\n", reader.path().string(), text);
}

}  // namespace trilith::program
