// Static equilibrium under the model's weight and present loads, without the motion towards it.
//
// F(x) = 0 is solved by Newton's method on steps of pseudo-time h, each from rest:
//
//     M (x' - x) / h^2 = F(x'),      h increases as the residual decreases
//
// Parts without support are held by their mass. If the structure carries the loads, h becomes very large and a step is
// a Newton step for F = 0. This is pseudo-transient continuation (Kelley and Keyes, "Convergence analysis of
// pseudo-transient continuation", SIAM J. Numer. Anal. 35, 1998). Each step is committed, so friction, yielding and
// softening follow the path.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "model/event/event.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "statics/travel.hpp"

namespace trilith {

struct EquilibriumOptions {
  double tolerance = 1e-8;   ///< largest residual force, as a share of the largest force carried
  int shares = 1;            ///< weight and loads are applied in this number of equal shares, each from rest to rest
  double first = 1;          ///< pseudo-time of the first step [s]; it is cut if it is too long
  int most_steps = 1000;     ///< of pseudo-time, for each share
  int most_iterations = 20;  ///< of a step.
  /// Equilibrium is searched near the given configuration. A body that moves farther than this share of its size from
  /// its initial position, rotates as far, or falls by more than its own height ends the search as unstable
  /// (displaced_body).
  double within = usual_travel;
  /// Limit for a body without support, or a deformable body with some support: largest displacement within a load share
  /// over the distance of its farthest point.
  double farthest = 1;
  /// Called at each iteration; the search ends when it returns true, and State remains unchanged. Empty: never stopped.
  std::function<bool()> is_stopped;
};

/// End of the search, in this order: at rest; a body without support has moved too far; no step converges, however
/// short; no rest within most_steps; stopped; a body has left its place.
enum class EquilibriumEnd { rests, goes_off, stuck, unsettled, stopped, unstable };
std::string_view name_of(EquilibriumEnd end);

struct Equilibrium {
  bool converged = false;
  EquilibriumEnd end = EquilibriumEnd::unsettled;
  int iterations = 0;         ///< Newton iterations of all steps, including failed ones
  int steps = 0;              ///< of pseudo-time, committed
  int cuts = 0;               ///< steps that were cut
  double left = 0;            ///< largest residual force, as a share of the largest force carried
  int worst = -1;             ///< node with this residual; if a body moves away, its node with the largest displacement
  Travel travel;              ///< of the body that has left its place, if the end is unstable
  std::vector<Event> events;  ///< of the path to equilibrium
};

/// Brings `state` (at a step border, see StaticTrial) to equilibrium. Time does not advance and velocities are 0. The
/// energy dissipated along the path is booked as `rest_damping`. Without an equilibrium State remains unchanged, to the
/// bit. The stability of equilibria is not checked. Throws InputError for options out of range and if a push
/// (model/loads.hpp) controls a displacement.
template <int D>
Equilibrium find_equilibrium(const Model<D>& model, State<D>& state, const EquilibriumOptions& options = {});

}  // namespace trilith
