// The state of rest under the model's weight and loads of the present time, without a motion that leads there.
//
// F(x) = 0 is solved by Newton's method on steps of pseudo-time h, each from rest:
//
//   M (x' - x) / h^2 = F(x'),      h growing as less is left over
//
// so that what nothing holds yet is held by its mass, and where the structure carries, h is as good as endless and a
// step is one of Newton's for F = 0: pseudo-transient continuation (Kelley and Keyes, "Convergence analysis of
// pseudo-transient continuation", SIAM J. Numer. Anal. 35, 1998). Each step is committed, so friction, yielding and
// softening follow the way.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "model/event.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "statics/travel.hpp"

namespace trilith {

struct EquilibriumOptions {
  double tolerance = 1e-8;   ///< largest force left over, as a share of the largest one carried
  int shares = 1;            ///< weight and loads are brought on in so many equal shares, each from rest to rest
  double first = 1;          ///< pseudo-time of the first step [s]; it is cut where that is too long
  int most_steps = 1000;     ///< of pseudo-time, for each share
  int most_iterations = 20;  ///< of a step
  /// Equilibrium is looked for near the given configuration: a body that goes farther than this share of its size from
  /// where the search began, turns as far, or falls by more than its own height ends it as unstable (displaced_body).
  double within = usual_travel;
  /// Likewise one that nothing holds up, or that deforms and is held somewhere, and goes farther than this share of the
  /// distance of its farthest point within a share of the loads.
  double farthest = 1;
  /// Asked at each iteration: once it says true the search ends, and State is as it was. Empty: it goes on.
  std::function<bool()> is_stopped;
};

/// How the search ended: at rest; a body that nothing held has gone too far; no step of pseudo-time however short
/// converges; no rest within the most steps; it was stopped; a body has left its place.
enum class EquilibriumEnd { rests, goes_off, stuck, unsettled, stopped, unstable };
std::string_view name_of(EquilibriumEnd end);

struct Equilibrium {
  bool converged = false;
  EquilibriumEnd end = EquilibriumEnd::unsettled;
  int iterations = 0;         ///< Newton's, of all steps, failed ones too
  int steps = 0;              ///< of pseudo-time, committed
  int cuts = 0;               ///< steps that were cut short
  double left = 0;            ///< largest force left over, as a share of the largest one carried
  int worst = -1;             ///< the node where that is; where a body goes off, its node that went farthest
  Travel travel;              ///< of the body that has left its place, where the end is unstable
  std::vector<Event> events;  ///< of the way there
};

/// Brings `state` (at a step border, see StaticTrial) to rest. Time does not go on; velocities are 0; the energy that
/// the way gave off is booked as `rest_damping`. Where there is no rest to be found State is as it was, to the bit.
/// Equilibria are not asked whether they are stable where they are found. Throws InputError for options out of range
/// and where a push (model/loads.hpp) controls a displacement.
template <int D>
Equilibrium find_equilibrium(const Model<D>& model, State<D>& state, const EquilibriumOptions& options = {});

}  // namespace trilith
