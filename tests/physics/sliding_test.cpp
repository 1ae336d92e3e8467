// VALIDATION C9, S1 to S4: friction in motion.
#include <algorithm>

#include "load/motion_read.hpp"
#include "load/record_folder.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("C9: the amplitude of a Coulomb-damped oscillator falls by 2F/k per half cycle, and it stops within F/k") {
  struct Case {
    double mass, k, friction, from, turn;
  };
  for (const Case c : {Case{1, 100, 0.5, 0.1, 0}, Case{1, 100, 0.5, 0.1, 203 * degree}, Case{20, 8000, 50, 0.08, 0}}) {
    const double kn = 1e6 * c.mass;
    Scene scene(Frictional{kn, kn, c.friction / (c.mass * standard_gravity), 1e-4}, c.turn);
    scene.builder.overlap_allowed = 1e-3;
    scene.fixed("base", rectangle({-2, -1}, {2, 0}));
    BodySpec spec;
    const double sunk = c.mass * standard_gravity / kn;
    spec.name = "block", spec.outline = rectangle({-0.5, -sunk}, {0.5, 0.1 - sunk}), spec.mass = c.mass;
    spec.support[2] = Support::fixed;
    scene.add(spec);
    BearingSpec spring;
    spring.name = "spring", spring.body_a = "base", spring.body_b = "block", spring.angle = c.turn;
    spring.point_a = spring.point_b = scene.to_world({0, 0.05});
    spring.law[along] = Linear{c.k, 0};
    scene.builder.add_bearing(spring);
    Model<2> model = scene.builder.build();
    model.bearings[0].rest.x() -= c.from;  // released at `from`
    Simulation<2> sim(std::move(model));
    const int n = node_of(sim.model(), "block");
    std::vector<double> turns, times;
    double x = 0, v = 0;
    run_for(sim, 8 * M_PI * std::sqrt(c.mass / c.k), 1e-4, each_step([&](const Instant<2>& now) {
              const double next = scene.to_scene(now.state.velocity[n]).x();
              x = c.from + scene.to_scene(now.state.position[n]).x();
              if (v * next < 0 && std::abs(x) > c.friction / c.k) turns.push_back(x), times.push_back(now.state.time);
              v = next;
            }));
    const double loss = 2 * c.friction / c.k, half = M_PI * std::sqrt(c.mass / c.k);
    REQUIRE(turns.size() >= 3);
    MESSAGE("C9 turning points ", turns[0], " ", turns[1], " ", turns[2], " m, half period ", times[0], " s (", half,
            ")");
    for (std::size_t i = 0; i < 3; ++i) {
      const double expected = (i % 2 == 0 ? -1 : 1) * (c.from - static_cast<double>(i + 1) * loss);
      CHECK(near(turns[i], expected, 0.01));
      CHECK(near(times[i], static_cast<double>(i + 1) * half, 0.01));
    }
    run_for(sim, 12 * half, 1e-4);
    const double stops = c.from + scene.to_scene(sim.state().position[n]).x();
    CHECK(std::abs(stops) <= 1.01 * c.friction / c.k);
    CHECK(sim.state().velocity[n].norm() < 1e-6);
  }
}

namespace {

/// A block on an incline, modelled by tilted gravity over a flat base. The world is rotated by `turn`, so that turn =
/// -incline shows the incline as seen by an observer. It starts with its static penetration.
struct Incline {
  Scene scene;
  Simulation<2> sim;
  int node;
  Incline(double incline, double mu, double turn)
      : scene(law(mu), turn), sim(make(scene, incline)), node(node_of(sim.model(), "block")) {}
  static Frictional law(double mu) { return {1e10, 5e9, mu, 3e-5}; }
  static Simulation<2> make(Scene& scene, double incline) {
    const double g = standard_gravity, mass = 400;
    scene.builder.overlap_allowed = 1e-3;
    scene.set_gravity({g * std::sin(incline), -g * std::cos(incline)});
    scene.fixed("base", rectangle({-1, -1}, {8, 0}));
    const double sunk = mass * g * std::cos(incline) / 1e10;
    scene.block("block", rectangle({0, -sunk}, {1, 0.2 - sunk}), mass);
    return scene.start();
  }
  [[nodiscard]] double x() const { return scene.to_scene(sim.state().position[node]).x(); }
};

}  // namespace

