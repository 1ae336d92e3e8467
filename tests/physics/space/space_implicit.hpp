// Stages of implicit steps in space for the physics tests.
#pragma once

#include <string>

#include "physics/space/solid_bodies.hpp"
#include "run/simulation.hpp"

namespace trilith::testing {

/// Fixed steps of length dt, whatever their energy error.
inline StageOptions steps_in_space(const AlphaMethod& scheme, double duration, double dt) {
  StageOptions o;
  o.duration = duration, o.dt = dt, o.integrator = scheme;
  o.tolerance = 1e-12, o.accuracy = 0;
  return o;
}

/// Steps of length dt that are halved if their energy error is too large.
inline StageOptions careful_steps(double duration, double dt) {
  StageOptions o = steps_in_space(AlphaMethod::hht(-0.05), duration, dt);
  o.tolerance = 1e-8, o.accuracy = 1e-3;
  return o;
}

inline StageOptions explicit_steps(double duration, double dt = 0) {
  StageOptions o;
  o.duration = duration, o.dt = dt;
  return o;
}

inline std::size_t node_called(const Model<3>& model, const std::string& body) {
  return static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(model.find_body(body))].first_node);
}

template <class F>
RunListener<3> after_each_step(F&& f) {
  RunListener<3> listener;
  listener.on_step = std::forward<F>(f);
  return listener;
}

/// Inertia of a node about its own position, in world axes [kg m2/s].
inline Vec3 turning_momentum(const Model<3>& model, const State<3>& state, std::size_t n) {
  return momentum_of(model.inertia[n], state.rotation[n], state.spin[n]);
}

}  // namespace trilith::testing
