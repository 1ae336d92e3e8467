#include "comma_list.hpp"

#include <fmt/format.h>

#include <charconv>

#include "base/error.hpp"

namespace trilith::program {

std::vector<std::string> comma_list(std::string_view text) {
  std::vector<std::string> out;
  for (std::size_t from = 0;;) {
    const std::size_t comma = text.find(',', from);
    out.emplace_back(text.substr(from, comma == std::string_view::npos ? comma : comma - from));
    if (comma == std::string_view::npos) return out;
    from = comma + 1;
  }
}

double number_of(const std::string& text, std::string_view what) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) throw InputError(fmt::format("{}: '{}' is not a number", what, text));
  return require_finite(value, what);
}

}  // namespace trilith::program
