// Rotation in space by implicit steps: invariants of a free body, convergence order, tops and pendulums (VALIDATION T31
// to T33, T35). A motion in a plane equals the plane model's motion.
#include <doctest/doctest.h>

#include <cmath>

#include "assembly/implicit_turn.hpp"
#include "model/space_builder/solid_model_builder.hpp"
#include "near.hpp"
#include "physics/space/space_implicit.hpp"

namespace trilith::testing {
namespace {

const AlphaMethod newmark = AlphaMethod::hht(0), damped = AlphaMethod::hht(-0.05);

SolidSpec flying(const Vec3& sides, const Vec3& spin) {
  SolidSpec spec;
  spec.name = "body", spec.pieces = {box_at(sides, Vec3::Zero())}, spec.mass = 2400 * sides.prod();
  spec.floating = true, spec.spin = spin;
  return spec;
}

Model<3> free_body(const Vec3& sides, const Vec3& spin) {
  SolidModelBuilder builder;
  builder.gravity = Vec3::Zero();
  builder.add_body(flying(sides, spin));
  return builder.build();
}

/// A body of `shape` on a spherical bearing of stiff springs at its `point`, initially rotated about this point.
struct OnBearing {
  Vec3 sides, from_pivot;  ///< of the box, and of its centre, upright
  double mass;
  UnitQuaternion turn;
  Vec3 spin;
  double stiffness;

  [[nodiscard]] Model<3> model() const {
    SolidModelBuilder builder;
    builder.gravity = Vec3(0, 0, -standard_gravity);
    SolidSpec base;
    base.name = "base", base.pieces = {box_at({0.1, 0.1, 0.1}, {0, 0, 0})}, base.mass = 1, base.floating = true;
    base.support.fill(Support::fixed);
    builder.add_body(base);
    builder.set_contact("*", "*", "none");
    const Vec3 centre = turn_of(turn).apply(from_pivot);
    SolidSpec spec;
    spec.name = "body", spec.pieces = {box_at(sides, centre, turn)}, spec.mass = mass, spec.floating = true;
    spec.spin = spin, spec.velocity = cross(spin, centre);
    builder.add_body(spec);
    BearingSpecOf<3> link;
    link.name = "link", link.body_a = "base", link.body_b = "body";
    link.law = {Linear{stiffness, 0}, Linear{stiffness, 0}, Linear{stiffness, 0}, {}, {}, {}};
    builder.add_bearing(link);
    return builder.build();
  }
};

/// Duration of `turns` full turns of the wrapped angle `angle_of_now` [s].
class TurnClock {
 public:
  explicit TurnClock(double angle) : last_(angle) {}
  void see(double angle, double time) {
    const double by = std::remainder(angle - last_, 2 * M_PI);
    const double before = turned_;
    turned_ += by, last_ = angle;
    if (std::floor(std::abs(turned_) / (2 * M_PI)) > std::floor(std::abs(before) / (2 * M_PI))) {
      const double over = std::abs(turned_) - 2 * M_PI * std::floor(std::abs(turned_) / (2 * M_PI));
      whole_at_ = time - (time - time_) * over / std::abs(by);
      ++count_;
    }
    time_ = time;
  }
  [[nodiscard]] double mean() const { return whole_at_ / count_; }
  [[nodiscard]] int count() const { return count_; }

