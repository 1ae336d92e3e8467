// Repeats a window of a stage with half the step, and compares the positions at its end.
#pragma once

#include <optional>

#include "model/seal_row.hpp"
#include "run/simulation.hpp"
#include "run/step_window.hpp"

namespace trilith {

/// Largest difference of the positions that counts as the same motion, as a share of the largest displacement within
/// the window.
inline constexpr double step_check_limit = 0.05;

template <int D>
class StepCheck {
 public:
  /// For a stage with these options, which begins at this instant of the simulation.
  StepCheck(const StepWindow& asked, const StageOptions& options, const Simulation<D>& at);

  /// Call it at every step border, and at the start of the stage. Keeps the instants at the ends of the window.
  void look(Simulation<D>& now);
  /// After the stage: repeats the window. Handlers of the script are not called. No row if the stage did not reach it.
  [[nodiscard]] std::optional<SealRow> repeat(Simulation<D>& ended);

 private:
  double from_, to_;  // [s]
  std::optional<Snapshot<D>> begin_;
  std::optional<State<D>> end_;
};

}  // namespace trilith
