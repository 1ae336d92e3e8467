// A step of an implicit scheme (assembly/alpha_scheme.hpp): the place at its end is found by Newton's method. How nodes
// turn in space: assembly/implicit_turn.hpp.
#pragma once

#include <cstdint>

#include "assembly/alpha_scheme.hpp"
#include "assembly/step_times.hpp"
#include "assembly/tangent/tangent.hpp"

namespace trilith {

struct ImplicitOptions {
  AlphaScheme scheme = AlphaScheme::hht(-0.05);
  double dt = 0;            ///< longest length of this step [s]
  double tolerance = 1e-8;  ///< largest force left over, as a share of the largest one carried
  /// What a step may miss, beyond which it is halved: of its energies, as a share of those that move and are stored;
  /// and, by half as much, of its velocities. 0: anything.
  double accuracy = 0;
  double shortest =
      0;  ///< no step is halved below this for what it misses: of next to no energy it may be any share [s]
  double give_up = 0;  ///< no step is halved below this, whatever for: then there is none [s]
  int most_iterations = 30;
};

/// How a step came out.
struct ImplicitStep {
  bool converged = false;
  int iterations = 0;                  ///< of all attempts
  int cuts = 0;                        ///< how often it was halved
  double dt = 0;                       ///< length taken [s]
  double left = 0;                     ///< force left over, as a share of the largest carried one
  double missed = 0;                   ///< see ImplicitOptions::accuracy
  int worst = -1;                      ///< the node where the most is left over
  int through_a = -1, through_b = -1;  ///< pieces that the last attempt would have taken through each other; -1: none
};

/// Makes a state that explicit steps have led to one that an implicit scheme goes on from, or the other way: `work` is
/// evaluated and committed at this instant. Velocities are those of the instant then, and the ledger is up to it.
template <int D>
void begin_implicit(const Model<D>& model, State<D>& state, const Work<D>& work);
template <int D>
void begin_explicit(const Model<D>& model, State<D>& state, const Work<D>& work);

/// Takes one step from an instant that has been evaluated and committed, with the ledger `energy`; halved where it does
/// not converge, and where it would take bodies through each other (integrate/explicit/tunnelling.hpp). Where it fails,
/// State is as it was. `work` is then evaluated at the end of the step, which is not committed. State::dt: the step to
/// try next, at most options.dt.
template <int D>
ImplicitStep advance_implicitly(const Model<D>& model, State<D>& state, Work<D>& work, const Energy& energy,
                                Tangent<D>& tangent, const ImplicitOptions& options, StepTimes* times = nullptr);

/// Kinetic energy of a state that is implicit: its velocities are those of the instant [J].
template <int D>
double implicit_kinetic(const Model<D>& model, const State<D>& state);

/// The ledger at the instant of the last evaluation, of a state that is implicit.
template <int D>
Energy implicit_energy(const Model<D>& model, const State<D>& state, const Work<D>& work);

}  // namespace trilith
