// Texts with rounded numbers, in other units: the exact values replace them before the conversion.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/unit_system.hpp"

namespace trilith {

/// A number that a text contains in rounded form.
struct ExactNumber {
  double value;           ///< in `unit`
  std::string_view unit;  ///< of SI
};

/// UnitSystem::message with the exact values of the numbers in the text: "137 kN m" of 136,987.6 N m is 136987600 N mm,
/// and not 137000000 N mm. A number that differs from all of them, to its digits, is converted itself.
std::string exact_message(const UnitSystem& units, std::string_view text, std::span<const ExactNumber> exact);

}  // namespace trilith
