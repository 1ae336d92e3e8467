// Window of a run that is repeated with half the step (run/step_check.hpp).
#pragma once

namespace trilith {

/// Window of a run [s]. Without a given one it is the last second of the last stage in which a motion acts.
struct StepWindow {
  double from = -1, to = -1;  ///< from below 0: none is given
  [[nodiscard]] bool given() const { return from >= 0; }
};

}  // namespace trilith
