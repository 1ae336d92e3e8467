// Names of what a model is made of: each has one of its own.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <unordered_set>

#include "base/error.hpp"
#include "base/terminal_text.hpp"

namespace trilith {

/// Throws InputError where there is no name, or one of more than `longest_name` bytes: each row of a results table is
/// as wide as the longest name in it.
inline void require_name(const std::string& name, std::string_view kind) {
  if (name.empty()) throw InputError(fmt::format("{} without a name; give each one of its own", kind));
  require_printable(name, kind, longest_name);
}

/// Throws InputError where a row is called so already; name_of(row) is its name.
template <class Rows, class Name>
void require_new(const Rows& rows, const std::string& name, std::string_view kind, Name&& name_of) {
  for (const auto& row : rows)
    if (name_of(row) == name)
      throw InputError(fmt::format("{} '{}' is there already; give each one of its own name", kind, name));
}

/// The same for very many rows that are added one by one: names of rows are looked up, not compared with each. Rows may
/// be taken off the end in between.
class RowNames {
 public:
  template <class Rows>
  void require_new(const Rows& rows, const std::string& name, std::string_view kind) {
    if (rows.size() < known_) names_.clear(), known_ = 0;
    for (; known_ < rows.size(); ++known_) names_.insert(rows[known_].name);
    if (names_.contains(name))
      throw InputError(fmt::format("{} '{}' is there already; give each one of its own name", kind, name));
  }

 private:
  std::unordered_set<std::string> names_;  // of the first `known_` rows
  std::size_t known_ = 0;
};

}  // namespace trilith
