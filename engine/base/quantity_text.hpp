// How a quantity is written for a reader: figures, and the unit with its prefix.
#pragma once

#include <string>
#include <string_view>

namespace trilith {

/// A unit to show values in: shown = value / `size`.
struct ShownUnit {
  double size = 1;
  std::string text;
};

/// The unit with the engineering prefix (n to T) that brings `largest` (magnitude, same unit) to 1 ... 1000, e.g.
/// (1.2e6, "N") -> {1e6, "MN"}. Units that take no prefix (%, ft, g, rad, ...; s upwards) keep their name from 0.001
/// to 100,000 and get a power of ten such as "10⁶ lbf" beyond; a pure number, of no unit or "1", likewise. "m/s2" and
/// "N*m" are shown as "m/s²" and "N·m".
ShownUnit engineering_unit(double largest, std::string_view unit);

/// "1.23 MN": `value` to `digits` significant figures with its engineering unit; a value that is not finite is "–".
std::string quantity_text(double value, std::string_view unit, int digits = 3);

/// `text`, a written number, with minus as U+2212 and zero without a sign.
std::string with_minus(std::string text);

/// A whole number in raised digits, such as ⁻⁴.
std::string superscript(int power);

}  // namespace trilith
