// A step of the water in joints together with the equilibrium of the bodies.
#pragma once

#include <vector>

#include "field/field.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "statics/equilibrium.hpp"

namespace trilith {

template <int D>
struct SeepageStep {
  const Model<D>& model;
  const Field& field;
  double dt;       ///< [s]
  bool mechanics;  ///< bodies are brought to equilibrium; false: they stay
  const EquilibriumOptions& how;
};

/// One implicit step. Pressures and positions at its end satisfy the flow, with the apertures of these positions, and
/// the equilibrium under these pressures. Water cannot follow a plate explicitly: it is stiffer than the plate's joint.
/// So the flow assumes that each point of a joint gives way to pressure like its contact law (the fixed stress split of
/// Kim, Tchelepi and Juanes, Comput. Methods Appl. Mech. Eng. 200, 2011), which is corrected by the equilibrium, and
/// Anderson's method (J. ACM 12, 1965) accelerates the iteration. Without convergence the state is undefined.
template <int D>
Equilibrium seepage_step(const SeepageStep<D>& step, FlowSolver& solver, State<D>& state);

/// The water flows for `dt` [s] between the bodies as they are now, after a step of a stage of motion. The step of the
/// motion resolves the stiffness of the enclosed water (run/field/water_step.hpp), so the pressure may follow the
/// motion explicitly. Appends the events of joints.
template <int D>
void flow_after_step(const Model<D>& model, double dt, FlowSolver& solver, State<D>& state, std::vector<Event>& events);

/// Joints between bodies in which every cell is full to more than a half; empty without such joints.
template <int D>
std::vector<bool> flooded_joints(const Model<D>& model, const State<D>& state);
/// Appends the events of joints that the water has filled, or left, since `before`.
template <int D>
void add_flow_events(const Model<D>& model, const State<D>& state, const std::vector<bool>& before,
                     std::vector<Event>& events);

}  // namespace trilith
