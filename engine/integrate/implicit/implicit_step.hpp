// A step of an implicit scheme (assembly/alpha_scheme.hpp): Newton's method finds the positions at its end. Rotation of
// nodes in space: assembly/implicit_turn.hpp.
#pragma once

#include <cstdint>
#include <functional>

#include "assembly/alpha_scheme.hpp"
#include "assembly/step_times.hpp"
#include "assembly/tangent/tangent.hpp"

namespace trilith {

struct ImplicitOptions {
  AlphaScheme scheme = AlphaScheme::hht(-0.05);
  double dt = 0;            ///< largest length of this step [s]
  double tolerance = 1e-8;  ///< largest residual force, as a share of the largest force carried.
  /// Error limits beyond which a step is halved: the energy error as a share of the kinetic and stored energy, and half
  /// of this value for the error of the velocities. 0: no limit.
  double accuracy = 0;
  double shortest = 0;  ///< errors halve no step below this length, as shares of small energies are arbitrary [s]
  double give_up = 0;   ///< no step is halved below this length for any reason; the step then fails [s]
  int most_iterations = 30;
  const std::function<bool()>* is_stopped = nullptr;  ///< see StepControl
  [[nodiscard]] bool stopped() const { return is_stopped != nullptr && *is_stopped && (*is_stopped)(); }
};

/// Result of a step.
struct ImplicitStep {
  bool converged = false;
  bool stopped = false;                ///< at the request of ImplicitOptions::is_stopped
  int iterations = 0;                  ///< sum over all attempts
  int cuts = 0;                        ///< number of halvings
  double dt = 0;                       ///< length of the accepted step [s]
  double left = 0;                     ///< residual force, as a share of the largest force carried
  double missed = 0;                   ///< see ImplicitOptions::accuracy
  int worst = -1;                      ///< node with the largest residual
  int through_a = -1, through_b = -1;  ///< pieces that would have passed through each other in the last attempt; -1:
                                       ///< none
};

/// Converts a state of explicit steps into a state of an implicit scheme, or back. `work` is evaluated and committed at
/// this instant. The velocities then refer to the instant, and the ledger is complete up to it.
template <int D>
void begin_implicit(const Model<D>& model, State<D>& state, const Work<D>& work);
template <int D>
void begin_explicit(const Model<D>& model, State<D>& state, const Work<D>& work);

/// Takes one step from an instant that has been evaluated and committed, with the ledger `energy`. The step is halved
/// if it does not converge, and if bodies would pass through each other (integrate/explicit/tunnelling.hpp). If the
/// step fails, State remains unchanged. Otherwise `work` is evaluated at the end of the step and not committed.
/// State::dt is the step to try next, at most options.dt.
template <int D>
ImplicitStep advance_implicitly(const Model<D>& model, State<D>& state, Work<D>& work, const Energy& energy,
                                Tangent<D>& tangent, const ImplicitOptions& options, StepTimes* times = nullptr);

/// Kinetic energy of an implicit state, whose velocities refer to the instant [J].
template <int D>
double implicit_kinetic(const Model<D>& model, const State<D>& state);

/// Energy ledger of an implicit state at the instant of the last evaluation.
template <int D>
Energy implicit_energy(const Model<D>& model, const State<D>& state, const Work<D>& work);

}  // namespace trilith
