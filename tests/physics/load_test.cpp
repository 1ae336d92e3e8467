// Loads, prescribed displacements, quiet release and pushover against closed forms and the energy ledger; the same bits
// for the same run.
#include <unistd.h>

#include <filesystem>

#include "edit/release.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "load/ramp.hpp"
#include "model/check/energy_check.hpp"
#include "model/io/checkpoint.hpp"
#include "model/loads.hpp"
#include "model/pushes.hpp"
#include "near.hpp"
#include "physics/space/solids.hpp"
#include "run/pushover.hpp"
#include "run/record/body_forces.hpp"

namespace trilith::testing {
namespace {

constexpr double g = standard_gravity;

PointLoad<2> force_on_body(const Model<2>& model, const std::string& body, const std::optional<Vec2>& at,
                           const Vec2& force, const LoadCurve& curve = {}) {
  PointLoadSpec spec;
  spec.name = "P", spec.at = at, spec.force = force, spec.curve = curve;
  return make_point_load(model, model.find_body(body), spec).front();
}

/// A block 1 m wide and 0.5 m high on a fixed base, on springs of `kn` [Pa/m].
Scene block_on_base(double kn, double mu = 0.6, double beta = 1e-5) {
  Scene scene(Frictional{kn, kn, mu, beta});
  scene.fixed("base", rectangle({-3, -1}, {3, 0}));
  scene.block("block", rectangle({-0.5, 0}, {0.5, 0.5}), 1000);
  return scene;
}

Energy ledger(const Simulation<2>& sim) {
  return energy_now(sim.model(), sim.state(), sim.work(), {sim.state().dt, {}});
}

TEST_CASE("an eccentric load on a block on springs moves and tilts it by the closed form") {
  const double kn = 1e10, weight = 1000 * g;
  for (const double e : {0.1, -0.06}) {
    Scene scene = block_on_base(kn);
    Simulation<2> sim = scene.start();
    settle(sim);
    const int n = node_of(sim.model(), "block");
    const double before = sim.state().position[n].y();
    CHECK(near(before - 0.25, -weight / kn, 1e-6));
    const double force = 2e4;
    const double now = sim.state().time;
    Model<2>& model = sim.edit_model();
    loads_of<PointLoad<2>>(model).push_back(
        force_on_body(model, "block", Vec2(e, 0.5), {0, -force}, ramp_curve(now, 0, 1, 0.05, true)));
    run_for(sim, 0.06);
    settle(sim);
    // The weight of the tilted block adds a moment of 1e-6 of the springs' moment.
    const double settled = force / kn, tilt = -force * e / (kn / 12);
    MESSAGE("settlement ", before - sim.state().position[n].y(), " m (", settled, "), tilt ", sim.state().rotation[n],
            " (", tilt, ")");
    CHECK(near(before - sim.state().position[n].y(), settled, 1e-4));
    CHECK(near(sim.state().rotation[n], tilt, 1e-4));
  }
}

TEST_CASE("the energy balance has the work of a load as force times displacement of its point, and closes") {
  Scene scene = block_on_base(1e8);
  Simulation<2> sim = scene.start();
  settle(sim);
  StageOptions options;
  options.duration = 0.01, options.safety = 0.1;
  sim.run(options);  // the step then has the same length before and after the load jumps
  sim.refresh();
  const Energy before = ledger(sim);
  const Vec2 at(0.15, 0.5), force(3e3, -2e4);
  const auto point = [&] {
    const int n = node_of(sim.model(), "block");
    return Vec2(sim.state().position[n] + Turn(sim.state().rotation[n]).apply(Vec2(at - Vec2(0, 0.25))));
  };
  const Vec2 from = point();
  Model<2>& model = sim.edit_model();
  loads_of<PointLoad<2>>(model).push_back(force_on_body(model, "block", at, force));
  EnergyCheck check;
  options.duration = 1, options.energy_interval = 1e-3;
  RunListener<2> listener;
  listener.on_energy = [&](const Instant<2>&, const Energy& e) { check.add(e, e.balance() - before.balance()); };
  sim.run(options, listener);
  sim.refresh();
  const double work = ledger(sim)[EnergyTerm::load] - before[EnergyTerm::load];
  MESSAGE("work ", work, " J, force times way ", force.dot(point() - from), " J, residual ", check.residual(), " of ",
          check.input(), " J");
  CHECK(near(work, force.dot(point() - from), 1e-6));
  CHECK(check.share() < 1e-3);
}

TEST_CASE("a free mass under a load over time gains the kinetic energy of the energy balance") {
  ModelBuilder builder;
  builder.gravity = Vec2::Zero();
  builder.add_material({"stone", 2000});
  BodySpec spec;
  spec.name = "block", spec.outline = rectangle({0, 0}, {1, 1}), spec.material = "stone", spec.mass = 8;
  spec.floating = true;
  builder.add_body(spec);
  Model<2> model = builder.build();
  loads_of<PointLoad<2>>(model).push_back(force_on_body(model, "block", {}, {4, 0}, LoadCurve{{0, 1, 2}, {0, 1, 0}}));
  Simulation<2> sim(std::move(model));
  run_for(sim, 3, 1e-3);
  sim.refresh();
  const double speed = 4 * 1.0 / 8;  // impulse 4 N s
  CHECK(near(sim.state().velocity[0].x(), speed, 1e-6));
  CHECK(near(ledger(sim)[EnergyTerm::load], 0.5 * 8 * speed * speed, 1e-5));
  CHECK(std::abs(ledger(sim).balance()) < 1e-12);
}

TEST_CASE("pressure on deformable bodies gives even stress") {
  const double p = 1e3;
  const auto stresses = [&](const Polygon& outline, int divisions, bool all_round, double thickness) {
    BodySpec spec = grid_body("b", outline, "soft", divisions, divisions);
    spec.thickness = thickness;
    Model<2> model = alone(elastic("soft", 2000, 1e9, 0.3, Plane::stress, ElementForm::assumed, 1e-4), spec);
    PressureSpec order;
    order.name = "p", order.value = p, order.curve = ramp_curve(0, 0, 1, 0.01, true);
    std::vector<FacePart> faces = outline_faces(model, 0);
    if (!all_round) {
      faces = faces_towards(model, 0, {1, 0});
      for (const FacePart& f : faces_towards(model, 0, {-1, 0})) faces.push_back(f);
    }
    loads_of<FaceLoad<2>>(model) = make_pressure(model, 0, faces, order);
    Simulation<2> sim(std::move(model));
    run_for(sim, 0.02);
    settle(sim, 1, 1e-13);
    double worst = 0;
    for (std::size_t e = 0; e < sim.model().elements.size(); ++e) {
      const auto s = in_world(element_stress(sim.model(), sim.state(), static_cast<int>(e)));
      worst = std::max({worst, std::abs(s.xx + p), std::abs(s.yy + (all_round ? p : 0)), std::abs(s.xy)});
    }
    return worst / p;
  };
  const Polygon crooked{{0, 0}, {1.1, 0.1}, {0.9, 0.7}, {0.1, 0.6}};
  for (const int divisions : {1, 3}) {
    const double sides = stresses(rectangle({0, 0}, {1, 0.5}), divisions, false, 1);
    const double round = stresses(crooked, divisions, true, 0.3);
    MESSAGE(divisions, " by ", divisions, ": off by ", sides, " between two sides, ", round, " all round, of the size");
    CHECK(sides < 1e-6);  // strains are 1e-6, and the load follows the current lengths of the faces
    CHECK(round < 1e-6);
  }
}

TEST_CASE("a driven body on a ramp lands at its end and stays, turning too") {
  Scene scene = block_on_base(1e9);
  Model<2> model = scene.builder.build();
  const int n = node_of(model, "base"), base = model.find_body("base");
  set_drive(model, base, 0, std::make_shared<GroundMotion>(ramp_motion(0.02, 0.7)), 0, model.start_position[n].x());
  set_drive(model, base, 2, std::make_shared<GroundMotion>(ramp_motion(-0.01, 0.5)), 0, 0);
  Simulation<2> sim(std::move(model));
  run_for(sim, 0.75);
  CHECK(std::abs(sim.state().position[n].x() - (sim.model().start_position[n].x() + 0.02)) < 1e-15);
  CHECK(std::abs(sim.state().rotation[n] + 0.01) < 1e-16);
  run_for(sim, 0.01);
  CHECK(std::abs(sim.state().velocity[n].x()) < 1e-12);
  CHECK(std::abs(sim.state().spin[n]) < 1e-12);
}

struct Pushed {
  PushCurve curve;
  Energy energy;
  double base_shear = 0, force = 0, ledger_start = 0;
  std::uint64_t hash = 0;
};

/// Pushes the block of a settled scene along x by `way` [m].
Pushed push_block(Scene& scene, double way, double speed, const std::optional<Vec2>& at = {}) {
  Simulation<2> sim = scene.start();
  settle(sim);
  sim.refresh();
  Pushed result;
  result.ledger_start = ledger(sim).balance();
  Model<2>& model = sim.edit_model();
  const Vec2 direction(way > 0 ? 1 : -1, 0);
  const auto motion = std::make_shared<GroundMotion>(even_motion(std::abs(way), speed));
  const int block = model.find_body("block");
  add_push(model, sim.state(), "push", push_rows(model, {block}, at, PushPattern::mass, direction), direction, motion);
  PushoverRecorder<2> recorder("push", motion->duration() / 200, {}, [](const Instant<2>&) { return 0.0; });
  StageOptions options;
  options.duration = motion->duration(), options.rest_share = 0.8;
  sim.run(options, each_step([&](const Instant<2>& now) { recorder.step(now); }));
  recorder.finish();
  sim.refresh();
  result.curve = recorder.curve();
  result.energy = ledger(sim);
  result.base_shear = force_on(sim.model(), sim.work(), std::vector<int>{0}).x();
  result.force = sim.work().push_force[0] * direction.x();
  result.hash = state_hash(sim.state());
  const double reached = push_place(sim.state(), sim.model().pushes[0]) - sim.model().pushes[0].origin;
  CHECK(near(reached, std::abs(way), 1e-9));
  return result;
}

TEST_CASE("a pushed block on friction takes mu W either way, and the base feels it") {
  for (const double mu : {0.3, 0.7})
    for (const double way : {0.01, -0.01}) {
      Scene scene = block_on_base(1e9, mu, 1e-4);
      const Pushed p = push_block(scene, way, 2e-3);
      const double friction = mu * 1000 * g, elastic = friction / 1e9;
      double least = 1e300, most = 0;
      for (std::size_t i = 20; i < 190; ++i)  // at constant speed
        least = std::min(least, p.curve.force[i]), most = std::max(most, p.curve.force[i]);
      MESSAGE("mu ", mu, " way ", way, ": force ", least, " to ", most, " N (", friction, "), peak ",
              p.curve.force[p.curve.peak()]);
      CHECK(near(least, friction, 1e-3));
      CHECK(near(most, friction, 1e-3));
      CHECK(near(p.curve.force[p.curve.peak()], friction, 0.01));
      CHECK(near(p.base_shear, p.force, 1e-3));
      CHECK(near(p.energy[EnergyTerm::load], friction * (0.01 - 0.5 * elastic), 2e-3));
      CHECK(std::abs(p.energy.balance() - p.ledger_start) < 1e-3 * p.energy[EnergyTerm::load]);
    }
}

TEST_CASE("a slender block pushed aside takes the force that lifts it off its toe of springs") {
  // Rocking on springs: the toe's pressure is a triangle of length c = sqrt(2 W / (kn theta)), so F h = W (b/2 - c/3 -
  // theta h), which approaches W b / (2 h) for stiff springs.
  const double b = 0.25, h = 0.5, weight = 1000 * g;
  for (const double kn : {1e9, 1e10})
    for (const double sign : {1.0, -1.0}) {
      Scene scene(Frictional{kn, kn, 0.8, 1e-4});
      scene.fixed("base", rectangle({-3, -1}, {3, 0}));
      scene.block("block", rectangle({-b / 2, 0}, {b / 2, 2 * h}), 1000);
      const Pushed p = push_block(scene, sign * 0.02, 2e-3);
      double expected = 0;
      for (double theta = 1e-4; theta < 0.04; theta += 1e-5)
        expected = std::max(expected, weight * (b / 2 - std::sqrt(2 * weight / (kn * theta)) / 3 - theta * h) / h);
      const double peak = p.curve.force[p.curve.peak()];
      MESSAGE("kn ", kn, ": peak ", peak, " N (", expected, "), without springs ", weight * b / 2 / h);
      CHECK(near(peak, expected, 0.01));
      CHECK(peak < weight * b / 2 / h);
      CHECK(std::abs(p.energy.balance() - p.ledger_start) < 1e-3 * p.energy[EnergyTerm::load]);
    }
}

TEST_CASE("pushed at its top, a squat block slides and a slender one rocks, at the lesser of mu W and W b / (2 h)") {
  const double weight = 1000 * g;
  for (const double mu : {0.15, 0.35}) {
    Scene scene(Frictional{1e10, 1e10, mu, 1e-4});
    scene.fixed("base", rectangle({-3, -1}, {3, 0}));
    scene.block("block", rectangle({-0.25, 0}, {0.25, 1}), 1000);  // b / (2 h) = 0.25 at the top
    const Pushed p = push_block(scene, 0.01, 5e-4, Vec2(0, 1));
    const double peak = p.curve.force[p.curve.peak()] / weight;
    MESSAGE("mu ", mu, ": peak ", peak, " W");
    if (mu < 0.25) CHECK(near(peak, mu, 0.01));
    if (mu > 0.25) CHECK(peak < 0.25);
    if (mu > 0.25) CHECK(peak > 0.23);
  }
}

TEST_CASE("two pushovers have the same bits") {
  const auto run = [] {
    Scene scene = block_on_base(1e9);
    return push_block(scene, 0.002, 2e-3).hash;
  };
  CHECK(run() == run());
}

TEST_CASE("a push on a set prescribes the weighted mean displacement of its bodies") {
  Scene scene(Frictional{1e9, 1e9, 0.5, 1e-4});
  scene.fixed("base", rectangle({-3, -1}, {9, 0}));
  scene.block("heavy", rectangle({0, 0}, {1, 0.5}), 2000);
  scene.block("light", rectangle({3, 0}, {4, 0.5}), 1000);
  Simulation<2> sim = scene.start();
  settle(sim);
  Model<2>& model = sim.edit_model();
  const auto motion = std::make_shared<GroundMotion>(even_motion(0.01, 5e-3));
  add_push(model, sim.state(), "push", push_rows(model, {1, 2}, {}, PushPattern::uniform, Vec2::UnitX()), Vec2::UnitX(),
           motion);
  const double heavy = sim.state().position[1].x(), light = sim.state().position[2].x();
  StageOptions options;
  options.duration = motion->duration(), options.rest_share = 0.8;
  double force = 0, time = 0;
  sim.run(options, each_step([&](const Instant<2>& now) {
            if (now.state.time < 0.5 * motion->duration() || now.state.time > 0.9 * motion->duration()) return;
            force += now.dt * now.work.push_force[0], time += now.dt;
          }));
  // Each body takes half of the force: the light body slides at 2 mu m g in total, the heavy one stays.
  CHECK(near(sim.state().position[2].x() - light, 0.02, 1e-3));
  CHECK(std::abs(sim.state().position[1].x() - heavy) < 1e-5);
  CHECK(near(force / time, 2 * 0.5 * 1000 * g, 2e-3));
}

/// Largest displacement below the equilibrium after a fixed block is released, as a share of the static deflection.
double overshoot(double fade, double* energy_off = nullptr) {
  const double kn = 1e7, deflection = 1000 * g / kn;
  Scene scene = block_on_base(kn, 0.6, 1e-6);
  Model<2> model = scene.builder.build();
  for (const int k : {0, 1, 2}) set_support(model, 1, k, Support::fixed);
  Simulation<2> sim(std::move(model));
  run_for(sim, 0.01);
  sim.refresh();
  const double before = ledger(sim).balance();
  sim.change_supports([&](Model<2>& m) { release_supports(m, sim.state(), 1, {true, true, true}, fade); });
  CHECK(sim.model().moves(1));
  double lowest = 0, rubbed = 0;
  run_for(sim, fade + 1, 0, each_step([&](const Instant<2>& now) {
            lowest = std::min(lowest, now.state.position[1].y() - 0.25);
            if (now.state.time > 0.01 + fade) rubbed = std::max(rubbed, std::abs(now.state.velocity[1].y()));
          }));
  sim.refresh();
  if (energy_off != nullptr) *energy_off = std::abs(ledger(sim).balance() - before) / (0.5 * 1000 * g * deflection);
  const double swing = rubbed / std::sqrt(kn / 1000);  // amplitude of the remaining vibration
  return std::max(-lowest / deflection - 1, swing / deflection);
}

TEST_CASE("a fixed block that is freed quietly settles without swinging, and suddenly freed swings by its deflection") {
  double off = 0;
  const double quiet = overshoot(1.0, &off), sudden = overshoot(0);
  MESSAGE("swing of the static deflection: quiet ", quiet, ", sudden ", sudden, "; ledger off by ", off);
  CHECK(quiet < 0.01);
  CHECK(sudden > 0.9);
  CHECK(off < 1e-3);
}

TEST_CASE("a body that stands by itself does not move when its supports are released") {
  Scene scene = block_on_base(1e9);
  Simulation<2> sim = scene.start();
  settle(sim, 100, 1e-12);
  for (const int k : {0, 1, 2}) set_support(sim.edit_model(), 1, k, Support::fixed);
  run_for(sim, 0.01);
  sim.refresh();
  const Vec2 from = sim.state().position[1];
  sim.change_supports([&](Model<2>& m) { release_supports(m, sim.state(), 1, {true, true, true}, 0.1); });
  run_for(sim, 0.5);
  CHECK((sim.state().position[1] - from).norm() < 1e-9 * 1e-3);
}

TEST_CASE("a released push leaves its force as a load that fades, and the block springs back slowly") {
  Scene scene = block_on_base(1e7);
  Simulation<2> sim = scene.start();
  settle(sim);
  Model<2>& model = sim.edit_model();
  const double way = 1e-4, speed = 1e-4;  // elastic: 0.6 W needs 5.9e-4 m
  const auto motion = std::make_shared<GroundMotion>(even_motion(way, speed));
  add_push(model, sim.state(), "push", push_rows(model, {1}, {}, PushPattern::mass, Vec2::UnitX()), Vec2::UnitX(),
           motion);
  StageOptions options;
  options.duration = motion->duration() + 0.2, options.rest_share = 0.8;
  sim.run(options);
  sim.refresh();
  CHECK(release_push(sim.edit_model(), sim.state(), sim.work(), "push", 1));
  CHECK_FALSE(release_push(sim.edit_model(), sim.state(), sim.work(), "push", 1));
  double fastest = 0;
  options.duration = 1.5;
  sim.run(options, each_step([&](const Instant<2>& now) { fastest = std::max(fastest, now.speed); }));
  CHECK(std::abs(sim.state().position[1].x()) < 0.01 * way);
  CHECK(fastest < 4 * way / 1);  // the quintic's peak speed is 1.9 times its mean; a sudden release would swing at 0.01
                                 // m/s
}

TEST_CASE("a checkpoint continues to the same bits while a load curve, a ramp and a push run") {
  const auto path = std::filesystem::temp_directory_path() / ("trilith_load_" + std::to_string(::getpid()));
  Scene scene = block_on_base(1e9);
  Model<2> model = scene.builder.build();
  loads_of<PointLoad<2>>(model).push_back(
      force_on_body(model, "block", Vec2(0.2, 0.5), {0, -3e3}, ramp_curve(0.02, 0, 1, 0.2, true)));
  PressureSpec pressure;
  pressure.name = "p", pressure.value = 500, pressure.curve = LoadCurve{{0, 0.1, 0.3}, {0, 1, 0.2}};
  loads_of<FaceLoad<2>>(model) = make_pressure(model, 1, faces_towards(model, 1, {1, 0}), pressure);
  set_drive(model, 0, 0, std::make_shared<GroundMotion>(ramp_motion(1e-3, 0.25)), 0, model.start_position[0].x());
  add_push(model, initial_state(model), "push", push_rows(model, {1}, {}, PushPattern::mass, Vec2::UnitX()),
           Vec2::UnitX(), std::make_shared<GroundMotion>(even_motion(2e-3, 1e-2)));
  Simulation<2> whole(model);
  run_for(whole, 0.1);
  save_state(whole.state(), whole.model(), path);
  run_for(whole, 0.2);
  Simulation<2> parts(model, load_state(model, path));
  run_for(parts, 0.2);
  CHECK(state_hash(parts.state()) == state_hash(whole.state()));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace trilith::testing
