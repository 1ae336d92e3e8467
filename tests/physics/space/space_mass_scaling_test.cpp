// Mass scaling of deformable bodies in space: added mass acts against deformation only, so that steps are longer.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "integrate/explicit/mass_scaling.hpp"
#include "law/bearing/linear.hpp"
#include "near.hpp"
#include "physics/space/space_solids.hpp"
#include "run/simulation.hpp"

namespace trilith::testing {
namespace {

constexpr double rod_young = 1e9, rod_density = 2000, rod_length = 2, rod_depth = 0.1;

SolidSpec rod_spec(int divisions, ElementShape shape) {
  return box_of("rod", box_solid(Vec3::Zero(), Vec3(rod_length, rod_depth, rod_depth)), "m", {divisions, 1, 1}, shape);
}

double plain_step(const Model<3>& model) {
  Work<3> work;
  const State<3> state = initial_state(model);
  evaluate(model, state, work, 0.0);
  return stable_step(model, state, work).dt;
}

/// A stage with steps of `times` the stable step of `model`.
StageOptions longer_steps(const Model<3>& model, double times, double duration) {
  StageOptions options;
  options.duration = duration;
  options.mass_scaling.emplace();
  options.mass_scaling->step = times * options.safety * plain_step(model);
  options.mass_scaling->most = 1000;
  return options;
}

/// Fixed steps with one mass share for all bodies.
class SharedRun {
 public:
  SharedRun(const Model<3>& model, double share, double dt) : model_(model), state_(initial_state(model)) {
    options_.dt = dt;
    if (share > 0) state_.added_share.assign(model.bodies.size(), share);
    look();
  }
  void run(double seconds, const std::function<void()>& each = {}) {
    for (auto left = std::lround(seconds / options_.dt); left > 0; --left) {
      commit(model_, state_, work_);
      advance(model_, state_, work_, options_);
      look();
      if (each) each();
    }
  }
  State<3>& state() { return state_; }
  [[nodiscard]] Energy energy() const { return energy_now(model_, state_, work_, options_); }
  [[nodiscard]] double mass() const {
    double sum = 0;
    for (const double m : model_.mass) sum += m;
    return sum;
  }
  [[nodiscard]] Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t n = 0; n < model_.mass.size(); ++n) sum += model_.mass[n] * state_.velocity[n];
    return sum;
  }
  [[nodiscard]] Vec3 centre() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t n = 0; n < model_.mass.size(); ++n) sum += model_.mass[n] * state_.position[n];
    return sum / mass();
  }
  [[nodiscard]] Vec3 angular_momentum() const {
    const Vec3 middle = centre();
    Vec3 sum = Vec3::Zero();
    for (std::size_t n = 0; n < model_.mass.size(); ++n)
      sum += cross(Vec3(state_.position[n] - middle), Vec3(model_.mass[n] * state_.velocity[n]));
    return sum;
  }

 private:
  void look() {
    evaluate(model_, state_, work_, state_.last_dt);
    add_inertia(model_, state_, work_, options_);
  }
  Model<3> model_;
  State<3> state_;
  Work<3> work_;
  StepOptions options_;
};

/// Period of the oscillation along x of the node farthest along x [s].
double swing_time(const Model<3>& model, const StageOptions& options, StageReport& report) {
  Simulation<3> sim(model);
  int end = 0;
  for (int n = 0; n < model.nodes(); ++n)
    if (model.start_position[n].x() > model.start_position[end].x()) end = n;
  double first = -1, last = -1, before = 0;
  int passages = 0;
  RunListener<3> listener;
  listener.on_step = [&](const Instant<3>& now) {
    const double v = now.state.velocity[end].x();
    if (before != 0 && before * v < 0) {
      const double at = now.state.time - now.state.last_dt * v / (v - before);
      (first < 0 ? first : last) = at;
      if (last >= 0) ++passages;
    }
    before = v;
  };
  report = sim.run(options, listener);
  REQUIRE(passages > 3);
  return 2 * (last - first) / passages;
}

