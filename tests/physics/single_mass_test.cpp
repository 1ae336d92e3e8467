// One mass on bearings: the elastic and the elastic-plastic oscillator under a record, the friction pendulum, a bearing
// with a limit, a span on two supports that move apart (VALIDATION D1 to D5).
#include <doctest/doctest.h>

#include <cmath>

#include "load/motion_read.hpp"
#include "load/record_folder.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

namespace trilith {
namespace {

using testing::box;
using testing::near;
using testing::Scene;

constexpr double inch = 0.0254;

/// A mass that can only move along x, on one bearing over a base that is driven along x. No gravity.
struct Oscillator {
  double period = 1, damping_ratio = 0.05;  ///< [s], [1]
  double mass = 1000;                       ///< [kg]
  double yield = 0;                         ///< [N], 0: elastic
  double turn = 0;                          ///< of the world [rad]

  [[nodiscard]] double stiffness() const { return mass * std::pow(2 * M_PI / period, 2); }
  [[nodiscard]] DirectionLaw law() const {
    const double c = 2 * damping_ratio * std::sqrt(stiffness() * mass);
    if (yield > 0) return ElasticPlastic{stiffness(), yield, 0, c};
    return Linear{stiffness(), c};
  }
  /// Largest displacement of the mass relative to the base [m], and its time [s after the start of the motion].
  [[nodiscard]] std::pair<double, double> peak(const GroundMotion& motion, double dt) const {
    Scene scene(Frictional{1e6, 1e6, 0.5, 0}, turn);
    scene.set_gravity({0, 0});
    scene.fixed("base", box(-1, -1, 1, 0));
    BodySpec body;
    body.name = "mass", body.outline = box(-0.5, 1, 0.5, 2), body.mass = mass;
    body.support = {Support::free, Support::free, Support::fixed};
    scene.add(body);
    scene.builder.set_contact("*", "*", "none");
    BearingSpec link;
    link.name = "columns", link.body_a = "base", link.body_b = "mass", link.angle = turn;
    link.point_a = scene.to_world({0, 0}), link.point_b = scene.to_world({0, 1});
    link.law = {law(), Linear{stiffness(), 0}, {}};
    scene.builder.add_bearing(link);
    Model<2> model = scene.builder.build();
    scene.drive_along_x(model, "base", motion);
    Simulation<2> sim(model);
    std::pair<double, double> most{0, 0};
    testing::run_for(sim, motion.end_time(), dt, testing::each_step([&](const Instant<2>& now) {
                       const double d = now.work.bearing_displacement[0].x();
                       if (std::abs(d) > most.first) most = {std::abs(d), now.state.time};
                     }));
    return most;
  }
};

/// The record of the textbook figures, or none with a message.
std::optional<GroundMotion> textbook_record() {
  const auto folder = testing::record_folder();
  if (!folder) return std::nullopt;
  return read_motion(*folder / "elcentro_1940_textbook_ns.csv");
}

TEST_CASE("D1: an elastic oscillator under El Centro has the peak displacements of the textbook record") {
  const auto record = textbook_record();
  if (!record) return;
  struct Row {
    double period, ratio, inches, at;
  };
  for (const Row& row : {Row{0.5, 0.02, 2.687, 0}, Row{1, 0.02, 5.967, 0}, Row{2, 0.02, 7.466, 0},
                         Row{2, 0.05, 5.373, 0}, Row{0.5, 0.05, 2.246, 2.35}}) {
    Oscillator o;
    o.period = row.period, o.damping_ratio = row.ratio;
    const auto [coarse, unused] = o.peak(*record, row.period / 250);
    const auto [most, at] = o.peak(*record, row.period / 1000);
    MESSAGE("D1 T = " << row.period << " s, zeta = " << row.ratio << ": " << most / inch << " in at " << at
                      << " s, expected " << row.inches << " in, with four times the step " << coarse / inch << " in");
    CHECK(near(most / inch, row.inches, 0.01));
    if (row.at > 0) CHECK(near(at, row.at, 0.01));
    CHECK(near(coarse, most, 0.01));
  }
}

TEST_CASE("D1: the oscillator's peak does not depend on the direction of the world nor on the mass") {
  const auto record = textbook_record();
  if (!record) return;
  Oscillator o;
  o.period = 0.5, o.damping_ratio = 0.05;
  const double straight = o.peak(*record, 2e-3).first;
  for (const double turn : {17.0, 90.0, 203.0}) {
    o.turn = turn * testing::degree;
    CHECK(near(o.peak(*record, 2e-3).first, straight, 1e-6));
  }
  o.turn = 0;
  for (const double mass : {1.0, 3.7e7}) {
    o.mass = mass;
    CHECK(near(o.peak(*record, 2e-3).first, straight, 1e-6));
  }
}

TEST_CASE("D2: an elastic-plastic oscillator under El Centro has the peaks and ductilities of the textbook record") {
  const auto record = textbook_record();
  if (!record) return;
  Oscillator elastic;
  elastic.period = 0.5, elastic.damping_ratio = 0.05;
  const double dt = 5e-4, elastic_force = elastic.stiffness() * elastic.peak(*record, dt).first;
  struct Row {
    double share, inches, ductility;
  };
  for (const Row& row : {Row{0.25, 1.7455, 3.108}, Row{0.5, 1.6243, 1.446}}) {
    Oscillator o = elastic;
    o.yield = row.share * elastic_force;
    const double most = o.peak(*record, dt).first, ductility = most / (o.yield / o.stiffness());
    MESSAGE("D2 yield at " << row.share << " of the elastic force: " << most / inch << " in, ductility " << ductility
                           << "; expected " << row.inches << " in, " << row.ductility);
    CHECK(near(most / inch, row.inches, 0.02));
    CHECK(near(ductility, row.ductility, 0.02));
  }
}

/// A weight on a friction pendulum over a base.
struct PendulumScene {
  double radius = 2, mu = 0.05, weight = 1e6;  ///< [m], [1], [N]
  double slack_stiffness = 1e9;                ///< before sliding [N/m]

