// Nodal forces and the resulting accelerations over the next step.
#pragma once

#include "assembly/node_forces.hpp"

namespace trilith {

/// Force along axis k of node n, and acceleration of driven nodes.
template <int D>
class NodeMotions {
 public:
  NodeMotions(const Model<D>& model, const State<D>& state, const Work<D>& work, const StepOptions& options)
      : model_(model), state_(state), work_(work), options_(options), outside_(model, state, work) {}
  [[nodiscard]] NodeForces<D> forces(int n) const {
    return node_forces(model_, state_, work_, n, velocity_of(state_, n), outside_, options_.rest);
  }
  /// Force along the axes on a node that is free along all of them.
  [[nodiscard]] Vec<D> free_force(int n) const {
    if (D == 3 || outside_.correction != nullptr) return along_of(forces(n).force);
    const Vec<D>& on = work_.force[n];
    Vec<D> sum = on;
    if constexpr (D == 2) sum += PlaneDamping(model_, n, state_.velocity[n], on, options_.rest).force();
    if (!work_.added_inertia.empty()) sum += work_.added_inertia[n];
    return sum;
  }
  [[nodiscard]] double driven(int n, int k) const {
    if (model_.support[n][k] != Support::driven || !(options_.dt > 0)) return 0;
    const double span = 0.5 * (state_.last_dt + options_.dt);
    return (driven_velocity(model_, state_, n, k, options_.dt) - state_.velocity[n][k]) / span;
  }
  [[nodiscard]] Dofs<D> ahead(int n) const {
    const Dofs<D> v = velocity_of(state_, n);
    return speed_ahead(model_, state_, n, v, forces(n), state_.last_dt, options_.dt);
  }

 private:
  const Model<D>& model_;
  const State<D>& state_;
  const Work<D>& work_;
  const StepOptions& options_;
  Outside<D> outside_;
};

}  // namespace trilith
