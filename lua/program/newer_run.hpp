// Results that are not the last ones.
#pragma once

#include <fmt/format.h>

#include "results/reading/info.hpp"

namespace trilith::program {

/// Says, on standard error, where what is shown is older than what a later run has left or is writing.
inline void tell_of_newer_run(const results::ResultsReader& reader) {
  const std::string text = results::newer_run_text(reader);
  if (!text.empty()) fmt::print(stderr, "note: {}: {}\n", reader.path().string(), text);
}

}  // namespace trilith::program
