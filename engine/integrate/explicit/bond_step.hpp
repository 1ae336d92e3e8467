// The time step for bonds that break: so short that the work of the step is the fracture energy of the law.
//
// Explicit steps are predicted. A bond that reaches its peak within the step ends the step there; along the softening
// line a step opens it by a share of its last opening (law/contact/bond_curve.hpp). Implicit steps are measured when
// they have converged, and cut where a bond has missed too much of its work. A bond may miss a share of its fracture
// energy, or of the kinetic energy of its two bodies against each other where that is far larger.
//
// The explicit prediction looks at all bonds, and then not again before the fastest of them can have come near its
// peak: intact walls pay for one comparison a step and a look every now and then.
#pragma once

#include <limits>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// How far the bonds can go until the next look at them. Any look gives the same step: it is no part of State.
struct BondRoom {
  double room = 0;    ///< least way of any bond to its peak [m]
  double speed = 0;   ///< largest rate of any bond, and since the look an upper bound [m/s]
  double way = 0;     ///< in one step any bond may go so far without a look [m]
  bool none = false;  ///< the model has no bonds

  /// Looks at the next call: the model, the state or its pairs were changed.
  void reset() { *this = {}; }
};

/// `dt` [s], or the part of it that is short enough for the bonds. From the last evaluation, and nothing else.
template <int D>
double bond_step(const Model<D>& model, const State<D>& state, const Work<D>& work, double dt, BondRoom& room);

/// How much of its work a bond has missed in the implicit step evaluated last, as a share of the allowed miss: the
/// largest of all bonds. Above 1 the step is too long.
template <int D>
double bond_miss(const Model<D>& model, const State<D>& state, const Work<D>& work, double dt);

/// A miss up to which a step that cannot be cut any more is taken.
inline constexpr double largest_bond_miss = 10;

}  // namespace trilith
