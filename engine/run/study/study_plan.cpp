#include "run/study/study_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/error.hpp"
#include "base/normal_distribution.hpp"
#include "base/portable.hpp"

namespace trilith {
namespace {

constexpr std::size_t most_cases = 1'000'000;

void check_names(const StudyPlan& plan) {
  if (plan.names.empty()) throw InputError("study: no parameter is given; give at least one with its values");
  for (std::size_t i = 0; i < plan.names.size(); ++i) {
    const std::string& name = plan.names[i];
    const auto& own = study_columns();
    if (name.empty() || name.find_first_of("= ,/") != std::string::npos)
      throw InputError(fmt::format("study: '{}' cannot name a parameter; use letters, digits and _", name));
    if (std::find(own.begin(), own.end(), name) != own.end())
      throw InputError(fmt::format("study: parameter '{}' has the name of a column of the table; use another", name));
    if (std::find(plan.names.begin() + static_cast<std::ptrdiff_t>(i) + 1, plan.names.end(), name) != plan.names.end())
      throw InputError(fmt::format("study: parameter '{}' is given twice", name));
  }
}

StudyPlan named_plan(const std::vector<StudyParameter>& parameters) {
  StudyPlan plan;
  for (const StudyParameter& p : parameters) {
    if (p.values.empty()) throw InputError(fmt::format("study: parameter '{}' has no values", p.name));
    for (const StudyValue& v : p.values)
      if (std::holds_alternative<double>(v)) require_finite(std::get<double>(v), "study: parameter '" + p.name + "'");
    plan.names.push_back(p.name);
    plan.units.push_back(p.unit);
  }
  check_names(plan);
  return plan;
}

/// SplitMix64 (Steele, Lea and Flood 2014): the same numbers on any machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ z >> 27) * 0x94d049bb133111ebULL;
    return z ^ z >> 31;
  }
  /// In [0, 1).
  double share() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

double quantile(const StudySpread& s, double p) {
  switch (s.kind) {
    case StudySpread::Kind::uniform:
      return s.first + p * (s.second - s.first);
    case StudySpread::Kind::log_uniform:
      return s.first * portable::pow(s.second / s.first, p);
    case StudySpread::Kind::normal:
      return s.first + s.second * normal_quantile(p);
    case StudySpread::Kind::log_normal:
      return s.first * portable::exp(s.second * normal_quantile(p));
  }
  return s.first;
}

void check_spread(const StudySpread& s) {
  const bool by_range = s.kind == StudySpread::Kind::uniform || s.kind == StudySpread::Kind::log_uniform;
  const bool logarithmic = s.kind == StudySpread::Kind::log_uniform || s.kind == StudySpread::Kind::log_normal;
  require_finite(s.first, "study: samples of '" + s.name + "'");
  require_finite(s.second, "study: samples of '" + s.name + "'");
  if (by_range && !(s.first < s.second))
    throw InputError(fmt::format("study: samples of '{}' go from {:g} to {:g}; the second must be above the first",
                                 s.name, s.first, s.second));
  if (!by_range && !(s.second >= 0))
    throw InputError(
        fmt::format("study: samples of '{}' have the deviation {:g}, must not be below 0", s.name, s.second));
  if (logarithmic && !(s.first > 0))
    throw InputError(fmt::format("study: samples of '{}' have {:g} first, must be above 0", s.name, s.first));
}

}  // namespace

std::string text_of(const StudyValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  return std::get<std::string>(value);
}

std::string StudyPlan::argument(std::size_t index, std::size_t parameter) const {
  const StudyValue& value = cases[index][parameter];
  const std::string& unit = units[parameter];
  const bool with_unit = !unit.empty() && std::holds_alternative<double>(value);
  return names[parameter] + "=" + text_of(value) + (with_unit ? " " + unit : "");
}

std::string StudyPlan::label(std::size_t index) const {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (k > 0) text += ", ";
    text += argument(index, k);
  }
  return text;
}

const std::vector<std::string>& study_columns() {
  static const std::vector<std::string> names{"case", "status", "exit", "seconds", "message", "folder"};
  return names;
}

