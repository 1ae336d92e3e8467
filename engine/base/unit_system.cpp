#include "base/unit_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/exact_message.hpp"
#include "base/quantity_text.hpp"
#include "base/units.hpp"

namespace trilith {
namespace {

/// Powers of ten from `least_power` on, each with the bits of its decimal text.
constexpr std::array powers_of_ten{1e-24, 1e-23, 1e-22, 1e-21, 1e-20, 1e-19, 1e-18, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13,
                                   1e-12, 1e-11, 1e-10, 1e-9,  1e-8,  1e-7,  1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1,
                                   1e0,   1e1,   1e2,   1e3,   1e4,   1e5,   1e6,   1e7,   1e8,   1e9,   1e10,  1e11,
                                   1e12,  1e13,  1e14,  1e15,  1e16,  1e17,  1e18,  1e19,  1e20,  1e21,  1e22};
constexpr int least_power = -24, most_power = 22;

/// The power of ten that a factor is.
std::optional<int> power_of_ten(double factor) {
  const auto at = std::find(powers_of_ten.begin(), powers_of_ten.end(), factor);
  if (at == powers_of_ten.end()) return std::nullopt;
  return least_power + static_cast<int>(at - powers_of_ten.begin());
}

double power_of(double base, int exponent) {
  double result = 1;
  for (int i = 0; i < std::abs(exponent); ++i) result *= base;
  return exponent < 0 ? 1 / result : result;
}

/// "kN s2" of the parts whose exponent has this sign.
std::string product_text(const std::array<std::pair<std::string_view, int>, 3>& parts, int sign) {
  std::string out;
  for (const auto& [name, exponent] : parts) {
    if (sign * exponent <= 0) continue;
    if (!out.empty()) out += ' ';
    out += name;
    if (sign * exponent != 1) out += std::to_string(sign * exponent);
  }
  return out;
}

/// A unit as texts of the engine write it, and its SI unit.
struct TextUnit {
  std::string text, unit;
  double factor;
  bool printed = false;  ///< as quantity_text writes it
};

/// All spellings in texts, longest first: plain ("N/m2", "kN m") and as quantity_text writes them ("N/m²", "kN·m").
std::vector<TextUnit> text_units() {
  static constexpr std::array prefixes{std::pair{"", 1.0},   std::pair{"k", 1e3},  std::pair{"M", 1e6},
                                       std::pair{"G", 1e9},  std::pair{"T", 1e12}, std::pair{"m", 1e-3},
                                       std::pair{"µ", 1e-6}, std::pair{"n", 1e-9}, std::pair{"p", 1e-12}};
  std::vector<TextUnit> all;
  for (const std::string base : {"N", "Pa", "J", "N m", "N/m", "Pa/m", "J/m", "N m/m", "m", "m/s", "m/s2"})
    for (const auto& [prefix, factor] : prefixes)
      if (base[0] != 'm' || factor <= 1) all.push_back({prefix + base, base, factor});
  for (const char* const unit :
       {"N m/rad", "N s/m", "kg m2", "kg/m3", "kg/m2", "N/m3", "N/m2", "J/m2", "kg", "m2", "m3", "1/m"})
    all.push_back({unit, unit, 1});
  all.push_back({"cm", "m", 1e-2});
  for (std::size_t i = 0, plain = all.size(); i < plain; ++i) {
    TextUnit raised = all[i];
    for (const auto& [from, to] :
         {std::pair{" ", "·"}, std::pair{"s2", "s²"}, std::pair{"m2", "m²"}, std::pair{"m3", "m³"}})
      if (const std::size_t at = raised.text.find(from); at != std::string::npos)
        raised.text.replace(at, std::string_view(from).size(), to);
    if (raised.text == all[i].text) continue;
    raised.printed = true;
    all.push_back(std::move(raised));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const TextUnit& a, const TextUnit& b) { return a.text.size() > b.text.size(); });
  return all;
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The unit at the start of `rest`, which no letter, digit or stroke continues; nullptr: none.
const TextUnit* unit_at(std::string_view rest) {
  static const std::vector<TextUnit> all = text_units();
  const auto found = std::find_if(all.begin(), all.end(), [&](const TextUnit& u) {
    if (!rest.starts_with(u.text)) return false;
    const std::string_view after = rest.substr(u.text.size());
    return after.empty() || !(is_word(after[0]) || after[0] == '/' || after.starts_with("·") ||
                              after.starts_with("²") || after.starts_with("³"));
  });
  return found == all.end() ? nullptr : &*found;
}

/// Words before the unit of a number that a message asks for.
constexpr std::string_view number_in = "number in ";

/// The unit after these words at `at`, without a prefix; nullptr: none.
const TextUnit* unit_asked_at(std::string_view text, std::size_t at) {
  if (!text.substr(at).starts_with(number_in)) return nullptr;
  const TextUnit* const unit = unit_at(text.substr(at + number_in.size()));
  return unit != nullptr && unit->factor == 1 ? unit : nullptr;
}

/// A number in a text: its end, and its value.
struct TextNumber {
  std::size_t end;
  double value;
  int digits;
  bool printed;  ///< with the minus sign of with_minus
};

/// At least three, and all digits before the point up to a thousand million.
int digits_for(double value, int digits) {
  int before = 1;
  if (std::abs(value) < 1e9)
    for (double left = std::abs(value); left >= 10; left /= 10) ++before;
  return std::clamp(std::max(digits, before), 3, 15);
}

constexpr std::string_view minus_sign = "−";

/// The number that begins at `at`, after an optional sign; no part of a word or of a longer number.
std::optional<TextNumber> number_at(std::string_view text, std::size_t at) {
  if (at > 0 && (is_word(text[at - 1]) || text[at - 1] == '.')) return std::nullopt;
  if (at > 1 && text[at - 1] == ',' && std::isdigit(static_cast<unsigned char>(text[at - 2])) != 0) return std::nullopt;
  std::size_t begin = at;
  const bool minus = text.substr(at).starts_with(minus_sign);
  if (minus) begin += minus_sign.size();
  double value = 0;
  const char* const first = text.data() + begin;
  const bool starts =
      begin < text.size() && (std::isdigit(static_cast<unsigned char>(*first)) != 0 || (*first == '-' && !minus));
  if (!starts) return std::nullopt;
  const auto [last, error] = std::from_chars(first, text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  std::string figures;
  for (const char* c = first; c != last && *c != 'e' && *c != 'E'; ++c)
    if (std::isdigit(static_cast<unsigned char>(*c)) != 0 && (!figures.empty() || *c != '0')) figures += *c;
  return TextNumber{static_cast<std::size_t>(last - text.data()), minus ? -value : value,
                    static_cast<int>(figures.size()), minus};
}

/// The exact value of a number of a text in SI, or this number. Texts round to at least three digits.
double exact_value(const TextNumber& number, const TextUnit& unit, std::span<const ExactNumber> exact) {
  const double size = number.value * unit.factor;
  const double share = 0.5 * power_of(10, 1 - std::max(3, number.digits));
  for (const ExactNumber& one : exact)
    if (one.unit == unit.unit && std::abs(std::abs(one.value) - std::abs(size)) <= 1.001 * share * std::abs(one.value))
      return std::copysign(one.value, size);
  return size;
}

}  // namespace

UnitSystem::UnitSystem(std::string_view text, std::string_view what) {
  if (text.empty() || text == "SI") return;
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("{}{}'units' is '{}'{}", what, what.empty() ? "" : ": ", text, why));
  };
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" ,\t\n", i), text.size());
    const std::string_view word = text.substr(i, end - i);
    i = end + 1;
    if (word.empty()) continue;
    UnitProduct unit;
    try {
      unit = parse_unit(word);
    } catch (const InputError&) {
      refuse(fmt::format(": there is no unit '{}'; give {}", word, system_example));
    }
    if (unit.dimension == Dimension{1, -2, 1} && force_name_.empty())
      force_ = unit.factor, force_name_ = word;
    else if (unit.dimension == Dimension{1, 0, 0} && length_name_.empty())
      length_ = unit.factor, length_name_ = word;
    else if (word != "s")
      refuse(fmt::format(", must be {}; the time is in s, and the mass follows from them", system_example));
  }
  if (force_name_.empty() || length_name_.empty()) refuse(fmt::format(", must be {}", system_example));
  text_ = text;
}

