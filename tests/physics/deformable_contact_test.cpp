// Deformable bodies in contact with each other and with rigid bodies, driven, and tied to bearings; the same bits for
// the same run.
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "assembly/contact/contact_resultants.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "law/bearing/linear.hpp"
#include "model/check/energy_check.hpp"
#include "model/io/checkpoint.hpp"
#include "near.hpp"
#include "physics/space/solids.hpp"

namespace trilith::testing {
namespace {

const std::array kinds{std::array{0, 0}, std::array{1, 1}, std::array{3, 2}};  // rigid, quad, mesh

std::string word(const std::array<int, 2>& kind) {
  return kind[0] == 0 ? "rigid" : kind[0] == 1 ? "quad" : "mesh";
}

/// A body of one of the `kinds`.
BodySpec made(const std::string& name, const Polygon& corners, const std::array<int, 2>& kind) {
  BodySpec spec = grid_body(name, corners, "soft", std::max(1, kind[0]), std::max(1, kind[1]));
  if (kind[0] == 0) spec.kind = BodyKind::rigid;
  spec.floating = false;
  return spec;
}

Scene soft_scene(const ContactLaw& law, double young = 1e9, double poisson = 0, double turn = 0, double damping = 0) {
  Scene scene(law, turn);
  scene.builder.add_material(elastic("soft", 2000, young, poisson, Plane::stress, ElementForm::assumed, damping));
  return scene;
}

TEST_CASE("C6: uniform pressure is transferred through faces that do not match, for all kinds of bodies" *
          doctest::test_suite("long")) {
  for (const auto& top : kinds)
    for (const auto& low : kinds) {
      if (top[0] == 0 && low[0] == 0) continue;
      Scene scene = soft_scene(Frictional{1e10, 4e9, 0.6, 1e-4});
      scene.set_gravity(Vec2::Zero());
      scene.fixed("base", rectangle({-1, -1}, {2, 0}));
      scene.add(made("low", rectangle({0, 0}, {1, 0.5}), low));
      for (int i = 0; i < 3; ++i) {
        BodySpec spec = made("top" + std::to_string(i), rectangle({i / 3.0, 0.5}, {(i + 1) / 3.0, 0.8}), top);
        spec.load = {0, -1e6 / 3};
        scene.add(spec);
      }
      Simulation<2> sim = scene.start();
      settle(sim, 20, 1e-9);
      sim.refresh();
      std::vector<TouchingContact> touching;
      contact_resultants(sim.model(), sim.state(), sim.work(), touching);
      double lowest = 1e9, highest = 0;
      for (const TouchingContact& c : touching) {
        if (c.body_a != 1 && c.body_b != 1) continue;
        const NearPair& p = sim.work().pairs[c.row];
        const auto x = [&](int s) { return sim.work().skin[s].x; };
        const double from = std::max(x(p.a1), x(p.b0)), to = std::min(x(p.a0), x(p.b1));
        const double from2 = std::max(x(p.a0), x(p.b1)), to2 = std::min(x(p.a1), x(p.b0));
        const double length = std::max(to - from, to2 - from2);
        if (length < 0.01) continue;  // edges of the neighbours
        lowest = std::min(lowest, c.resultant.normal / length),
        highest = std::max(highest, c.resultant.normal / length);
      }
      CAPTURE(word(top));
      CAPTURE(word(low));
      CHECK(near(lowest, 1e6, 1e-3));
      CHECK(near(highest, 1e6, 1e-3));
      for (int b = 1; b < 5; ++b) CHECK(std::abs(body_pose(sim.model(), sim.state(), b).rotation) < 1e-7);
    }
}

TEST_CASE("virtual power: surface forces do the work of their nodal forces, for every kind of body") {
  for (const auto& kind : kinds) {
    Scene scene = soft_scene(Frictional{1e8, 4e7, 0.6, 0});
    BodySpec spec = made("b", Polygon{{0, 0}, {1.1, 0.1}, {0.9, 0.7}, {0.1, 0.6}}, kind);
    spec.floating = true;
    scene.add(spec);
    const Model<2> model = scene.builder.build();
    State<2> state = initial_state(model);
    Work<2> work;
    for (int n = 0; n < model.nodes(); ++n) {
      state.velocity[n] = {std::sin(3.0 * n + 1), std::cos(5.0 * n)};
      if (kind[0] == 0) state.spin[n] = 1.7, state.rotation[n] = 0.4;
    }
    evaluate(model, state, work, 0);
    double at_skin = 0, at_nodes = 0, size = 0;
    for (std::size_t i = 0; i < work.skin.size(); ++i) {
      const double k = static_cast<double>(i);
      work.skin_force[i] = 1e3 * Vec2(std::cos(k), std::sin(7 * k));
      at_skin += work.skin_force[i].dot(Vec2(work.skin[i].u, work.skin[i].v));
      size += work.skin_force[i].norm() * Vec2(work.skin[i].u, work.skin[i].v).norm();
    }
    Model<2> still = model;
    still.gravity.field = Vec2::Zero();
    std::fill(work.element_force.begin(), work.element_force.end(), Vec2::Zero());
    assemble_forces(still, state, work);
    for (int n = 0; n < model.nodes(); ++n)
      at_nodes += work.force[n].dot(state.velocity[n]) + work.moment[n] * state.spin[n];
    CAPTURE(word(kind));
    CHECK(std::abs(at_skin - at_nodes) < 1e-12 * size);
  }
}

TEST_CASE("a tied point and a force at it are transposes of each other") {
  Scene scene = soft_scene(Frictional{1e8, 4e7, 0.6, 0});
  BodySpec spec = made("b", Polygon{{0, 0}, {1.1, 0.1}, {0.9, 0.7}, {0.1, 0.6}}, {3, 2});
  spec.floating = true;
  scene.add(spec);
  const Model<2> model = scene.builder.build();
  State<2> state = initial_state(model);
  const Turn turn(0.7);
  for (int n = 0; n < model.nodes(); ++n) {
    state.position[n] = turn.apply(model.start_position[n]) + 0.02 * Vec2(std::sin(1.0 + n), std::cos(2.0 * n));
    state.velocity[n] = {std::sin(3.0 * n + 1), std::cos(5.0 * n)};
  }
  const Attachment<2> attachment = tie_point(model, 0, {0.5, 0.3}, "test");
  const Pose pose = pose_at(model, state, attachment);
  const Vec2 force(3, -2);
  const double moment = 0.7;
  std::vector<Vec2> on(state.position.size(), Vec2::Zero());
  std::vector<double> none(state.position.size(), 0.0);
  apply_force(model, state, attachment, force, moment, on, none);
  double power = 0;
  for (std::size_t n = 0; n < on.size(); ++n) power += on[n].dot(state.velocity[n]);
  CHECK(near(power, force.dot(pose.velocity) + moment * pose.spin, 1e-12));
  // The body's spin is the rate of its rotation.
  const double h = 1e-7;
  State<2> later = state;
  for (std::size_t n = 0; n < on.size(); ++n) later.position[n] += h * state.velocity[n];
  CHECK(near((pose_at(model, later, attachment).rotation - pose.rotation) / h, pose.spin, 1e-5));
  CHECK_THROWS_AS(tie_point(model, 0, {3, 3}, "test"), InputError);
}

TEST_CASE("a deformable column on a bearing hangs at its weight over the spring") {
  Scene scene = soft_scene(Frictional{1e8, 4e7, 0.6, 0}, 1e9, 0.2);
  scene.fixed("top", rectangle({-1, 1}, {1, 2}));
  scene.add(made("load", rectangle({-0.25, 0.2}, {0.25, 0.6}), {2, 2}));
  BearingSpec b;
  b.name = "rod", b.body_a = "top", b.body_b = "load", b.point_a = {0, 1}, b.point_b = {0, 0.6};
  b.law = {Linear{1e6, 1e2}, Linear{1e6, 1e2}, Linear{}};
  scene.builder.add_bearing(b);
  Simulation<2> sim = scene.start();
  settle(sim, 50, 1e-8);
  const double weight = body_mass(sim.model(), 1) * standard_gravity;
  sim.refresh();
  CHECK(near(sim.work().bearing_displacement[0].y(), -weight / 1e6, 1e-4));
  CHECK(near(sim.work().bearing_force[0].y(), weight, 1e-4));
}

/// A small stack of bodies of each kind on a shaken base, turned by an angle.
struct Shaken {
  Scene scene;
  explicit Shaken(double turn) : scene(soft_scene(Frictional{1e9, 4e8, 0.5, 1e-5}, 2e8, 0.2, turn, 1e-5)) {
    scene.fixed("base", rectangle({-2, -0.5}, {2, 0}));
    scene.add(made("a", rectangle({-0.5, 0}, {0.5, 0.4}), {1, 1}));
    scene.add(made("b", rectangle({-0.45, 0.4}, {0.45, 0.8}), {2, 2}));
    scene.add(made("c", rectangle({-0.5, 0.8}, {0.5, 1.2}), {0, 0}));
  }
  Simulation<2> start() {
    Model<2> model = scene.builder.build();
    scene.drive_along_x(model, "base",
                        *motion_of(2, 1e-3, [](double t) { return t < 0.4 ? 6 * std::sin(2 * M_PI * 5 * t) : 0; }));
    return Simulation(model);
  }
};

TEST_CASE("deformable bodies shaken in a rotated frame do the same") {
  std::vector<Vec2> moved;
  for (const double turn : {0.0, 17 * degree, 203 * degree}) {
    Shaken shaken(turn);
    Simulation<2> sim = shaken.start();
    run_for(sim, 0.5, 2e-5);
    const Pose pose = body_pose(sim.model(), sim.state(), 2);
    moved.push_back(shaken.scene.to_scene(pose.place - body_start(sim.model(), 2)));
  }
  for (const Vec2& m : moved) CHECK((m - moved[0]).norm() < 1e-6 * (1e-3 + moved[0].norm()));
}

TEST_CASE("deformable bodies: repeated, continued and memory-freed runs give the same bits") {
  Simulation<2> straight = Shaken(0).start(), again = Shaken(0).start(), dropped = Shaken(0).start();
  run_for(straight, 0.1), run_for(again, 0.1);
  CHECK(state_hash(straight.state()) == state_hash(again.state()));
  StageOptions options;
  options.duration = 0.1;
  RunListener<2> drops;
  drops.at_border = [&] {
    if (dropped.state().step % 50 == 0) dropped.drop_work();
  };
  dropped.run(options, drops);
  CHECK(state_hash(straight.state()) == state_hash(dropped.state()));
  const auto path = std::filesystem::temp_directory_path() / ("trilith_deformable_" + std::to_string(::getpid()));
  save_state(straight.state(), straight.model(), path);
  Simulation<2> loaded(straight.model(), load_state(straight.model(), path));
  run_for(straight, 0.1), run_for(loaded, 0.1);
  CHECK(state_hash(straight.state()) == state_hash(loaded.state()));
  std::filesystem::remove(path);
}

TEST_CASE("the energy balance of shaken deformable bodies closes to 0.1 %") {
  Simulation<2> sim = Shaken(0).start();
  EnergyCheck check;
  double first = 0, damping = 0;
  bool begun = false;
  RunListener<2> listener;
  listener.on_energy = [&](const Instant<2>&, const Energy& e) {
    if (!begun) first = e.balance(), begun = true;
    check.add(e, e.balance() - first);
    damping = e[EnergyTerm::element_damping];
  };
  StageOptions options;
  options.duration = 0.6, options.energy_interval = 0.005, options.safety = 0.2;
  sim.run(options, listener);
  MESSAGE("residual ", 100 * check.share(), " % of ", check.input(), " J, dissipated by the elements' damping ",
          damping, " J");
  CHECK(check.share() < 1e-3);
  CHECK(damping > 0);
}

TEST_CASE("a plastic block under a falling weight keeps its energy balance and stays deformed") {
  Scene scene(Frictional{1e9, 4e8, 0.5, 2e-5});
  scene.builder.add_material({"lead", 2000, Solid{J2{2e8, 0.3, 2e4, 1e6}, Plane::stress}});
  scene.fixed("base", rectangle({-2, -0.5}, {2, 0}));
  scene.add(grid_body("soft", rectangle({-0.3, 0}, {0.3, 0.4}), "lead", 3, 2));
  BodySpec weight;
  weight.name = "weight", weight.outline = rectangle({-0.4, 0.5}, {0.4, 0.7}), weight.mass = 300;
  weight.floating = true;
  scene.add(weight);
  Simulation<2> sim = scene.start();
  EnergyCheck check;
  double first = 0, plastic = 0;
  bool begun = false;
  RunListener<2> listener;
  listener.on_energy = [&](const Instant<2>&, const Energy& e) {
    if (!begun) first = e.balance(), begun = true;
    check.add(e, e.balance() - first);
    CHECK(e[EnergyTerm::plastic] >= plastic);
    plastic = e[EnergyTerm::plastic];
  };
  StageOptions options;
  options.duration = 0.5, options.energy_interval = 0.005, options.safety = 0.1;
  sim.run(options, listener);
  MESSAGE("plastic ", plastic, " J of ", check.input(), " J, residual ", 100 * check.share(), " %");
  CHECK(plastic > 0.3 * 300 * standard_gravity * 0.1);
  CHECK(check.share() < 2e-3);
}

TEST_CASE("invalid keys of a deformable body are rejected") {
  const auto message = [](auto&& change) -> std::string {
    Scene scene = soft_scene(Frictional{1e8, 4e7, 0.6, 0});
    BodySpec spec = grid_body("b", rectangle({0, 0}, {1, 1}), "soft", 1, 1);
    change(spec);
    try {
      scene.add(spec);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  CHECK(message([](BodySpec& s) { s.material = "stone"; }).find("needs a material with a stiffness") !=
        std::string::npos);
  CHECK(message([](BodySpec& s) {
          s.outline = {{0, 0}, {1, 0}, {2, 1}, {1, 2}, {0, 1}};
        }).find("four corners") != std::string::npos);
  CHECK(message([](BodySpec& s) { s.inertia = 1; }).find("takes no inertia") != std::string::npos);
  CHECK(message([](BodySpec& s) { s.support[2] = Support::fixed; }).find("no rotation to hold") != std::string::npos);
  Scene scene = soft_scene(Frictional{1e8, 4e7, 0.6, 0});
  scene.add(grid_body("b", rectangle({0, 0}, {1, 1}), "soft", 1, 1));
  Model<2> model = scene.builder.build();
  const auto motion = motion_of(1, 0.1, [](double) { return 0.0; });
  CHECK_THROWS_AS(set_drive(model, 0, 2, motion, 0, 0), InputError);
  const Support before = model.support[0][2];
  set_support(model, 0, 2, Support::free);  // nodes of elements have no rotation
  CHECK(model.support[0][2] == before);
}

TEST_CASE("deformable bodies that collide corner on face with friction and damping close the energy balance") {
  // The bodies are so soft that a corner's velocity differs much from the velocity of a rigid piece: the power of
  // contact forces must be computed with the velocities of corners.
  for (const auto& kind : kinds) {
    Scene scene = soft_scene(Frictional{1e9, 5e8, 0.5, 5e-4}, 1e8, 0.2);
    scene.set_gravity(Vec2::Zero());
    scene.add(made("low", rectangle({-1, -0.5}, {1, 0}), kind));
    const Turn turn(0.2);
    Polygon corners = rectangle({-0.5, -0.2}, {0.5, 0.2});
    for (Vec2& p : corners) p = Vec2(0, 0.301) + turn.apply(p);
    BodySpec high = made("high", corners, kind);
    high.velocity = {2, -5};
    scene.add(high);
    Simulation<2> sim = scene.start();
    StageOptions options;
    options.duration = 0.1, options.safety = 0.1;
    sim.run(options);
    const Energy energy = energy_now(sim.model(), sim.state(), sim.work(), {sim.state().last_dt, {}});
    const double put_in = 0.5 * 2000 * 0.4 * (2 * 2 + 5 * 5);
    CAPTURE(word(kind));
    CHECK(std::abs(energy.balance() - put_in) < 1e-3 * put_in);
    CHECK(energy[EnergyTerm::contact_damping] > 0.05 * put_in);
    CHECK(energy[EnergyTerm::contact_friction] > 0.005 * put_in);
  }
}

}  // namespace
}  // namespace trilith::testing