void require_rising(const StudyPlan& plan, const std::string& parameter) {
  const auto found = std::find(plan.names.begin(), plan.names.end(), parameter);
  if (found == plan.names.end())
    throw InputError(
        fmt::format("study: there is no parameter '{}' for ida; there are {}", parameter, fmt::join(plan.names, ", ")));
  const std::size_t k = static_cast<std::size_t>(found - plan.names.begin());
  for (const auto& row : plan.cases)
    if (!std::holds_alternative<double>(row[k]))
      throw InputError(fmt::format("study: '{}' is the parameter of ida, but its value '{}' is not a number", parameter,
                                   text_of(row[k])));
}

std::vector<std::vector<std::size_t>> rising_chains(const StudyPlan& plan, const std::string& parameter) {
  const auto rising =
      static_cast<std::size_t>(std::find(plan.names.begin(), plan.names.end(), parameter) - plan.names.begin());
  std::map<std::string, std::size_t> chain_of;  // key: the other parameters
  std::vector<std::vector<std::size_t>> chains;
  for (std::size_t i = 0; i < plan.cases.size(); ++i) {
    std::string others;
    for (std::size_t k = 0; k < plan.names.size(); ++k)
      if (k != rising) others += plan.argument(i, k) + '\n';
    const auto [at, added] = chain_of.emplace(others, chains.size());
    if (added) chains.emplace_back();
    chains[at->second].push_back(i);
  }
  if (rising < plan.names.size())
    for (std::vector<std::size_t>& chain : chains)
      std::stable_sort(chain.begin(), chain.end(), [&](std::size_t a, std::size_t b) {
        return std::get<double>(plan.cases[a][rising]) < std::get<double>(plan.cases[b][rising]);
      });
  return chains;
}

StudyPlan product_plan(const std::vector<StudyParameter>& parameters) {
  StudyPlan plan = named_plan(parameters);
  std::size_t count = 1;
  for (const StudyParameter& p : parameters) {
    if (p.values.size() > most_cases / count)
      throw InputError(fmt::format("study: more than {} cases; give fewer values, or samples", most_cases));
    count *= p.values.size();
  }
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<StudyValue> row(parameters.size());
    std::size_t rest = i;
    for (std::size_t k = parameters.size(); k-- > 0; rest /= parameters[k].values.size())
      row[k] = parameters[k].values[rest % parameters[k].values.size()];
    plan.cases.push_back(std::move(row));
  }
  return plan;
}

StudyPlan list_plan(const std::vector<StudyParameter>& parameters) {
  StudyPlan plan = named_plan(parameters);
  const std::size_t count = parameters[0].values.size();
  for (const StudyParameter& p : parameters)
    if (p.values.size() != count)
      throw InputError(
          fmt::format("study: parameter '{}' has {} values and '{}' has {}; a list of cases needs one of "
                      "each in every case",
                      p.name, p.values.size(), parameters[0].name, count));
  for (std::size_t i = 0; i < count; ++i) {
    plan.cases.emplace_back();
    for (const StudyParameter& p : parameters) plan.cases.back().push_back(p.values[i]);
  }
  return plan;
}

StudyPlan sampled_plan(const std::vector<StudySpread>& spreads, int count, std::uint64_t seed) {
  if (count < 1 || static_cast<std::size_t>(count) > most_cases)
    throw InputError(fmt::format("study: {} samples are asked for, must be 1 to {}", count, most_cases));
  std::vector<StudyParameter> columns;
  Random random(seed);
  const auto n = static_cast<std::size_t>(count);
  for (const StudySpread& s : spreads) {
    check_spread(s);
    std::vector<std::size_t> part(n);
    std::iota(part.begin(), part.end(), std::size_t{0});
    for (std::size_t i = n; i > 1; --i) std::swap(part[i - 1], part[random.next() % i]);
    StudyParameter column{s.name, s.unit, {}};
    for (const std::size_t p : part)
      column.values.emplace_back(quantile(s, (static_cast<double>(p) + random.share()) / count));
    columns.push_back(std::move(column));
  }
  return list_plan(columns);
}

}  // namespace trilith
