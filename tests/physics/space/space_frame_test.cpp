// Beams and frames in space: closed forms at rest, frequencies counted in free vibration, conserved quantities in
// flight, and the same results in a rotated world.
#include <unistd.h>

#include <doctest/doctest.h>

#include <filesystem>

#include "model/io/checkpoint.hpp"
#include "near.hpp"
#include "physics/space/space_frames.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double steel_young = 2.1e11, steel_poisson = 0.3, steel_density = 7850;

Section3 bar_section() {
  return plain_section(0.05, 0.1);
}

/// A cantilever along `along`, fixed at its start; `last`: the node of its tip.
Model<3> cantilever(double length, const UnitQuaternion& turn, int divisions, const Section3& section, bool shear,
                    const Material& material = member_material(steel_density, steel_young, steel_poisson)) {
  SolidSpec spec = chain_body("bar", {Vec3::Zero(), turn_of(turn).apply(Vec3(length, 0, 0))}, section, divisions);
  spec.frame->joints[0].support = clamped;
  spec.frame->members[0].orientation = turn_of(turn).y();
  spec.frame->members[0].shear = shear;
  return of_space_frames(material, {spec});
}
constexpr std::size_t tip = 1;

Vec3 turned_by(const Model<3>& model, const State<3>& state, std::size_t node) {
  return angle_of(state.rotation[node] * inverse(model.start_rotation[node]));
}

/// Mean length of the full periods of `of` until `end`, by its upward passages through 0 [s].
double counted_period(SolidRun& run, double end, const std::function<double()>& of) {
  double before = of(), first = -1, last = -1;
  int count = 0;
  while (run.time() < end) {
    const double then = run.time();
    run.step();
    const double now = of();
    if (before < 0 && now >= 0) {
      last = then + (run.time() - then) * before / (before - now);
      if (first < 0) first = last;
      ++count;
    }
    before = now;
  }
  REQUIRE(count > 3);
  return (last - first) / (count - 1);
}

double step_of(const Model<3>& model, double share = 0.5) {
  const State<3> state = initial_state(model);
  Work<3> work;
  evaluate(model, state, work, 0);
  return share * stable_step(model, state, work).dt;
}

}  // namespace

TEST_CASE("a cantilever in space bends about both axes and twists by the closed forms") {
  std::mt19937_64 bits(1);
  const double length = 2, e = steel_young, g = steel_young / (2 * (1 + steel_poisson)), load = 0.1;
  for (int i = 0; i < 4; ++i) {
    const UnitQuaternion turn = i == 0 ? UnitQuaternion{} : random_turn(bits);
    const Turn3 axes = turn_of(turn);
    const Section3 s = bar_section();
    for (const bool shear : {false, true}) {
      const Model<3> model = cantilever(length, turn, 4, s, shear);
      SpaceEquilibrium rest(model);
      rest.force[tip] = axes.apply(Vec3(0, load, load)), rest.moment[tip] = axes.apply(Vec3(load, 0, 0));
      CHECK(rest.solve(1, 1e-6) < 1e-6);
      const Vec3 moved = axes.undo(Vec3(rest.state().position[tip] - model.start_position[tip]));
      const Vec3 turned = axes.undo(turned_by(model, rest.state(), tip));
      const double up = load * std::pow(length, 3) / (3 * e * s.second_moment[1]) +
                        (shear ? load * length / (g * s.shear_area[1]) : 0),
                   across = load * std::pow(length, 3) / (3 * e * s.second_moment[0]) +
                            (shear ? load * length / (g * s.shear_area[0]) : 0);
      CHECK(near(moved.y(), up, 1e-5));
      CHECK(near(moved.z(), across, 1e-5));
      CHECK(near(turned.x(), load * length / (g * s.torsion), 1e-5));
      CHECK(near(turned.z(), load * length * length / (2 * e * s.second_moment[1]), 1e-5));
      CHECK(near(turned.y(), -load * length * length / (2 * e * s.second_moment[0]), 1e-5));
    }
  }
}

TEST_CASE("forces in the members of a frame in space balance its loads") {
  const Model<3> model = cantilever(2, UnitQuaternion{}, 4, bar_section(), false);
  SpaceEquilibrium rest(model);
  rest.force[tip] = Vec3(7, 11, 13), rest.moment[tip] = Vec3(5, 0, 0);
  rest.solve(1, 1e-8);
  const std::vector<SectionForces3> rows = member_forces(model, rest.state(), 0);
  REQUIRE(rows.size() == 8);
  CHECK(near(rows.front().normal, 7, 1e-3));
  CHECK(near(rows.front().torque, 5, 1e-3));
  // The load at the end acts on the part before it; the part behind it has the opposite shear.
  CHECK(near(rows.front().shear[0], -11, 1e-3));
  CHECK(near(rows.front().shear[1], -13, 1e-3));
  CHECK(near(rows.front().moment[1], 2 * 11, 1e-3));
  CHECK(near(rows.front().moment[0], -2 * 13, 1e-3));
  CHECK(near_zero(rows.back().moment[1], 1e-2));
  CHECK(near_zero(rows.back().moment[0], 1e-2));
}

