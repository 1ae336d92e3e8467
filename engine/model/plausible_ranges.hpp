// Plausible ranges of inputs: a number beyond them is allowed, with a note that asks whether it is intended.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/schema.hpp"

namespace trilith {

/// Plausible range of a number with this name and unit, wherever it is given.
struct PlausibleRange {
  std::string_view name, unit;
  double least, most;
  std::string_view question;  ///< the value that was probably meant
};

/// nullptr where all allowed values are plausible.
const PlausibleRange* usual_range(std::string_view name, std::string_view unit);

/// "mu = 35 is more than the usual 2: ...?"; "" where the number is plausible.
std::string plausibility_note(std::string_view name, std::string_view unit, double value);

/// "usually at most 2", for reference pages; "" where there is no such range.
std::string plausible_range_text(std::string_view name, std::string_view unit);

/// Adds "owner: note" to `list` where the number is implausible.
void add_plausibility_note(std::vector<std::string>& list, const std::string& owner, std::string_view name,
                           std::string_view unit, double value);

/// For one of many similar objects, such as the bodies of a wall: adds the note for the first one only.
void add_plausibility_note_once(std::vector<std::string>& list, const std::string& owner, std::string_view name,
                                std::string_view unit, double value);

/// For all numbers of a law.
template <Declared T>
void add_plausibility_notes(std::vector<std::string>& list, const std::string& owner, const T& value) {
  for (const Parameter<T>& p : T::parameters()) add_plausibility_note(list, owner, p.name, p.unit, value.*(p.member));
}

}  // namespace trilith
