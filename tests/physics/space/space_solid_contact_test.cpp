// Deformable bodies in space: free flight, contact with each other and with rigid bodies, waves, bearings.
#include <fmt/format.h>

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "assembly/start.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "law/bearing/linear.hpp"
#include "load/ramp.hpp"
#include "near.hpp"
#include "physics/space/soft_solids.hpp"

namespace trilith::testing {
namespace {

/// Stable step times `safety` [s].
double stable_dt(const Model<3>& model, double safety = 0.8) {
  const State<3> state = initial_state(model);
  Work<3> work;
  evaluate(model, state, work, 0.0);
  return safety * stable_step(model, state, work).dt;
}

TEST_CASE("a soft body in space that tumbles keeps its energy and its angular momentum") {
  for (const ElementShape shape : all_shapes) {
    CAPTURE(std::string(info_of(shape).name));
    SolidSpec spec = box_of("b", box_solid(Vec3::Zero(), Vec3(1, 0.5, 0.25)), "m", {2, 1, 1}, shape);
    spec.spin = Vec3(3, 8, 2), spec.velocity = Vec3(1, 2, 3);
    const Model<3> model = alone_in_space(elastic_in("m", 1000, 1e7, 0.3), spec);
    SolidRun run(model, stable_dt(model, 0.5));
    run.step();
    const double begun = run.energy().balance(), moving = run.moving_energy();
    const Vec3 turning = run.angular_momentum();
    double most = 0;
    for (int i = 0; i < 40; ++i) {
      run.run(0.05);
      most = std::max(most, std::abs(run.energy().balance() - begun));
    }
    CHECK(most < 2e-3 * moving);
    CHECK((run.angular_momentum() - turning).norm() < 1e-9 * turning.norm());
  }
}

TEST_CASE("the computed stable step is stable, and 1.5 times it is not") {
  SolidSpec spec = box_of("b", box_solid(Vec3::Zero(), Vec3(1, 0.5, 0.25)), "m", {2, 2, 2});
  const Model<3> model = alone_in_space(elastic_in("m", 1000, 1e7, 0.3), spec);
  const auto grown = [&](double safety) {
    SolidRun run(model, stable_dt(model, safety));
    std::mt19937_64 bits(3);
    for (Vec3& v : run.state().velocity) v = 1e-3 * random_in_ball(bits);
    run.run(4000 * stable_dt(model, safety));
    double sum = 0;  // not a number after overflow
    for (const Vec3& v : run.state().velocity) sum += v.norm();
    return sum / static_cast<double>(model.nodes()) / 1e-3;
  };
  CHECK(grown(0.99) < 10);
  CHECK_FALSE(grown(1.5) < 1e3);
}

/// A stack of two layers of blocks with non-matching meshes under a rigid cap, under the cap's load; mean stress of
/// each deformable body [Pa].
void press_stack(const std::array<int, 3>& lower, ElementShape lower_shape, const std::array<int, 3>& upper,
                 ElementShape upper_shape) {
  const double kn = 1e9, young = 1e8, pressure = 1e4;
  // Without friction, which would lock in the slip of the first load oscillation.
  SolidModelBuilder builder = soft_world(frictional(kn, kn, 0, 1e-4), young, 0, 2e-4);
  builder.gravity = Vec3::Zero();
  builder.add_body(fixed_box("ground", box_solid(Vec3(-1, -1, -0.5), Vec3(2, 2, 0))));
  const auto add = [&](const std::string& name, const Vec3& low, const Vec3& high, const std::array<int, 3>& divisions,
                       ElementShape shape) {
    SolidSpec spec = divisions[0] == 0 ? rigid_box(name, box_solid(low, high))
                                       : box_of(name, box_solid(low, high), "soft", divisions, shape);
    builder.add_body(std::move(spec));
  };
  // Two blocks below, three above: their faces do not match.
  add("a", Vec3(0, 0, 0), Vec3(0.5, 1, 0.4), lower, lower_shape);
  add("b", Vec3(0.5, 0, 0), Vec3(1, 1, 0.4), lower, lower_shape);
  add("c", Vec3(0, 0, 0.4), Vec3(0.3, 1, 0.8), upper, upper_shape);
  add("d", Vec3(0.3, 0, 0.4), Vec3(0.8, 1, 0.8), upper, upper_shape);
  add("e", Vec3(0.8, 0, 0.4), Vec3(1, 1, 0.8), upper, upper_shape);
  SolidSpec cap = rigid_box("cap", box_solid(Vec3(0, 0, 0.8), Vec3(1, 1, 1)));
  cap.load = Vec3(0, 0, -pressure);
  builder.add_body(cap);
  const Model<3> model = builder.build();
  SolidRun run(model, stable_dt(model));
  run.model().mass_damping = 30;
  run.run(0.8);
  for (int e = 0; e < static_cast<int>(model.space_elements.size()); ++e) {
    const SpaceVector s = in_world(element_stress(model, run.state(), e));
    CHECK(near(s[2], -pressure, 1e-3));
    for (const int k : {0, 1, 3, 4, 5}) CHECK(near_zero(s[k], 1e-3 * pressure));
  }
}

TEST_CASE("uniform pressure is transferred through a stack of rigid and deformable blocks whose faces do not match" *
          doctest::test_suite("long")) {
  press_stack({1, 1, 1}, ElementShape::brick, {1, 1, 1}, ElementShape::brick);
  press_stack({2, 2, 1}, ElementShape::brick, {0, 0, 0}, ElementShape::brick);
  press_stack({0, 0, 0}, ElementShape::brick, {1, 1, 1}, ElementShape::tetrahedron);
  press_stack({1, 1, 1}, ElementShape::brick, {1, 1, 1}, ElementShape::quadratic_tetrahedron);
}

TEST_CASE("a brick resting on the ground carries its weight, settles by it, and stays at rest") {
  const double kn = 1e8, density = 2000, young = 1e8;
  SolidModelBuilder builder = soft_world(frictional(kn, kn, 0.5, 1e-4), young, 0, 1e-3, density);
  builder.add_body(fixed_box("ground", box_solid(Vec3(-1, -1, -0.5), Vec3(2, 2, 0))));
  builder.add_body(box_of("b", box_solid(Vec3::Zero(), Vec3(1, 1, 1)), "soft", {1, 1, 1}));
  const Model<3> model = builder.build();
  SolidRun run(model, stable_dt(model));
  run.model().mass_damping = 30;
  run.run(2);
  const double weight = density * standard_gravity;
  // The lower half of the mass stands on the contact, the upper half compresses the block.
  double low = 0;
  for (int n = 1; n < 9; ++n)
    if (model.start_position[n].z() < 0.5) low += 0.25 * run.state().position[n].z();
  CHECK(near(low, -weight / kn, 1e-3));
  CHECK(near(in_world(element_stress(model, run.state(), 0))[2], -0.5 * weight, 1e-3));
  CHECK(largest_of(run.state().velocity) < 1e-9);
}

TEST_CASE("B8 in space: two equal elastic bars that meet swap their speeds after 2 L / c" *
          doctest::test_suite("long")) {
  const double young = 30e9, density = 2400, length = 10, speed = 1, c = std::sqrt(young / density);
  const int parts = 40;
  SolidModelBuilder builder = soft_world(frictional(1e13, 1e13, 0), young, 0, 0, density);
  builder.gravity = Vec3::Zero();
  SolidSpec hitting = box_of("hitting", box_solid(Vec3(0, 0, 0), Vec3(length, 0.5, 0.5)), "soft", {parts, 1, 1});
  hitting.velocity = Vec3(speed, 0, 0);
  builder.add_body(hitting);
  builder.add_body(
      box_of("hit", box_solid(Vec3(length + 1e-6, 0, 0), Vec3(2 * length + 1e-6, 0.5, 0.5)), "soft", {parts, 1, 1}));
  const Model<3> model = builder.build();
  SolidRun run(model, stable_dt(model));
  const double begun = run.energy().balance();
  double first = -1, last = 0, most = 0;
  while (run.time() < 2.5 * length / c) {
    run.step();
    if (!run.work().general_touching.empty()) {
      if (first < 0) first = run.time();
      last = run.time(), most = std::max(most, run.work().general_touching[0].force.norm() / 0.25);
    }
  }
  CHECK(near(last - first, 2 * length / c, 0.03));
  const auto speed_of = [&](int body) { return body_pose(model, run.state(), body).velocity.x(); };
  CHECK(near_zero(speed_of(0), 0.03));
  CHECK(near(speed_of(1), speed, 0.03));
  CHECK(near_zero(run.energy().balance() - begun, 1e-2 * run.moving_energy()));
  // Behind the front the stress is rho c v / 2; the front itself overshoots.
  CHECK(most > density * c * speed / 2 * 0.97);
}

TEST_CASE("a cantilever of bricks has the frequency of beam theory with shear" * doctest::test_suite("long")) {
  const double young = 2e9, density = 2000, length = 3;
  SolidSpec spec = box_of("beam", box_solid(Vec3(0, 0, 0), Vec3(length, 0.25, 0.25)), "m", {12, 1, 1});
  spec.supports = {{Vec3(0, 0, 0), Vec3(0, 0.25, 0.25), {Support::fixed, Support::fixed, Support::fixed}}};
  const Model<3> model = alone_in_space(elastic_in("m", density, young, 0), spec);
  SolidRun run(model, stable_dt(model));
  const int tip = model.nodes() - 1;
  for (int n = 0; n < model.nodes(); ++n) {
    const double x = model.start_position[n].x() / length;
    if (model.moves(n)) run.state().velocity[n] = Vec3(0, 0, 1e-3 * x * x * (3 - x) / 2);
  }
  // From one upward passage through 0 to a later one.
  std::vector<double> rises;
  double before = -1;
  while (run.time() < 1.5 && rises.size() < 4) {
    run.step();
    const double z = run.state().position[tip].z() - model.start_position[tip].z();
    if (before < 0 && z >= 0 && run.time() > 0.01) rises.push_back(run.time());
    before = z;
  }
  REQUIRE(rises.size() == 4);
  const double frequency = 3 / (rises[3] - rises[0]);
  const double slender =
      1.8751 * 1.8751 / (2 * std::numbers::pi * length * length) * std::sqrt(young * 0.25 * 0.25 / (12 * density));
  CHECK(near(frequency, slender, 0.02));
}

TEST_CASE("mortar between bricks that deform carries tension and bending, and is at rest without load") {
  Bonded law;
  law.kn = law.ks = 1e10, law.mu = 0.6, law.tension = 1e6, law.cohesion = 1e6, law.beta = 1e-4;
  SolidModelBuilder builder = soft_world(law, 1e9, 0.2, 1e-4);
  builder.gravity = Vec3::Zero();
  builder.add_body(fixed_box("root", box_solid(Vec3(-0.4, 0, 0), Vec3(0, 0.2, 0.2))));
  for (int i = 0; i < 3; ++i)
    builder.add_body(box_of(fmt::format("u{}", i), box_solid(Vec3(0.4 * i, 0, 0), Vec3(0.4 * (i + 1), 0.2, 0.2)),
                            "soft", {1, 1, 1}));
  Model<3> model = builder.build();
  const double load = -50;
  for (int n = 0; n < model.nodes(); ++n)
    if (model.start_position[n].x() > 1.2 - 1e-9) model.load[n] = Vec3(0, 0, load / 4);
  SolidRun run(model, start_state(model), stable_dt(model));
  run.model().mass_damping = 20;
  run.run(1.5);
  // A brick has one curvature, taken at its middle, and one shear strain; each joint is a spring of kn I and kn A.
  const double inertia = std::pow(0.2, 4) / 12, area = 0.04, shear = 1e9 / 2.4;
  double expected = 0;
  for (const double arm : {1.0, 0.6, 0.2}) expected += load * 0.4 * (arm * arm / (1e9 * inertia) + 1 / (shear * area));
  for (const double arm : {1.2, 0.8, 0.4}) expected += load * (arm * arm / (1e10 * inertia) + 1 / (1e10 * area));
  double tip = 0;
  for (int n = 0; n < model.nodes(); ++n)
    if (model.start_position[n].x() > 1.2 - 1e-9)
      tip += 0.25 * (run.state().position[n].z() - model.start_position[n].z());
  CHECK(near(tip, expected, 1e-3));
  CHECK(run.work().contacts.joint.size() == 3);
}

TEST_CASE("a bearing and a load on a deformable body give their nodes the force and the moment they have") {
  SolidModelBuilder builder = soft_world(frictional(1e9, 1e9, 0.5), 1e8, 0.2, 1e-3);
  builder.gravity = Vec3::Zero();
  builder.add_body(fixed_box("wall", box_solid(Vec3(-1, 0, 0), Vec3(-0.5, 1, 1))));
  builder.add_body(box_of("b", box_solid(Vec3(0, 0, 0), Vec3(1, 1, 1)), "soft", {2, 2, 2}));
  BearingSpecOf<3> spec;
  spec.name = "spring", spec.body_a = "wall", spec.body_b = "b";
  spec.point_a = Vec3(-0.5, 0.5, 0.5), spec.point_b = Vec3(0, 0.5, 0.5);
  for (std::size_t k = 0; k < 6; ++k) spec.law[k] = Linear{k < 3 ? 1e6 : 1e5, 0};
  builder.add_bearing(spec);
  Model<3> model = builder.build();
  SolidLoadSpec load;
  load.name = "pull", load.force = Vec3(100, 0, 0), load.at = Vec3(1, 0.5, 0.5);
  loads_of<PointLoad<3>>(model).push_back(make_solid_load(model, 1, load));
  SolidRun run(model, stable_dt(model));
  run.model().mass_damping = 20;
  run.run(1);
  CHECK(near(run.work().bearing_displacement[0].x(), 100 / 1e6, 1e-3));
  CHECK(near(in_world(element_stress(model, run.state(), 0))[0] + in_world(element_stress(model, run.state(), 2))[0] +
                 in_world(element_stress(model, run.state(), 4))[0] +
                 in_world(element_stress(model, run.state(), 6))[0],
             400, 0.02));
}

TEST_CASE("the energy balance of a wall of bricks in mortar, one element for each, closes as its base is shaken" *
          doctest::test_suite("long")) {
  Bonded law;
  law.kn = 2e9, law.ks = 1e9, law.mu = 0.6, law.tension = 2e4, law.cohesion = 3e4, law.beta = 1e-4;
  SolidModelBuilder builder = soft_world(law, 2e9, 0.2, 2e-5, 2000);
  builder.add_body(fixed_box("base", box_solid(Vec3(-0.5, -0.5, -0.3), Vec3(2.5, 0.7, 0))));
  for (int course = 0; course < 8; ++course)
    for (int i = 0; i < 5; ++i) {
      const double from = course % 2 == 0 ? 0.4 * i : std::max(0.0, 0.4 * i - 0.2),
                   to = course % 2 == 0 ? 0.4 * (i + 1) : std::min(2.0, 0.4 * i + 0.2);
      SolidSpec unit =
          box_of(fmt::format("c{}.u{}", course, i),
                 box_solid(Vec3(from, 0, 0.2 * course), Vec3(to, 0.2, 0.2 * (course + 1))), "soft", {1, 1, 1});
      builder.add_body(std::move(unit));
    }
  Model<3> model = builder.build();
  const auto motion = std::make_shared<const GroundMotion>(ramp_motion(0.05, 0.1));
  set_drive(model, 0, 1, motion, 0, model.start_position[0].y());
  SolidRun run(model, start_state(model), stable_dt(model));
  const double begun = run.energy().balance();
  run.run(0.5);
  const Energy e = run.energy();
  CHECK(near(run.state().position[0].y() - model.start_position[0].y(), 0.05, 1e-6));
  CHECK(run.moving_energy() > 1);  // it sways, or separates
  CHECK(near_zero(e.balance() - begun, 1e-2 * std::abs(e[EnergyTerm::support])));
}

TEST_CASE("T2 with an elastic block: it rocks over an edge with the period of the rigid one" *
          doctest::test_suite("long")) {
  // Released at half of its critical angle about the lower edge at x = 0.2.
  const double turned = 0.5 * std::atan2(0.4, 1.2), kn = 1e10;
  SolidModelBuilder builder = soft_world(frictional(kn, kn, 5), 5e9, 0.2, 0, 2000);
  builder.overlap_allowed = 1e-3;
  builder.add_body(fixed_box("ground", box_solid(Vec3(-2, -2, -0.5), Vec3(2, 2, 0))));
  const Polyhedron upright = box_solid(Vec3(-0.4, -0.2, 0), Vec3(0, 0.2, 1.2));
  const Polyhedron box = placed(placed(upright, rotation_by(Vec3(0, turned, 0)), Vec3::Zero()), {}, Vec3(0.2, 0, 0));
  builder.add_body(box_of("block", box, "soft", {4, 1, 10}));
  const Model<3> model = builder.build();
  // Its masses lie at the nodes, which makes its inertia about the edge slightly larger than 4/3 m R^2.
  double mass = 0, inertia = 0;
  for (int n = model.bodies[1].first_node; n < model.nodes(); ++n) {
    const Vec3 arm = model.start_position[n] - Vec3(0.2, 0, 0);
    mass += model.mass[n], inertia += model.mass[n] * (arm.x() * arm.x() + arm.z() * arm.z());
  }
  const double more = inertia / (4.0 / 3 * mass * 0.4);
  SolidRun run(model, stable_dt(model));
  double time = -1, aside = 0;
  run.run_until(2, [&] {
    const Vec3 back = angle_of(body_pose(model, run.state(), 1).turned);
    if (std::abs(back.y()) >= turned) time = run.time(), aside = std::max(std::abs(back.x()), std::abs(back.z()));
    return time >= 0;
  });
  CHECK(near(more, 1, 0.01));
  CHECK(near(time, 0.3874 * std::sqrt(more), 0.01));
  CHECK(near_zero(aside, 1e-6));
}

TEST_CASE("T5 with elastic bars: one on edge across two others on edge presses each by half its weight") {
  const double kn = 1e10, side = 0.2, reach = side / std::sqrt(2.0);
  SolidModelBuilder builder = soft_world(frictional(kn, kn, 1, 1e-5), 10e9, 0.2, 1e-5, 2400);
  builder.overlap_allowed = 1e-2;
  const auto bar = [&](const Vec3& along, double length, const Vec3& at) {
    const Polyhedron upright =
        box_at(Vec3(length, side, side), Vec3::Zero(), rotation_by(Vec3(std::numbers::pi / 4, 0, 0)));
    const UnitQuaternion turn = along.y() > 0.5 ? rotation_by(Vec3(0, 0, std::numbers::pi / 2)) : UnitQuaternion{};
    return placed(upright, turn, at);
  };
  for (const double x : {-0.5, 0.5}) {
    SolidSpec rail = fixed_box(x < 0 ? "left" : "right", bar(Vec3::UnitY(), 1, Vec3(x, 0, 0)));
    builder.add_body(rail);
  }
  SolidSpec across = box_of("across", bar(Vec3::UnitX(), 1.6, Vec3(0, 0, 2 * reach)), "soft", {8, 1, 1});
  // The rolling rotation is fixed: the nodes at its ends stay in the plane of its axis.
  across.supports = {{Vec3(-0.9, -1, 0), Vec3(0.9, 1, 1), {Support::free, Support::fixed, Support::free}}};
  builder.add_body(across);
  const Model<3> model = builder.build();
  SolidRun run(model, stable_dt(model));
  run.model().mass_damping = 60;
  run.run(1);
  const double weight = body_mass(model, 2) * standard_gravity;
  double left = 0, right = 0;
  for (const GeneralContact<3>& c : run.work().general_touching) (c.centre.x() < 0 ? left : right) += c.force.z();
  CHECK(near(left, weight / 2, 0.01));
  CHECK(near(right, weight / 2, 0.01));
}

}  // namespace
}  // namespace trilith::testing
