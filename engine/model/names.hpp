// Names in a model: each object has a unique one.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <unordered_set>

#include "base/error.hpp"
#include "base/terminal_text.hpp"

namespace trilith {

/// Throws InputError for an empty name, or one with more than `longest_name` bytes: each row of a results table is as
/// wide as its longest name.
inline void require_name(const std::string& name, std::string_view kind) {
  if (name.empty()) throw InputError(fmt::format("{} without a name; give each its own name", kind));
  require_printable(name, kind, longest_name);
}

/// Throws InputError where a row already has this name; name_of(row) is its name.
template <class Rows, class Name>
void require_new(const Rows& rows, const std::string& name, std::string_view kind, Name&& name_of) {
  for (const auto& row : rows)
    if (name_of(row) == name)
      throw InputError(fmt::format("{} '{}' exists already; give each its own name", kind, name));
}

/// For very many rows that are added one by one: names are looked up, not compared with each row. Rows may be removed
/// from the end in between.
class RowNames {
 public:
  template <class Rows>
  [[nodiscard]] bool contains(const Rows& rows, const std::string& name) {
    if (rows.size() < known_) names_.clear(), known_ = 0;
    for (; known_ < rows.size(); ++known_) names_.insert(rows[known_].name);
    return names_.contains(name);
  }
  template <class Rows>
  void require_new(const Rows& rows, const std::string& name, std::string_view kind) {
    if (contains(rows, name))
      throw InputError(fmt::format("{} '{}' exists already; give each its own name", kind, name));
  }

 private:
  std::unordered_set<std::string> names_;  // of the first `known_` rows
  std::size_t known_ = 0;
};

}  // namespace trilith
