#include "integrate/implicit/implicit_step.hpp"

#include <algorithm>
#include <utility>

#include "integrate/implicit/implicit_trial.hpp"

namespace trilith {
namespace {

/// Largest number of halvings of a step to converge, to follow the bonds that break in it, and to satisfy the energy
/// limit.
constexpr int most_cuts = 14, most_cuts_for_bonds = 18, most_cuts_for_energy = 7;
/// The next step may be longer if the error is below this share of the limit.
constexpr double well_kept = 0.2;
/// After this number of halvings, an error above `no_better` times the previous error does not depend on the step
/// length: a contact has changed its shape.
constexpr int cuts_that_tell = 4;
constexpr double no_better = 0.6;
/// A step is easy if it converges within this number of iterations; the next may then be longer by `growth`.
constexpr int easy_iterations = 8;
constexpr double growth = 2;

}  // namespace

template <int D>
ImplicitStep advance_implicitly(const Model<D>& model, State<D>& state, Work<D>& work, const Energy& energy,
                                Tangent<D>& tangent, const ImplicitOptions& options, StepTimes* times) {
  ImplicitTrial<D> trial(model, state, work, energy, tangent, options, times);
  ImplicitStep out;
  out.dt = options.dt;
  int most = most_cuts;
  for (; out.cuts <= most && (out.cuts == 0 || out.dt >= options.give_up); ++out.cuts, out.dt *= 0.5) {
    const int before = out.iterations;
    const bool converged = trial.attempt(out.dt, out);
    if (out.stopped) break;
    if (!converged || trial.tunnels(out)) continue;
    // The equation of motion at both ends does not detect a bond that breaks within the step without its work.
    if (trial.bonds_missed() > (out.cuts < most_cuts_for_bonds ? 1 : largest_bond_miss)) {
      most = most_cuts_for_bonds;
      continue;
    }
    const Energy booked = trial.booked();
    const double last = std::exchange(out.missed, options.accuracy > 0 ? trial.missed(booked) : 0);
    const bool gains = out.cuts < cuts_that_tell || out.missed <= no_better * last;
    const bool can_be_cut = out.cuts < most_cuts_for_energy && 0.5 * out.dt >= options.shortest;
    // The tangent is adequate: the step is correct but too long, and is repeated from its start with half the length.
    if (out.missed > options.accuracy && gains && can_be_cut) continue;
    for (std::size_t i = 0; i < booked.value.size(); ++i) state.given.value[i] += booked.value[i];
    ++state.step;
    state.most_energy = std::max(state.most_energy, trial.most_before());
    out.converged = true;
    const bool easy =
        out.cuts == 0 && out.iterations - before <= easy_iterations && out.missed <= well_kept * options.accuracy;
    state.dt = easy ? growth * out.dt : out.dt;
    trial.mark_advance();
    return out;
  }
  trial.give_up();
  work.valid = false;
  return out;
}

template ImplicitStep advance_implicitly(const Model<2>&, State<2>&, Work<2>&, const Energy&, Tangent<2>&,
                                         const ImplicitOptions&, StepTimes*);
template ImplicitStep advance_implicitly(const Model<3>&, State<3>&, Work<3>&, const Energy&, Tangent<3>&,
                                         const ImplicitOptions&, StepTimes*);

}  // namespace trilith