TEST_CASE("mass scaling in space: a held rod swings slower by the root of its mass and the added one over its mass") {
  const double period = 4 * rod_length / std::sqrt(rod_young / rod_density);
  for (const ElementShape shape : all_shapes) {
    CAPTURE(std::string(info_of(shape).name));
    Model<3> model = alone_in_space(elastic_in("m", rod_density, rod_young, 0), rod_spec(20, shape));
    for (int n = 0; n < model.nodes(); ++n) {
      const double x = model.start_position[n].x();
      model.support[n][1] = model.support[n][2] = Support::fixed;  // motion along the rod alone
      if (x < 1e-9) model.support[n][0] = Support::fixed;
      model.start_velocity[n].x() = 0.01 * std::sin(0.5 * M_PI * x / rod_length);
    }
    const StageOptions options = longer_steps(model, 4, 12 * period);
    StageOptions plain = options;
    plain.mass_scaling.reset(), plain.duration = 4 * period;
    StageReport report, plainly;
    const double slowed = swing_time(model, options, report), found = swing_time(model, plain, plainly);
    REQUIRE(report.scaled);
    const double share = report.scaled->most;
    MESSAGE("added ", share, " times the mass, period ", slowed / found, " of the plain one");
    CHECK(near(found, period, 5e-3));
    CHECK(near(share, 15, 0.01));  // the step is proportional to the square root of the mass
    CHECK(near(slowed, found * std::sqrt(1 + share), 1e-3));
    CHECK(near(report.scaled->share, share, 1e-12));  // this rod is the whole model
    CHECK(near(report.scaled->energy, share * report.scaled->kinetic, 1e-9));
    CHECK(near(report.longest_dt, options.mass_scaling->step, 1e-12));
    CHECK(near(report.scaled->before, report.longest_dt / 4, 0.09));  // at most one rung of the step ladder below
    CHECK_FALSE(plainly.scaled);
  }
}

TEST_CASE("mass scaling in space: the requested step is stable, and without scaling it is unstable") {
  for (const ElementShape shape : all_shapes) {
    CAPTURE(std::string(info_of(shape).name));
    const Model<3> model = alone_in_space(
        elastic_in("m", 2000, 1e9, 0.2), mesh_spec("b", "m", distorted_box(Vec3(1, 0.8, 0.6), {2, 2, 2}, shape, 0.05)));
    const double asked = 5 * plain_step(model);
    Work<3> work;
    State<3> state = initial_state(model);
    evaluate(model, state, work, 0.0);
    ScaledMass found;
    MassScaling scaling;
    scaling.step = asked;
    scale_masses(model, state, work, scaling, 1, true, found);
    CHECK(found.most > 20);
    CHECK(near(stable_step(model, state, work).dt, asked, 1e-9));
    const auto grown = [&](double share, double dt) {
      SharedRun run(model, share, dt);
      std::mt19937_64 bits(3);
      for (Vec3& v : run.state().velocity) v = 1e-3 * random_in_ball(bits);
      run.run(3000 * dt);
      double sum = 0;  // not a number after overflow
      for (const Vec3& v : run.state().velocity) sum += v.norm();
      return sum / model.nodes() / 1e-3;
    };
    CHECK(grown(found.most, 0.95 * asked) < 10);
    CHECK_FALSE(grown(0, 0.95 * asked) < 1e3);
    CHECK_FALSE(grown(found.most, 1.6 * asked) < 1e3);
  }
}

/// A thrown box that tumbles about all of its axes.
Model<3> tumbling_box(ElementShape shape, const std::array<Support, 6>& support = {}) {
  SolidSpec spec = box_of("b", box_solid(Vec3::Zero(), Vec3(1, 0.5, 0.25)), "m", {2, 2, 1}, shape);
  const bool is_held = support[1] != Support::free;
  spec.support = support;
  spec.velocity = Vec3(1, is_held ? 0 : 2, 3);
  spec.spin = is_held ? Vec3(0, 8, 0) : Vec3(3, 8, 2);
  Model<3> model = alone_in_space(elastic_in("m", 2000, 1e9, 0.3), spec);
  model.gravity.field = Vec3(0, 0, -standard_gravity);
  return model;
}

