// Ranges in which inputs usually are: beyond them a number is allowed, and a note asks whether it is meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/schema.hpp"

namespace trilith {

/// What is usual for a number of that name and unit, wherever it is given.
struct PlausibleRange {
  std::string_view name, unit;
  double least, most;
  std::string_view question;  ///< what was likely meant instead
};

/// nullptr where all that is allowed is usual.
const PlausibleRange* usual_range(std::string_view name, std::string_view unit);

/// "mu = 35 is more than the usual 2: ...?"; "" where the number is usual.
std::string plausibility_note(std::string_view name, std::string_view unit, double value);

/// "usually at most 2", for reference pages; "" where there is no such range.
std::string plausible_range_text(std::string_view name, std::string_view unit);

/// Adds "owner: note" to `list` where the number is implausible.
void add_plausibility_note(std::vector<std::string>& list, const std::string& owner, std::string_view name,
                           std::string_view unit, double value);

/// The same of one of many that may be alike, as bodies of a wall: told of the first alone.
void add_plausibility_note_once(std::vector<std::string>& list, const std::string& owner, std::string_view name,
                                std::string_view unit, double value);

/// The same for all numbers of a law.
template <Declared T>
void add_plausibility_notes(std::vector<std::string>& list, const std::string& owner, const T& value) {
  for (const Parameter<T>& p : T::parameters()) add_plausibility_note(list, owner, p.name, p.unit, value.*(p.member));
}

}  // namespace trilith
