// Stages of implicit steps for the physics tests, and a single mass on a single law.
#pragma once

#include "physics/scene.hpp"

namespace trilith::testing {

/// Fixed steps of length dt, whatever their energy error.
inline StageOptions implicit_stage(const AlphaMethod& scheme, double duration, double dt) {
  StageOptions o;
  o.duration = duration, o.dt = dt, o.integrator = scheme;
  o.tolerance = 1e-12, o.accuracy = 0;
  return o;
}

/// Steps of length dt that are halved if their energy error is too large.
inline StageOptions adaptive_stage(const AlphaMethod& scheme, double duration, double dt) {
  StageOptions o = implicit_stage(scheme, duration, dt);
  o.tolerance = 1e-8, o.accuracy = 1e-3;
  return o;
}

/// A mass that moves along x alone, without weight, connected to a fixed base by one law.
struct MassOnLaw {
  DirectionLaw law;
  double mass = 1, velocity = 0, load = 0;  ///< [kg], [m/s], [N]

  [[nodiscard]] Model<2> model() const {
    Scene scene(Frictional{1e6, 1e6, 0.5, 0});
    scene.set_gravity({0, 0});
    scene.fixed("base", box(-1, -1, 1, 0));
    BodySpec body;
    body.name = "mass", body.outline = box(-0.5, 1, 0.5, 2), body.mass = mass;
    body.support = {Support::free, Support::fixed, Support::fixed};
    body.velocity = {velocity, 0}, body.load = {load, 0};
    scene.add(body);
    scene.builder.set_contact("*", "*", "none");
    BearingSpec link;
    link.name = "link", link.body_a = "base", link.body_b = "mass";
    link.point_a = {0, 0}, link.point_b = {0, 1.5};
    link.law = {law, {}, {}};
    scene.builder.add_bearing(link);
    return scene.builder.build();
  }
};

/// Displacement of the mass at every instant of a stage, with the first one [m].
inline std::vector<double> history_of(const MassOnLaw& what, const StageOptions& stage) {
  Simulation<2> sim(what.model());
  const int node = node_of(sim.model(), "mass");
  std::vector<double> out{0};
  sim.run(stage, each_step([&](const Instant<2>& now) { out.push_back(now.state.position[node].x()); }));
  return out;
}

}  // namespace trilith::testing
