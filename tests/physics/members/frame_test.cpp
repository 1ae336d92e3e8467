// Beams and frames: internal forces, known deflections, vibrations and flight.
#include "integrate/explicit/stable_step.hpp"
#include "model/pose.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"

namespace trilith::testing {
namespace {

constexpr double frame_young = 1e9;

/// Three members with rigid ends and a pin, with a deformed initial shape.
BodySpec odd_frame() {
  BodySpec spec;
  spec.name = "odd", spec.kind = BodyKind::frame, spec.material = "m", spec.floating = true;
  FrameSpec frame;
  frame.joints = {{.name = "a", .place = {0, 0}}, {.name = "b", .place = {0, 3}}, {.name = "c", .place = {4, 3.5}}};
  FrameMember column, beam, brace;
  column.from = 0, column.to = 1, column.section = rectangle_section(0.3, 0.4), column.divisions = 2;
  column.ends[1] = Vec2(0.05, 2.8);
  beam.from = 1, beam.to = 2, beam.section = rectangle_section(0.3, 0.5), beam.divisions = 2, beam.shear = true;
  beam.ends[0] = Vec2(0.2, 3.0);
  brace.from = 0, brace.to = 2, brace.section = rectangle_section(0.1, 0.1), brace.divisions = 2;
  brace.pinned = {true, true};
  frame.members = {column, beam, brace};
  spec.frame = frame;
  return spec;
}

State<2> bent_state(const Model<2>& model, double turn) {
  State<2> state = initial_state(model);
  const Turn axes(turn);
  for (int n = 0; n < model.nodes(); ++n) {
    state.position[n] = axes.apply(model.start_position[n]) + 0.03 * Vec2(std::sin(1.0 + n), std::cos(2.0 * n));
    state.rotation[n] = turn + 0.05 * std::sin(3.0 * n + 0.5);
    state.velocity[n] = {std::sin(2.0 * n), std::cos(5.0 * n + 1)};
    state.spin[n] = std::cos(1.7 * n);
  }
  return state;
}

TEST_CASE("beam forces are the gradient of the stored energy, with no resultant and no moment") {
  const Model<2> model = of_frames(elastic_material("m", 2400, frame_young, 0.2), {odd_frame()});
  for (const double turn : {0.0, 1.1, 3.1, 40.0}) {
    State<2> state = bent_state(model, turn);
    const auto energy = [&] {
      Work<2> work;
      internal_forces(model, state, work);
      return work.element_stored;
    };
    const double scale = energy();
    Vec2 sum = Vec2::Zero();
    double moment = 0;
    const std::vector<NodeDofs> force = forces_at(model, state);
    for (int n = 0; n < model.nodes(); ++n) {
      sum += Vec2(force[n][0], force[n][1]);
      moment += cross(state.position[n], Vec2(force[n][0], force[n][1])) + force[n][2];
      for (const int k : {0, 1, 2}) {
        double& at = dof_of(state, n, k);
        const double was = at, h = 1e-6;
        at = was + h;
        const double high = energy();
        at = was - h;
        const double low = energy();
        at = was;
        CHECK(near_zero(force[n][k] + (high - low) / (2 * h), 2e-6 * scale / 0.05));
      }
    }
    CHECK(sum.norm() < 1e-9 * scale / 0.05);
    CHECK(std::abs(moment) < 1e-9 * scale / 0.05 * 4);
  }
}

TEST_CASE("B1: a rigid rotation of a frame by any angle, over several full turns, causes no force and no energy") {
  const Model<2> model = of_frames(elastic_material("m", 2400, frame_young, 0.2), {odd_frame()});
  for (int degrees = -900; degrees <= 900; degrees += 7) {
    State<2> state = initial_state(model);
    const Turn turn(degrees * degree);
    for (int n = 0; n < model.nodes(); ++n) {
      state.position[n] = Vec2(3, -2) + turn.apply(model.start_position[n]);
      state.rotation[n] = degrees * degree;
    }
    for (const NodeDofs& f : forces_at(model, state))
      for (const double part : f) CHECK(std::abs(part) < 1e-9 * frame_young * 0.2);
    Work<2> work;
    internal_forces(model, state, work);
    CHECK(work.element_stored < 1e-18 * frame_young);
  }
}

TEST_CASE("dampings of beams take the power in the energy balance, and none in a rigid motion") {
  const Model<2> model = of_frames(elastic_material("m", 2400, frame_young, 0.2, 1e-3), {odd_frame()});
  State<2> state = bent_state(model, 0.7);
  Work<2> work;
  internal_forces(model, state, work);
  double power = 0;
  for (int n = 0; n < model.nodes(); ++n)
    power += work.element_damping[n].dot(state.velocity[n]) + work.element_damping_moment[n] * state.spin[n];
  CHECK(power < 0);
  for (int n = 0; n < model.nodes(); ++n) {
    state.velocity[n] = Vec2(1, 2) + cross(0.5, state.position[n]);
    state.spin[n] = 0.5;
  }
  internal_forces(model, state, work);
  for (const Vec2& f : work.element_damping) CHECK(f.norm() < 1e-9 * frame_young * 0.2 * 1e-3);
}

TEST_CASE("B4: a cantilever under a dead end load bends as the elastica") {
  struct Row {
    double number, deflection, shortening, angle;
  };
  // Mattiasson, "Numerical results from large deflection beam and frame problems analysed by means of elliptic
  // integrals", Int. J. Numer. Meth. Engng 17, 1981.
  for (const Row& row : {Row{1, .30172, .05643, .29371}, Row{2, .49346, .16064, .49768}, Row{5, .71379, .38763, .77373},
                         Row{10, .81061, .55500, .91055}}) {
    BodySpec spec = beam_body("beam", {0, 0}, {1, 0}, rectangle_section(0.01, 0.01), "m", 10);
    spec.frame->joints[0].support = held;
    const Model<2> model = of_frames(elastic_material("m", 1000, frame_young), {spec});
    const double bending = frame_young * 1e-8 / 12;
    State<2> state = initial_state(model);
    std::vector<NodeDofs> load = no_load(model);
    for (double part = 0.5; part <= row.number; part += 0.5) {
      load[1][1] = -part * bending;
      state = balance(model, state, load);
    }
    CHECK(near(-state.position[1].y(), row.deflection, 0.01));
    CHECK(near(1 - state.position[1].x(), row.shortening, 0.01));
    CHECK(near(-state.rotation[1] * 2 / M_PI, row.angle, 0.01));
  }
}

TEST_CASE("B5: an end moment of 2 pi EI / L bends a cantilever to a circle") {
  BodySpec spec = beam_body("beam", {0, 0}, {1, 0}, rectangle_section(0.01, 0.01), "m", 20);
  spec.frame->joints[0].support = held;
  const Model<2> model = of_frames(elastic_material("m", 1000, frame_young), {spec});
  State<2> state = initial_state(model);
  std::vector<NodeDofs> load = no_load(model);
  for (int step = 1; step <= 40; ++step) {
    load[1][2] = 2 * M_PI * frame_young * 1e-8 / 12 * step / 40;
    state = balance(model, state, load);
  }
  CHECK(state.position[1].norm() < 0.01);
  CHECK(near(state.rotation[1], 2 * M_PI, 1e-6));
}

/// Mode shape of a cantilever for the root `b` of cos b cosh b = -1, at x from 0 to 1, and its slope.
std::pair<double, double> cantilever_mode(double b, double x) {
  const double s = (std::cosh(b) + std::cos(b)) / (std::sinh(b) + std::sin(b));
  return {std::cosh(b * x) - std::cos(b * x) - s * (std::sinh(b * x) - std::sin(b * x)),
          b * (std::sinh(b * x) + std::sin(b * x) - s * (std::cosh(b * x) - std::cos(b * x)))};
}

/// Frequency of a cantilever that starts with the velocities of a mode, from `cycles` zero crossings of the tip [Hz].
double counted_frequency(double root, int divisions, int cycles) {
  BodySpec spec = beam_body("beam", {0, 0}, {3, 0}, rectangle_section(0.1, 0.2), "m", divisions);
  spec.frame->joints[0].support = held;
  const Model<2> model = of_frames(elastic_material("m", 7850, 2.1e11), {spec});
  State<2> state = initial_state(model);
  for (int n = 0; n < model.nodes(); ++n) {
    if (model.support[n][0] != Support::free) continue;
    const auto [shape, slope] = cantilever_mode(root, model.start_position[n].x() / 3);
    state.velocity[n] = {0, 1e-3 * shape};
    state.spin[n] = 1e-3 * slope / 3;
  }
  Simulation<2> sim(model, state);
  std::vector<double> up;
  double last = 0, last_time = 0;
  run_for(sim, (cycles + 1) / (18.567 * std::pow(root / 1.87510, 2)), 0, each_step([&](const Instant<2>& now) {
            const double y = now.state.position[1].y();
            if (last < 0 && y >= 0) up.push_back(last_time + (now.state.time - last_time) * -last / (y - last));
            last = y, last_time = now.state.time;
          }));
  REQUIRE(up.size() >= 2);
  return static_cast<double>(up.size() - 1) / (up.back() - up.front());
}

TEST_CASE("B6: a steel cantilever swings at its frequencies") {
  const double first = counted_frequency(1.87510, 10, 10);
  CHECK(near(first, 18.567, 0.01));
  // Higher frequencies are slightly below the values of the slender beam: the rotary inertia of the sections lowers
  // them by half of (wave number times radius of gyration)^2 (Rayleigh).
  const double radius = 0.2 / std::sqrt(12);
  for (const auto& [root, divisions, ratio] : {std::tuple(4.69409, 20, 6.2669), std::tuple(7.85476, 30, 17.547)}) {
    const double slender = ratio * 18.567, rayleigh = 1 - 0.5 * std::pow(root / 3 * radius, 2);
    CHECK(near(counted_frequency(root, divisions, 10), slender * rayleigh, 0.01));
  }
}

TEST_CASE("F10: a deep cantilever deflects by bending and, where it is requested, by shear") {
  for (const bool shear : {false, true}) {
    BodySpec spec = beam_body("beam", {0, 0}, {1.2, 0}, rectangle_section(0.1, 0.4), "m", 3);
    spec.frame->joints[0].support = held;
    spec.frame->members[0].shear = shear;
    const Model<2> model = of_frames(elastic_material("m", 7850, 2.1e11, 0.3), {spec});
    std::vector<NodeDofs> load = no_load(model);
    load[1][1] = -1e3;  // a hundredth, so that the deflection stays small
    const State<2> state = balance(model, initial_state(model), load);
    CHECK(near(-100e3 * state.position[1].y(), shear ? .55886 : .51429, 1e-3));
    // Internal forces of the member: constant shear force, and a moment that falls from P L to zero.
    const std::vector<SectionForces> forces = member_forces(model, state, 0);
    CHECK(near(forces.front().moment, -1e3 * 1.2, 1e-3));
    CHECK(near_zero(forces.back().moment, 1));
    CHECK(near(forces[2].shear, 1e3, 1e-3));
  }
}

TEST_CASE("a frame in free flight keeps momentum, angular momentum and energy, bent and turning") {
  const Model<2> model = of_frames(elastic_material("m", 2400, frame_young, 0.2), {odd_frame()});
  State<2> state = bent_state(model, 0.4);
  for (Vec2& v : state.velocity) v *= 2;
  Simulation<2> sim(model, state);
  const auto totals = [&](const State<2>& s) {
    std::array<double, 3> sum{};
    for (int n = 0; n < model.nodes(); ++n) {
      for (const int k : {0, 1}) sum[static_cast<std::size_t>(k)] += model.mass[n] * s.velocity[n][k];
      sum[2] += model.mass[n] * cross(s.position[n], s.velocity[n]) + model.inertia[n] * s.spin[n];
    }
    return sum;
  };
  const auto before = totals(sim.state());
  sim.refresh();
  const Energy first = sim.energy();
  const double energy = first[EnergyTerm::kinetic] + first[EnergyTerm::strain];
  double worst = 0;
  StageOptions options;
  options.duration = 1, options.energy_interval = 0.01, options.safety = 0.1;
  RunListener<2> listener;
  listener.on_energy = [&](const Instant<2>&, const Energy& e) {
    worst = std::max(worst, std::abs(e[EnergyTerm::kinetic] + e[EnergyTerm::strain] - energy));
  };
  sim.run(options, listener);
  const auto after = totals(sim.state());
  for (const std::size_t k : {0, 1}) CHECK(near(after[k], before[k], 1e-9));
  CHECK(near(after[2], before[2], 1e-3));
  CHECK(worst < 0.01 * energy);
  CHECK(sim.state().step > 1000);
}

TEST_CASE("the stable step of a frame is stable just below it and not just above") {
  const Model<2> model = of_frames(elastic_material("m", 2400, frame_young, 0.2), {odd_frame()});
  State<2> start = bent_state(model, 0);  // velocities only, and so small that strains stay small
  start.position = model.start_position, start.rotation = model.start_rotation;
  for (int n = 0; n < model.nodes(); ++n) start.velocity[n] *= 1e-3, start.spin[n] *= 1e-3;
  Work<2> work;
  evaluate(model, start, work, 0);
  const double longest = stable_step(model, start, work).dt;
  const auto energy_after = [&](double dt) {
    State<2> s = start;
    Work<2> w;
    for (int i = 0; i < 4000; ++i) {
      evaluate(model, s, w, dt);
      advance(model, s, w, {dt, {}});
    }
    return w.element_stored;
  };
  CHECK(energy_after(0.99 * longest) < 100 * energy_after(0.1 * longest));
  CHECK(!(energy_after(1.5 * longest) < 1e6 * energy_after(0.1 * longest)));  // the bound is close to the true limit
}

TEST_CASE("F11: a force that moves over a simple beam deflects it more than one that stands") {
  struct Row {
    double speed, factor;
  };
  for (const Row& row : {Row{39.27, 1.2576}, Row{78.54, 1.7054}}) {
    const double length = 20, force = 100e3, bending = 5e9;
    const int divisions = 20;
    BodySpec spec = beam_body("beam", {0, 0}, {length, 0}, given_section(2, 0.1, 1), "m", divisions);
    spec.frame->joints[0].support = hinged;
    spec.frame->joints[1].support = {Support::free, Support::fixed, Support::free};
    Model<2> model = of_frames(elastic_material("m", 2500, 5e10), {spec});
    // Each node carries its share while the force is on the beams next to it.
    const double step = length / divisions / row.speed;
    for (int i = 1; i < divisions; ++i)
      add_load(model, "beam", {i * length / divisions, 0}, {0, -force}, 0,
               {{(i - 1) * step, i * step, (i + 1) * step}, {0, 1, 0}});
    Simulation<2> sim(model);
    double most = 0;
    const int middle = 2 + divisions / 2 - 1;  // two joints come first
    run_for(sim, length / row.speed, 0,
            each_step([&](const Instant<2>& now) { most = std::max(most, -now.state.position[middle].y()); }));
    CHECK(near(most, row.factor * force * length * length * length / (48 * bending), 0.005));
  }
}

TEST_CASE("F15: a beam that falls flat onto its end supports deflects as the sum of its modes") {
  BodySpec spec = beam_body("beam", {0, 0}, {8, 0}, rectangle_section(0.3, 0.5), "m", 40);
  spec.frame->joints[0].support = hinged;
  spec.frame->joints[1].support = {Support::free, Support::fixed, Support::free};
  const Model<2> model = of_frames(elastic_material("m", 2400, 30e9), {spec});
  State<2> state = initial_state(model);
  for (int n = 0; n < model.nodes(); ++n)
    if (model.support[n][1] == Support::free) state.velocity[n] = {0, -1};
  Simulation<2> sim(model, state);
  double most = 0, at = 0;
  run_for(sim, 0.03, 0, each_step([&](const Instant<2>& now) {
            const double down = -now.state.position[2 + 19].y();
            if (down > most) most = down, at = now.state.time;
          }));
  CHECK(near(most, 16.178e-3, 0.02));
  CHECK(near(at, 17.01e-3, 0.02));
}

}  // namespace
}  // namespace trilith::testing
