// Members in space with consistent mass and with band damping: frequencies of a few elements, Lagrange's forces,
// conserved quantities, agreement with the plane, damping ratios of free vibration.
#include <doctest/doctest.h>

#include <fmt/format.h>

#include "assembly/element/consistent_mass.hpp"
#include "assembly/start.hpp"
#include "assembly/tangent/beam_tangent.hpp"
#include "element/beam/beam_inertia_3d.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "integrate/implicit/implicit_step.hpp"
#include "modal/mode_damping.hpp"
#include "modal/modes.hpp"
#include "model/io/state_words.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"
#include "physics/members/implicit.hpp"
#include "physics/space/space_frames.hpp"
#include "physics/space/space_implicit.hpp"

namespace trilith::testing {
namespace {

/// A thin steel bar of 10 m in a rotated world, 10 mm deep and `width` wide, clamped at its start.
Model<3> thin_cantilever(int divisions, bool consistent, double width, const UnitQuaternion& world) {
  const Turn3 turn = turn_of(world);
  SolidSpec spec = chain_body("bar", {Vec3::Zero(), turn.apply(Vec3(10, 0, 0))}, plain_section(width, 0.01), divisions);
  spec.frame->consistent = consistent, spec.frame->members[0].orientation = turn.z();
  spec.frame->joints[0].support = clamped;
  return of_space_frames(member_material(7850, 2e11, 0.3), {spec});
}

TEST_CASE("a cantilever in space of 1, 2 and 4 beams with consistent mass has the known frequencies") {
  const std::vector<std::vector<double>> known{{3.53273, 34.8069}, {3.51772, 22.2215}, {3.51613, 22.0602}};
  const std::array exact{3.5160153, 22.0344916};
  const UnitQuaternion world = rotation_by({0.4, -1.1, 0.7});
  std::array<std::vector<double>, 3> found;
  for (const int i : {0, 1, 2}) {
    const Model<3> model = thin_cantilever(1 << i, true, 0.04, world);
    // About both axes: at 40 mm width the bar is four times as stiff across.
    const double unit = std::sqrt(2e11 * 1e-4 / 12 / (7850.0 * 1e4));
    std::vector<double> all;
    for (const NaturalMode<3>& mode : modes(model, initial_state(model), 6 << i))
      all.push_back(std::sqrt(mode.square) / unit);
    for (const double expected : {known[i][0], 4 * known[i][0], known[i][1]}) {
      const auto nearest = std::min_element(
          all.begin(), all.end(), [&](double a, double b) { return std::abs(a - expected) < std::abs(b - expected); });
      CHECK(near(*nearest, expected, 2e-5));
      found[i].push_back(*nearest);
    }
    MESSAGE(
        fmt::format("{} beams in space: {:.5f}, {:.5f} across, {:.4f}", 1 << i, found[i][0], found[i][1], found[i][2]));
  }
  CHECK(near((found[1][0] - exact[0]) / (found[2][0] - exact[0]), 16, 0.08));
}

BeamVector3 motion_of_ends(double seed) {
  BeamVector3 v;
  for (int i = 0; i < 12; ++i) v[i] = std::sin(seed + 1.7 * i);
  return v;
}

TEST_CASE("inertia forces of a beam in space are Lagrange's") {
  for (const std::array<bool, 2> pinned : {std::array{false, false}, {true, false}, {false, true}, {true, true}}) {
    const BeamInertia3 inertia = beam_inertia_in_space(1200, 2, pinned);
    const Vec3 from(0.3, -0.2, 0.5), to(1.8, 0.6, 1.1);
    const BeamVector3 v = motion_of_ends(0.3), a = motion_of_ends(2.1);
    const auto chord_at = [&](double t) {
      const Vec3 speed = v.segment<3>(6) - v.segment<3>(0), rise = a.segment<3>(6) - a.segment<3>(0);
      return Vec3(to - from + t * speed + 0.5 * t * t * rise);
    };
    const auto momentum_at = [&](double t) -> BeamVector3 {
      return mass_in_space(inertia, chord_at(t).normalized()) * (v + t * a);
    };
    const double h = 1e-5;
    BeamVector3 expected = (momentum_at(h) - momentum_at(-h)) / (2 * h);
    const BeamVector3 momentum = momentum_at(0);
    for (const int end : {0, 1})
      expected.segment<3>(6 * end + 3) -=
          cross(Vec3(v.segment<3>(6 * end + 3)), Vec3(momentum.segment<3>(6 * end + 3)));
    for (int k = 0; k < 3; ++k) {
      const auto energy = [&](double by) {
        Vec3 chord = chord_at(0);
        chord[k] += by;
        return 0.5 * v.dot(mass_in_space(inertia, chord.normalized()) * v);
      };
      const double slope = (energy(h) - energy(-h)) / (2 * h);
      expected[6 + k] -= slope, expected[k] += slope;
    }
    const Vec3 chord = chord_at(0);
    const BeamVector3 found = inertia_forces(inertia, {chord.normalized(), chord.norm(), v, a});
    for (int i = 0; i < 12; ++i) CHECK(near_zero(found[i] - expected[i], 1e-5 * expected.norm()));
    // The resultant force and moment of inertia are the rates of the momenta: zero without external forces.
    BeamVector3 still = BeamVector3::Zero();
    const BeamVector3 own = inertia_forces(inertia, {chord.normalized(), chord.norm(), v, still});
    const Vec3 sum = own.segment<3>(0) + own.segment<3>(6);
    const Vec3 rate = ((momentum_at(h) - momentum_at(-h)) / (2 * h)).segment<3>(0) +
                      ((momentum_at(h) - momentum_at(-h)) / (2 * h)).segment<3>(6);
    const BeamVector3 from_rise = mass_in_space(inertia, chord.normalized()) * a;
    CHECK((sum - (rate - from_rise.segment<3>(0) - from_rise.segment<3>(6))).norm() < 1e-5 * expected.norm());
  }
}

TEST_CASE("a beam in space with consistent mass that moves in a plane has the mass of the plane's, but its sections'") {
  const Section section = rectangle_section(1e-3, 1e-3);  // so thin that the rotary inertia of its sections is
                                                          // negligible
  for (const std::array<bool, 2> pinned : {std::array{false, false}, {true, false}, {true, true}}) {
    const BeamMatrix flat = turned(beam_inertia(1200, 2, section, pinned).consistent, Vec2(0.6, 0.8));
    const BeamMatrix3 deep = mass_in_space(beam_inertia_in_space(1200, 2, pinned), Vec3(0.6, 0.8, 0));
    constexpr std::array at{0, 1, 5, 6, 7, 11};
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) CHECK(near_zero(flat(i, j) - deep(at[i], at[j]), 1e-3));
  }
}

/// A steel bar of 4 m that flies, rotates and tumbles.
Model<3> tumbling_bar(int divisions, double mass_damping = 0) {
  SolidSpec spec = chain_body("bar", {Vec3(0, 0, 0), Vec3(4, 0, 0)}, plain_section(0.2, 0.4), divisions);
  spec.frame->consistent = true, spec.velocity = Vec3(0.5, 0.2, -0.1), spec.spin = Vec3(0, 1, 3);
  Model<3> model = of_space_frames(member_material(7850, 2e11, 0.3), {spec});
  model.mass_damping = mass_damping;
  return model;
}
Vec3 momentum_in_space(const Model<3>& model, const State<3>& state) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t n = 0; n < model.mass.size(); ++n) sum += model.mass[n] * state.velocity[n];
  for (const Beam3& beam : model.beams_3d) {
    BeamVector3 v;
    const auto a = static_cast<std::size_t>(beam.node[0]), b = static_cast<std::size_t>(beam.node[1]);
    v << state.velocity[a], state.spin[a], state.velocity[b], state.spin[b];
    const BeamVector3 more = added_mass(model, state, beam) * v;
    sum += more.segment<3>(0) + more.segment<3>(6);
  }
  return sum;
}

