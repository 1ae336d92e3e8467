// Names of what a model is made of: each has one of its own.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/terminal_text.hpp"

namespace trilith {

/// Throws InputError where there is no name.
inline void require_name(const std::string& name, std::string_view kind) {
  if (name.empty()) throw InputError(fmt::format("{} without a name; give each one of its own", kind));
  require_printable(name, kind);
}

/// Throws InputError where a row is called so already; name_of(row) is its name.
template <class Rows, class Name>
void require_new(const Rows& rows, const std::string& name, std::string_view kind, Name&& name_of) {
  for (const auto& row : rows)
    if (name_of(row) == name)
      throw InputError(fmt::format("{} '{}' is there already; give each one of its own name", kind, name));
}

}  // namespace trilith
