// Points of bonds on their curves: displacement, rate, and displacement before the step.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "law/contact/bond_curve.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// One point of a bond between two bodies.
struct PlacedBond {
  BondCurve curve;
  double at = 0, rate = 0;  ///< displacement [m] and its rate [m/s]; after an implicit step, the mean rate over the
                            ///< step
  double size = 0;          ///< size of the whole joint: length [m], or area in space [m2]
  double share = 1;         ///< of the joint, represented by this place [1]
  int row = -1;             ///< of its pair
  int body_a = -1, body_b = -1;
};

/// Work of one joint that a step has skipped.
struct SkippedBond {
  PlacedBond bond;                                      ///< any place of it
  double missing = 0;                                   ///< [J]
  double most = 0;                                      ///< of any place, as a share of the allowed miss [1]
  double longest = std::numeric_limits<double>::max();  ///< step that would follow the bond [s]
};

/// Reduced mass of two bodies, m_a m_b / (m_a + m_b); 0 if neither moves [kg].
template <int D>
double mass_of_both(const Work<D>& work, const PlacedBond& bond) {
  const double a = work.impacts.mass[bond.body_a], b = work.impacts.mass[bond.body_b];
  return a == 0 ? b : b == 0 ? a : a * b / (a + b);
}

/// Calls f(PlacedBond) for each point of each bond at the evaluated instant. With `after`, the curves are taken at the
/// start of the next step; otherwise those at the start of the last step, of length dt [s].
template <class F>
void each_bond(const Model<2>& model, const State<2>& state, const Work<2>& work, bool after, double dt, F&& f);
template <class F>
void each_bond(const Model<3>& model, const State<3>& state, const Work<3>& work, bool after, double dt, F&& f);

}  // namespace trilith

#include "integrate/explicit/bond_places_plane.hpp"
#include "integrate/explicit/bond_places_space.hpp"
