#include "base/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace trilith {
namespace {

/// The sign of NaN has no meaning, so it is left out.
std::string figures(double value) {
  return std::isnan(value) ? "nan" : fmt::format("{:g}", value);
}

std::string with_unit(double value, std::string_view unit) {
  return fmt::format("{}{}{}", figures(value), unit.empty() ? "" : " ", unit);
}

}  // namespace

double require_finite(double value, std::string_view what) {
  if (!std::isfinite(value)) throw InputError(fmt::format("{} is {}, must be a finite number", what, figures(value)));
  return value;
}

double require_positive(double value, std::string_view what, std::string_view unit) {
  if (!(std::isfinite(value) && value > 0))
    throw InputError(fmt::format("{} is {}, must be finite and above 0", what, with_unit(value, unit)));
  return value;
}

double require_not_negative(double value, std::string_view what, std::string_view unit) {
  if (!(std::isfinite(value) && value >= 0))
    throw InputError(fmt::format("{} is {}, must be finite and not below 0", what, with_unit(value, unit)));
  return value;
}

}  // namespace trilith
