// Bodies of one element in space rotate by their own inertia: Euler's equations, pivots, energy ledger.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <memory>

#include "assembly/element/rotary_inertia.hpp"
#include "assembly/start.hpp"
#include "assembly/whole_body.hpp"
#include "load/ramp.hpp"
#include "near.hpp"
#include "physics/space/soft_solids.hpp"

namespace trilith::testing {
namespace {

constexpr double stiff = 2e10;

/// A brick whose upper face is smaller by `taper` along x and by half of `taper` along y.
SpaceMesh tapered_brick(const Vec3& sides, double taper) {
  SpaceMesh mesh = mesh_of(box_solid(Vec3::Zero(), sides), {BodyKind::mesh, {1, 1, 1}, ElementShape::brick}, "box");
  for (Vec3& x : mesh.node)
    if (x.z() > 0.5 * sides.z()) x.x() *= 1 - taper, x.y() *= 1 - 0.5 * taper;
  return mesh;
}

SpaceMesh lone_tetrahedron() {
  SpaceMesh mesh =
      mesh_of(box_solid(Vec3::Zero(), Vec3(1, 1, 1)), {BodyKind::mesh, {1, 1, 1}, ElementShape::tetrahedron}, "box");
  const auto cell = mesh.cell[0];
  SpaceMesh one;
  one.cell = {cell};
  for (int i = 0; i < 4; ++i)
    one.node.push_back(mesh.node[cell.node[i]].cwiseProduct(Vec3(1, 0.7, 0.4))), one.cell[0].node[i] = i;
  return one;
}

Model<3> free_body(const SpaceMesh& mesh, double damping = 0) {
  return alone_in_space(elastic_in("m", 2000, stiff, 0.2, damping), mesh_spec("b", "m", mesh));
}

void set_spin(SolidRun& run, const Vec3& about, const Vec3& spin) {
  for (int n = 0; n < run.model().nodes(); ++n)
    if (run.model().moves(n)) run.state().velocity[n] = cross(spin, Vec3(run.state().position[n] - about));
}

/// Rotation of a rigid body of inertia `own` at the end, from Euler's equations by the Runge-Kutta method.
UnitQuaternion turn_of_rigid(const Eigen::Matrix3d& own, const Vec3& spin, double time) {
  const Vec3 momentum = own * spin;
  UnitQuaternion q;
  const int steps = 20000;
  const double dt = time / steps;
  const auto rate = [&](const UnitQuaternion& at) {
    const Turn3 turn(at);
    return turn.apply(own.inverse() * turn.undo(momentum));
  };
  for (int i = 0; i < steps; ++i) {
    const Vec3 half = rate(renormalised(rotation_by(0.5 * dt * rate(q)) * q));
    q = renormalised(rotation_by(dt * half) * q);
  }
  return q;
}

struct Spun {
  double residual, momentum, turned;  ///< shares of the kinetic energy and of J w; angle to the rotation of the rigid
                                      ///< body
};

Spun spin_freely(const Model<3>& model, const Vec3& spin, double time, double dt) {
  SolidRun run(model, dt);
  const RotaryInertia<3> start = rotary_inertia(model, run.state(), 0);
  set_spin(run, start.centre, spin);
  run.drop_work();
  const auto momentum = [&] {
    const RotaryInertia<3> now = rotary_inertia(run.model(), run.state(), 0);
    Vec3 h = Vec3::Zero();
    for (int n = 0; n < model.nodes(); ++n)
      h += cross(Vec3(run.state().position[n] - now.centre), Vec3(model.mass[n] * run.state().velocity[n]));
    return Vec3(now.own * (now.lumped.inverse() * h));
  };
  const double begun = run.energy().balance(), kinetic = run.moving_energy();
  const Vec3 before = start.own * spin;
  CHECK(near(kinetic, 0.5 * spin.dot(before), 1e-9));
  run.run(time);
  const UnitQuaternion off =
      body_pose(run.model(), run.state(), 0).turned * inverse(turn_of_rigid(start.own, spin, time));
  return {std::abs(run.energy().balance() - begun) / kinetic, (momentum() - before).norm() / before.norm(),
          angle_of(off).norm()};
}

TEST_CASE("a free body of one element rotates in space by Euler's equations") {
  const Vec3 sides(1, 2, 0.5);
  // Deformation by strains of the order (density spin^2 size^2) / E = 1.5e-5 changes the inertia by as much.
  for (const SpaceMesh& mesh : {tapered_brick(sides, 0), tapered_brick(sides, 0.4), lone_tetrahedron()}) {
    CAPTURE(mesh.node.size());
    for (const double damping : {0.0, 1e-5}) {
      const Spun spun = spin_freely(free_body(mesh, damping), Vec3(3, 5, 2), 0.5, 4e-5);
      CHECK(spun.residual < 3e-5);
      CHECK(spun.momentum < 1e-6);
      CHECK(spun.turned < 5e-5);
    }
  }
}

TEST_CASE("a soft body of one element keeps energy and angular momentum as it stretches and turns in space") {
  for (const SpaceMesh& mesh :
       {tapered_brick(Vec3(1, 2, 0.5), 0), tapered_brick(Vec3(1, 2, 0.5), 0.4), lone_tetrahedron()}) {
    CAPTURE(mesh.node.size());
    const Model<3> model = alone_in_space(elastic_in("m", 2000, 2e6, 0.2, 0), mesh_spec("b", "m", mesh));
    double residual = 1;
    for (const double dt : {2e-4, 1e-4}) {
      SolidRun run(model, dt);
      const RotaryInertia<3> start = rotary_inertia(model, run.state(), 0);
      const Vec3 spin(6, 9, 4), before = start.own * spin;
      set_spin(run, start.centre, spin);
      run.drop_work();
      const double kinetic = run.moving_energy(), begun = run.energy().balance();
      double off = 0, stored = 0;
      for (int i = 0; i < 100; ++i) {
        run.run(0.005);
        off = std::max(off, std::abs(run.energy().balance() - begun) / kinetic);
        stored = std::max(stored, kinetic - run.moving_energy());
      }
      const RotaryInertia<3> now = rotary_inertia(run.model(), run.state(), 0);
      Vec3 h = Vec3::Zero();
      for (int n = 0; n < model.nodes(); ++n)
        h += cross(Vec3(run.state().position[n] - now.centre), Vec3(model.mass[n] * run.state().velocity[n]));
      CHECK(stored > 0.004 * kinetic);
      CHECK(off < 2e-5);
      CHECK((now.own * (now.lumped.inverse() * h) - before).norm() < 1e-2 * before.norm() * (dt / 1e-4));
      CHECK(off < 0.6 * residual);
      residual = off;
    }
  }
}

TEST_CASE("a body of one element that is pinned at a corner turns about it as a rigid one does") {
  for (const double taper : {0.0, 0.4}) {
    CAPTURE(taper);
    SolidSpec spec = mesh_spec("b", "m", tapered_brick(Vec3(1, 2, 0.5), taper));
    spec.supports = {{Vec3::Constant(-1e-6), Vec3::Constant(1e-6), {Support::fixed, Support::fixed, Support::fixed}}};
    const Model<3> model = alone_in_space(elastic_in("m", 2000, stiff, 0.2, 1e-5), spec);
    SolidRun run(model, 4e-5);
    const RotaryInertia<3> of = rotary_inertia(model, run.state(), 0);
    const Vec3 spin(3, 5, 2);
    const Eigen::Matrix3d about = of.own + turn_inertia(body_mass(model, 0), of.centre);
    set_spin(run, Vec3::Zero(), spin);
    run.drop_work();
    const double kinetic = run.moving_energy(), begun = run.energy().balance();
    CHECK(near(kinetic, 0.5 * spin.dot(about * spin), 1e-9));
    run.run(0.5);
    const UnitQuaternion off = body_pose(run.model(), run.state(), 0).turned * inverse(turn_of_rigid(about, spin, 0.5));
    CHECK(near_zero(run.energy().balance() - begun, 3e-5 * kinetic));
    CHECK(angle_of(off).norm() < 5e-5);
  }
}

TEST_CASE("the energy balance of bricks in mortar on a base that is shaken closes at any step") {
  for (const double dt : {1.6e-5, 8e-6}) {
    Bonded law;
    law.kn = 2e9, law.ks = 1e9, law.mu = 0.6, law.tension = 2e4, law.cohesion = 3e4, law.beta = 1e-4;
    SolidModelBuilder builder = soft_world(law, 2e9, 0.2, 2e-5, 2000);
    builder.add_body(fixed_box("base", box_solid(Vec3(-0.5, -0.5, -0.3), Vec3(2.5, 0.7, 0))));
    for (int i = 0; i < 3; ++i)
      builder.add_body(box_of(fmt::format("u{}", i), box_solid(Vec3(0, 0, 0.2 * i), Vec3(0.4, 0.2, 0.2 * (i + 1))),
                              "soft", {1, 1, 1}));
    Model<3> model = builder.build();
    const auto motion = std::make_shared<const GroundMotion>(ramp_motion(0.05, 0.1));
    set_drive(model, 0, 1, motion, 0, model.start_position[0].y());
    SolidRun run(model, start_state(model), dt);
    const double begun = run.energy().balance();
    run.run(0.2);
    CHECK(run.moving_energy() > 1);
    CHECK(near_zero(run.energy().balance() - begun, 1e-3 * run.energy()[EnergyTerm::support]));
  }
}

}  // namespace
}  // namespace trilith::testing
