#include "base/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

namespace trilith {
namespace {

/// A smaller quantity in SI units is rounding noise.
constexpr double least_quantity = 1e-12;

/// A smaller share is rounding noise.
constexpr double least_share = 1e-8;

/// A value that just reaches a prefix or a power of ten must not miss it by rounding.
constexpr double slack = 1e-9;

/// `digits` significant figures, at least all integer digits, without trailing zeros.
std::string figure_text(double value, int digits) {
  const double magnitude = std::abs(value);
  const int before = magnitude >= 1 ? static_cast<int>(std::floor(std::log10(magnitude))) + 1 : 1;
  if (magnitude >= 1e9 || before <= digits) return with_minus(fmt::format("{:.{}g}", value, digits));
  return with_minus(fmt::format("{:.0f}", value));
}

struct Prefix {
  int power;
  const char* text;
};
constexpr std::array<Prefix, 9> prefixes = {
    {{-12, "p"}, {-9, "n"}, {-6, "µ"}, {-3, "m"}, {0, ""}, {3, "k"}, {6, "M"}, {9, "G"}, {12, "T"}}};

/// Units that take prefixes, with the largest usual prefix.
struct Prefixable {
  std::string_view unit;
  int largest_power;
};
constexpr std::array<Prefixable, 14> prefixable = {{{"N", 12},
                                                    {"Pa", 12},
                                                    {"J", 12},
                                                    {"W", 12},
                                                    {"Hz", 12},
                                                    {"N·m", 12},
                                                    {"N/m", 12},
                                                    {"Pa/m", 12},
                                                    {"J/m", 12},
                                                    {"N·m/m", 12},
                                                    {"m", 0},
                                                    {"m/s", 0},
                                                    {"m/s²", 0},
                                                    {"s", 0}}};

std::string spelled(std::string_view unit) {
  std::string out(unit == "1" ? "" : unit);
  for (std::size_t at = out.find('*'); at != std::string::npos; at = out.find('*')) out.replace(at, 1, "·");
  for (const auto& [plain, raised] : {std::pair{"^2", "²"}, std::pair{"^3", "³"}})
    for (std::size_t at = out.find(plain); at != std::string::npos; at = out.find(plain)) out.replace(at, 2, raised);
  for (const std::string_view ending : {"s2", "m2", "m3", "ft2", "in2"})
    if (out.ends_with(ending)) out.replace(out.size() - 1, 1, out.back() == '2' ? "²" : "³");
  return out;
}

ShownUnit plain_unit(double largest, const std::string& unit) {
  if (largest == 0 || (largest >= 1e-3 && largest < 1e5)) return {1, unit};
  const int power = 3 * static_cast<int>(std::floor(std::log10(largest) / 3 + slack));
  return {std::pow(10.0, power), "10" + superscript(power) + (unit.empty() ? "" : " " + unit)};
}

}  // namespace

std::string with_minus(std::string text) {
  if (text.empty() || text[0] != '-') return text;
  if (text.find_first_not_of("-0.") == std::string::npos) return text.substr(1);
  return "−" + text.substr(1);
}

std::string superscript(int power) {
  static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = power < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(power))) out += digits[static_cast<std::size_t>(c - '0')];
  return out;
}

/// Selects the largest prefix that the magnitude reaches, so that the figures are between 1 and 1000. A power of ten is
/// used where the unit takes no prefix or no prefix is large enough.
ShownUnit engineering_unit(double largest, std::string_view unit, const UnitSystem& system) {
  if (const auto own = system.unit_for(unit)) {
    const double in_system = std::isfinite(largest) ? std::abs(largest) / own->factor : 0;
    const ShownUnit plain = plain_unit(in_system, printed_unit(own->name));
    return {own->factor * plain.size, plain.text};
  }
  const std::string name = spelled(unit);
  const double magnitude = std::abs(largest);
  const auto row =
      std::find_if(prefixable.begin(), prefixable.end(), [&](const Prefixable& p) { return p.unit == name; });
  if (row == prefixable.end() || !std::isfinite(magnitude))
    return plain_unit(std::isfinite(magnitude) ? magnitude : 0, name);
  if (magnitude == 0) return {1, name};
  const Prefix* best = &prefixes.front();
  for (const Prefix& p : prefixes)
    if (p.power <= row->largest_power && magnitude >= std::pow(10.0, p.power) * (1 - slack)) best = &p;
  const double size = std::pow(10.0, best->power);
  if (magnitude >= 1e5 * size || magnitude < 1e-3 * size) return plain_unit(magnitude, name);
  return {size, best->text + name};
}

std::string printed_unit(std::string_view unit) {
  std::string out;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool raised =
        i > 0 && unit[i] >= '2' && unit[i] <= '9' && std::isalpha(static_cast<unsigned char>(unit[i - 1])) != 0;
    if (raised)
      out += superscript(unit[i] - '0');
    else if (unit[i] == ' ' || unit[i] == '*')
      out += "·";
    else
      out += unit[i];
  }
  return out;
}

std::string quantity_text(double value, std::string_view unit, int digits, const UnitSystem& system) {
  if (!std::isfinite(value)) return "–";
  if (std::abs(value) < least_quantity) value = 0;
  const ShownUnit shown = engineering_unit(value, unit, system);
  const std::string figure = figure_text(value / shown.size, digits);
  if (shown.text.empty()) return figure;
  return figure + (shown.text.starts_with("10") ? "·" : " ") + shown.text;
}

std::string percent_text(double share, int digits) {
  if (!std::isfinite(share)) return "–";
  if (std::abs(share) < least_share) return "0 %";
  const double percent = 100 * share;
  const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(percent))));
  std::string figure = fmt::format("{:.{}f}", percent, std::max(0, decimals));
  if (figure.find('.') != std::string::npos) figure.erase(figure.find_last_not_of('0') + 1);
  if (figure.ends_with('.')) figure.pop_back();
  return figure + " %";
}

}  // namespace trilith
