// The name that the user most likely meant, for messages such as "did you mean 'height'?".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trilith {

/// Number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b`
/// (restricted Damerau-Levenshtein distance).
int edit_distance(std::string_view a, std::string_view b);

/// The element of `known` nearest to `given`, if it is within a third of its length (at least 1 edit). Otherwise the
/// only element that begins with `given`, if `given` has three letters or more. Otherwise "".
std::string nearest_name(std::string_view given, const std::vector<std::string>& known);

/// "; since version 1.0 it is 'rest'" for a former name; otherwise "; did you mean 'height'?", or without a near name
/// "; known: a, b, c", or "; there are none".
std::string name_hint(std::string_view given, const std::vector<std::string>& known);

}  // namespace trilith