TEST_CASE("a cantilever that an end moment about any axis rolls up becomes a circle") {
  std::mt19937_64 bits(2);
  for (int i = 0; i < 3; ++i) {
    const UnitQuaternion turn = random_turn(bits);
    const Turn3 axes = turn_of(turn);
    const double length = 10;
    Section3 s = plain_section(0.1, 0.1);
    const int divisions = 10;
    const Model<3> model = cantilever(length, turn, divisions, s, false, member_material(steel_density, steel_young));
    // About any axis perpendicular to the bar: its section has the same stiffness about all of them.
    const Vec3 axis = axes.apply(Vec3(0, std::cos(i * 1.0), std::sin(i * 1.0)));
    SpaceEquilibrium rest(model);
    rest.moment[tip] = 2 * M_PI * steel_young * s.second_moment[1] / length * axis;
    CHECK(rest.solve(40, 1e-3) < 1e-3);
    CHECK((rest.state().position[tip] - model.start_position[0]).norm() < 2e-3 * length);
    // At half of the length the bar is across the circle, at its diameter; the first and last elements are chords of
    // the circle.
    const Vec3 middle = rest.state().position[2 + divisions / 2 - 1] - model.start_position[0];
    CHECK(near(middle.norm(), length / M_PI, 0.02));
    CHECK(near_zero(middle.dot(axis), 1e-6));
  }
}

TEST_CASE("the tip of the 45 degree bend under an out-of-plane force has the published position (F1)") {
  const double radius = 100;
  std::vector<Vec3> places;
  const int chords = 8;
  for (int i = 0; i <= chords; ++i) {
    const double angle = M_PI / 4 * i / chords;
    places.emplace_back(radius * std::sin(angle), radius * (1 - std::cos(angle)), 0);
  }
  // The published runs use 1/6 for the torsion constant of the square.
  GivenSection square{1, 1.0 / 12, 1, 0, 0, 1.0 / 12, 1.0 / 6, 1, 0};
  SolidSpec spec = chain_body("bend", places, section_in_space(square), 1);
  for (SpaceMember& member : spec.frame->members) member.shear = true;
  spec.frame->joints[0].support = clamped;
  const Model<3> model = of_space_frames(member_material(1, 1e7, 0), {spec});
  SpaceEquilibrium rest(model);
  rest.force[chords] = Vec3(0, 0, 600);
  CHECK(rest.solve(12, 1e-6) < 1e-6);
  const Vec3 at = rest.state().position[chords];
  MESSAGE("tip at " << at.x() << " " << at.y() << " " << at.z());
  // Simo and Vu-Quoc 1986: (15.79, 47.23, 53.37), with the first two exchanged.
  CHECK(near(at.x(), 47.23, 3e-3));
  CHECK(near(at.y(), 15.79, 3e-3));
  CHECK(near(at.z(), 53.37, 3e-3));
}

TEST_CASE("a free cantilever in space swings about both axes and twists at the frequencies of the closed forms") {
  const double length = 2, g = steel_young / (2 * (1 + steel_poisson));
  const Section3 s = bar_section();
  const Model<3> model = cantilever(length, UnitQuaternion{}, 16, s, false);
  const double mass = steel_density * s.area, root = 1.875104 * 1.875104 / (length * length);
  const auto period_along = [&](int k, double expected) {
    SolidRun run(model, step_of(model));
    for (int n = 0; n < model.nodes(); ++n) {
      const double x = model.start_position[n].x() / length;
      run.state().velocity[n][k] = 1e-3 * x * x * (3 - x);
    }
    return counted_period(run, 6 * expected, [&] { return run.place(tip)[k] - 1e-9; });
  };
  const double up = 2 * M_PI / (root * std::sqrt(steel_young * s.second_moment[1] / mass)),
               across = 2 * M_PI / (root * std::sqrt(steel_young * s.second_moment[0] / mass));
  CHECK(near(period_along(1, up), up, 5e-3));
  CHECK(near(period_along(2, across), across, 5e-3));
  // A shaft fixed at one end twists in a quarter wave.
  const double polar = steel_density * (s.second_moment[0] + s.second_moment[1]),
               twist = 4 * length / std::sqrt(g * s.torsion / polar);
  SolidRun run(model, step_of(model));
  for (int n = 0; n < model.nodes(); ++n)
    run.state().spin[n].x() = 1e-3 * std::sin(M_PI / 2 * model.start_position[n].x() / length);
  CHECK(near(counted_period(run, 8 * twist, [&] { return turned_by(model, run.state(), tip).x(); }), twist, 2e-3));
}

