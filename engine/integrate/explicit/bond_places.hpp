// The places of all bonds along their curves: where they are, how fast they go, and where they were before the step.
#pragma once

#include <algorithm>
#include <cmath>

#include "law/contact/bond_curve.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// One place of a bond between two bodies.
struct PlacedBond {
  BondCurve curve;
  double at = 0, rate = 0;  ///< displacement [m] and its rate [m/s]; after an implicit step the mean rate over it
  double size = 0;          ///< of the whole joint: its length [m], in space its area [m2]
  int body_a = -1, body_b = -1;
};

/// Mass of two bodies against each other, m_a m_b / (m_a + m_b); 0 where neither moves [kg].
template <int D>
double mass_of_both(const Work<D>& work, const PlacedBond& bond) {
  const double a = work.impacts.mass[bond.body_a], b = work.impacts.mass[bond.body_b];
  return a == 0 ? b : b == 0 ? a : a * b / (a + b);
}

/// Calls f(PlacedBond) for every place of every bond at the evaluated instant; `after`: as the step ahead begins. Else
/// with the curves that the step behind began with, for a step of length dt [s].
template <class F>
void each_bond(const Model<2>& model, const State<2>& state, const Work<2>& work, bool after, double dt, F&& f);
template <class F>
void each_bond(const Model<3>& model, const State<3>& state, const Work<3>& work, bool after, double dt, F&& f);

}  // namespace trilith

#include "integrate/explicit/bond_places_plane.hpp"
#include "integrate/explicit/bond_places_space.hpp"
