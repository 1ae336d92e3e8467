// VALIDATION I5: a mass on a bar so stiff that no step resolves its stretch.
#include "near.hpp"
#include "physics/members/frames.hpp"
#include "physics/members/implicit.hpp"

namespace trilith::testing {
namespace {

constexpr double pendulum_mass = 10, pendulum_length = 3.0443, pendulum_speed = 7.72;  // [kg], [m], [m/s]

/// A mass at the end of a massless bar of EA = 1e10 N, hinged at the origin, with an initial velocity across the bar.
/// The mass has a negligible rotary inertia and rotates with the bar, which has the bending stiffness EI.
struct StiffPendulum {
  Model<2> model;
  State<2> state;

  explicit StiffPendulum(double inertia = 1e-3, double bending = 1e4) {
    BodySpec spec;
    spec.name = "bar", spec.kind = BodyKind::frame, spec.material = "m", spec.floating = true;
    FrameSpec frame;
    frame.joints = {{.name = "hinge", .place = {0, 0}, .support = held},
                    {.name = "mass", .place = {pendulum_length, 0}, .mass = pendulum_mass, .inertia = inertia}};
    FrameMember bar;
    bar.from = 0, bar.to = 1, bar.section = given_section(1e-3, bending / 1e13, 0.03), bar.divisions = 1,
    bar.pinned = {true, false};
    frame.members = {bar}, spec.frame = frame;
    model = of_frames(elastic_material("m", 1e-6, 1e13), {spec});
    state = initial_state(model);
    state.velocity[1] = {0, pendulum_speed};
    state.spin[1] = pendulum_speed / pendulum_length;
  }
};

/// Results after ten seconds of rotation.
struct Turning {
  double least = 1e300, most = 0;  ///< kinetic and elastic energy [J]
  double period = 0;               ///< mean of the whole turns [s]
  double tension = 0;              ///< mean over the last turn [N]
  double momentum = 0;             ///< angular, at the end [kg m2/s]
  StageEnd end = StageEnd::time;
  std::int64_t steps = 0;

  explicit Turning(const StageOptions& stage, const StiffPendulum& made = StiffPendulum()) {
    Simulation<2> sim(made.model, made.state);
    const Beam& bar = sim.model().beams[0];
    double angle = 0, before = 0, sum = 0, time = 0;
    int turns = 0;
    double last_turn = 0;
    StageOptions told = stage;
    told.energy_interval = 2e-3;
    RunListener<2> listener = each_step([&](const Instant<2>& now) {
      const Vec2 place = now.state.position[1];
      angle = std::atan2(place.y(), place.x());
      if (before < 0 && angle >= 0) {
        ++turns;
        last_turn = now.state.time - now.state.last_dt * angle / (angle - before);
        period = last_turn / turns;
      }
      before = angle;
      if (now.state.time > 10 - 2.47771) {
        sum += now.state.last_dt * bar.stiffness.axial * (place.norm() - pendulum_length), time += now.state.last_dt;
        tension = sum / time;
      }
    });
    listener.on_energy = [&](const Instant<2>&, const Energy& e) {
      const double all = e[EnergyTerm::kinetic] + e[EnergyTerm::strain];
      least = std::min(least, all), most = std::max(most, all);
    };
    const StageReport report = sim.run(told, listener);
    end = report.end, steps = report.steps;
    momentum = pendulum_mass * cross(sim.state().position[1], sim.state().velocity[1]);
  }
};

/// Fixed HHT steps of length `h` [s].
StageOptions implicit_stage_of(double alpha, double h) {
  StageOptions stage = implicit_stage(AlphaMethod::hht(alpha), 10, h);
  stage.tolerance = 1e-8;
  return stage;
}

void tell_turning(const std::string& what, const Turning& t) {
  MESSAGE(
      fmt::format("I5 {}: {:.3f} to {:.3f} J (297.992), a turn {:.5f} s (2.47771), {:.3f} N (195.770), {:.3f} "
                  "kg m2/s (235.020); {} steps",
                  what, t.least, t.most, t.period, t.tension, t.momentum, t.steps));
}

void check_energy(const Turning& t, double within) {
  CHECK(t.end == StageEnd::time);
  CHECK(near(t.least, 297.992, within));
  CHECK(near(t.most, 297.992, within));
}

TEST_CASE("I5: a stiff pendulum keeps energy and momentum for four turns with the usual scheme and step") {
  const Turning t(adaptive_stage(AlphaMethod::hht(-0.05), 10, 0.005));
  tell_turning("alpha -0.05, h 0.005 s", t);
  check_energy(t, 0.01);
  CHECK(near(t.period, 2.47771, 0.01));
  CHECK(near(t.tension, 195.770, 0.01));
  CHECK(near(t.momentum, 235.020, 0.01));
  CHECK(t.steps < 2100);
}

TEST_CASE("I5: with the largest damping of HHT a stiff pendulum loses energy in proportion to the step") {
  const Turning coarse(implicit_stage_of(-0.3, 0.05)), fine(implicit_stage_of(-0.3, 0.01));
  tell_turning("alpha -0.3, h 0.05 s", coarse);
  tell_turning("alpha -0.3, h 0.01 s", fine);
  check_energy(coarse, 0.016);
  check_energy(fine, 0.001);
}

TEST_CASE("I5: average acceleration diverges for a stiff pendulum unless steps are limited by their energy error") {
  const Turning free(implicit_stage_of(0, 0.05)), held_to(adaptive_stage(AlphaMethod::hht(0), 10, 0.05));
  tell_turning("alpha 0, h 0.05 s", free);
  tell_turning("alpha 0, h 0.05 s at most", held_to);
  CHECK(std::max(free.most / 297.992 - 1, 1 - free.least / 297.992) > 0.01);
  check_energy(held_to, 0.01);
}

TEST_CASE("I5: a stiff pendulum with almost no rotary inertia keeps turning on a bar stiff in bending") {
  for (const double inertia : {1e-9, 1.5e-13}) {
    const StiffPendulum made(inertia, 1e6);
    const Turning adaptive(adaptive_stage(AlphaMethod::hht(-0.05), 10, 0.005), made);
    const Turning fixed(implicit_stage_of(-0.05, 0.005), made);
    tell_turning(fmt::format("inertia {:g} kg m2, h 0.005 s at most", inertia), adaptive);
    tell_turning(fmt::format("inertia {:g} kg m2, h 0.005 s", inertia), fixed);
    for (const Turning& t : {adaptive, fixed}) {
      check_energy(t, 0.001);
      CHECK(near(t.period, 2.47771, 0.001));
      CHECK(near(t.tension, 195.770, 0.001));
      CHECK(t.steps < 2100);
    }
  }
}

}  // namespace
}  // namespace trilith::testing
