// Mass, momentum, angular momentum and kinetic energy of a model, in the plane and in space: quantities that a split
// conserves.
#pragma once

#include <vector>

#include "assembly/element/rotary_inertia.hpp"
#include "base/space.hpp"
#include "run/simulation.hpp"

namespace trilith::testing {

/// Sums over the nodal masses of all bodies that are present.
template <int D>
struct PresentMotion {
  double mass = 0, kinetic = 0;
  Vec<D> momentum = Vec<D>::Zero(), first = Vec<D>::Zero();  ///< [N s], [kg m]
  Spin<D> angular = nothing<Spin<D>>();
};
template <int D>
PresentMotion<D> motion_of_present(const Simulation<D>& sim) {
  const Model<D>& model = sim.model();
  const State<D>& s = sim.state();
  PresentMotion<D> sum;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (s.left[b] != 0) continue;
    const auto from = static_cast<std::size_t>(model.bodies[b].first_node);
    for (std::size_t n = from; n < from + static_cast<std::size_t>(model.bodies[b].nodes); ++n) {
      const double m = model.mass[n];
      sum.mass += m, sum.momentum += m * s.velocity[n], sum.first += m * s.position[n];
      sum.angular += cross(s.position[n], Vec<D>(m * s.velocity[n]));
      sum.kinetic += 0.5 * m * s.velocity[n].squaredNorm();
    }
  }
  return sum;
}

/// Sums over all nodes by the mass matrix of the equation of motion.
template <int D>
struct WholeMotion {
  Vec<D> momentum = Vec<D>::Zero();
  Spin<D> angular = nothing<Spin<D>>();
  double kinetic = 0;
};
template <int D>
WholeMotion<D> whole_motion(const Simulation<D>& sim) {
  const Model<D>& model = sim.model();
  const State<D>& s = sim.state();
  std::vector<Dofs<D>> v(model.mass.size(), Dofs<D>{}), p(model.mass.size(), Dofs<D>{});
  for (std::size_t n = 0; n < v.size(); ++n)
    for (int k = 0; k < D; ++k) v[n][static_cast<std::size_t>(k)] = s.velocity[n][k];
  add_rotary_momentum(model, s, v, p);
  WholeMotion<D> sum;
  for (std::size_t n = 0; n < v.size(); ++n) {
    Vec<D> own = model.mass[n] * s.velocity[n];
    for (int k = 0; k < D; ++k) own[k] += p[n][static_cast<std::size_t>(k)];
    sum.momentum += own, sum.angular += cross(s.position[n], own), sum.kinetic += 0.5 * own.dot(s.velocity[n]);
  }
  return sum;
}

}  // namespace trilith::testing
