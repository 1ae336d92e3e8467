// Time step for bonds that break. The step is short enough for its work to match the fracture energy of the law.
//
// Explicit steps are predicted. If a bond reaches its peak within the step, the step ends there. Along the softening
// line a step opens the bond by a share of its last opening (law/contact/bond_curve.hpp). Implicit steps are checked
// after convergence and are halved if a bond has missed too much of its work. The allowed error is a share of the
// fracture energy. Between fast bodies it grows with the kinetic energy of their relative motion, up to 2 %.
//
// The explicit prediction checks all bonds. It repeats the full check only when the fastest bond may have reached the
// vicinity of its peak. Intact walls therefore cost one comparison per step and a full check from time to time.
#pragma once

#include <limits>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Bound of the motion of all bonds until the next full check. The step length does not depend on when checks occur, so
/// this is not part of State.
struct BondRoom {
  double room = 0;    ///< least distance of any bond to its peak [m]
  double speed = 0;   ///< largest rate of any bond; after the check an upper bound [m/s]
  double way = 0;     ///< opening in one step that needs no check [m]
  bool none = false;  ///< the model has no bonds
  bool near = false;  ///< at the last call some bond could come near its peak within the step
  bool fresh = true;  ///< no check since the last reset

  /// Forces a check at the next call, after a change of the model, the state or its pairs.
  void reset() { *this = {}; }
};

/// `dt` [s], or a shorter step that the bonds require. The result depends on the last evaluation and on jumps of
/// prescribed velocities within the step (integrate/explicit/drive_jumps.hpp).
template <int D>
double bond_step(const Model<D>& model, const State<D>& state, const Work<D>& work, double dt, BondRoom& room);

/// Largest missed work of any bond in the last evaluated implicit step, as a share of the allowed error. The step is
/// too long if the value is above 1.
template <int D>
double bond_miss(const Model<D>& model, const State<D>& state, const Work<D>& work, double dt);

/// Largest value of bond_miss at which a step is accepted that cannot be halved further.
inline constexpr double largest_bond_miss = 10;

}  // namespace trilith
