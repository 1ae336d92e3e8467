// One exception type for wrong input. A defect of the engine is an assertion; a physical outcome is a returned report.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace trilith {

/// Wrong input. The message states the given value, the allowed range and a remedy. The Lua binding adds script and
/// line.
class InputError : public std::runtime_error {
 public:
  /// `message`: one line without a final full stop, SI values with units, e.g. "body 'pier 3': mass is -2 kg, must be
  /// above 0; check the sign of the density".
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

/// Throws InputError unless `value` is finite. `what` names the quantity with its owner.
double require_finite(double value, std::string_view what);

/// Throws InputError unless `value` is finite and above zero. `unit` is shown after the value.
double require_positive(double value, std::string_view what, std::string_view unit);

/// Throws InputError unless `value` is finite and not below zero.
double require_not_negative(double value, std::string_view what, std::string_view unit);

}  // namespace trilith
