// Equilibrium in space by statics, and large motions of frames by implicit steps: blocks under their weight, the 45
// degree bend (VALIDATION F1), the right-angle cantilever (F5), a load path past its limit.
#include <doctest/doctest.h>

#include <fmt/format.h>

#include "near.hpp"
#include "physics/space/space_frames.hpp"
#include "physics/space/space_implicit.hpp"
#include "statics/equilibrium.hpp"
#include "statics/load_path.hpp"

namespace trilith::testing {
namespace {

TEST_CASE("statics in space rest a stack where consolidation does, at the overlap of its weight") {
  for (const UnitQuaternion& world : {UnitQuaternion{}, rotation_by({0.9, 0.3, -0.6})}) {
    SpaceBuilder builder;
    const Turn3 turn(world);
    builder.gravity(turn.apply(Vec3(0, 0, -standard_gravity)));
    const auto at = [&](const Polyhedron& shape) { return placed(shape, world, Vec3::Zero()); };
    builder.add(fixed_stone("floor", at(box_solid(Vec3(-3, -3, -0.5), Vec3(3, 3, 0)))));
    const double kn = 1e9;
    for (int i = 0; i < 3; ++i)
      builder.add(stone("block " + std::to_string(i), at(box_at({0.5, 0.4, 0.3}, {0.02 * i, 0.01 * i, 0.15 + 0.3 * i},
                                                                rotation_by({0, 0, 0.3 * i})))));
    builder.contact(0, 0, frictional(kn, 5e8, 0.6, 2e-4), "joint");
    Simulation<3> sim(builder.build());
    StageOptions stage;
    stage.name = "rest", stage.duration = 1, stage.must_rest = true;
    const StageReport report = sim.settle(stage, {});
    INFO(report.reason);
    REQUIRE(report.end == StageEnd::rest);
    CHECK(report.ratio <= 1e-8);
    sim.refresh();
    CHECK(near_zero(sim.energy().balance(), 1e-6));
    const double area = 0.5 * 0.4, weight = sim.model().mass[1] * standard_gravity;
    const double sunk = -turn.undo(Vec3(sim.state().position[1] - sim.model().start_position[1])).z();
    CHECK(near(sunk, 3 * weight / (kn * area), 1e-2));
    // Released, the structure stays in equilibrium.
    StageOptions still = explicit_steps(0.2);
    const Vec3 before = sim.state().position[3];
    sim.run(still);
    CHECK((sim.state().position[3] - before).norm() < 1e-9);
  }
}

TEST_CASE("statics in space name the unsupported body and leave it in place") {
  SpaceBuilder builder;
  builder.gravity(Vec3(0, 0, -standard_gravity));
  builder.add(fixed_stone("floor", box_solid(Vec3(-3, -3, -0.5), Vec3(3, 3, 0))));
  builder.add(stone("loose", box_at({0.3, 0.3, 0.3}, {0, 0, 4})));
  builder.contact(0, 0, frictional(1e8, 1e8, 0.5, 2e-4), "joint");
  Simulation<3> sim(builder.build());
  const std::uint64_t before = state_hash(sim.state());
  StageOptions stage;
  stage.name = "rest", stage.duration = 1;
  const StageReport report = sim.settle(stage, {});
  CHECK(report.end == StageEnd::not_at_rest);
  CHECK(report.reason.find("loose has no support") != std::string::npos);
  CHECK(state_hash(sim.state()) == before);
}

/// The 45 degree bend of `chords` straight elements.
Model<3> bend_of_45(int chords) {
  const double radius = 100;
  std::vector<Vec3> places;
  for (int i = 0; i <= chords; ++i) {
    const double angle = M_PI / 4 * i / chords;
    places.emplace_back(radius * std::sin(angle), radius * (1 - std::cos(angle)), 0);
  }
  // The published runs use 1/6 for the torsion constant of the square.
  const GivenSection square{1, 1.0 / 12, 1, 0, 0, 1.0 / 12, 1.0 / 6, 1, 0};
  SolidSpec spec = chain_body("bend", places, section_in_space(square), 1);
  for (SpaceMember& member : spec.frame->members) member.shear = true;
  spec.frame->joints[0].support = clamped;
  return of_space_frames(member_material(1, 1e7, 0), {spec});
}

TEST_CASE("F1: statics moves the tip of the 45 degree bend of 16 elements to the published position") {
  struct Row {
    double load;
    Vec3 tip;
  };
  for (const Row& row :
       {Row{300, {58.779, 40.192, 22.245}}, Row{450, {52.239, 48.503, 18.508}}, Row{600, {47.150, 53.475, 15.685}}}) {
    Model<3> model = bend_of_45(16);
    model.load[16] = Vec3(0, 0, row.load);
    State<3> state = initial_state(model);
    EquilibriumOptions how;
    how.farthest = 2;  // the tip moves by more than half of the length
    const Equilibrium found = find_equilibrium(model, state, how);
    INFO(std::string(name_of(found.end)) << ", left " << found.left << " at node " << found.worst << ", " << found.steps
                                         << " steps");
    REQUIRE(found.converged);
    const Vec3 at = state.position[16];
    MESSAGE(fmt::format("F1, P {}: {:.3f} {:.3f} {:.3f}, {} steps, {} iterations", row.load, at.x(), at.y(), at.z(),
                        found.steps, found.iterations));
    CHECK(near(at.x(), row.tip.x(), 3e-3));
    CHECK(near(at.z(), row.tip.y(), 3e-3));
    CHECK(near(at.y(), row.tip.z(), 3e-3));
  }
}

TEST_CASE("a load-controlled path in space leads to the equilibrium of statics") {
  Model<3> model = bend_of_45(8);
  PointLoad<3> load;
  load.name = "push", load.body = 0, load.at = Attachment<3>::to_node(8, Vec3::Zero()), load.force = Vec3(0, 0, 600);
  loads_of<PointLoad<3>>(model).push_back(load);
  for (const PathControl control : {PathControl::load, PathControl::arc}) {
    LoadPathOptions<3> how;
    how.control = control, how.first = control == PathControl::load ? 0.1 : 4;
    how.to = 1, how.followed = {{{8, 2}, 1}};
    how.goes_on = [](const PathPoint& point, const State<3>&) { return point.factor < 1; };
    State<3> state = initial_state(model);
    const LoadPath path = follow_loads(model, state, how);
    REQUIRE(path.end == PathEnd::arrived);
    REQUIRE(path.points.back().factor >= 1 - 1e-9);
    if (control == PathControl::load) {
      State<3> direct = initial_state(model);
      EquilibriumOptions far;
      far.farthest = 2;
      REQUIRE(find_equilibrium(model, direct, far).converged);
      CHECK((state.position[8] - direct.position[8]).norm() < 1e-5);
      CHECK(near(path.points.back().displacement, direct.position[8].z(), 1e-6));
    }
  }
}

TEST_CASE("a load path in space that is stopped ends at its last point") {
  Model<3> model = bend_of_45(8);
  PointLoad<3> load;
  load.name = "push", load.body = 0, load.at = Attachment<3>::to_node(8, Vec3::Zero()), load.force = Vec3(0, 0, 600);
  model.loads.of<PointLoad<3>>().push_back(load);
  int asked = 0;
  LoadPathOptions<3> how;
  how.first = 1e-3, how.longest = 1e-3, how.most_points = 100000, how.followed = {{{8, 2}, 1}};
  how.is_stopped = [&asked] { return ++asked > 400; };
  State<3> state = initial_state(model);
  const LoadPath path = follow_loads(model, state, how);
  CHECK(path.end == PathEnd::stopped);
  CHECK(path.iterations <= 401);
  CHECK(path.points.size() > 1);
}

/// F5: legs of 10 m, with a section inertia much larger than their stiffness implies.
Model<3> right_angle(int divisions) {
  const GivenSection section{1, 1e-3, 1, 0, 1, 1e-3, 1e-3, 1, 1};
  SolidSpec spec =
      chain_body("frame", {Vec3::Zero(), Vec3(10, 0, 0), Vec3(10, 10, 0)}, section_in_space(section), divisions);
  for (SpaceMember& member : spec.frame->members) member.shear = true;
  spec.frame->joints[0].support = clamped;
  Model<3> model = of_space_frames(member_material(1, 1e6, -0.5), {spec});
  // Rotary inertia per length: 20 about the axis, 10 and 10 across.
  std::vector<Vec3> tensor(model.mass.size(), Vec3::Zero());
  for (const Beam3& beam : model.beams_3d)
    for (const int n : beam.node) {
      const bool first = std::abs(model.start_position[static_cast<std::size_t>(beam.node[1])].x() -
                                  model.start_position[static_cast<std::size_t>(beam.node[0])].x()) > 1e-9;
      tensor[static_cast<std::size_t>(n)] += 0.5 * beam.length * (first ? Vec3(20, 10, 10) : Vec3(10, 20, 10));
    }
  for (std::size_t n = 0; n < tensor.size(); ++n) {
    const Turn3 axes(model.start_rotation[n]);
    model.inertia[n] = {axes.x().cwiseAbs2().dot(tensor[n]), axes.y().cwiseAbs2().dot(tensor[n]),
                        axes.z().cwiseAbs2().dot(tensor[n])};
  }
  PointLoad<3> load;
  load.name = "push", load.body = 0, load.at = Attachment<3>::to_node(1, Vec3::Zero()), load.force = Vec3(0, 0, 1);
  load.curve.time = {0, 1, 2}, load.curve.share = {0, 50, 0};
  loads_of<PointLoad<3>>(model).push_back(load);
  return model;
}

TEST_CASE("F5: the right-angle cantilever moves the same with implicit and explicit steps" *
          doctest::test_suite("long")) {
  for (const bool implicit : {false, true}) {
    Simulation<3> sim(right_angle(20));
    struct Reading {
      double time, elbow, tip;
    };
    // The elbow at 2, 5 and 10 s, the tip at 5 and 10 s.
    const std::vector<Reading> expected{{2, 4.115, 0}, {5, 3.111, 5.479}, {10, -3.095, 4.464}};
    std::size_t next = 0;
    double after_load = 0, energy_off = 0, tip_peak = 0, tip_peak_at = 0;
    StageOptions stage = implicit ? steps_in_space(AlphaMethod::hht(0), 15, 0.025) : explicit_steps(15);
    stage.energy_interval = 0.1;
    RunListener<3> listener = after_each_step([&](const Instant<3>& now) {
      const double elbow = now.state.position[1].z(), tip = now.state.position[2].z(), t = now.state.time;
      if (t < 9 && tip > tip_peak) tip_peak = tip, tip_peak_at = t;
      if (next == expected.size() || t < expected[next].time - 1e-9) return;
      const Reading& row = expected[next++];
      MESSAGE((implicit ? "implicit" : "explicit")
              << ", " << t << " s: elbow " << elbow << " (" << row.elbow << "), tip " << tip << " (" << row.tip << ")");
      CHECK(near(elbow, row.elbow, 0.01));
      if (row.tip > 0) CHECK(near(tip, row.tip, 0.01));
    });
    listener.on_energy = [&](const Instant<3>& now, const Energy& e) {
      if (now.state.time < 2.001) return;
      const double all = e[EnergyTerm::kinetic] + e[EnergyTerm::strain];
      if (after_load == 0) after_load = all;
      energy_off = std::max(energy_off, std::abs(all - after_load));
    };
    const StageReport report = sim.run(stage, listener);
    INFO(report.reason);
    CHECK(report.end == StageEnd::time);
    CHECK(next == expected.size());
    CHECK(near(tip_peak, 8.252, 0.01));
    CHECK(near(tip_peak_at, 7.436, 0.01));
    CHECK(near(sim.state().position[2].z(), -9.163, 0.02));
    CHECK(near(sim.state().position[2].x(), -2.240 + 10, 0.02));
    CHECK(near(sim.state().position[2].y(), -7.242 + 10, 0.02));
    MESSAGE("energy after the load " << after_load << " J (114.88), off by " << energy_off << "; " << report.steps
                                     << " steps; at 15 s " << sim.state().position[2].transpose());
    CHECK(near(after_load, 114.88, 5e-3));
    CHECK(energy_off < 2e-3 * after_load);
  }
}

TEST_CASE("a soft frame that tumbles freely keeps energy, momentum and angular momentum by implicit steps") {
  SolidSpec spec = chain_body("frame", {Vec3::Zero(), Vec3(1, 0, 0), Vec3(1.3, 0.8, 0.2), Vec3(1.1, 0.9, 1)},
                              plain_section(0.02, 0.03), 3);
  Model<3> model = of_space_frames(member_material(2000, 2e9, 0.3), {spec});
  const Vec3 spin(1.1, -2, 3);
  for (std::size_t n = 0; n < model.mass.size(); ++n)
    model.start_velocity[n] = Vec3(0.5, 0.2, -0.1) + cross(spin, model.start_position[n]), model.start_spin[n] = spin;
  Simulation<3> sim(model);
  const auto momenta = [&] {
    const State<3>& s = sim.state();
    std::pair<Vec3, Vec3> sum{Vec3::Zero(), Vec3::Zero()};
    for (std::size_t n = 0; n < s.position.size(); ++n) {
      const Vec3 own = model.mass[n] * s.velocity[n];
      sum.first += own, sum.second += cross(s.position[n], own) + turning_momentum(model, s, n);
    }
    return sum;
  };
  sim.refresh();
  const double energy = sim.energy().balance();
  const auto [along, about] = momenta();
  CHECK(sim.run(steps_in_space(AlphaMethod::hht(0), 2, 2e-3)).end == StageEnd::time);
  sim.refresh();
  // Strain energy against the work of forces at both ends of steps: to the order of the scheme.
  CHECK(near(sim.energy().balance(), energy, 1e-4));
  CHECK((momenta().first - along).norm() < 1e-9 * along.norm());
  // The scheme evaluates forces at both ends of a step, not at its middle: the angular momentum is conserved to the
  // order of the scheme.
  CHECK((momenta().second - about).norm() < 1e-3 * about.norm());
}

}  // namespace
}  // namespace trilith::testing