TEST_CASE("a free bar in space with consistent mass conserves energy, and momentum to the square of the step") {
  for (const int beams : {1, 3}) {
    const Model<3> model = tumbling_bar(beams);
    std::array<double, 3> astray{};
    for (const int finer : {0, 1, 2}) {
      Simulation<3> sim(model);
      const double before = implicit_kinetic(model, sim.state());
      const Vec3 begun = momentum_in_space(model, sim.state());
      StageOptions stage = steps_in_space(AlphaMethod::hht(0), 0.2, 1e-3 / (1 << finer));
      stage.tolerance = 1e-9;  // with a tighter tolerance, rounding halves some steps
      sim.run(stage, after_each_step([&](const Instant<3>& now) {
                astray[static_cast<std::size_t>(finer)] =
                    std::max(astray[static_cast<std::size_t>(finer)],
                             (momentum_in_space(model, now.state) - begun).norm() / begun.norm());
              }));
      CHECK(near(sim.energy()[EnergyTerm::kinetic], before, 1e-4));
      const Vec3 chord = (sim.state().position[1] - sim.state().position[0]).normalized();
      const Vec3 expected = turn_of(rotation_by(0.2 * Vec3(0, 1, 3))).x();
      CHECK((chord - expected).norm() < 1e-3);
    }
    MESSAGE(fmt::format("{} beams in space: momentum off by {:.3g}, {:.3g}, {:.3g} of it", beams, astray[0], astray[1],
                        astray[2]));
    CHECK(astray[0] < 1e-4);
    for (const std::size_t finer : {1, 2}) CHECK(near(astray[finer - 1] / astray[finer], 4, 0.1));
  }
}