/// The force has the exponent of the mass, and the length has the rest.
std::optional<UnitSystem::Named> UnitSystem::unit_for(std::string_view unit) const {
  if (is_si() || unit.empty() || unit == "1") return std::nullopt;
  UnitProduct product;
  try {
    product = parse_unit(unit);
  } catch (const InputError&) {
    return std::nullopt;
  }
  const auto [l, t, m] = product.dimension;
  if (product.factor != 1 || (l == 0 && m == 0)) return std::nullopt;
  const std::optional<int> force = power_of_ten(force_), length = power_of_ten(length_);
  Named out{power_of(force_, m) * power_of(length_, l - m), {}};
  if (force && length) {
    const int exponent = *force * m + *length * (l - m);
    if (exponent >= least_power && exponent <= most_power)
      out.factor = powers_of_ten[static_cast<std::size_t>(exponent - least_power)];
  }
  // A mass alone has a name of its own.
  if (product.dimension == Dimension{0, 0, 1} && (out.factor == 1 || out.factor == 1e3)) {
    out.name = out.factor == 1 ? "kg" : "t";
    return out;
  }
  const std::array parts{std::pair{std::string_view(force_name_), m}, std::pair{std::string_view(length_name_), l - m},
                         std::pair{std::string_view("s"), t + 2 * m}};
  const std::string above = product_text(parts, 1), below = product_text(parts, -1);
  out.name = (above.empty() ? "1" : above) + (below.empty() ? "" : "/" + below);
  return out;
}

