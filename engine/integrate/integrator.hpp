// The members of a scheme of time integration. A scheme is one file with these members and one row of
// integrate/list.hpp.
//
//   name, sentence    its name in scripts (`integrator = "name"`), and its description
//   velocities        times of the velocities in State. The energy ledger (energy_now), the rates that laws receive,
//                     and the change from and to other schemes (begin_implicit, begin_explicit) follow from it.
//   bound             limit of its steps: stability, or an error that it controls itself
//   step(input)       one step
//   parameters()      optional: its numbers in scripts, as for laws (base/schema.hpp)
#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <string_view>

#include "assembly/step_options.hpp"
#include "assembly/step_times.hpp"
#include "model/energy.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

template <int D>
class Tangent;

/// Instant to which velocities refer. Staggered: half a step before the positions (leapfrog). Collocated: the instant
/// of the positions; State then also keeps the accelerations and the start of the last step, and State::implicit() is
/// true.
enum class VelocityTimes { staggered, collocated };
template <int D>
VelocityTimes velocity_times(const State<D>& state) {
  return state.implicit() ? VelocityTimes::collocated : VelocityTimes::staggered;
}

/// Stability: the step is at most a share of the longest stable one, and impacts, breaking bonds, and bodies that could
/// pass through each other shorten it (integrate/explicit). Accuracy: the scheme shortens its steps itself.
enum class StepBound { stability, accuracy };

/// Limits of a scheme that controls its error.
struct StepControl {
  double tolerance = 1e-8;  ///< largest residual force, as a share of the largest force carried
  double accuracy = 0;      ///< allowed energy error of a step, as a share of the kinetic and stored energy; 0: any
  double shortest = 0;      ///< errors shorten no step below this length [s]
  double give_up = 0;       ///< the step fails rather than become shorter than this [s]
  /// Called at each iteration; the step ends when it returns true. nullptr or empty: never stopped.
  const std::function<bool()>* is_stopped = nullptr;
};

/// An instant that has been evaluated and committed, and the step from there.
template <int D>
struct StepInput {
  const Model<D>& model;
  State<D>& state;
  Work<D>& work;
  Tangent<D>& tangent;  ///< kept from step to step
  Energy energy;        ///< ledger at the instant, with collocated velocities
  double dt;            ///< length of the step; the largest one for a scheme that controls its error [s]
  RestDamping rest;
  StepControl control;
  StepTimes* times;
};

/// Result of a step. State is then at its end; after a failed step it is unchanged.
struct StepResult {
  bool done = true;
  double dt = 0;       ///< length of the step, or of the last attempt [s]
  std::string reason;  ///< if it failed: the reason, the place, and advice; empty if it was stopped
};

template <class I>
concept Integrator = requires(const I& scheme, const StepInput<2>& plane, const StepInput<3>& space) {
  { I::name } -> std::convertible_to<std::string_view>;
  { I::sentence } -> std::convertible_to<std::string_view>;
  { I::velocities } -> std::convertible_to<VelocityTimes>;
  { I::bound } -> std::convertible_to<StepBound>;
  { scheme.step(plane) } -> std::same_as<StepResult>;
  { scheme.step(space) } -> std::same_as<StepResult>;
};

}  // namespace trilith