TEST_CASE("damping by mass brakes a bar in space with consistent mass, all of it in the energy balance") {
  Simulation<3> sim(tumbling_bar(2, 2));
  const double kinetic = implicit_kinetic(sim.model(), sim.state());
  sim.run(steps_in_space(AlphaMethod::hht(0), 0.25, 5e-4));
  const Energy e = sim.energy();
  CHECK(near(e[EnergyTerm::kinetic], kinetic * std::exp(-1), 1e-3));
  CHECK(near(e[EnergyTerm::mass_damping], kinetic * (1 - std::exp(-1)), 1e-3));
}

TEST_CASE("effective masses in space are the mass that is free to move, with consistent mass too") {
  const Model<3> model = thin_cantilever(3, true, 0.02, {});
  const State<3> state = initial_state(model);
  std::array<double, 3> sum{};
  for (const NaturalMode<3>& mode : modes(model, state, 100))
    for (const std::size_t k : {0, 1, 2}) sum[k] += mode.mass[k];
  const std::array<double, 3> free = free_mass(model, state);
  const double whole = 7850 * 0.02 * 0.01 * 10;
  for (const std::size_t k : {0, 1, 2}) CHECK(near(sum[k], free[k], 1e-9));
  CHECK(near(free[0], whole * (1 - (2.0 / 3) / 3), 1e-9));
  for (const std::size_t k : {1, 2}) CHECK(near(free[k], whole * (1 - (264.0 / 420) / 3), 1e-9));
}

TEST_CASE(
    "a cantilever in space with consistent mass follows its modes in implicit steps and continues with the same bits") {
  SolidSpec spec = chain_body("post", {Vec3::Zero(), Vec3(0, 0, 3)}, plain_section(0.2, 0.2), 2);
  spec.frame->consistent = true, spec.frame->joints[0].support = clamped, spec.frame->joints[1].mass = 5e4;
  Model<3> model = of_space_frames(member_material(7850, 2e11, 0.3), {spec});
  const double frequency = modes(model, initial_state(model), 1)[0].frequency();
  SolidLoadSpec load;
  load.name = "pull", load.at = Vec3(0, 0, 3), load.force = Vec3(1.5e3, 1e3, 0);
  loads_of<PointLoad<3>>(model) = {make_solid_load(model, 0, load)};
  Simulation<3> sim(model);
  StageOptions stage = steps_in_space(AlphaMethod::hht(0), 1.2 / frequency, 0.004 / frequency);
  stage.tolerance = 1e-9;
  double most = 0, at = 0;
  std::vector<std::uint64_t> kept;
  sim.run(stage, after_each_step([&](const Instant<3>& now) {
            const double drift = now.state.position[1].x();
            if (drift > most) most = drift, at = now.state.time;
            if (kept.empty() && now.state.time > 0.4 / frequency) kept = state_words(now.state);
          }));
  CHECK(near(at, 0.5 / frequency, 0.01));
  CHECK(std::abs(sim.energy()[EnergyTerm::numerical]) < 1e-3 * sim.energy()[EnergyTerm::strain] + 1);
  Simulation on(sim.model(), state_from_words(sim.model(), kept, "state"));
  stage.end_time = sim.state().time;
  on.run(stage);
  CHECK(state_hash(on.state()) == state_hash(sim.state()));
}