namespace {

/// A soft angle frame of two legs at a right angle, which tumbles while its legs swing.
Model<3> tumbling(const UnitQuaternion& turn, double damping = 0) {
  const Turn3 axes = turn_of(turn);
  SolidSpec spec = chain_body("angle", {axes.apply(Vec3(2, 0, 0)), Vec3::Zero(), axes.apply(Vec3(0, 2, 0.5))},
                              plain_section(0.05, 0.08), 4);
  for (SpaceMember& member : spec.frame->members) member.orientation = axes.apply(Vec3(0.1, 0.2, 1));
  spec.velocity = axes.apply(Vec3(1, 2, 3)), spec.spin = axes.apply(Vec3(4, -3, 5));
  return of_space_frames(member_material(2000, 2e8, 0.2, damping), {spec});
}

}  // namespace

TEST_CASE("a soft frame that tumbles freely keeps its energy, momentum and angular momentum") {
  const Model<3> model = tumbling(UnitQuaternion{});
  SolidRun run(model, step_of(model, 0.4));
  run.step();
  const Vec3 momentum = run.momentum(), angular = run.angular_momentum();
  const double begun = run.energy().balance();
  double most = 0, strain = 0, moving = run.moving_energy();
  while (run.time() < 3) {
    for (int i = 0; i < 50; ++i) run.step();
    const Energy energy = run.energy();
    strain = std::max(strain, energy[EnergyTerm::strain]);
    most = std::max(most, std::abs(energy.balance() - begun));
  }
  MESSAGE("strain energy to " << strain / moving << ", drift of energy " << most / moving);
  CHECK(strain > 0.01 * moving);
  CHECK(most < 1e-4 * moving);
  CHECK((run.momentum() - momentum).norm() < 1e-10 * momentum.norm());
  CHECK((run.angular_momentum() - angular).norm() < 1e-6 * angular.norm());
}

TEST_CASE("a frame structure moves the same way in rotated axes") {
  std::mt19937_64 bits(9);
  const UnitQuaternion turn = random_turn(bits);
  const Model<3> straight = tumbling(UnitQuaternion{}), turned = tumbling(turn);
  const double dt = step_of(straight, 0.4);
  SolidRun one(straight, dt), other(turned, dt);
  one.run(0.5), other.run(0.5);
  for (int n = 0; n < straight.nodes(); ++n) CHECK((turn_of(turn).apply(one.place(n)) - other.place(n)).norm() < 1e-7);
  CHECK(near(one.energy()[EnergyTerm::strain], other.energy()[EnergyTerm::strain], 1e-5));
}

TEST_CASE("damping of beams in space acts on vibration and not on rigid motion, and the energy balance contains it") {
  const Model<3> model = tumbling(UnitQuaternion{}, 2e-3);
  SolidRun run(model, step_of(model, 0.3));
  run.step();
  const Vec3 angular = run.angular_momentum();
  const Energy begun = run.energy();
  run.run(3);
  const Energy energy = run.energy();
  CHECK(energy[EnergyTerm::element_damping] > 0);
  CHECK(near_zero(energy.balance() - begun.balance(), 2e-3 * begun[EnergyTerm::kinetic]));
  CHECK((run.angular_momentum() - angular).norm() < 1e-6 * angular.norm());
}

TEST_CASE("the longest step of a frame in space is stable, and 2.1 times it is not") {
  const Model<3> model = cantilever(2, UnitQuaternion{}, 6, bar_section(), true);
  const double dt = step_of(model, 1);
  const auto grown = [&](double share) {
    SolidRun run(model, share * dt);
    std::mt19937_64 bits(1);
    for (int n = 0; n < model.nodes(); ++n) {
      run.state().velocity[n] = 1e-6 * random_in_ball(bits), run.state().spin[n] = 1e-6 * random_in_ball(bits);
      if (!model.moves(n)) run.state().velocity[n] = run.state().spin[n] = Vec3::Zero();
    }
    for (int i = 0; i < 4000; ++i) {
      run.step();
      if (!(run.velocity(tip).norm() < 1)) return true;
    }
    return false;
  };
  CHECK(!grown(1));
  CHECK(grown(2.2));
}

TEST_CASE("a frame in space has the same bits saved and continued and after its scratch memory is freed") {
  const Model<3> model = tumbling(UnitQuaternion{}, 1e-4);
  const double dt = step_of(model, 0.4);
  SolidRun plain(model, dt), dropped(model, dt);
  for (int i = 0; i < 500; ++i) {
    if (i % 37 == 0) dropped.drop_work();
    plain.step(), dropped.step();
  }
  CHECK(state_hash(plain.state()) == state_hash(dropped.state()));
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("frame" + std::to_string(::getpid()) + ".state");
  save_state(plain.state(), model, path);
  SolidRun rest(model, load_state(model, path), dt);
  std::filesystem::remove(path);
  plain.run(0.05), rest.run(0.05);
  CHECK(state_hash(rest.state()) == state_hash(plain.state()));
}
