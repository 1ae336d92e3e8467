// A parameter is declared once. Reading, messages, saving and the reference page all use the declaration.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "base/error.hpp"

namespace trilith {

inline constexpr double no_default = std::numeric_limits<double>::quiet_NaN();
inline constexpr double unbounded = std::numeric_limits<double>::infinity();

/// One number of a law or material: the member that holds it, its key, unit, default and range.
template <class Owner>
struct Parameter {
  double Owner::*member;
  std::string_view name;
  std::string_view unit;  ///< SI, "1" for none
  double preset;          ///< the default, or `no_default` where it must be given
  double least, most;     ///< allowed range; `least` itself is allowed only if `includes_least`
  bool includes_least;
  std::string_view sentence;  ///< the description

  [[nodiscard]] bool required() const { return std::isnan(preset); }
  [[nodiscard]] bool allows(double v) const {
    return std::isfinite(v) && (includes_least ? v >= least : v > least) && v <= most;
  }
  [[nodiscard]] std::string range() const {
    const char* const low = includes_least ? "not below" : "above";
    if (most < unbounded) return fmt::format("{} {:g} and at most {:g}", low, least, most);
    return fmt::format("{} {:g}", low, least);
  }
};

/// A type with declared parameters: `name`, `sentence`, and `parameters`, a std::array of Parameter<T>.
template <class T>
concept Declared = requires {
  { T::name } -> std::convertible_to<std::string_view>;
  { T::sentence } -> std::convertible_to<std::string_view>;
  T::parameters()[0].member;
};

/// Throws InputError where a declared parameter of `value` is outside its range.
template <Declared T>
void check_parameters(const T& value) {
  for (const Parameter<T>& p : T::parameters())
    if (!p.allows(value.*(p.member)))
      throw InputError(
          fmt::format("{}: {} is {:g} {}, must be {}", T::name, p.name, value.*(p.member), p.unit, p.range()));
}

/// "frictional{kn=1e+08 Pa/m, ...}": the values in use, for results and messages.
template <Declared T>
std::string describe(const T& value) {
  std::string text = fmt::format("{}{{", T::name);
  std::string_view gap = "";
  for (const Parameter<T>& p : T::parameters()) {
    text += fmt::format("{}{}={:g}", gap, p.name, value.*(p.member));
    if (p.unit != "1") text += fmt::format(" {}", p.unit);
    gap = ", ";
  }
  return text + "}";
}

/// A compile-time list of types. Each folder's list.hpp has one row per law.
template <class... Ts>
struct TypeList {
  static constexpr int size = sizeof...(Ts);
  /// A value of one of the types; VariantOrNone may also be empty, which is its first alternative.
  using Variant = std::variant<Ts...>;
  using VariantOrNone = std::variant<std::monostate, Ts...>;
  /// Calls f.template operator()<T>() for every T in order.
  template <class F>
  static constexpr void for_each(F&& f) {
    (f.template operator()<Ts>(), ...);
  }
  /// True if f.template operator()<T>() is true for every T.
  template <class F>
  static constexpr bool all(F&& f) {
    return (f.template operator()<Ts>() && ...);
  }
  /// Calls f.template operator()<T>() for the T at index `place`, which is below size.
  template <class F>
  static decltype(auto) at(std::size_t place, F&& f) {
    return pick<F, Ts...>(place, f);
  }

 private:
  template <class F, class First, class... Rest>
  static decltype(auto) pick(std::size_t place, F& f) {
    if constexpr (sizeof...(Rest) > 0)
      if (place != 0) return pick<F, Rest...>(place - 1, f);
    return f.template operator()<First>();
  }
};

}  // namespace trilith
