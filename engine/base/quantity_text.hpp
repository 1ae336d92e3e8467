// Formats a quantity for display: significant figures and the unit with its prefix.
#pragma once

#include <string>
#include <string_view>

#include "base/unit_system.hpp"

namespace trilith {

/// A display unit: shown = value / `size`.
struct ShownUnit {
  double size = 1;
  std::string text;
};

/// The unit with the engineering prefix (p to T) that scales `largest` (a magnitude in `unit`) to 1 ... 1000, e.g.
/// (1.2e6, "N") -> {1e6, "MN"}. Units without prefixes (%, ft, g, rad, ...; s upwards) keep their name from 0.001 to
/// 100,000 and get a power of ten such as "10⁶ lbf" beyond. A pure number, without unit or with "1", is treated alike.
/// "m/s2" and "N*m" are shown as "m/s²" and "N·m". In a `system` other than SI it is the unit of that system instead,
/// without prefixes: 1.2e6 N is 1200 kN.
ShownUnit engineering_unit(double largest, std::string_view unit, const UnitSystem& system = {});

/// "1.23 MN": `value` to `digits` significant figures with its engineering unit; "–" where the value is not finite,
/// 0 below 1e-12 of its unit, which is rounding noise.
std::string quantity_text(double value, std::string_view unit, int digits = 3, const UnitSystem& system = {});
inline std::string quantity_text(double value, std::string_view unit, const UnitSystem& system) {
  return quantity_text(value, unit, 3, system);
}

/// The name of a unit as it is printed: "kN·m" for "kN m", "N/mm²" for "N/mm2".
std::string printed_unit(std::string_view unit);

/// "0.012 %": a share to `digits` significant figures without an exponent; 0 below 1e-8, which is rounding noise.
std::string percent_text(double share, int digits = 2);

/// `text`, a formatted number, with U+2212 as the minus sign and zero without a sign.
std::string with_minus(std::string text);

/// An integer in superscript digits, such as ⁻⁴.
std::string superscript(int power);

}  // namespace trilith
