#include "build/plane/part.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace trilith {

std::string part_name(std::string_view owner, std::string_view piece) {
  return owner.empty() ? std::string(piece) : fmt::format("{}.{}", owner, piece);
}

std::string builder_title(std::string_view kind, std::string_view name) {
  return name.empty() ? std::string(kind) : fmt::format("{} '{}'", kind, name);
}

int require_count(int value, int low, int high, std::string_view what) {
  if (value < low || value > high)
    throw InputError(fmt::format("{} is {}, must be a whole number from {} to {}", what, value, low, high));
  return value;
}

}  // namespace trilith