TEST_CASE("mass scaling in space: free flight and rotation are unchanged") {
  for (const ElementShape shape : all_shapes) {
    CAPTURE(std::string(info_of(shape).name));
    const Model<3> model = tumbling_box(shape);
    const double dt = 0.5 * plain_step(model), share = 25;
    SharedRun plain(model, 0, dt), scaled(model, share, dt);
    const Vec3 angular = scaled.angular_momentum();
    plain.run(0.3), scaled.run(0.3);
    CHECK((scaled.centre() - plain.centre()).norm() < 1e-12);
    CHECK((scaled.momentum() - plain.momentum()).norm() < 1e-12 * plain.momentum().norm());
    CHECK((scaled.angular_momentum() - angular).norm() < 1e-11 * angular.norm());
    double apart = 0;
    for (std::size_t n = 0; n < model.mass.size(); ++n)
      apart = std::max(apart, (scaled.state().position[n] - plain.state().position[n]).norm());
    // Both oscillate about their stretch, of the order of rho w^2 l^3 / 3E. If the added mass acted on the rotation,
    // the stretch and the moments of inertia would be off by `share` times as much, and so would 2.6 rad of rotation.
    const double stretch = 2000 * 77 * std::pow(0.5, 3) / 3e9;
    MESSAGE("nodes are ", apart / stretch, " stretches apart");
    CHECK(apart < 4 * stretch);
  }
}

TEST_CASE("mass scaling in space: a rod that spins is stretched by rho w^2 l^3 / 3E, as its own mass has it") {
  const double spin = 20, half = 0.5 * rod_length, load = rod_density * spin * spin / rod_young;
  Model<3> model = alone_in_space(elastic_in("m", rod_density, rod_young, 0), rod_spec(20, ElementShape::brick));
  const Vec3 middle(half, 0.5 * rod_depth, 0.5 * rod_depth);
  for (int n = 0; n < model.nodes(); ++n) {
    const Vec3 arm = model.start_position[n] - middle;
    model.start_velocity[n] = cross(Vec3(0, 0, spin), arm);
  }
  SharedRun run(model, 15, 0.5 * plain_step(model));
  // Starts with its equilibrium stretch, so that it does not oscillate.
  for (int n = 0; n < model.nodes(); ++n) {
    const Vec3 arm = model.start_position[n] - middle;
    run.state().position[n].x() += 0.5 * load * (half * half - arm.x() * arm.x() / 3) * arm.x();
  }
  double sum = 0;
  int count = 0;
  run.run(0.5, [&] {
    const auto end_at = [&](double x) {
      Vec3 place = Vec3::Zero();
      for (int n = 0; n < model.nodes(); ++n)
        if (std::abs(model.start_position[n].x() - x) < 1e-9) place += run.state().position[n] / 4;
      return place;
    };
    sum += (end_at(rod_length) - end_at(0)).norm(), ++count;
  });
  const double stretch = 0.5 * (sum / count - rod_length), expected = load * half * half * half / 3;
  MESSAGE("stretched by ", stretch / expected, " of what it should be");
  CHECK(near(stretch, expected, 0.02));
}

TEST_CASE("mass scaling in space: a body held in a plane keeps its motion along the plane") {
  const std::array<Support, 6> in_plane{Support::free, Support::fixed, Support::free};
  const Model<3> model = tumbling_box(ElementShape::brick, in_plane);
  const double dt = 0.5 * plain_step(model);
  SharedRun plain(model, 0, dt), scaled(model, 25, dt);
  const double angular = scaled.angular_momentum().y();
  plain.run(0.3), scaled.run(0.3);
  CHECK((scaled.centre() - plain.centre()).norm() < 1e-12);
  CHECK((scaled.momentum() - plain.momentum()).norm() < 1e-12 * plain.momentum().norm());
  CHECK(near(scaled.angular_momentum().y(), angular, 1e-11));
  CHECK(std::abs(angular) > 1);
}

TEST_CASE("mass scaling in space: the energy of a tumbling and vibrating body is conserved") {
  Model<3> model = tumbling_box(ElementShape::brick);
  std::mt19937_64 bits(7);
  for (Vec3& v : model.start_velocity) v += 0.2 * random_in_ball(bits);
  SharedRun run(model, 25, 2 * plain_step(model));
  const double begun = run.energy().balance(), moving = run.energy()[EnergyTerm::kinetic];
  const double added = added_energy(model, run.state());
  double most = 0;
  run.run(2, [&] { most = std::max(most, std::abs(run.energy().balance() - begun)); });
  MESSAGE("the balance strays by ", most, " of ", moving, " J, of which the added mass had ", added);
  CHECK(added > 0.01 * moving);
  CHECK(most < 2e-3 * moving);
}