  [[nodiscard]] Model<2> model(const std::array<Support, 3>& support) const {
    Scene scene(Frictional{1e6, 1e6, 0.5, 0});
    scene.fixed("base", box(-5, -1, 5, 0));
    BodySpec body;
    body.name = "mass", body.outline = box(-1, 0.1, 1, 1), body.weight = weight, body.support = support;
    scene.add(body);
    scene.builder.set_contact("*", "*", "none");
    BearingSpec link;
    link.name = "pendulum", link.body_a = "base", link.body_b = "mass";
    const double axial_stiffness = 1e10;
    link.law = {Pendulum{radius, mu, slack_stiffness, 0},
                Linear{axial_stiffness, 0.2 * std::sqrt(axial_stiffness * weight / standard_gravity)},
                {}};
    scene.builder.add_bearing(link);
    return scene.builder.build();
  }
};

TEST_CASE("D3: a friction pendulum has its loop area, effective stiffness and equivalent damping") {
  struct Row {
    double radius, mu, weight, amplitude;
  };
  for (const Row& row : {Row{2, 0.05, 1e6, 0.2}, Row{1, 0.08, 3e5, 0.1}, Row{4, 0.03, 5e6, 0.35}}) {
    PendulumScene p;
    p.radius = row.radius, p.mu = row.mu, p.weight = row.weight;
    p.slack_stiffness = 1e3 * row.mu * row.weight / row.amplitude;
    Model<2> model = p.model({Support::fixed, Support::free, Support::fixed});
    const double cycle = 1, w = 2 * M_PI / cycle, d = row.amplitude;
    const auto motion = testing::motion_of(
        3 * cycle, 1e-3, [&](double t) { return -d * w * w * std::sin(w * t); }, d * w);
    Simulation<2> sim(model);
    testing::settle(sim);
    const double start = sim.state().time, weight_loss = sim.state().given[EnergyTerm::bearing_inner];
    CHECK(weight_loss == 0);
    set_drive(sim.edit_model(), 0, 0, motion, start, model.start_position[0].x());
    double most_force = 0, most = 0, area = 0, last_force = 0, last = 0;
    const auto follow = testing::each_step([&](const Instant<2>& now) {
      const double u = now.work.bearing_displacement[0].x(), f = -now.work.bearing_force[0].x();
      area += 0.5 * (f + last_force) * (u - last);
      last_force = f, last = u;
      if (std::abs(u) > most) most = std::abs(u), most_force = std::abs(f);
    });
    testing::run_for(sim, cycle, 0, follow);  // the first loop begins at the middle
    area = 0;
    const double before = sim.state().given[EnergyTerm::bearing_inner];
    testing::run_for(sim, cycle, 0, follow);
    const double lost = sim.state().given[EnergyTerm::bearing_inner] - before;
    const double loop = 4 * row.mu * row.weight * d, stiffness = row.weight / row.radius + row.mu * row.weight / d;
    const double damping = lost / (2 * M_PI * (most_force / most) * most * most);
    MESSAGE("D3 R = " << row.radius << " m: loop area " << area << " J, booked " << lost << " J, expected " << loop
                      << "; effective stiffness " << most_force / most << " N/m, expected " << stiffness << "; damping "
                      << damping << ", expected " << loop / (2 * M_PI * stiffness * d * d));
    CHECK(near(area, loop, 0.01));
    CHECK(near(lost, loop, 0.01));
    CHECK(near(most_force / most, stiffness, 0.01));
    CHECK(near(damping, loop / (2 * M_PI * stiffness * d * d), 0.01));
  }
}

TEST_CASE("D3: a mass on a pendulum without friction swings with 2 pi sqrt(R/g), whatever its weight") {
  for (const double radius : {0.5, 2.0, 6.0})
    for (const double weight : {1e3, 1e6}) {
      PendulumScene p;
      p.radius = radius, p.mu = 0, p.weight = weight;
      p.slack_stiffness = weight / radius;
      Model<2> model = p.model({Support::free, Support::free, Support::fixed});
      const double period = 2 * M_PI * std::sqrt(radius / standard_gravity);
      Simulation<2> sim(model);
      testing::settle(sim);
      // Set in motion by a jump of the base, which then stands still.
      const double speed = 0.1;
      State<2> state = sim.state();
      state.velocity[1].x() = speed;
      Simulation<2> swing(model, state);
      double last_x = 0, last_t = 0, first = -1, crossing = -1;
      int crossings = 0;
      const double begin = state.time;
      testing::run_for(swing, 5.2 * period, 0, testing::each_step([&](const Instant<2>& now) {
                         const double x = now.work.bearing_displacement[0].x(), t = now.state.time - begin;
                         if (last_x < 0 && x >= 0) {
                           crossing = last_t + (t - last_t) * -last_x / (x - last_x);
                           if (first < 0) first = crossing;
                           ++crossings;
                         }
                         last_x = x, last_t = t;
                       }));
      const double ours = (crossing - first) / (crossings - 1);
      INFO("R = ", radius, ", W = ", weight);
      if (radius == 2) MESSAGE("D3 period " << ours << " s, expected " << period << " s");
      CHECK(near(ours, period, 0.01));
    }
}

/// A block on a table, connected to it by a spring along x with a displacement limit, pulled slowly by a moving table.
struct TiedBlock {
  double stiffness = 10 * 4448.2216 / inch;  ///< 10 kip/in [N/m]
  double limit = 10 * inch, weight = 2e5, mu = 0.35;

