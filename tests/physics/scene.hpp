// Small scenes for the physics tests: one material, one contact law, bodies by their corners, in a world that may be
// rotated.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "load/motion.hpp"
#include "model/builder/builder.hpp"
#include "run/simulation.hpp"

namespace trilith::testing {

/// The rectangle between two corners [m].
inline Polygon box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline constexpr double degree = M_PI / 180;
inline constexpr std::array<Support, 3> held{Support::fixed, Support::fixed, Support::fixed};

/// Motion given by its acceleration at every `step` [s] from 0 to `end`, so fine that it counts as continuous.
template <class F>
std::shared_ptr<const GroundMotion> motion_of(double end, double step, F&& acceleration, double start_velocity = 0) {
  std::vector<double> samples;
  const auto count = static_cast<int>(std::ceil(end / step)) + 1;
  for (int i = 0; i < count; ++i) samples.push_back(acceleration(i * step));
  return std::make_shared<GroundMotion>(samples, step, MotionStart{start_velocity, 0});
}

/// Builder of a model. All input is given in scene axes; world axes are rotated from them by `turn` [rad]: outlines,
/// velocities, loads, gravity and drives. So a scene may be run in any direction.
class Scene {
 public:
  explicit Scene(const ContactLaw& law, double turn = 0) : turn_(turn) {
    builder.add_material({"stone", 2000});
    builder.add_law("joint", law);
    builder.set_contact("*", "*", "joint");
    set_gravity({0, -standard_gravity});
  }
  void set_gravity(const Vec2& field) { builder.gravity = turn_.apply(field); }

  /// A body as given, in scene axes.
  void add(BodySpec spec) {
    for (Vec2& p : spec.outline) p = turn_.apply(p);
    spec.velocity = turn_.apply(spec.velocity);
    spec.load = turn_.apply(spec.load);
    if (spec.material.empty()) spec.material = "stone";
    builder.add_body(std::move(spec));
  }
  void fixed(const std::string& name, const Polygon& outline) {
    BodySpec spec;
    spec.name = name, spec.outline = outline, spec.support = held;
    add(std::move(spec));
  }
  /// A free body of `mass` [kg].
  void block(const std::string& name, const Polygon& outline, double mass, const Vec2& velocity = Vec2::Zero()) {
    BodySpec spec;
    spec.name = name, spec.outline = outline, spec.mass = mass, spec.velocity = velocity;
    add(std::move(spec));
  }
  [[nodiscard]] Simulation<2> start() { return Simulation(builder.build()); }
  [[nodiscard]] Vec2 to_world(const Vec2& v) const { return turn_.apply(v); }
  [[nodiscard]] Vec2 to_scene(const Vec2& v) const { return turn_.undo(v); }

  /// Drives a body by `motion` along the x axis of the scene, from time `start` [s] on.
  void drive_along_x(Model<2>& model, const std::string& body, const GroundMotion& motion, double start = 0) const {
    const int b = model.find_body(body), n = model.bodies[b].first_node;
    const Vec2 way = turn_.apply(Vec2::UnitX());
    for (const int k : {0, 1}) {
      if (std::abs(way[k]) < 1e-12) continue;
      set_drive(model, b, k, std::make_shared<GroundMotion>(motion.scaled(way[k])), start, model.start_position[n][k]);
    }
  }

  ModelBuilder builder;

 private:
  Turn turn_;
};

inline int node_of(const Model<2>& model, const std::string& body) {
  return model.bodies[model.find_body(body)].first_node;
}

/// Current position of skin point `corner` of a body, in world axes [m].
inline Vec2 corner_of(const Simulation<2>& sim, const std::string& body, int corner) {
  const Model<2>& model = sim.model();
  const Body& b = model.bodies[model.find_body(body)];
  const State<2>& s = sim.state();
  return s.position[b.first_node] + Turn(s.rotation[b.first_node]).apply(model.skin_place[b.first_skin + corner]);
}

/// Continues for `duration` [s]; `dt` 0: automatic step.
inline StageReport run_for(Simulation<2>& sim, double duration, double dt = 0, const RunListener<2>& listener = {}) {
  StageOptions options;
  options.duration = duration;
  options.dt = dt;
  return sim.run(options, listener);
}

/// Calls f(instant) after each step.
template <class F>
RunListener<2> each_step(F&& f) {
  RunListener<2> listener;
  listener.on_step = std::forward<F>(f);
  return listener;
}

/// Settles a scene under the damping of consolidation.
inline StageReport settle(Simulation<2>& sim, double longest = 100, double still_speed = 1e-10) {
  StageOptions options;
  options.name = "settle";
  options.duration = longest;
  options.rest_share = 0.8;
  options.until_rest = true;
  options.still_speed = still_speed;
  options.still_ratio = 1e-6;
  options.still_hold = 0.02;
  return sim.run(options);
}

}  // namespace trilith::testing
