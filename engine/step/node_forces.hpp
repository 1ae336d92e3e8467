// Forces of one node at an instant and the velocity they lead to: what a step, its ledger and the pushes share.
#pragma once

#include <array>
#include <cmath>

#include "step/central_difference.hpp"

namespace trilith {

/// One number for each degree of freedom of a node: x, y, rotation. Plain doubles: this is run for every node at every
/// step, and vectors of two go through memory.
using Dofs = std::array<double, 3>;

inline Dofs velocity_of(const State<2>& state, int n) {
  return {state.velocity[n].x(), state.velocity[n].y(), state.spin[n]};
}

inline Dofs mass_of(const Model<2>& model, int n) {
  return {model.mass[n], model.mass[n], model.inertia[n]};
}

/// Forces of one node at an instant, on its free degrees of freedom, and what the supports take on the others.
struct NodeForces {
  Dofs force{}, weight{}, load{}, rest{}, mass{}, on_support{};
  Dofs element_damping{};
  bool held = false, damped = false;  ///< some degree of freedom is not free; there are dampings of the node
};

/// Dampings that belong to whole nodes.
inline void add_dampings(const Model<2>& model, int n, const Dofs& v, const RestDamping& rest, NodeForces& f) {
  const Dofs mass = mass_of(model, n);
  if (rest.share > 0) {
    const double speed = std::sqrt(v[0] * v[0] + v[1] * v[1]);
    const double brake = rest.share * std::sqrt(f.force[0] * f.force[0] + f.force[1] * f.force[1]);
    for (const int k : {0, 1})
      if (speed > 0) f.rest[k] = -brake / speed * v[k];
    if (v[2] != 0) f.rest[2] = -std::copysign(rest.share * std::abs(f.force[2]), v[2]);
  }
  for (const int k : {0, 1, 2}) {
    if (model.support[n][k] == Support::free) f.mass[k] = -model.mass_damping * mass[k] * v[k];
    f.force[k] += f.rest[k] + f.mass[k];
  }
}

/// What acts on nodes from outside at one instant, found once for all of them.
struct Outside {
  Vec2 field;                           ///< [m/s2]
  const Vec2* load;                     ///< [node] N
  const double* moment = nullptr;       ///< [node] N m; nullptr: none
  const Vec2* trim = nullptr;           ///< [node] N; nullptr: none
  const double* trim_moment = nullptr;  ///< [node] N m

  Outside(const Model<2>& model, const State<2>& state, const Work<2>& work)
      : field(model.gravity.at(state.time)), load(model.load.data()) {
    if (!work.load.empty()) load = work.load.data(), moment = work.load_moment.data();
    if (!work.trim.empty()) trim = work.trim.data(), trim_moment = work.trim_moment.data();
  }
};

/// Forces of pushes that no damping may answer: see step/displacement_control.hpp.
inline void add_trim(const Outside& outside, const std::array<Support, 3>& support, int n, NodeForces& f) {
  const Dofs trim{outside.trim[n].x(), outside.trim[n].y(), outside.trim_moment[n]};
  for (const int k : {0, 1, 2}) {
    if (support[k] != Support::free) continue;
    f.force[k] += trim[k];
    f.load[k] += trim[k];
  }
}

[[gnu::always_inline]] inline NodeForces node_forces(const Model<2>& model, const Work<2>& work, int n, const Dofs& v,
                                                     const Outside& outside, const RestDamping& rest) {
  NodeForces f;
  const auto& support = model.support[n];
  const double mass = model.mass[n];
  const Dofs total{work.force[n].x(), work.force[n].y(), work.moment[n]};
  const Dofs weight{mass * outside.field.x(), mass * outside.field.y(), 0};
  const Dofs load{outside.load[n].x(), outside.load[n].y(), outside.moment == nullptr ? 0 : outside.moment[n]};
  f.held = support[0] != Support::free || support[1] != Support::free || support[2] != Support::free;
  f.force = total, f.weight = weight, f.load = load;
  if (!work.element_damping.empty())
    f.element_damping = {work.element_damping[n].x(), work.element_damping[n].y(),
                         work.element_damping_moment.empty() ? 0 : work.element_damping_moment[n]};
  for (const int k : {0, 1, 2}) {
    if (!f.held || support[k] == Support::free) continue;
    f.force[k] = f.weight[k] = f.load[k] = 0;
    f.on_support[k] = total[k] - weight[k] - load[k];
  }
  f.damped = rest.share > 0 || model.mass_damping > 0;
  if (f.damped) add_dampings(model, n, v, rest, f);
  if (outside.trim != nullptr) add_trim(outside, support, n, f);
  return f;
}

[[gnu::always_inline]] inline double dot(const Dofs& a, const Dofs& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Work of weight, loads, supports and dampings along `path`. A step's path is half of the one behind and half of the
/// one ahead of the instant of the forces: the work a step really does.
[[gnu::always_inline]] inline void add_work(const NodeForces& f, const Dofs& path, Energy& given) {
  given[EnergyTerm::gravity] -= dot(f.weight, path);
  given[EnergyTerm::load] += dot(f.load, path);
  if (f.held) given[EnergyTerm::support] -= dot(f.on_support, path);
  given[EnergyTerm::element_damping] -= dot(f.element_damping, path);
  if (!f.damped) return;
  given[EnergyTerm::rest_damping] -= dot(f.rest, path);
  given[EnergyTerm::mass_damping] -= dot(f.mass, path);
}

/// Velocity of a driven degree of freedom that brings it to its motion's place at the end of the step.
inline double driven_velocity(const Model<2>& model, const State<2>& state, int n, int k, double dt) {
  const Drive& drive = model.drives[model.drive_of[n][k]];
  const double now = k == 2 ? state.rotation[n] : state.position[n][k];
  return (drive.origin + drive.motion->displacement(state.time + dt - drive.start) - now) / dt;
}

/// Half a step or so on: free degrees of freedom by their forces, driven ones by their motion, fixed ones still.
[[gnu::always_inline]] inline Dofs speed_ahead(const Model<2>& model, const State<2>& state, int n, const Dofs& v,
                                               const NodeForces& f, double span, double dt) {
  Dofs next{};
  const Dofs mass = mass_of(model, n);
  for (const int k : {0, 1, 2}) {
    const Support support = model.support[n][k];
    if (support == Support::free) next[k] = v[k] + f.force[k] / mass[k] * span;
    if (support == Support::driven) next[k] = driven_velocity(model, state, n, k, dt);
  }
  return next;
}

}  // namespace trilith