TEST_CASE("S1: a block slides down an incline at g (sin - mu cos), in rotated frames") {
  struct Case {
    double incline, mu;
  };
  for (const Case c : {Case{30, 0.3}, Case{30, 0.5}, Case{40, 0.5}, Case{55, 0.9}, Case{10, 0}})
    for (const double turn : {-c.incline, 0.0, 17.0, 90.0, 203.0, 331.0}) {
      Incline block(c.incline * degree, c.mu, turn * degree);
      const double a = standard_gravity * (std::sin(c.incline * degree) - c.mu * std::cos(c.incline * degree));
      const double from = block.x();
      run_for(block.sim, 1.0);
      const double way = block.x() - from, speed = block.scene.to_scene(block.sim.state().velocity[block.node]).x();
      if (turn == 0) MESSAGE("S1 ", c.incline, " deg, mu ", c.mu, ": ", way, " m in 1 s (", a / 2, ")");
      CHECK(near(way, a / 2, 0.005));
      CHECK(near(speed, a, 0.005));
    }
}

TEST_CASE("S1: below the friction angle a block stays, and creeps less than 1e-6 m in 10 s") {
  struct Case {
    double incline, mu;
  };
  for (const Case c : {Case{20, 0.5}, Case{30, 0.7}, Case{44, 1}})
    for (const double turn : {-c.incline, 0.0, 203.0}) {
      Incline block(c.incline * degree, c.mu, turn * degree);
      run_for(block.sim, 1.0);  // the elastic slip under its own weight
      const double from = block.x();
      run_for(block.sim, 10.0);
      CHECK(std::abs(block.x() - from) < 1e-6);
    }
}

TEST_CASE("S1: in a frame rotated by 17, 90 and 203 degrees the motion is the same") {
  const auto end_of = [](double turn) {
    Incline block(35 * degree, 0.4, turn);
    run_for(block.sim, 0.5, 1e-4);
    const Vec2 p = block.scene.to_scene(block.sim.state().position[block.node]);
    return Eigen::Vector3d(p.x(), p.y(), block.sim.state().rotation[block.node]);
  };
  const Eigen::Vector3d upright = end_of(0);
  for (const double turn : {17.0, 90.0, 203.0}) {
    const double apart = (end_of(turn * degree) - upright).norm();
    MESSAGE("turned by ", turn, " deg: differs by ", apart, " m");
    CHECK(apart < 1e-9);
  }
}

namespace {

/// Base acceleration `a` [m/s2] for `length` [s], then 0 until `end`.
std::shared_ptr<const GroundMotion> pulse(double a, double length, double end) {
  const double step = 1e-4;
  return motion_of(end, step, [=](double t) {
    if (std::abs(t - length) < 0.1 * step) return 0.5 * a;
    return t < length ? a : 0.0;
  });
}

struct Slip {
  double base_speed, slip, ends;  // [m/s], [m], [s]
};

Slip slip_under_pulse(double share, double length, double mu, double turn) {
  const double kn = 1e10, g = standard_gravity, mass = 400, sunk = mass * g / kn, end = 3 * length * share / mu;
  Scene scene(Frictional{kn, kn, mu, 3e-5}, turn);
  scene.builder.overlap_allowed = 1e-3;
  scene.fixed("base", rectangle({-3, -1}, {3, 0}));
  scene.block("block", rectangle({-0.5, -sunk}, {0.5, 0.1 - sunk}), mass);
  Model<2> model = scene.builder.build();
  scene.drive_along_x(model, "base", *pulse(share * g, length, 2 * end));
  Simulation<2> sim(std::move(model));
  const int base = node_of(sim.model(), "base"), block = node_of(sim.model(), "block");
  const auto apart = [&](const State<2>& s) { return scene.to_scene(s.position[base] - s.position[block]).x(); };
  const double from = apart(sim.state());
  double ends = 0;
  run_for(sim, end, 0, each_step([&](const Instant<2>& now) {
            const double rate = scene.to_scene(now.state.velocity[base] - now.state.velocity[block]).x();
            if (rate > 1e-3) ends = now.state.time;
          }));
  return {scene.to_scene(sim.state().velocity[base]).x(), apart(sim.state()) - from, ends};
}

}  // namespace