/// The plane's mast (band_damping_test.cpp) in a rotated world, with section sides of 0.1 m and an oblique initial
/// velocity of 0.1 m/s.
Model<3> mast_in_space(double hertz, const std::optional<BandDamping>& band, const UnitQuaternion& world = {}) {
  const Turn3 turn = turn_of(world);
  SolidSpec spec = chain_body("mast", {Vec3::Zero(), turn.apply(Vec3(0, 0, 3))}, plain_section(0.1, 0.1), 2);
  const double bending = 2.1e11 * 1e-4 / 12, w = 2 * M_PI * hertz;
  spec.frame->joints[0].support = clamped;
  spec.frame->joints[1].mass = 3 * bending / (27 * w * w);
  spec.frame->joints[1].inertia = 1e-3 * spec.frame->joints[1].mass;
  Material steel = member_material(8000 / (hertz * hertz), 2.1e11);
  steel.band = band;
  Model<3> model = of_space_frames(steel, {spec});
  model.start_velocity[1] = turn.apply(Vec3(0.08, 0.06, 0));
  return model;
}

struct SpaceSwing {
  double ratio = 0, given = 0, residual = 0;
};

SpaceSwing swing_in_space(Model<3> model, double hertz, const Vec3& way, const std::optional<AlphaMethod>& scheme) {
  Simulation<3> sim(std::move(model));
  StageOptions o = scheme ? steps_in_space(*scheme, 12 / hertz, 1 / (200 * hertz)) : explicit_steps(12 / hertz);
  if (scheme) o.tolerance = 1e-9;
  std::vector<double> peaks;
  double before = 0, last = 0;
  sim.refresh();
  const double begun = sim.energy()[EnergyTerm::kinetic];
  const Vec3 start = sim.state().position[1];
  sim.run(o, after_each_step([&](const Instant<3>& now) {
            const double x = way.dot(now.state.position[1] - start);
            if (std::abs(last) > std::abs(before) && std::abs(last) > std::abs(x) && last * x > 0)
              peaks.push_back(std::abs(last));
            before = last, last = x;
          }));
  sim.refresh();
  const Energy end = sim.energy();
  REQUIRE(peaks.size() > 16);
  return {std::log(peaks[4] / peaks[16]) / (12 * M_PI), end[EnergyTerm::element_damping] / begun,
          std::abs(end.balance() - begun) / begun};
}

TEST_CASE("damping over a band in space: free vibration has the requested ratio in any frame, with all steps") {
  const UnitQuaternion world = rotation_by({0.6, -0.9, 0.4});
  const Vec3 way = turn_of(world).apply(Vec3(0.8, 0.6, 0));
  for (const double hertz : {1.0, 4.5, 20.0}) {
    const BandDamping band{0.03, 1, 20};
    const SpaceSwing s = swing_in_space(mast_in_space(hertz, band, world), hertz, way, std::nullopt);
    MESSAGE("asked .03 in space, at ", hertz, " Hz ", s.ratio, ", given off ", s.given, ", ledger ", s.residual);
    CHECK(near(s.ratio, 0.03, 0.15));
    CHECK(s.residual < 2e-3);
    CHECK(near(s.given, 1 - std::exp(-4 * M_PI * 12 * s.ratio), 0.05));
    const SpaceSwing upright = swing_in_space(mast_in_space(hertz, band), hertz, Vec3(0.8, 0.6, 0), std::nullopt);
    CHECK(near(upright.ratio, s.ratio, 1e-6));
  }
  const SpaceSwing by_explicit = swing_in_space(mast_in_space(4.5, BandDamping{0.03, 1, 20}, world), 4.5, way, {});
  const SpaceSwing by_implicit =
      swing_in_space(mast_in_space(4.5, BandDamping{0.03, 1, 20}, world), 4.5, way, AlphaMethod::hht(0));
  CHECK(near(by_implicit.ratio, by_explicit.ratio, 0.01));
  CHECK(near(by_implicit.given, by_explicit.given, 0.02));
}

