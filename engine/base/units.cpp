#include "base/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/nearest.hpp"

namespace trilith {
namespace {

// Exact by definition: international foot and pound (1959), standard gravity (3rd CGPM, 1901).
constexpr double foot = 0.3048, inch = 0.0254, pound = 0.45359237, gravity = 9.80665;
constexpr double pound_force = pound * gravity;

// Exponents of length, time and mass, in this order.
constexpr Dimension none{}, length{1, 0, 0}, time_{0, 1, 0}, mass{0, 0, 1}, frequency{0, -1, 0}, acceleration{1, -2, 0},
    force{1, -2, 1}, stress{-1, -2, 1}, energy{2, -2, 1}, unit_weight{-2, -2, 1};

// Name, SI value, dimension and description, in the order of manuals and messages.
constexpr std::array units{
    Unit{"m", 1, length, "metre"},
    Unit{"mm", 1e-3, length, "millimetre"},
    Unit{"cm", 1e-2, length, "centimetre"},
    Unit{"km", 1e3, length, "kilometre"},
    Unit{"inch", inch, length, "inch, 25.4 mm"},
    Unit{"ft", foot, length, "foot, 12 inch"},
    Unit{"yd", 3 * foot, length, "yard, 3 ft"},
    Unit{"s", 1, time_, "second"},
    Unit{"ms", 1e-3, time_, "millisecond"},
    Unit{"min", 60, time_, "minute"},
    Unit{"Hz", 1, frequency, "hertz, one per second"},
    Unit{"kg", 1, mass, "kilogram"},
    Unit{"t", 1e3, mass, "tonne, 1000 kg"},
    Unit{"lbm", pound, mass, "pound as a mass"},
    Unit{"slug", pound_force / foot, mass, "slug, lbf s2/ft"},
    Unit{"N", 1, force, "newton"},
    Unit{"kN", 1e3, force, "kilonewton"},
    Unit{"MN", 1e6, force, "meganewton"},
    Unit{"lbf", pound_force, force, "pound as a force"},
    Unit{"kip", 1e3 * pound_force, force, "1000 lbf"},
    Unit{"Pa", 1, stress, "pascal"},
    Unit{"kPa", 1e3, stress, "kilopascal"},
    Unit{"MPa", 1e6, stress, "megapascal"},
    Unit{"GPa", 1e9, stress, "gigapascal"},
    Unit{"psi", pound_force / (inch * inch), stress, "lbf/inch2"},
    Unit{"psf", pound_force / (foot * foot), stress, "lbf/ft2"},
    Unit{"ksi", 1e3 * pound_force / (inch * inch), stress, "kip/inch2"},
    Unit{"ksf", 1e3 * pound_force / (foot * foot), stress, "kip/ft2"},
    Unit{"pcf", pound_force / (foot * foot * foot), unit_weight, "lbf/ft3: a unit weight, not a density"},
    Unit{"kcf", 1e3 * pound_force / (foot * foot * foot), unit_weight, "kip/ft3: a unit weight, not a density"},
    Unit{"g", gravity, acceleration, "standard gravity, 9.80665 m/s2 (not the gram)"},
    Unit{"J", 1, energy, "joule"},
    Unit{"kJ", 1e3, energy, "kilojoule"},
    Unit{"rad", 1, none, "radian"},
    Unit{"deg", std::numbers::pi / 180, none, "degree"},
    Unit{"percent", 1e-2, none, "percent, one hundredth"},
};

/// Common names of units that have another name here.
struct OtherName {
  std::string_view name, here;
};
constexpr std::array other_names{
    OtherName{"in", "inch"},    OtherName{"ins", "inch"},    OtherName{"inches", "inch"}, OtherName{"feet", "ft"},
    OtherName{"foot", "ft"},    OtherName{"yard", "yd"},     OtherName{"yards", "yd"},    OtherName{"meter", "m"},
    OtherName{"metre", "m"},    OtherName{"meters", "m"},    OtherName{"metres", "m"},    OtherName{"sec", "s"},
    OtherName{"secs", "s"},     OtherName{"second", "s"},    OtherName{"seconds", "s"},   OtherName{"msec", "ms"},
    OtherName{"minute", "min"}, OtherName{"minutes", "min"}, OtherName{"ton", "t"},       OtherName{"tonne", "t"},
    OtherName{"tons", "t"},     OtherName{"tonnes", "t"},    OtherName{"kilogram", "kg"}, OtherName{"newton", "N"},
    OtherName{"pascal", "Pa"},  OtherName{"hertz", "Hz"},    OtherName{"radian", "rad"},  OtherName{"radians", "rad"},
    OtherName{"degree", "deg"}, OtherName{"degrees", "deg"}, OtherName{"pct", "percent"}, OtherName{"joule", "J"},
};

bool equal_but_for_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

/// The intended unit: another common name, the same letters in another case, the only unit with this prefix, or the
/// nearest spelling. Spelling is not tried for one or two letters, because nearly every unit is near. "" if nothing
/// matches.
std::string meant_unit(std::string_view name) {
  for (const OtherName& other : other_names)
    if (equal_but_for_case(other.name, name)) return std::string(other.here);
  const auto only = [&](auto&& fits) -> std::string {
    if (std::count_if(units.begin(), units.end(), fits) != 1) return {};
    return std::string(std::find_if(units.begin(), units.end(), fits)->name);
  };
  std::string best = only([&](const Unit& u) { return equal_but_for_case(u.name, name); });
  if (best.empty() && name.size() >= 3) best = nearest_name(name, unit_names());
  if (best.empty() && name.size() >= 2) best = only([&](const Unit& u) { return u.name.starts_with(name); });
  return best;
}

/// The message of the InputError names the intended unit, for one or two letters also the others of its dimension, or
/// all units. `lb` is ambiguous between force and mass, so the message asks which one is meant.
const Unit& find_unit(std::string_view name, std::string_view expression) {
  for (const Unit& u : units)
    if (u.name == name) return u;
  const std::string where = name == expression ? "" : fmt::format(" in '{}'", expression);
  if (name == "lb")
    throw InputError(fmt::format("there is no unit 'lb'{}; write lbf for a force, lbm for a mass", where));
  const std::string best = meant_unit(name);
  if (best.empty())
    throw InputError(fmt::format("there is no unit '{}'{}; known: {}", name, where, fmt::join(unit_names(), ", ")));
  const auto like = std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.name == best; });
  std::vector<std::string> others = unit_names(like->dimension);
  std::erase(others, best);
  throw InputError(fmt::format(
      "there is no unit '{}'{}; did you mean '{}'?{}", name, where, best,
      others.empty() || name.size() > 2 ? "" : fmt::format(" Other units of this kind: {}", fmt::join(others, ", "))));
}

