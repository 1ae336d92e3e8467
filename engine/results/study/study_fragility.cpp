#include "results/study/study_fragility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.hpp"

namespace trilith::results {
namespace {

/// "record=a.csv, seed=2": all parameters with several values, except `over`.
std::string record_name(const std::vector<const StudyColumn*>& others, std::size_t row) {
  std::string name;
  for (const StudyColumn* c : others)
    name += fmt::format("{}{}={}", name.empty() ? "" : ", ", c->name, study_text(*c, row));
  return name;
}

bool varies(const StudyColumn& column, std::size_t rows) {
  for (std::size_t i = 1; i < rows; ++i)
    if (study_text(column, i) != study_text(column, 0)) return true;
  return false;
}

bool passed_any_over(const std::vector<StudyColumn>& columns) {
  for (const StudyColumn& c : columns)
    if (const auto* texts = std::get_if<std::vector<std::string>>(&c.values); texts != nullptr && c.name == "status")
      return std::find(texts->begin(), texts->end(), "passed over") != texts->end();
  return false;
}

/// Between the highest intensity below the first one with the outcome, and that one; unbounded without an outcome.
CapacityBounds capacity_of(const RecordCases& record, const std::vector<double>& x, const std::vector<Holds>& holds) {
  CapacityBounds bounds{0, std::numeric_limits<double>::infinity()};
  for (const std::size_t row : record.rows) {
    if (holds[row] == Holds::yes) return {bounds.low, x[row]};
    if (holds[row] == Holds::no) bounds.low = x[row];
  }
  return bounds;
}

bool says_something(const CapacityBounds& b) {
  return b.low > 0 || std::isfinite(b.high);
}

}  // namespace

std::vector<RecordCases> cases_by_record(const std::vector<StudyColumn>& columns, const std::string& over) {
  const StudyNames names = study_names(columns);
  const std::vector<double>& x = study_numbers(study_column(columns, over, names.parameters, "parameter"));
  std::vector<const StudyColumn*> others;
  for (const std::string& name : names.parameters)
    if (const StudyColumn& c = study_column(columns, name, names.parameters, "parameter");
        name != over && varies(c, x.size()))
      others.push_back(&c);
  std::vector<RecordCases> records;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::string name = record_name(others, i);
    auto record = std::find_if(records.begin(), records.end(), [&](const RecordCases& r) { return r.name == name; });
    if (record == records.end()) record = records.insert(records.end(), {name, {}});
    record->rows.push_back(i);
  }
  for (RecordCases& r : records)
    std::stable_sort(r.rows.begin(), r.rows.end(), [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
  return records;
}

StudyFragility study_fragility(const std::vector<StudyColumn>& columns, const std::string& condition,
                               const std::string& over) {
  const std::vector<Holds> holds = condition_of_cases(columns, condition);
  const std::vector<RecordCases> records = cases_by_record(columns, over);
  const StudyColumn& column = study_column(columns, over, study_names(columns).parameters, "parameter");
  const std::vector<double>& x = study_numbers(column);
  StudyFragility f{over, column.unit, passed_any_over(columns), {}, {}};
  std::vector<CapacityBounds> bounds;
  std::map<double, Tally> stripes;
  for (const double v : x) stripes[v];
  if (f.incremental) {
    for (const RecordCases& record : records) {
      const CapacityBounds capacity = capacity_of(record, x, holds);
      if (!says_something(capacity)) continue;
      bounds.push_back(capacity);
      for (auto& [value, tally] : stripes)
        if (value <= capacity.low || value >= capacity.high) tally.add(value >= capacity.high ? Holds::yes : Holds::no);
    }
  } else {
    for (std::size_t i = 0; i < x.size(); ++i) {
      stripes[x[i]].add(holds[i]);
      if (holds[i] == Holds::yes) bounds.push_back({0, x[i]});
      if (holds[i] == Holds::no && x[i] > 0) bounds.push_back({x[i], std::numeric_limits<double>::infinity()});
    }
  }
  for (const auto& [value, tally] : stripes)
    if (tally.count > 0) f.stripes.push_back({value, tally});
  f.curve = fit_fragility(bounds);
  return f;
}

std::string fragility_text(const StudyFragility& f) {
  const Confidence median = f.curve.median_interval();
  const std::string unit = f.unit.empty() || f.unit == "1" ? "" : " " + f.unit;
  return fmt::format("median {:.4g}{} (95 % {:.4g} to {:.4g}), dispersion {:.3g}, of {} {}", f.curve.median, unit,
                     median.low, median.high, f.curve.dispersion, f.curve.count, f.incremental ? "records" : "cases");
}

}  // namespace trilith::results
