// The user's mistake, as one exception type; our own mistakes are asserts, nature's answers are returned reports.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace trilith {

/// Wrong input: what was given, what is allowed, what to try. The binding to Lua adds script and line.
class InputError : public std::runtime_error {
 public:
  /// `message`: one line, no trailing full stop, SI values with units, e.g.
  /// "body 'pier 3': mass is -2 kg, must be above 0; check the sign of the density".
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

/// Throws InputError unless `value` is finite. `what` names the quantity with its owner.
double require_finite(double value, std::string_view what);

/// Throws InputError unless `value` is finite and above zero. `unit` is shown after the value.
double require_positive(double value, std::string_view what, std::string_view unit);

/// Throws InputError unless `value` is finite and not below zero.
double require_not_negative(double value, std::string_view what, std::string_view unit);

}  // namespace trilith
