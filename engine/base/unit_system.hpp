// Units in which numbers are shown: a unit of force and a unit of length, such as "kN m", with the second and the
// radian.
//
// The engine and its results files are in SI. Programs that show results convert them by a UnitSystem. The unit of mass
// follows: force s2/length.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace trilith {

/// Units of a system in messages: the allowed text and examples.
inline constexpr std::string_view system_example =
    "a unit of force and a unit of length, such as \"kN m\", \"N mm\" or \"kip ft\"";

class UnitSystem {
 public:
  /// SI, with its engineering prefixes: nothing is converted.
  UnitSystem() = default;
  /// A unit of force and a unit of length in either order; an "s" may follow. "SI" and "" are SI. Messages of the
  /// InputError begin with `what`, if it is given.
  explicit UnitSystem(std::string_view text, std::string_view what = "units");

  [[nodiscard]] bool is_si() const { return text_.empty(); }
  /// As given; "" for SI.
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::string& force() const { return force_name_; }    ///< name; "" for SI
  [[nodiscard]] const std::string& length() const { return length_name_; }  ///< name; "" for SI

  /// The unit of this system for a quantity in `unit`, such as "kN/m2" for "Pa", and its SI value.
  struct Named {
    double factor;
    std::string name;
  };
  /// Nothing for SI, for units that do not depend on force and length (s, Hz, rad, 1), for units that are not
  /// coherent with SI (g, degC), and for unknown ones: these are shown as they are.
  [[nodiscard]] std::optional<Named> unit_for(std::string_view unit) const;
  /// Name of the unit; `unit` itself where unit_for has nothing.
  [[nodiscard]] std::string name(std::string_view unit) const;
  /// `value`, in `unit`, in this system. Powers of ten are exact to the last bit of one product or quotient.
  [[nodiscard]] double shown(double value, std::string_view unit) const;
  /// `text` with each number that has an SI unit, such as "0.5 m" or "12 kN", converted with the same number of
  /// digits, at least three.
  [[nodiscard]] std::string message(std::string_view text) const;

 private:
  std::string text_, force_name_, length_name_;
  double force_ = 1, length_ = 1;
};

}  // namespace trilith