std::string UnitSystem::name(std::string_view unit) const {
  const std::optional<Named> own = unit_for(unit);
  return own ? own->name : std::string(unit);
}

double UnitSystem::shown(double value, std::string_view unit) const {
  const std::optional<Named> own = unit_for(unit);
  if (!own) return value;
  // 1e-3 has no exact bits, and 1e3 has.
  const std::optional<int> power = power_of_ten(own->factor);
  if (!power || *power >= 0 || -*power > most_power) return value / own->factor;
  return value * powers_of_ten[static_cast<std::size_t>(-*power - least_power)];
}

std::string UnitSystem::message(std::string_view text) const {
  return exact_message(*this, text, {});
}

std::string exact_message(const UnitSystem& units, std::string_view text, std::span<const ExactNumber> exact) {
  if (units.is_si()) return std::string(text);
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    if (const TextUnit* const asked = unit_asked_at(text, at)) {
      out += text.substr(at, number_in.size());
      out += units.name(asked->unit);
      at += number_in.size() + asked->text.size();
      continue;
    }
    const std::optional<TextNumber> number = number_at(text, at);
    const bool apart = number && number->end < text.size() && text[number->end] == ' ';
    const TextUnit* const unit = apart ? unit_at(text.substr(number->end + 1)) : nullptr;
    if (unit == nullptr) {
      const std::size_t end = number ? number->end : at + 1;
      out += text.substr(at, end - at), at = end;
      continue;
    }
    const double value = units.shown(exact_value(*number, *unit, exact), unit->unit);
    const std::string figure = fmt::format("{:.{}g}", value, digits_for(value, number->digits));
    out += number->printed ? with_minus(figure) : figure;
    out += " " + (unit->printed ? printed_unit(units.name(unit->unit)) : units.name(unit->unit));
    at = number->end + 1 + unit->text.size();
  }
  return out;
}

}  // namespace trilith
