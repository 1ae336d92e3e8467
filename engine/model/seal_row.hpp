// One check of the seal of a run, as the results file stores it.
#pragma once

#include <string>
#include <vector>

namespace trilith {

/// The check that fails by an event of its own, body.passed.
inline constexpr const char* penetration_check = "deepest penetration";

struct SealRow {
  std::string check;  ///< "energy balance", ...
  std::string state;  ///< "passed", "failed", or "not made" where the run has nothing to check
  double value = 0;   ///< the worst of the run
  double limit = 0;   ///< it may be at most this; 0: no limit
  std::string unit;
  std::string text;        ///< in a few words
  double valid_until = 0;  ///< of a failed check: start of the stage at whose end it failed [s]

  [[nodiscard]] bool failed() const { return state == "failed"; }
};

/// "energy balance: 12 % of the input, must be at most 10 %"
std::string seal_text(const SealRow& row);
/// The lines for the terminal: one with all figures if all checks passed, otherwise one for each that failed.
std::vector<std::string> seal_lines(const std::vector<SealRow>& rows);

}  // namespace trilith
