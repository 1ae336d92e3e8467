// Ranges in which inputs usually are: beyond them a number is allowed, and a note asks whether it is meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/schema.hpp"

namespace trilith {

/// What is usual for a number of that name and unit, wherever it is given.
struct UsualRange {
  std::string_view name, unit;
  double least, most;
  std::string_view question;  ///< what was likely meant instead
};

/// nullptr where all that is allowed is usual.
const UsualRange* usual_range(std::string_view name, std::string_view unit);

/// "mu = 35 is more than the usual 2: ...?"; "" where the number is usual.
std::string doubt(std::string_view name, std::string_view unit, double value);

/// "usually at most 2", for reference pages; "" where there is no such range.
std::string usual_text(std::string_view name, std::string_view unit);

/// Adds "owner: doubt" to `list` where there is one.
void add_doubt(std::vector<std::string>& list, const std::string& owner, std::string_view name, std::string_view unit,
               double value);

/// The same of one of many that may be alike, as bodies of a wall: told of the first alone.
void add_doubt_once(std::vector<std::string>& list, const std::string& owner, std::string_view name,
                    std::string_view unit, double value);

/// The same for all numbers of a law.
template <Declared T>
void add_doubts(std::vector<std::string>& list, const std::string& owner, const T& value) {
  for (const Parameter<T>& p : T::parameters()) add_doubt(list, owner, p.name, p.unit, value.*(p.member));
}

}  // namespace trilith