 private:
  double last_, turned_ = 0, time_ = 0, whole_at_ = 0;
  int count_ = 0;
};

/// Current axis of a body whose axis was upright in its specification.
Vec3 axis_of(const State<3>& state, std::size_t n, const Vec3& own) {
  return turn_of(state.rotation[n]).apply(own);
}

TEST_CASE("a free body of three inertias keeps momentum and energy by average acceleration at any length of step") {
  for (const double dt : {0.01, 0.1, 0.4}) {
    Simulation<3> sim(free_body({0.3, 0.5, 1.1}, {0.7, 3, 0.4}));
    const Vec3 momentum = turning_momentum(sim.model(), sim.state(), 0);
    const double energy = 0.5 * momentum.dot(sim.state().spin[0]);
    CHECK(sim.run(steps_in_space(newmark, 200 * dt, dt)).end == StageEnd::time);
    const State<3>& end = sim.state();
    CHECK((turning_momentum(sim.model(), end, 0) - momentum).norm() < 1e-10 * momentum.norm());
    CHECK(near(0.5 * momentum.dot(end.spin[0]), energy, 1e-9));
    sim.refresh();
    CHECK(near(sim.energy().balance(), energy, 1e-9));
    CHECK((end.spin[0] - sim.model().start_spin[0]).norm() > 1e-2);
  }
}

TEST_CASE("HHT conserves the momentum of a free body, and the energy balance contains its dissipation") {
  Simulation<3> sim(free_body({0.3, 0.5, 1.1}, {0.7, 3, 0.4}));
  const Vec3 momentum = turning_momentum(sim.model(), sim.state(), 0);
  const double energy = 0.5 * momentum.dot(sim.state().spin[0]);
  CHECK(sim.run(steps_in_space(AlphaMethod::hht(-0.2), 4, 0.02)).end == StageEnd::time);
  CHECK((turning_momentum(sim.model(), sim.state(), 0) - momentum).norm() < 1e-10 * momentum.norm());
  sim.refresh();
  CHECK(near(sim.energy().balance(), energy, 1e-9));
}

TEST_CASE("T33: a free symmetric body spins and precesses, with implicit and explicit steps") {
  for (const bool implicit : {false, true}) {
    Simulation<3> sim(free_body({0.4, 0.4, 0.1}, {1, 0, 10}));
    const Vec3 momentum = turning_momentum(sim.model(), sim.state(), 0), up = momentum.normalized(),
               aside = Vec3(Vec3::UnitX() - up.x() * up).normalized(), third = cross(up, aside);
    const auto round = [&](const State<3>& s) {
      const Vec3 axis = axis_of(s, 0, Vec3::UnitZ());
      return std::atan2(axis.dot(third), axis.dot(aside));
    };
    const auto within = [](const State<3>& s) {
      const Vec3 own = turn_of(s.rotation[0]).undo(s.spin[0]);
      return std::atan2(own.y(), own.x());
    };
    REQUIRE((axis_of(sim.state(), 0, Vec3::UnitZ()) - Vec3::UnitZ()).norm() < 1e-12);
    TurnClock axis(round(sim.state())), spin(within(sim.state()));
    double off = 0;
    const auto see = [&](const Instant<3>& now) {
      axis.see(round(now.state), now.state.time), spin.see(within(now.state), now.state.time);
      const double cone = std::acos(axis_of(now.state, 0, Vec3::UnitZ()).dot(up));
      off = std::max(off, std::abs(cone - radians(3.04098)));
    };
    sim.run(implicit ? steps_in_space(newmark, 20, 2e-3) : explicit_steps(20, 2e-3), after_each_step(see));
    CHECK(axis.count() == 60);
    CHECK(near(2 * M_PI / axis.mean(), 18.8501, 2e-3));
    CHECK(near(2 * M_PI / spin.mean(), 8.82353, 2e-3));
    CHECK(off < 2e-3 * radians(3.04098));
  }
}

TEST_CASE("T31: a bar on a spherical bearing moves on its cone, with implicit and explicit steps") {
  const double d = 0.5, angle = radians(30), rate = 4.12652, mass = 20;
  const Vec3 spin(0, 0, rate);
  const OnBearing bar{{0.1, 0.1, 1}, {0, 0, -d}, mass, rotation_by({angle, 0, 0}), spin, 1e8};
  for (const bool implicit : {false, true}) {
    Simulation<3> sim(bar.model());
    const std::size_t n = node_called(sim.model(), "body");
    const auto place = [&](const State<3>& s) { return s.position[n]; };
    const auto round = [&](const State<3>& s) { return std::atan2(place(s).y(), place(s).x()); };
    TurnClock clock(round(sim.state()));
    double off = 0;
    const auto see = [&](const Instant<3>& now) {
      clock.see(round(now.state), now.state.time);
      const Vec3 x = place(now.state);
      off = std::max(off, std::abs(std::atan2(std::hypot(x.x(), x.y()), -x.z()) - angle));
    };
    const StageReport report =
        sim.run(implicit ? steps_in_space(damped, 15.3, 2e-3) : explicit_steps(15.3), after_each_step(see));
    INFO(report.reason);
    CHECK(report.end == StageEnd::time);
    CHECK(clock.count() == 10);
    CHECK(near(clock.mean(), 1.52263, 2e-3));
    CHECK(off < radians(0.05));
    MESSAGE("T31 " << (implicit ? "implicit" : "explicit") << ": " << clock.mean() << " s a turn, cone off by "
                   << off * 180 / M_PI << " degrees, " << report.steps << " steps");
  }
}

TEST_CASE("T32: a heavy top keeps its steady precession") {
  const double lean = radians(20), own = 80, mass = 2400 * 0.3 * 0.3 * 0.05;
  for (const double precession : {1.26360, 41.0099}) {
    const UnitQuaternion turn = rotation_by({lean, 0, 0});
    const Vec3 axis = turn_of(turn).z();
    // The axial spin is the component of the total angular velocity along the axis.
    const Vec3 round = precession * Vec3::UnitZ(), spin = round + (own - round.dot(axis)) * axis;
    const OnBearing top{{0.3, 0.3, 0.05}, {0, 0, 0.15}, mass, turn, spin, 1e8};
    Simulation<3> sim(top.model());
    const std::size_t n = node_called(sim.model(), "body");
    const auto angle = [&](const State<3>& s) { return std::atan2(s.position[n].y(), s.position[n].x()); };
    TurnClock clock(angle(sim.state()));
    double off = 0;
    const auto see = [&](const Instant<3>& now) {
      clock.see(angle(now.state), now.state.time);
      const Vec3 a = axis_of(now.state, n, turn_of(inverse(sim.model().start_rotation[n])).apply(axis));
      off = std::max(off, std::abs(std::acos(a.z()) - lean));
    };
    const double turns = precession > 10 ? 20 : 1, dt = 5e-4;
    const StageReport report =
        sim.run(steps_in_space(damped, 1.02 * turns * 2 * M_PI / precession, dt), after_each_step(see));
    INFO(report.reason);
    CHECK(report.end == StageEnd::time);
    CHECK(clock.count() == static_cast<int>(turns));
    CHECK(near(clock.mean(), 2 * M_PI / precession, 5e-3));
    CHECK(off < radians(0.1));
    MESSAGE("T32: " << 2 * M_PI / clock.mean() << " rad/s (" << precession << "), axis off by " << off * 180 / M_PI
                    << " degrees");
  }
}

TEST_CASE("T35: a spherical pendulum returns to its apex at the exact time and azimuth") {
  for (const bool implicit : {false, true}) {
    const double angle = radians(40);
    const OnBearing ball{{0.1, 0.1, 2}, {0, 0, -1}, 10, rotation_by({0, -angle, 0}), {}, 1e7};
    Model<3> model = ball.model();
    const std::size_t n = node_called(model, "body");
    model.inertia[n] = Vec3::Constant(1e-4);  // almost a point mass, at the end of its link
    model.start_velocity[n] = Vec3(0, 1, 0);
    // Spin of the link about the pivot: across the link by the velocity of its end.
    const Vec3 arm = model.start_position[n];
    model.start_spin[n] = cross(arm, model.start_velocity[n]) / arm.squaredNorm();
    Simulation<3> sim(model);
    double far = 0, before = 0, before_that = 0, time = 0, turned = 0, last = std::atan2(arm.y(), arm.x());
    double at = 0, turned_there = 0, turned_before = 0;
    const auto see = [&](const Instant<3>& now) {
      const Vec3& x = now.state.position[n];
      const double radius = std::hypot(x.x(), x.y()), round = std::atan2(x.y(), x.x());
      const double dt = now.state.time - time;
      turned_before = turned, turned += std::remainder(round - last, 2 * M_PI), last = round;
      if (at == 0 && before_that > 0 && before > before_that && before >= radius && now.state.time > 0.5) {
        const double bend = before_that - 2 * before + radius, share = 0.5 * (before_that - radius) / bend;
        at = time + share * dt, far = before;
        turned_there = turned_before + share * (turned - turned_before);
      }
      before_that = before, before = radius, time = now.state.time;
    };
    const StageReport report =
        sim.run(implicit ? steps_in_space(damped, 1.2, 1e-3) : explicit_steps(1.2), after_each_step(see));
    INFO(report.reason);
    CHECK(report.end == StageEnd::time);
    CHECK(near(at, 1.03891, 2e-3));
    CHECK(near(far, 0.64279, 2e-3));
    // The body turns by more than half a turn: the shorter angle between the two points is 164.842 degrees.
    CHECK(near(turned_there, 2 * M_PI - radians(164.842), 2e-3));
  }
}

TEST_CASE("a pendulum that swings in a plane of space with implicit steps equals the pendulum in the plane") {
  // A rod about a fixed axis, with one rotation as the unknown.
  const double dt = 0.01;
  SolidModelBuilder builder;
  builder.gravity = Vec3::Zero();
  SolidSpec spec = flying({0.3, 0.5, 1.1}, {0, 2, 0});
  spec.support = {Support::fixed, Support::fixed, Support::fixed, Support::fixed, Support::free, Support::fixed};
  builder.add_body(spec);
  Simulation<3> sim(builder.build());
  sim.run(steps_in_space(damped, 1, dt));
  CHECK(near(turn_between(sim.model().start_rotation[0], sim.state().rotation[0]).y(), 2, 1e-12));
  CHECK(near(sim.state().spin[0].y(), 2, 1e-12));
}

TEST_CASE("average acceleration is of second order for a top on a spring") {
  // Half the step, a quarter of the error.
  const auto end_of_run = [](double dt) {
    const OnBearing top{{0.3, 0.2, 0.05}, {0, 0, 0.2}, 10, rotation_by({0.4, 0.2, 0}), {0.5, -1, 12}, 2e4};
    Simulation<3> sim(top.model());
    CHECK(sim.run(steps_in_space(newmark, 0.6, dt)).end == StageEnd::time);
    return sim.state();
  };
  const State<3> fine = end_of_run(0.6 / 15360);
  std::array<double, 2> off{}, turn_off{};
  for (const std::size_t i : {0, 1}) {
    const State<3> s = end_of_run(0.6 / (i == 0 ? 960 : 1920));
    off[i] = (s.position[1] - fine.position[1]).norm();
    turn_off[i] = turn_between(fine.rotation[1], s.rotation[1]).norm();
  }
  MESSAGE("errors " << off[0] << " and " << off[1] << " m, " << turn_off[0] << " and " << turn_off[1] << " rad");
  CHECK(off[0] / off[1] > 3.8);
  CHECK(off[0] / off[1] < 4.3);
  CHECK(turn_off[0] / turn_off[1] > 3.8);
  CHECK(turn_off[0] / turn_off[1] < 4.3);
}

}  // namespace
}  // namespace trilith::testing