TEST_CASE("S2: a base pulse slips a block by V^2/(2 g mu) (1 - mu/A)") {
  struct Case {
    double a, length, mu, turn;
  };
  for (const Case c : {Case{0.5, 0.25, 0.2, 0}, Case{0.5, 0.25, 0.2, 17 * degree}, Case{0.5, 0.25, 0.2, 90 * degree},
                       Case{0.5, 0.25, 0.2, 203 * degree}, Case{0.8, 0.1, 0.3, 0}, Case{-0.4, 0.3, 0.1, 0}}) {
    const double g = standard_gravity, size = std::abs(c.a), v = size * g * c.length;
    // A pulse the other way is the same slip in a world rotated by half a turn.
    const Slip s = slip_under_pulse(size, c.length, c.mu, c.a < 0 ? c.turn + M_PI : c.turn);
    const double expected = v * v / (2 * g * c.mu) * (1 - c.mu / size);
    MESSAGE("S2 base ", s.base_speed, " m/s (", v, "), slip ", s.slip, " m (", expected, "), ends ", s.ends, " s (",
            v / (c.mu * g), ")");
    CHECK(near(s.base_speed, v, 0.005));
    CHECK(near(s.slip, expected, 0.005));
    CHECK(near(s.ends, v / (c.mu * g), 0.005));
  }
}

TEST_CASE("S3: a block on a driven slope slips downhill as the one-way sliding block under Takatori") {
  const auto folder = record_folder();
  if (!folder) return;
  const GroundMotion record =
      read_motion(*folder / "kobe_1995_takatori_090.csv").scaled_to_peak(0.4 * standard_gravity);
  struct Case {
    double yield, sign, expected;  // share of g, of the record, m
  };
  for (const Case c : {Case{0.1, 1, 0.72419}, Case{0.1, -1, 0.62859}, Case{0.2, 1, 0.12860}, Case{0.2, -1, 0.06662}}) {
    const double g = standard_gravity, slope = 25 * degree, kn = 4e8, mass = 400;
    const double mu = std::tan(slope) + c.yield / std::cos(slope);
    Scene scene(Frictional{kn, kn, mu, 1e-4}, -slope);
    scene.set_gravity({g * std::sin(slope), -g * std::cos(slope)});
    scene.fixed("slope", rectangle({-3, -1}, {5, 0}));
    scene.block("block", rectangle({-0.5, 0}, {0.5, 0.1}), mass);
    Simulation<2> settling = scene.start();
    settle(settling);
    Model<2> model = settling.model();
    // Downhill is +x: the block slips if the ground's uphill acceleration exceeds the friction limit.
    scene.drive_along_x(model, "slope", record.scaled(-c.sign), settling.state().time);
    Simulation<2> sim(std::move(model), settling.state());
    const int base = node_of(sim.model(), "slope"), block = node_of(sim.model(), "block");
    const auto apart = [&] { return scene.to_scene(sim.state().position[block] - sim.state().position[base]).x(); };
    const double from = apart();
    run_for(sim, record.duration());
    const double slip = apart() - from;
    MESSAGE("S3 yield ", c.yield, " g, sign ", c.sign, ": ", slip, " m (", c.expected, ")");
    CHECK(near(slip, c.expected, 0.015));
  }
}

namespace {

/// A deck on two supports that are pushed together under it: one long, and a seat of `length` [m].
struct Deck {
  bool seat_lost, fell;
};

Deck deck_on_seat(double length) {
  const double kn = 1e9;
  Scene scene(Frictional{kn, kn, 0.2, 1e-4});
  scene.fixed("left", rectangle({-2, -3}, {1, 0}));
  scene.fixed("right", rectangle({10 - length, -3}, {11, 0}));
  scene.block("deck", rectangle({0, 0}, {10, 0.5}), 1e4);
  SeatSpec seat;
  seat.name = "seat", seat.body = "deck", seat.support = "right", seat.end = {10, 0}, seat.edge = {10 - length, 0};
  scene.builder.add_seat(seat);
  Simulation<2> settling = scene.start();
  settle(settling);
  Model<2> model = settling.model();
  const auto push = pulse(0.5 * standard_gravity, 0.25, 4);
  for (const char* support : {"left", "right"}) scene.drive_along_x(model, support, *push, settling.state().time);
  Simulation<2> sim(std::move(model), settling.state());
  const int deck = node_of(sim.model(), "deck");
  const double from = sim.state().position[deck].y();
  run_for(sim, 2.0);
  return {sim.state().seat_lost[0] != 0, sim.state().position[deck].y() < from - 0.5};
}

}  // namespace

TEST_CASE("S4: a deck falls off a seat of 0.20 m and stays on one of 0.26 m") {
  const Deck off = deck_on_seat(0.20), on = deck_on_seat(0.26);
  CHECK(off.seat_lost);
  CHECK(off.fell);
  CHECK_FALSE(on.seat_lost);
  CHECK_FALSE(on.fell);
}