  [[nodiscard]] Model<2> model(bool becomes_friction) const {
    Scene scene(Frictional{1e9, 5e8, mu, 1e-3});
    scene.fixed("table", box(-2, -0.5, 3, 0));
    BodySpec block;
    block.name = "block", block.outline = box(0, 0, 1, 0.5), block.weight = weight;
    block.support = {Support::fixed, Support::free, Support::fixed};
    scene.add(block);
    if (!becomes_friction) scene.builder.set_contact("*", "*", "none");
    BearingSpec link;
    link.name = "spring", link.body_a = "table", link.body_b = "block";
    link.point_a = link.point_b = {0.5, 0};
    link.law = {Linear{stiffness, 0}, Linear{1e9, 1e6}, {}};
    link.limit[along] = limit;
    link.replaces_contact = becomes_friction;
    scene.builder.add_bearing(link);
    return scene.builder.build();
  }
};

TEST_CASE("D4: a bearing pulled to its limit carries k times the limit, then nothing or the friction of its contact") {
  for (const bool becomes_friction : {false, true}) {
    TiedBlock tied;
    Simulation<2> sim(tied.model(becomes_friction));
    testing::settle(sim);
    const double speed = 0.05, begin = sim.state().time;
    const auto motion = std::make_shared<GroundMotion>(std::vector<double>{0, 0}, 20.0, MotionStart{-speed, 0});
    set_drive(sim.edit_model(), 0, 0, motion, begin, sim.state().position[0].x());
    double most = 0, at = 0, after = 0;
    const int block = testing::node_of(sim.model(), "block");
    testing::run_for(sim, 1.2 * tied.limit / speed, 0, testing::each_step([&](const Instant<2>& now) {
                       // Force along x on the block by bearing and contact.
                       const double f = now.work.force[block].x(), u = now.work.bearing_displacement[0].x();
                       if (std::abs(f) > most) most = std::abs(f), at = u;
                       after = std::abs(f);
                     }));
    const double peak = tied.stiffness * tied.limit, left = becomes_friction ? tied.mu * tied.weight : 0;
    MESSAGE("D4 " << std::string(becomes_friction ? "with" : "without") << " friction: peak " << most / 4448.2216
                  << " kip at " << at / inch << " in, then " << after / 4448.2216
                  << " kip; expected 100 kip at 10 in, then " << left / 4448.2216 << " kip");
    CHECK(near(most, peak, 0.005));
    CHECK(near(at, tied.limit, 0.005));
    CHECK(std::abs(after - left) <= 0.005 * left);
    CHECK(sim.state().bearing[0].status == (becomes_friction ? BearingStatus::changed : BearingStatus::failed));
  }
}

/// A span on two equal springs over two supports with their own motions.
struct SpanOnTwo {
  double period = 0.9, damping_ratio = 0.05, mass = 2e5;

