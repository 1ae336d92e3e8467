// Terms of the spin of a body of one element, see rotary_inertia.hpp.
#pragma once

#include "assembly/element/rotary_inertia.hpp"

namespace trilith {

template <int D>
struct SpinTerms {
  TurnVector<D> spin;    ///< s [rad/s]
  TurnVector<D> rate;    ///< k [rad/s2]
  NodeVectors<D> force;  ///< f_s [N]

  /// From the angular momentum of the lumped masses, if J is a multiple of Jl.
  SpinTerms(const RotaryInertia<D>& of, const TurnVector<D>& momentum);
  /// From the velocities of the nodes [m/s].
  SpinTerms(const RotaryInertia<D>& of, const NodeVectors<D>& velocity);
};

/// T' D v of a body. velocity(i): of its node i.
template <int D, class Velocity>
TurnVector<D> angular_momentum(const RotaryInertia<D>& of, Velocity&& velocity) {
  TurnVector<D> sum = TurnVector<D>::Zero();
  for (int i = 0; i < of.nodes.count; ++i) {
    const auto v = velocity(i);
    for (int k = 0; k < D; ++k) sum += of.nodes.mass[i] * v[k] * turn_row(k, of.nodes.arm[i]);
  }
  return sum;
}

}  // namespace trilith
