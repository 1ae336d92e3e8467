// The name the user most likely meant, for messages of the form "did you mean 'height'?".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trilith {

/// Number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b`
/// (restricted Damerau-Levenshtein distance).
int edit_distance(std::string_view a, std::string_view b);

/// The nearest of `known` to `given`; where none is within a third of its length (at least 1), the only one that begins
/// with it, if it has three letters; else "".
std::string nearest_name(std::string_view given, const std::vector<std::string>& known);

/// "; did you mean 'height'?" or, where nothing is near, "; known: a, b, c", "; there are none".
std::string name_hint(std::string_view given, const std::vector<std::string>& known);

}  // namespace trilith
