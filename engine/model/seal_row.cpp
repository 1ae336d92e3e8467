#include "model/seal_row.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/quantity_text.hpp"

namespace trilith {
namespace {

/// A figure of a check: a share as percent, other values with their unit.
std::string figure(double value, const std::string& unit) {
  return unit == "1" ? percent_text(value) : unit.empty() ? fmt::format("{:g}", value) : quantity_text(value, unit);
}

}  // namespace

std::string seal_text(const SealRow& row) {
  if (row.state == "not made") return fmt::format("{}: {}", row.check, row.text);
  const std::string shown =
      fmt::format("{}: {}{}{}", row.check, figure(row.value, row.unit), row.text.empty() ? "" : " ", row.text);
  return row.failed() ? fmt::format("{}, must be at most {}", shown, figure(row.limit, row.unit)) : shown;
}

std::vector<std::string> seal_lines(const std::vector<SealRow>& rows) {
  std::vector<std::string> passed, failed;
  for (const SealRow& row : rows) {
    if (row.failed()) failed.push_back("seal: FAILED: " + seal_text(row));
    if (row.state == "passed") passed.push_back(seal_text(row));
  }
  if (!failed.empty()) return failed;
  return passed.empty() ? passed : std::vector{fmt::format("seal: passed: {}", fmt::join(passed, "; "))};
}

}  // namespace trilith
