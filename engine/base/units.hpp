// Units and their SI values: one table for scripts, the command line and messages.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trilith {

/// Exponents of metre, second and kilogram. An angle has none.
struct Dimension {
  int length = 0, time = 0, mass = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// One unit: a value times `factor` is in SI.
struct Unit {
  std::string_view name;
  double factor;
  Dimension dimension;
  std::string_view sentence;
};

/// All units, in the order of display.
std::span<const Unit> unit_table();

/// A product of units.
struct UnitProduct {
  double factor = 1;
  Dimension dimension;
};

/// Factor and dimension of an expression such as "ft", "kip/ft", "m/s2", "N s/m" or "1". Units may have an integer
/// exponent; a blank or '*' multiplies; '/' divides by everything up to the next '/'. Throws InputError for an unknown
/// unit and names the nearest one.
UnitProduct parse_unit(std::string_view expression);

/// SI value of "0.6", "0.6g" or "0.6 m/s2"; a plain number is in `unit`. Messages begin with `what`. Throws InputError
/// where the text is not a finite number, or its unit differs from `unit` in dimension.
double parse_quantity(std::string_view text, std::string_view unit, std::string_view what);

/// The SI unit of a dimension: "m/s2", "N", "1".
std::string si_unit(const Dimension& dimension);

/// Names of all units, or of all units with this dimension.
std::vector<std::string> unit_names();
std::vector<std::string> unit_names(const Dimension& dimension);

}  // namespace trilith