  [[nodiscard]] Simulation<2> start() const {
    Scene scene(Frictional{1e6, 1e6, 0.5, 0});
    scene.set_gravity({0, 0});
    scene.fixed("left", box(-1, -1, 1, 0));
    scene.fixed("right", box(19, -1, 21, 0));
    BodySpec span;
    span.name = "span", span.outline = box(0, 0.1, 20, 1.3), span.mass = mass;
    span.support = {Support::free, Support::free, Support::fixed};
    scene.add(span);
    scene.builder.set_contact("*", "*", "none");
    const double k = 0.5 * mass * std::pow(2 * M_PI / period, 2);
    const double c = 0.5 * 2 * damping_ratio * std::sqrt(2 * k * mass);
    for (const char* side : {"left", "right"}) {
      BearingSpec link;
      link.name = side, link.body_a = side, link.body_b = "span";
      link.point_a = link.point_b = {side == std::string("left") ? 0.5 : 19.5, 0.05};
      link.law = {Linear{k, c}, Linear{k, 0}, {}};
      scene.builder.add_bearing(link);
    }
    return Simulation(scene.builder.build());
  }
};

TEST_CASE("D5: a span on two equal springs moves as one mass under the mean of the two support motions") {
  const auto folder = testing::own_record("elcentro_1940_rest_ns.csv");
  const GroundMotion right = read_motion(folder);
  const GroundMotion left = right.time_scaled(0.8).delayed(1.02 * 0.2);
  const SpanOnTwo span;
  Simulation<2> sim = span.start();
  set_drive(sim.edit_model(), 0, 0, std::make_shared<GroundMotion>(left), 0, sim.model().start_position[0].x());
  set_drive(sim.edit_model(), 1, 0, std::make_shared<GroundMotion>(right), 0, sim.model().start_position[1].x());
  // The single mass by an independent integration (velocity Verlet in the mean motion, at a tenth of the step).
  const double w = 2 * M_PI / span.period, dt = 1e-3;
  const auto mean = [&](double t) { return 0.5 * (left.displacement(t) + right.displacement(t)); };
  const auto mean_speed = [&](double t) { return 0.5 * (left.velocity(t) + right.velocity(t)); };
  double x = 0, v = 0, t = 0, error = 0, most = 0;
  const double fine = dt / 10;
  const double x0 = sim.model().start_position[2].x();
  testing::run_for(sim, 30, dt, testing::each_step([&](const Instant<2>& now) {
                     while (t < now.state.time - 0.5 * fine) {
                       const auto a = [&](double at, double xx, double vv) {
                         return -w * w * (xx - mean(at)) - 2 * span.damping_ratio * w * (vv - mean_speed(at));
                       };
                       const double middle = v + 0.5 * fine * a(t, x, v);
                       x += fine * middle;
                       t += fine;
                       v = middle + 0.5 * fine * a(t, x, middle);
                     }
                     most = std::max(most, std::abs(x));
                     error = std::max(error, std::abs(now.state.position[2].x() - x0 - x));
                   }));
  MESSAGE("D5 largest displacement " << most << " m, largest difference to the single mass " << error << " m");
  CHECK(most > 0.05);
  CHECK(error < 0.005 * most);
}

TEST_CASE("D5: at rest the span stands at the mean of the displacements of its supports") {
  const SpanOnTwo span;
  for (const auto& [u1, u2] : {std::pair{0.3, 0.1}, std::pair{-0.2, 0.5}, std::pair{0.0, 0.25}}) {
    Simulation<2> sim = span.start();
    const double x0 = sim.model().start_position[2].x();
    for (const int side : {0, 1}) {
      const double end = side == 0 ? u1 : u2;  // a smooth motion in 2 s
      const auto motion = testing::motion_of(2, 1e-3, [&](double t) { return end * M_PI / 2 * std::sin(M_PI * t); });
      set_drive(sim.edit_model(), side, 0, motion, 0, sim.model().start_position[side].x());
    }
    testing::run_for(sim, 40);
    const double left = sim.state().position[0].x() - sim.model().start_position[0].x();
    const double right = sim.state().position[1].x() - sim.model().start_position[1].x();
    CHECK(std::abs(left - u1) < 1e-4);
    CHECK(std::abs(right - u2) < 1e-4);
    CHECK(near(sim.state().position[2].x() - x0, 0.5 * (left + right), 1e-5));
  }
}

}  // namespace
}  // namespace trilith