/// By multiplication, so that a unit's factor has the same bits on every machine.
double whole_power(double base, int exponent) {
  double result = 1;
  for (int i = 0; i < std::abs(exponent); ++i) result *= base;
  return exponent < 0 ? 1 / result : result;
}

/// A product of units multiplies their factors and adds the exponents of length, time and mass.
void multiply(UnitProduct& product, const Unit& unit, int exponent) {
  product.factor *= whole_power(unit.factor, exponent);
  product.dimension.length += exponent * unit.dimension.length;
  product.dimension.time += exponent * unit.dimension.time;
  product.dimension.mass += exponent * unit.dimension.mass;
}

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

std::span<const Unit> unit_table() {
  return units;
}

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  for (const Unit& u : units) names.emplace_back(u.name);
  return names;
}

std::vector<std::string> unit_names(const Dimension& dimension) {
  std::vector<std::string> names;
  for (const Unit& u : units)
    if (u.dimension == dimension) names.emplace_back(u.name);
  return names;
}

/// From left to right: names with an exponent after them. Everything after a stroke divides, so kN/m s2 is kN/(m s2).
UnitProduct parse_unit(std::string_view expression) {
  const std::string_view text = trimmed(expression);
  if (text.empty()) throw InputError("an empty unit; write 1 for a pure number");
  UnitProduct product;
  int sign = 1;
  for (std::size_t i = 0; i < text.size();) {
    // A single 1, as in 1/s, is the empty product.
    const bool one = text[i] == '1' && (i + 1 == text.size() || !is_digit(text[i + 1]));
    if (is_blank(text[i]) || text[i] == '*' || text[i] == '/' || one) {
      if (text[i] == '/') sign = -1;
      ++i;
    } else if (is_letter(text[i])) {
      const std::size_t begin = i;
      while (i < text.size() && is_letter(text[i])) ++i;
      const Unit& unit = find_unit(text.substr(begin, i - begin), text);
      int exponent = 1;
      if (i < text.size() && text[i] == '^') ++i;
      if (i < text.size() && is_digit(text[i])) exponent = text[i++] - '0';
      multiply(product, unit, sign * exponent);
    } else {
      throw InputError(
          fmt::format("unit '{}' cannot be read at '{}'; write it as in kip/ft, m/s2 or N s/m", text, text.substr(i)));
    }
  }
  return product;
}

/// A number in `unit`, or a number followed by a unit of the same dimension.
double parse_quantity(std::string_view text, std::string_view unit, std::string_view what) {
  const std::string_view given = trimmed(text);
  const char* const begin = given.data();
  const char* const end = begin + given.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin != end && *begin == '+' ? begin + 1 : begin, end, value);
  if (error != std::errc{} || !std::isfinite(value))
    throw InputError(fmt::format("{} is '{}', must be a number, with or without a unit (as in 0.6 or 0.6{})", what,
                                 text, unit == "1" ? "deg" : unit));
  const UnitProduct wanted = parse_unit(unit);
  const std::string_view own = trimmed(std::string_view(rest, static_cast<std::size_t>(end - rest)));
  if (own.empty()) return value * wanted.factor;
  const UnitProduct product = parse_unit(own);
  if (unit == "1" && !(product.dimension == wanted.dimension))
    throw InputError(fmt::format("{} is '{}', which is in {}; must be a number without a unit, as declared", what, text,
                                 si_unit(product.dimension)));
  if (!(product.dimension == wanted.dimension))
    throw InputError(fmt::format("{} is '{}', which is in {}; must be in {} or another unit of {}", what, text,
                                 si_unit(product.dimension), unit, si_unit(wanted.dimension)));
  return value * product.factor;
}

/// By its own name if it has one, otherwise as a product of kg, m and s.
std::string si_unit(const Dimension& d) {
  for (const std::string_view named : {"N", "Pa", "J"})
    if (find_unit(named, named).dimension == d) return std::string(named);
  std::string above, below;
  const auto add = [&](std::string_view name, int exponent) {
    if (exponent == 0) return;
    std::string& side = exponent > 0 ? above : below;
    if (!side.empty()) side += ' ';
    side += name;
    if (std::abs(exponent) != 1) side += std::to_string(std::abs(exponent));
  };
  add("kg", d.mass);
  add("m", d.length);
  add("s", d.time);
  if (above.empty()) above.push_back('1');
  return below.empty() ? above : fmt::format("{}/{}", above, below);
}

}  // namespace trilith
