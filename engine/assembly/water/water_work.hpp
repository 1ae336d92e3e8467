// Work of water in the ledger: it is summed with all loads, and then moved to its own term.
#pragma once

#include <vector>

#include "assembly/node_forces.hpp"

namespace trilith {

/// Forces of water on the nodes at an instant; empty without water.
template <int D>
struct WaterForces {
  const std::vector<Vec<D>>& force;      ///< [node] [N]
  const std::vector<Moment<D>>& moment;  ///< [node] [N m]
};

/// Moves their work along path_of(node) on the free directions from the loads to the water.
template <int D, class PathOf>
void book_water(const Model<D>& model, const WaterForces<D>& of, Energy& given, PathOf&& path_of) {
  double sum = 0;
  for (std::size_t i = 0; i < of.force.size(); ++i) {
    const int n = static_cast<int>(i);
    if (of.force[i].isZero(0) && of.moment[i] == nothing<Moment<D>>()) continue;
    const Dofs<D> f = dofs_of(of.force[i], of.moment[i]), path = path_of(n);
    for (std::size_t k = 0; k < f.size(); ++k)
      if (model.support[i][k] == Support::free) sum += f[k] * path[k];
  }
  given[EnergyTerm::load] -= sum, given[EnergyTerm::water] += sum;
}

/// As book_water, along the present velocities for a time `span` [s].
template <int D>
void book_water(const Model<D>& model, const State<D>& state, const Work<D>& work, Energy& given, double span) {
  if (work.water.empty()) return;
  book_water<D>(model, {work.water, work.water_moment}, given, [&](int n) {
    Dofs<D> path = velocity_of(state, n);
    for (double& p : path) p *= span;
    return path;
  });
}

}  // namespace trilith
