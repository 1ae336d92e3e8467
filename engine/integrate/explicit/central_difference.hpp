// Explicit central differences (leapfrog), and the energy ledger of its steps.
#pragma once

#include "integrate/integrator.hpp"

namespace trilith {

/// Advances the state by one step from an instant that has been evaluated and committed.
template <int D>
void advance(const Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options,
             StepTimes* times = nullptr);

/// Energy ledger at the instant of the last evaluation (before `advance`): stored terms from the state, dissipated
/// terms from the running sums. The kinetic energy follows the leapfrog scheme: half of m v(-) v(+).
template <int D>
Energy energy_now(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options);

struct CentralDifference {
  static constexpr std::string_view name = "explicit";
  static constexpr std::string_view sentence = "central differences (leapfrog)";
  static constexpr VelocityTimes velocities = VelocityTimes::staggered;
  static constexpr StepBound bound = StepBound::stability;

  template <int D>
  [[nodiscard]] StepResult step(const StepInput<D>& input) const;
};

}  // namespace trilith