TEST_CASE("damping over a band in space: modes give the ratio of free vibration, the longest step the stiffening") {
  const BandDamping band{0.04, 0.5, 30};
  for (const double hertz : {0.7, 6.0}) {
    const Model<3> model = mast_in_space(hertz, band);
    const State<3> state = start_state(model);
    const std::vector<NaturalMode<3>> found = modes(model, state, 1);
    const ModeDamping damping = mode_damping(model, state, found)[0];
    const SpaceSwing s = swing_in_space(model, hertz, Vec3(0.8, 0.6, 0), std::nullopt);
    CHECK(near(damping.bands, s.ratio, 0.05));
    CHECK(near_zero(damping.elements, 1e-9));
    const auto step = [](const Model<3>& m) {
      const State<3> at = start_state(m);
      Work<3> work;
      evaluate(m, at, work, 1e-6);
      return std::pair(stable_step(m, at, work).dt, unbanded_step(m, at, work).dt);
    };
    const double without = step(mast_in_space(hertz, std::nullopt)).first;
    CHECK(near(step(model).first, without / std::sqrt(damping_branches(band).stiffening()), 1e-12));
    CHECK(step(model).second == without);
  }
}

TEST_CASE("damping over a band in space: the tangent matches central differences") {
  Material steel = member_material(7850, 2.1e11, 0.3);
  steel.band = BandDamping{0.1, 1, 50};
  const Model<3> model =
      of_space_frames(steel, {chain_body("beam", {Vec3::Zero(), Vec3(2, 1, 0.5)}, plain_section(0.1, 0.2), 1)});
  State<3> state = start_state(model);
  for (std::size_t i = 0; i < state.beam_memory.size(); ++i)
    state.beam_memory[i] = 1e4 * std::sin(1.0 + static_cast<double>(i));
  state.position[1] += Vec3(1e-3, -2e-3, 1e-3);
  for (const double dt : {1e-4, 1e-2, 1.0}) {
    const BeamBlock3 block = beam_block(model, state, model.beams_3d[0], 0, dt);
    for (int column = 0; column < 12; ++column) {
      constexpr double way = 1e-6;
      Eigen::Matrix<double, 12, 1> difference = Eigen::Matrix<double, 12, 1>::Zero();
      for (const double side : {1.0, -1.0}) {
        State<3> moved = state;
        const auto n = static_cast<std::size_t>(column / 6);
        if (const int k = column % 6; k < 3) {
          moved.position[n][k] += side * way;
        } else {
          Vec3 turn = Vec3::Zero();
          turn[k - 3] = side * way;
          moved.rotation[n] = rotation_by(turn) * moved.rotation[n];
        }
        Work<3> work;
        internal_forces(model, moved, work, dt);
        for (int i = 0; i < 2; ++i) {
          const auto at = static_cast<std::size_t>(i);
          difference.segment<3>(6 * i) += side * (work.element_force[at] + work.element_damping[at]);
          difference.segment<3>(6 * i + 3) += side * (work.element_moment[at] + work.element_damping_moment[at]);
        }
      }
      for (int row = 0; row < 12; ++row)
        CHECK(std::abs(difference[row] / (2 * way) - block(row, column)) < 2e-6 * block.cwiseAbs().maxCoeff());
    }
  }
}

}  // namespace
}  // namespace trilith::testing
