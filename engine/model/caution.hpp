// Notes that limit a result, as opposed to notes on the model or on progress.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trilith {

/// Begins a note that limits a result: inertia carries a part of the peak, a load path has ended early. Quiet runs
/// display it too, and the seal of the run repeats the first one.
inline constexpr std::string_view caution_mark = "caution: ";

inline bool is_caution(std::string_view note) {
  return note.starts_with(caution_mark);
}

/// ", 2 of which limit a result: pushover: the peak of ..." with the first of them; "" without one.
inline std::string caution_text(const std::vector<std::string>& notes) {
  std::size_t count = 0;
  std::string_view first;
  for (const std::string& note : notes)
    if (is_caution(note) && count++ == 0) first = std::string_view(note).substr(caution_mark.size());
  if (count == 0) return "";
  return ", " + std::to_string(count) + (count == 1 ? " of which limits" : " of which limit") +
         " a result: " + std::string(first);
}

}  // namespace trilith
