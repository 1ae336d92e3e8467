// Units and what they are in SI: the one table that scripts, the command line and messages share.
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

/// One unit: `factor` times it gives SI.
struct Unit {
  std::string_view name;
  double factor;
  Dimension dimension;
  std::string_view sentence;
};

/// All units there are, in the order in which a list shows them.
std::span<const Unit> unit_table();

/// A product of units.
struct UnitProduct {
  double factor = 1;
  Dimension dimension;
};

/// Factor and dimension of an expression such as "ft", "kip/ft", "m/s2", "N s/m" or "1": units with an optional whole
/// exponent, multiplied by a blank or '*', divided by '/' (everything after it, up to the next '/', divides).
/// Throws InputError for an unknown unit, with the nearest name.
UnitProduct parse_unit(std::string_view expression);

/// SI value of "0.6", "0.6g" or "0.6 m/s2"; a plain number is in `unit`. `what` begins the messages.
/// Throws InputError where it is no finite number, or its unit is not of the dimension of `unit`.
double parse_quantity(std::string_view text, std::string_view unit, std::string_view what);

/// The SI unit of a dimension: "m/s2", "N", "1".
std::string si_unit(const Dimension& dimension);

/// Names of all units that have this dimension, or of all.
std::vector<std::string> unit_names();
std::vector<std::string> unit_names(const Dimension& dimension);

}  // namespace trilith