/// A meshed cube of 1 m between a wall and a free side, on a spring along one axis at the middle of a face.
Model<3> cube_on_spring(std::size_t axis, double stiffness) {
  SolidModelBuilder builder;
  builder.gravity = Vec3::Zero();
  builder.add_material(elastic_in("m", 2000, 1e9, 0.2));
  SolidSpec wall;
  wall.name = "wall", wall.pieces = {box_solid(Vec3(-1, 0, 0), Vec3(-0.5, 1, 1))}, wall.material = "m";
  wall.support.fill(Support::fixed);
  builder.add_body(wall);
  builder.add_body(box_of("b", box_solid(Vec3(0, 0, 0), Vec3(1, 1, 1)), "m", {3, 3, 3}));
  BearingSpecOf<3> spring;
  spring.name = "spring", spring.body_a = "wall", spring.body_b = "b";
  spring.point_a = Vec3(-0.5, 0.5, 0.5), spring.point_b = Vec3(0, 0.5, 0.5);
  spring.law[axis] = Linear{stiffness, 0};
  builder.add_bearing(spring);
  return builder.build();
}

TEST_CASE("mass scaling in space: a nearly rigid body on a spring keeps its period, and the bound contains it") {
  const double stiffness = 1e6, mass = 2000, period = 2 * M_PI * std::sqrt(mass / stiffness);
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    const Model<3> model = cube_on_spring(axis, stiffness);
    const State<3> state = initial_state(model);
    Work<3> work;
    evaluate(model, state, work, 0.0);
    double inertia = 0;
    for (int n = 1; n < model.nodes(); ++n)
      inertia += model.mass[n] * (model.start_position[n] - Vec3(0.5, 0.5, 0)).head<2>().squaredNorm();
    const double rate = stiffness / mass + (axis == 1 ? stiffness * 0.25 / inertia : 0);
    CHECK(near(body_rates(model, state, work, true)[1].rigid.stiffness, rate, 1e-9));
  }
  Model<3> model = cube_on_spring(0, stiffness);
  for (int n = 1; n < model.nodes(); ++n) model.start_velocity[n].x() = 0.01;
  const StageOptions options = longer_steps(model, 4, 4 * period);
  StageReport report;
  CHECK(near(swing_time(model, options, report), period, 5e-3));
  REQUIRE(report.scaled);
  CHECK(report.scaled->most > 10);
}

TEST_CASE("mass scaling in space: the deflection of a cantilever of bricks under its weight does not change") {
  std::array<double, 2> bent{};
  for (const bool scaled : {false, true}) {
    SolidSpec spec = box_of("c", box_solid(Vec3::Zero(), Vec3(1, 0.2, 0.2)), "m", {6, 1, 2});
    spec.supports = {{Vec3(0, 0, 0), Vec3(0, 0.2, 0.2), {Support::fixed, Support::fixed, Support::fixed}}};
    Model<3> model = alone_in_space(elastic_in("m", 2000, 1e9, 0.2), spec);
    model.gravity.field = Vec3(0, 0, -standard_gravity);
    StageOptions options = longer_steps(model, 3, 2);
    options.rest_share = 0.8;
    if (!scaled) options.mass_scaling.reset();
    Simulation<3> sim(model);
    sim.run(options);
    for (int n = 0; n < model.nodes(); ++n)
      bent[scaled] = std::min(bent[scaled], sim.state().position[n].z() - model.start_position[n].z());
  }
  // q L^4 / 8 E I of a slender beam
  MESSAGE("bent by ", bent[0], " and ", bent[1]);
  CHECK(near(-bent[1], 12 * 2000 * standard_gravity / (8 * 1e9 * 0.04), 0.15));
  CHECK(near(bent[1], bent[0], 1e-6));
}

}  // namespace
}  // namespace trilith::testing
