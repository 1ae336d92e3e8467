// Consistent mass of beams: frequencies of a few elements, inertia forces, conserved quantities, moving supports.
#include "assembly/element/consistent_mass.hpp"
#include "element/beam/beam_inertia.hpp"
#include "integrate/implicit/implicit_step.hpp"
#include "modal/modes.hpp"
#include "model/check/energy_check.hpp"
#include "model/io/state_words.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"
#include "physics/members/implicit.hpp"

namespace trilith::testing {
namespace {

/// A bar 10 m long and 10 mm thick, so thin that the rotary inertia of its sections is negligible.
BodySpec thin_bar(int divisions, bool consistent) {
  BodySpec spec = beam_body("bar", {0, 0}, {10, 0}, rectangle_section(1, 0.01), "steel", divisions);
  spec.frame->consistent = consistent;
  return spec;
}
Material thin_steel() {
  return elastic_material("steel", 7850, 2e11);
}

/// (beta L)^2 of the first modes of a cantilever, which are its frequencies over sqrt(EI / mu L^4).
std::vector<double> numbers_of_cantilever(int divisions, bool consistent, int count) {
  BodySpec spec = thin_bar(divisions, consistent);
  spec.frame->joints[0].support = held;
  Model<2> model = of_frames(thin_steel(), {spec});
  if (!consistent)
    for (double& inertia : model.inertia) inertia *= 1e-6;
  const Section s = spec.frame->members[0].section;
  const double unit = std::sqrt(2e11 * s.second_moment / (7850 * s.area * 1e4));
  std::vector<double> out;
  for (const Mode& mode : modes(model, initial_state(model), 3 * divisions))
    if (static_cast<int>(out.size()) < count) out.push_back(std::sqrt(mode.square) / unit);
  return out;
}

TEST_CASE("a cantilever of 1, 2 and 4 beams with consistent mass has the known frequencies, from above") {
  const std::vector<std::vector<double>> known{{3.53273, 34.8069}, {3.51772, 22.2215}, {3.51613, 22.0602}};
  const std::array exact{3.5160153, 22.0344916};
  std::array<std::vector<double>, 3> high, low;
  for (const int i : {0, 1, 2}) {
    high[i] = numbers_of_cantilever(1 << i, true, 2), low[i] = numbers_of_cantilever(1 << i, false, 1);
    MESSAGE(
        fmt::format("{} beams: consistent {:.5f}, {:.4f}; lumped {:.5f}", 1 << i, high[i][0], high[i][1], low[i][0]));
    for (const int k : {0, 1}) CHECK(near(high[i][k], known[i][k], 3e-6));
    for (const int k : {0, 1}) CHECK(high[i][k] > exact[k]);
    CHECK(low[i][0] < exact[0]);
  }
  // Convergence order 4 (consistent) and 2 (lumped).
  CHECK(near((high[1][0] - exact[0]) / (high[2][0] - exact[0]), 16, 0.08));
  CHECK(near((exact[0] - low[1][0]) / (exact[0] - low[2][0]), 4, 0.15));
}

TEST_CASE("inertia forces of a rotating beam are Lagrange's, and none bends a rigidly rotating beam") {
  const Section section = rectangle_section(0.3, 0.5);
  const double length = 2;
  for (const std::array<bool, 2> pinned : {std::array{false, false}, std::array{true, false}, std::array{true, true}}) {
    const BeamMatrix m = beam_inertia(1200, length, section, pinned).consistent;
    BeamVector x, v, a;
    x << 0.3, -0.2, 0, 1.8, 1.1, 0;
    v << 0.4, -0.7, 0.3, -0.2, 0.9, 0.8;
    a << -1.1, 0.6, 0.2, 0.5, -0.3, 0.9;
    const auto momentum = [&](const BeamVector& at, const BeamVector& rate) -> BeamVector {
      return turned(m, (at.segment<2>(3) - at.segment<2>(0)).normalized()) * rate;
    };
    const auto energy = [&](const BeamVector& at) { return 0.5 * v.dot(momentum(at, v)); };
    const double h = 1e-5;
    const BeamVector x_after = x + h * v + 0.5 * h * h * a, x_before = x - h * v + 0.5 * h * h * a;
    BeamVector expected = (momentum(x_after, v + h * a) - momentum(x_before, v - h * a)) / (2 * h);
    for (int i = 0; i < 6; ++i) {
      BeamVector to = BeamVector::Zero();
      to[i] = h;
      expected[i] -= (energy(x + to) - energy(x - to)) / (2 * h);
    }
    const Vec2 chord = x.segment<2>(3) - x.segment<2>(0);
    const BeamVector found = inertia_forces(m, {chord.normalized(), chord.norm(), v, a});
    for (int i = 0; i < 6; ++i) CHECK(near(found[i], expected[i], 1e-6));
  }
}

TEST_CASE("a bar of one beam with consistent mass has the kinetic energy of a bar that moves and turns") {
  for (const double angle : {0.0, 0.7, 2.5}) {
    const Vec2 way = 4 * Vec2(std::cos(angle), std::sin(angle));
    BodySpec spec = beam_body("bar", {1, 2}, Vec2(Vec2(1, 2) + way), rectangle_section(0.2, 0.4), "steel", 1);
    spec.frame->consistent = true, spec.velocity = {3, -1}, spec.spin = 0;
    const Model<2> model = of_frames(thin_steel(), {spec});
    State<2> state = initial_state(model);
    const double spin = 2, mass = 7850 * 0.08 * 4;
    for (const int end : {0, 1}) {
      const Vec2 arm = (end == 0 ? -0.5 : 0.5) * way;
      state.velocity[end] = Vec2(3, -1) + cross(spin, arm), state.spin[end] = spin;
    }
    const double turning = mass * (16.0 + 0.4 * 0.4) / 12;
    CHECK(near(implicit_kinetic(model, state), 0.5 * mass * 10 + 0.5 * turning * spin * spin, 1e-12));
  }
}

/// M v summed over the nodes, with the mass matrix of implicit steps [kg m/s].
Vec2 momentum_of(const Model<2>& model, const State<2>& state) {
  Vec2 sum = Vec2::Zero();
  for (int n = 0; n < model.nodes(); ++n) sum += model.mass[n] * state.velocity[n];
  for (const Beam& beam : model.beams) {
    BeamVector v;
    v << state.velocity[beam.node[0]], state.spin[beam.node[0]], state.velocity[beam.node[1]], state.spin[beam.node[1]];
    const BeamVector more = added_mass(model, state, beam) * v;
    sum += more.segment<2>(0) + more.segment<2>(3);
  }
  return sum;
}

/// A steel bar of 4 m that flies and rotates, along y 0.4 times as fast as along x.
Model<2> flying_bar(int divisions, double speed, double spin, double mass_damping = 0) {
  BodySpec spec = beam_body("bar", {0, 0}, {4, 0}, rectangle_section(0.2, 0.4), "steel", divisions);
  spec.frame->consistent = true, spec.velocity = {speed, 0.4 * speed}, spec.spin = spin;
  Model<2> model = of_frames(thin_steel(), {spec});
  model.mass_damping = mass_damping;
  return model;
}
Vec2 middle_of(const State<2>& s) {
  return 0.5 * (s.position[0] + s.position[1]);
}

TEST_CASE("a free rotating bar with consistent mass conserves energy, and momentum to the square of the step") {
  for (const int beams : {1, 2, 4}) {
    const Model<2> model = flying_bar(beams, 0.5, 3);
    std::array<double, 4> astray{};
    for (const int finer : {0, 1, 2, 3}) {
      Simulation<2> sim(model);
      const double before = implicit_kinetic(model, sim.state());
      const Vec2 begun = momentum_of(model, sim.state());
      sim.run(implicit_stage(AlphaMethod::hht(0), 0.25, 1e-3 / (1 << finer)), each_step([&](const Instant<2>& now) {
                astray[finer] = std::max(astray[finer], (momentum_of(model, now.state) - begun).norm() / begun.norm());
              }));
      const Vec2 chord = sim.state().position[1] - sim.state().position[0];
      CHECK(near(std::atan2(chord.y(), chord.x()), 0.75, 1e-4));
      CHECK(near(sim.energy()[EnergyTerm::kinetic], before, 1e-4));
    }
    MESSAGE(fmt::format("{} beams: momentum off by {:.3g}, {:.3g}, {:.3g}, {:.3g} of it", beams, astray[0], astray[1],
                        astray[2], astray[3]));
    CHECK(astray[0] < 3e-5);
    for (const int finer : {1, 2, 3}) CHECK(near(astray[finer - 1] / astray[finer], 4, 0.03));
  }
}

// The rotation of a beam's own deflected shape is not part of its velocities (docs/theory/frames.md). So flight bends a
// rotating beam, and the mean of its ends is not its centre of mass. Both errors are of second order in the length of
// the beams, whatever the step.
TEST_CASE("the error of the centre of a flying and rotating bar falls with the square of the beam length") {
  std::array<double, 3> astray{};
  for (const int i : {0, 1, 2})
    for (const double speed : {0.0, 0.5}) {
      Simulation<2> sim(flying_bar(1 << i, speed, 3));
      sim.run(implicit_stage(AlphaMethod::hht(0), 0.1, 1e-4));
      const double off = (middle_of(sim.state()) - Vec2(2 + 0.1 * speed, 0.04 * speed)).norm();
      if (speed == 0) CHECK(off < 1e-13);
      astray[i] = off;
    }
  MESSAGE(fmt::format("middle astray by {:.3g}, {:.3g}, {:.3g} m", astray[0], astray[1], astray[2]));
  CHECK(astray[0] < 6e-6);
  CHECK(astray[1] < 0.6 * astray[0]);
  CHECK(astray[2] < 0.35 * astray[1]);
}

TEST_CASE("mass damping brakes flight and rotation of a bar with consistent mass, all in the energy balance") {
  for (const int beams : {1, 3}) {
    const double c = 2;
    Simulation<2> sim(flying_bar(beams, 0.5, 3, c));
    const Vec2 begun = momentum_of(sim.model(), sim.state());
    const double kinetic = implicit_kinetic(sim.model(), sim.state());
    sim.run(implicit_stage(AlphaMethod::hht(0), 0.5, 5e-4));
    const Energy e = sim.energy();
    // Velocities fall as exp(-c t), energies twice as fast: 0.5 s at 2 1/s.
    CHECK(near(momentum_of(sim.model(), sim.state()).norm(), begun.norm() * std::exp(-1), 1e-4));
    CHECK(near(e[EnergyTerm::kinetic], kinetic * std::exp(-2), 1e-3));
    CHECK(near(e[EnergyTerm::mass_damping], kinetic * (1 - std::exp(-2)), 1e-3));
    MESSAGE(fmt::format("{} beams: {:.6g} of {:.6g} J left, {:.6g} J given off", beams, e[EnergyTerm::kinetic], kinetic,
                        e[EnergyTerm::mass_damping]));
  }
}

TEST_CASE("effective masses of all modes are the mass that is free to move, lumped or consistent") {
  for (const bool consistent : {false, true}) {
    BodySpec spec = thin_bar(4, consistent);
    spec.frame->joints[0].support = held;
    const Model<2> model = of_frames(thin_steel(), {spec});
    const State<2> state = initial_state(model);
    std::array<double, 2> sum{};
    for (const Mode& mode : modes(model, state, 100))
      for (const int k : {0, 1}) sum[k] += mode.mass[k];
    const std::array<double, 2> free = free_mass(model, state);
    const double whole = 7850 * 0.01 * 10;
    MESSAGE(fmt::format("free {:.6g} and {:.6g} of {:.6g} kg", free[0], free[1], whole));
    for (const int k : {0, 1}) CHECK(near(sum[k], free[k], 1e-9));
    // One beam, a quarter of the bar, is fixed at its foot: the foot carries 1/2 of the beam's mass (lumped), or 2/3
    // along and 229/420 across (consistent).
    CHECK(near(free[0], whole * (1 - (consistent ? 2.0 / 3 : 0.5) / 4), 1e-9));
    CHECK(near(free[1], whole * (1 - (consistent ? 264.0 / 420 : 0.5) / 4), 1e-5));
  }
}

TEST_CASE("a state within implicit steps with consistent mass continues with the same bits") {
  BodySpec spec = beam_body("post", {0, 0}, {0, 3}, rectangle_section(0.2, 0.2), "steel", 3);
  spec.frame->consistent = true, spec.frame->joints[0].support = held;
  spec.frame->joints[1].mass = 5e3;
  Model<2> model = of_frames(thin_steel(), {spec});
  model.mass_damping = 0.5;
  std::vector<double> samples;
  for (int i = 0; i <= 200; ++i) samples.push_back(3 * std::sin(2 * M_PI * i / 50.0));
  set_drive(model, 0, 0, std::make_shared<GroundMotion>(samples, 0.01), 0, 0);
  for (const StageOptions& plan :
       {implicit_stage(AlphaMethod::hht(-0.05), 1, 0.01), adaptive_stage(AlphaMethod::from_radius(0.8), 1, 0.02)}) {
    StageOptions stage = plan;
    Simulation<2> once(model);
    std::vector<std::uint64_t> kept;
    RunListener<2> listener;
    listener.on_step = [&](const Instant<2>& now) {
      if (kept.empty() && now.state.time > 0.43) kept = state_words(now.state);
    };
    once.run(stage, listener);
    Simulation on(once.model(), state_from_words(once.model(), kept, "state"));
    CHECK(on.state().implicit());
    CHECK(on.state().time < 0.5);
    stage.end_time = once.state().time;
    on.run(stage);
    CHECK(on.state().position[1].x() != 0);
    CHECK(state_hash(on.state()) == state_hash(once.state()));
  }
}

TEST_CASE("a cantilever with consistent mass follows its modes in implicit steps, also on a moving base") {
  BodySpec spec = beam_body("post", {0, 0}, {0, 3}, rectangle_section(0.2, 0.2), "steel", 3);
  spec.frame->consistent = true, spec.frame->joints[0].support = held;
  spec.frame->joints[1].mass = 5e4;  // so heavy that the post has a single mode
  Model<2> model = of_frames(thin_steel(), {spec});
  const double frequency = modes(model, initial_state(model), 1)[0].frequency();
  // Under a sudden load, the largest displacement of the head is after half a period.
  add_load(model, "post", {0, 3}, {2e3, 0});
  Simulation<2> sim(model);
  double most = 0, at = 0;
  sim.run(implicit_stage(AlphaMethod::hht(0), 1.2 / frequency, 0.002 / frequency),
          each_step([&](const Instant<2>& now) {
            const double drift = now.state.position[1].x();
            if (drift > most) most = drift, at = now.state.time;
          }));
  MESSAGE("farthest after " << at * frequency << " periods (0.5)");
  CHECK(near(at, 0.5 / frequency, 0.01));
  CHECK(std::abs(sim.energy()[EnergyTerm::numerical]) < 1e-3 * sim.energy()[EnergyTerm::strain] + 1);
}

TEST_CASE("a support that moves does its work on consistent mass, whatever the frame weighs") {
  for (const double head : {0.0, 5e4}) {
    BodySpec spec = beam_body("post", {0, 0}, {0, 3}, rectangle_section(0.2, 0.2), "steel", 3);
    spec.frame->consistent = true, spec.frame->joints[0].support = held;
    spec.frame->joints[1].mass = head;
    Model<2> model = of_frames(thin_steel(), {spec});
    std::vector<double> samples;
    for (int i = 0; i <= 200; ++i) samples.push_back(3 * std::sin(2 * M_PI * i / 200.0));
    set_drive(model, 0, 0, std::make_shared<GroundMotion>(samples, 0.005, MotionStart{-3 / (2 * M_PI), 0}), 0, 0);
    Simulation<2> sim(model);
    // The ground moves as the scheme begins. Its node then has the consistent mass of a beam of 1 m instead of the
    // lumped half: 13/35 of the mass and 6/5 I/A.
    const double speed = 3 / (2 * M_PI), mass = 7850 * 0.04;
    const double begun = 0.5 * speed * speed * mass * (0.5 - 13.0 / 35 - 1.2 * 0.04 / 12);
    sim.run(implicit_stage(AlphaMethod::hht(0), 1, 5e-4));
    const Energy e = sim.energy();
    MESSAGE("head of " << head << " kg: put in " << e[EnergyTerm::support] << " J, begun with " << begun
                       << " J, numerical " << e[EnergyTerm::numerical] << " J");
    CHECK(near_zero(e[EnergyTerm::numerical] - begun, 1e-4 * std::abs(e[EnergyTerm::support])));
  }
}

}  // namespace
}  // namespace trilith::testing
