// Cases of a study: a product of values, a list, or samples.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace trilith {

/// A parameter's value in one case: a number (in the parameter's unit), a text or a flag.
using StudyValue = std::variant<double, std::string, bool>;

/// The shortest text that reads back as the same value: "0.1", "rocking", "true".
std::string text_of(const StudyValue& value);

struct StudyParameter {
  std::string name;
  std::string unit;                ///< unit of its numbers; "": the unit that its script declares, or none
  std::vector<StudyValue> values;  ///< at least one
};

/// The cases of a study: the same parameters in each.
struct StudyPlan {
  std::vector<std::string> names, units;       ///< [parameter]
  std::vector<std::vector<StudyValue>> cases;  ///< [case][parameter]

  /// "mu=0.4": as on the command line of the case's script, with the unit if there is one.
  [[nodiscard]] std::string argument(std::size_t index, std::size_t parameter) const;
  /// "mu=0.4, copy=2"
  [[nodiscard]] std::string label(std::size_t index) const;
};

/// Distribution of the samples of a parameter.
struct StudySpread {
  enum class Kind { uniform, log_uniform, normal, log_normal };
  std::string name, unit;
  Kind kind = Kind::uniform;
  /// uniform, log_uniform: least and most (log_uniform: above 0). normal: mean and standard deviation. log_normal:
  /// median (above 0) and standard deviation of the natural logarithm.
  double first = 0, second = 1;
};

/// Every combination of values; the last parameter varies fastest. Throws InputError for a parameter without values, a
/// duplicate name, the name of a table column, and more than 1,000,000 cases.
StudyPlan product_plan(const std::vector<StudyParameter>& parameters);

/// The cases one by one: all parameters have the same number of values. Throws InputError as above.
StudyPlan list_plan(const std::vector<StudyParameter>& parameters);

/// Latin hypercube samples (McKay, Beckman and Conover 1979): each parameter has one value in each of `count` intervals
/// of equal probability, in its own random order. The same seed gives the same samples. Throws InputError as above.
StudyPlan sampled_plan(const std::vector<StudySpread>& spreads, int count, std::uint64_t seed);

/// Throws InputError if `parameter` is not in the plan, or has a value that is not a number.
void require_rising(const StudyPlan& plan, const std::string& parameter);

/// Groups of cases that differ in `parameter` alone, each from the lowest value up; "": each case is a group. The
/// groups are in the order of their first cases.
std::vector<std::vector<std::size_t>> rising_chains(const StudyPlan& plan, const std::string& parameter);

/// Reserved names for parameters and figures: the columns of the table of a study.
const std::vector<std::string>& study_columns();

}  // namespace trilith
