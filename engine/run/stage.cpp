#include "run/stage.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace trilith {
namespace {

/// Largest share of the longest stable step. Above it impacts have energy errors of 20 %.
constexpr double longest_safety = 0.9;

void require_valid_scaling(const StageOptions& o, const std::string& owner) {
  if (!o.mass_scaling) return;
  require_positive(o.mass_scaling->step, owner + ": mass_scaling: step", "s");
  require_positive(o.mass_scaling->most, owner + ": mass_scaling: most", "1");
  if (o.dt > 0)
    throw InputError(
        fmt::format("{}: dt is {:g} s and mass_scaling has a step of {:g} s; leave dt out; mass_scaling sets the step",
                    owner, o.dt, o.mass_scaling->step));
  if (bound_of(o.integrator) == StepBound::accuracy)
    throw InputError(owner + ": mass_scaling is for explicit steps; implicit steps do not need it; keep one");
}

}  // namespace

void require_valid(const StageOptions& o) {
  const std::string owner = fmt::format("stage '{}'", o.name);
  require_positive(o.duration, owner + ": duration", "s");
  require_not_negative(o.dt, owner + ": dt", "s");
  if (!(o.safety > 0 && o.safety <= longest_safety))
    throw InputError(
        fmt::format("{}: safety is {:g}, must be above 0 and at most {:g}: close to 1 a step is stable but too coarse "
                    "to conserve energy",
                    owner, o.safety, longest_safety));
  if (!(o.rest_share >= 0 && o.rest_share < 1))
    throw InputError(fmt::format("{}: local_damping is {:g}, must be at least 0 and below 1", owner, o.rest_share));
  if (bound_of(o.integrator) == StepBound::accuracy && o.rest_share > 0)
    throw InputError(
        fmt::format("{}: damping is {:g}, which is for explicit steps; leave it out, or use integrator = \"explicit\"",
                    owner, o.rest_share));
  require_valid_scaling(o, owner);
  for (const double v : {o.frame_interval, o.history_interval, o.energy_interval})
    require_not_negative(v, owner + ": interval", "s");
  if (o.until_rest) {
    require_positive(o.still_speed, owner + ": speed at rest", "m/s");
    require_positive(o.still_ratio, owner + ": unbalanced ratio at rest", "");
    require_not_negative(o.still_hold, owner + ": hold", "s");
  }
}

}  // namespace trilith
