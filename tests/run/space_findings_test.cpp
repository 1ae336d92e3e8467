// Storeys, joints, base shear, thrust and damage of solids in space, against closed forms.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

#include "contact/joint/joint_plan.hpp"
#include "model/pose.hpp"
#include "model/space_builder/solid_model_builder.hpp"
#include "near.hpp"
#include "physics/space/solid_bodies.hpp"
#include "results/reading/reader.hpp"
#include "run/record/body_forces.hpp"
#include "run/record/recording.hpp"
#include "run/record/storey_damage.hpp"
#include "run/simulation.hpp"

namespace trilith::testing {
namespace {

enum FoundBody { ground_body, low_left, low_right, floor_body, high_body };

SolidSpec part_of(const std::string& name, const Polyhedron& shape, std::vector<std::string> groups) {
  SolidSpec spec;
  spec.name = name, spec.pieces = {shape}, spec.material = "stone", spec.groups = std::move(groups);
  return spec;
}

/// Two units of 1 m x 1 m x 2 m side by side on a fixed base, on them a floor of 4 m x 4 m x 0.5 m (z from 2 to 2.5 m),
/// on it a unit of 1 m x 1 m x 1 m. `turn` rotates the house about its origin.
Model<3> small_house(const ContactLaw& law, const UnitQuaternion& turn = {}) {
  SolidModelBuilder builder;
  Material stone;
  stone.name = "stone", stone.density = 2000;
  builder.add_material(stone);
  builder.add_law("joint", law);
  builder.set_contact("stone", "stone", "joint");
  const auto add = [&](const std::string& name, const Vec3& sides, const Vec3& centre,
                       std::vector<std::string> groups) {
    SolidSpec spec = part_of(name, placed(box_at(sides, centre), turn, Vec3::Zero()), std::move(groups));
    if (name == "base") spec.support.fill(Support::fixed);
    builder.add_body(spec);
  };
  add("base", {8, 8, 1}, {0, 0, -0.5}, {"base"});
  add("low left", {1, 1, 2}, {-0.5, 0, 1}, {"units", "storey 1"});
  add("low right", {1, 1, 2}, {0.5, 0, 1}, {"units", "storey 1"});
  add("floor", {4, 4, 0.5}, {0, 0, 2.25}, {"floors", "storey 1"});
  add("high", {1, 1, 1}, {0.2, 0.1, 3}, {"units", "storey 2"});
  return builder.build();
}

const ContactLaw found_mortar = Bonded{1e10, 4e9, 0.6, 1e-5, 1e5, 1e5};
const ContactLaw found_dry = Frictional{1e10, 4e9, 0.6, 1e-5};

Work<3> evaluated_at(const Model<3>& model, const State<3>& state) {
  Simulation<3> sim(model, state);
  sim.refresh();
  return sim.work();
}

/// The joint between two bodies.
const FaceJoint& joint_of(const std::vector<FaceJoint>& joints, int a, int b) {
  for (const FaceJoint& joint : joints)
    if (joint.body_a == a && joint.body_b == b) return joint;
  FAIL("no joint");
  return joints.front();
}

TEST_CASE("storeys in space have heights from floor to floor, drift both ways and twist") {
  const Model<3> model = small_house(found_mortar);
  const std::vector<Storey> storeys = find_storeys(model);
  const std::vector<int> base = find_base(model);
  CHECK(base == std::vector<int>{ground_body});
  REQUIRE(storeys.size() == 2);
  CHECK(near(storeys[0].height, 2.5, 1e-12));
  CHECK(near(storeys[1].height, 1, 1e-12));
  CHECK(storeys[0].top == std::vector<int>{floor_body});
  CHECK(storeys[1].top == std::vector<int>{high_body});
  State<3> state = initial_state(model);
  const double twist = 0.7;
  state.position[ground_body] += Vec3(0.01, 0.02, 0);
  state.position[floor_body] += Vec3(0.04, -0.01, -0.002);
  state.position[high_body] += Vec3(0.1, 0.05, 0.001);
  state.rotation[floor_body] = rotation_by(Vec3(0, 0, twist)) * state.rotation[floor_body];
  state.rotation[high_body] = rotation_by(Vec3(0, 0, -2.5)) * state.rotation[high_body];
  const Vec3 low = storey_drift(model, state, storeys, base, 0), high = storey_drift(model, state, storeys, base, 1);
  CHECK((low - Vec3(0.03, -0.03, -0.002)).norm() < 1e-14);
  CHECK((high - Vec3(0.06, 0.06, 0.003)).norm() < 1e-14);
  CHECK(near(level_part(high), 0.06 * std::sqrt(2.0), 1e-12));
  CHECK((top_drift(model, state, storeys, base) - Vec3(0.09, 0.03, 0.001)).norm() < 1e-14);
  CHECK(near(storey_twist(model, state, storeys, base, 0), twist, 1e-12));
  // A rotation of -3.2 rad against the floor equals one of 2 pi - 3.2 rad the other way.
  CHECK(near(storey_twist(model, state, storeys, base, 1), 2 * std::numbers::pi - 2.5 - twist, 1e-12));
}

/// Two beams side by side, with or without a slab on them, and a unit of the same height.
Model<3> beamed_storey(bool slab) {
  SolidModelBuilder builder;
  Material stone;
  stone.name = "stone", stone.density = 2000;
  builder.add_material(stone);
  const auto add = [&](const std::string& name, const Vec3& sides, const Vec3& centre,
                       std::vector<std::string> groups) {
    groups.emplace_back("storey 1");
    SolidSpec spec = part_of(name, box_at(sides, centre), std::move(groups));
    spec.floating = true;
    builder.add_body(spec);
  };
  add("left", {0.2, 4, 0.2}, {-1, 0, 2}, {"beams", "floors"});
  add("right", {0.2, 4, 0.2}, {1, 0, 2}, {"beams", "floors"});
  add("unit", {0.4, 0.2, 0.2}, {0, 0, 2}, {"units"});
  if (slab) add("slab", {4, 4, 0.2}, {0, 0, 2.2}, {"floors"});
  return builder.build();
}

TEST_CASE("a storey's top is the mean of its beams and its slab alone where one lies on them") {
  for (const bool slab : {false, true}) {
    const Model<3> model = beamed_storey(slab);
    const std::vector<Storey> storeys = find_storeys(model);
    REQUIRE(storeys.size() == 1);
    CHECK(near(storeys[0].height, slab ? 0.4 : 0.2, 1e-12));
    State<3> state = initial_state(model);
    state.position[0] += Vec3(0.02, 0, 0), state.position[1] += Vec3(0.04, 0.02, 0);
    if (slab) state.position[3] += Vec3(0.1, 0.2, 0);
    const Vec3 drift = storey_drift(model, state, storeys, find_base(model), 0);
    CHECK((drift - (slab ? Vec3(0.1, 0.2, 0) : Vec3(0.03, 0.01, 0))).norm() < 1e-14);
  }
}

TEST_CASE("twist of a storey without a floor is the twist of its topmost units about their centre") {
  const Model<3> model = small_house(found_mortar);
  State<3> state = initial_state(model);
  const UnitQuaternion turn = rotation_by(Vec3(0, 0, 0.3));
  for (const int body : {low_left, low_right}) {
    state.position[body] = Turn3(turn).apply(state.position[body]) + Vec3(0.4, 0, 0);
    state.rotation[body] = turn * state.rotation[body];
  }
  CHECK(near(mean_twist(model, state, {low_left, low_right}), 0.3, 1e-12));
  CHECK(near(mean_twist(model, state, {low_left}), 0.3, 1e-12));
  CHECK(near_zero(mean_twist(model, state, {ground_body}), 1e-15));
  CHECK(mean_twist(model, state, {}) == 0);
}

TEST_CASE("joints in space are the faces that lie on each other, with their area, bonded or dry, however they stand") {
  for (const Vec3& about : {Vec3(0, 0, 0), Vec3(0.3, -0.7, 1.1), Vec3(2, 1, -0.4)})
    for (const bool bonded : {true, false}) {
      const UnitQuaternion turn = rotation_by(about);
      const Model<3> model = small_house(bonded ? found_mortar : found_dry, turn);
      const std::vector<FaceJoint> joints = find_joints(model);
      REQUIRE(joints.size() == 6);
      double area = 0;
      for (const FaceJoint& joint : joints) {
        area += joint.area;
        CHECK(joint.bonded == bonded);
      }
      CHECK(near(area, 2 * 1 + 1 * 2 + 2 * 1 + 1, 1e-9));
      const FaceJoint& top = joint_of(joints, floor_body, high_body);
      CHECK((turn_of(turn).undo(top.place) - Vec3(0.2, 0.1, 2.5)).norm() < 1e-9);
      // The longer axis of the joint between the two low units is vertical.
      const FaceJoint& between = joint_of(joints, low_left, low_right);
      CHECK((between.end[1] - between.end[0]).cwiseAbs().isApprox(turn_of(turn).apply(Vec3(0, 0, 2)).cwiseAbs(), 1e-9));
    }
}

TEST_CASE("a lifted, shifted and rotated stone in space has the opening and slip of geometry") {
  for (const Vec3& about : {Vec3(0, 0, 0), Vec3(0.3, -0.7, 1.1)}) {
    const UnitQuaternion turn = rotation_by(about);
    const Model<3> model = small_house(found_mortar, turn);
    const std::vector<FaceJoint> joints = find_joints(model);
    State<3> state = initial_state(model);
    const double lift = 0.003, angle = 0.01;
    const Vec3 shift(0.002, -0.001, 0);
    const UnitQuaternion tilt = turn * rotation_by(Vec3(angle, 0, 0)) * inverse(turn);
    state.position[high_body] += turn_of(turn).apply(Vec3(shift + Vec3(0, 0, lift)));
    state.rotation[high_body] = tilt * state.rotation[high_body];
    const Work<3> work = evaluated_at(model, state);
    const JointDisplacement top = joint_displacement(joint_of(joints, floor_body, high_body), model, state, work);
    // The bottom corners are at 0.5 m horizontally and 0.5 m below the centroid; the tilt lifts those at +y.
    const double c = std::cos(angle), s = std::sin(angle);
    CHECK(near(top.opening, lift + 0.5 * s + 0.5 * (1 - c), 1e-9));
    CHECK(near(top.slip, std::hypot(shift.x(), shift.y() + 0.5 * s), 1e-9));
    const JointDisplacement other = joint_displacement(joint_of(joints, low_left, low_right), model, state, work);
    CHECK(near_zero(other.opening, 1e-14));
    CHECK(near_zero(other.slip, 1e-14));
  }
}

TEST_CASE("damage of a joint in space is the share of its area whose bond is lost") {
  const Model<3> model = small_house(found_mortar);
  Simulation<3> sim(model);
  const std::vector<FaceJoint> joints = find_joints(model);
  const FaceJoint& top = joint_of(joints, floor_body, high_body);
  State<3> state = sim.state();
  CHECK(joint_damage(top, state) == 0);
  const int row = state.contacts.find(top.contact);
  REQUIRE(row >= 0);
  JointMemory* memory = state.contacts.joint_at(static_cast<std::size_t>(row));
  REQUIRE(memory != nullptr);
  memory->sound = false;
  divide(*memory);
  memory->bonds &= ~0b11U;  // two of sixteen patches of one size
  CHECK(near(joint_damage(top, state), 2.0 / 16, 1e-9));
  memory->patch[2].damage.fill(0.4);
  CHECK(near(joint_damage(top, state), 2.4 / 16, 1e-9));
  memory->bonds = 0;
  CHECK(near(joint_damage(top, state), 1, 1e-12));
  CHECK(joint_damage(joint_of(joints, low_left, low_right), state) == 0);
  CHECK(joint_damage(joint_of(find_joints(small_house(found_dry)), floor_body, high_body), state) == 0);
}

TEST_CASE("damage of a house in space by storey, on both sides of each limit") {
  const Model<3> model = small_house(found_mortar);
  const std::vector<int> bodies{0, 1, 2, 3, 4};
  const auto after = [&](const Vec3& high_moves, const Vec3& floor_moves) {
    State<3> state = initial_state(model);
    state.position[high_body] += high_moves, state.position[floor_body] += floor_moves;
    return damage_by_storey(model, state, evaluated_at(model, state), bodies, Findings<3>(model), DamageLimits{});
  };
  auto rows = after(Vec3::Zero(), Vec3::Zero());
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].joints == 5);
  CHECK(rows[1].joints == 1);
  CHECK(rows[0].units == 2);
  CHECK(rows[1].units == 1);
  for (const StoreyDamage& row : rows) CHECK(row.joints_apart + row.units_out_of_place == 0);
  // In both horizontal directions: 0.018 m each are 0.02546 m; an inch is 0.0254 m.
  rows = after({0.018, -0.018, 0}, Vec3::Zero());
  CHECK(rows[1].units_out_of_place == 1);
  CHECK(rows[1].joints_apart == 1);
  rows = after({0.0179, -0.0179, 0}, Vec3::Zero());
  CHECK(rows[1].units_out_of_place == 0);
  // With the floor it is in place, and the floor's joints below are open.
  rows = after({0.1, 0.1, 0}, {0.1, 0.1, 0});
  CHECK(rows[1].units_out_of_place == 0);
  CHECK(rows[1].joints_apart == 0);
  CHECK(rows[0].joints_apart == 2);
  rows = after({0, 0, -0.03}, {0, 0, -0.03});
  CHECK(rows[1].units_out_of_place == 1);
}

TEST_CASE("base shear in space equals the inertia and weight of the structure on the base") {
  const Model<3> model = small_house(found_mortar);
  Simulation<3> sim(model);
  const std::vector<int> base = find_base(model);
  std::vector<Vec3> before = sim.state().velocity;
  sim.refresh();
  Vec3 last = force_on(model, sim.work(), base);  // velocities are half a step before their instant
  double worst = 0, largest = 0, last_dt = 0, mass = 0;
  for (int n = 1; n < model.nodes(); ++n) mass += model.mass[n];
  RunListener<3> listener;
  listener.on_step = [&](const Instant<3>& now) {
    Vec3 inertia = Vec3::Zero();
    for (int n = 1; n < now.model.nodes(); ++n)
      inertia += now.model.mass[n] * ((now.state.velocity[n] - before[n]) / (0.5 * (last_dt + now.state.last_dt)) -
                                      now.model.gravity.field);
    before = now.state.velocity, last_dt = now.state.last_dt;
    worst = std::max(worst, (last + inertia).norm());
    last = force_on(now.model, now.work, base);
    largest = std::max(largest, level_part(last));
  };
  sim.edit([](Model<3>& m) { m.gravity.field = Vec3(2, 1, -9.80665); });
  StageOptions stage;
  stage.duration = 0.1, stage.dt = 2e-5;
  sim.run(stage, listener);
  CHECK(largest > 0.5 * mass * std::sqrt(5.0));
  CHECK(worst / (mass * 10) < 1e-9);
}

TEST_CASE("a results file of solids has their joints and the state of each in every frame") {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "trilith_space_joints_test.h5";
  std::filesystem::remove(path);
  Simulation<3> sim(small_house(found_mortar));
  sim.edit([](Model<3>& m) { m.gravity.field = Vec3(40, 0, -9.80665); });  // bonds of 0.1 MPa break
  {
    RecordingOptions<3> options;
    options.with_joints = true;
    Recording<3> recording(path, sim.model(), sim.state(), options);
    StageOptions stage;
    stage.duration = 0.1, stage.frame_interval = 0.02;
    sim.run(stage, recording.listener());
    recording.finish();
  }
  const results::ResultsReader reader(path);
  const results::Header& header = reader.header();
  REQUIRE(header.joints.size() == 6);
  double area = 0;
  std::array<int, 3> of_storey{};
  for (const results::JointRow& joint : header.joints) area += joint.area, ++of_storey.at(joint.storey);
  CHECK(near(area, 7, 1e-9));
  CHECK(of_storey == std::array<int, 3>{0, 5, 1});
  REQUIRE(header.fields.size() == 3);
  const results::Frame last = reader.frame(reader.frame_count() - 1), first = reader.frame(0);
  sim.refresh();
  const std::vector<FaceJoint> joints = find_joints(small_house(found_mortar));
  double lost = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const JointDisplacement moved = joint_displacement(joints[i], sim.model(), sim.state(), sim.work());
    CHECK(last.fields[0][i] == moved.opening);
    CHECK(last.fields[1][i] == moved.slip);
    CHECK(last.fields[2][i] == joint_damage(joints[i], sim.state()));
    CHECK(first.fields[2][i] == 0);
    lost += last.fields[2][i];
  }
  CHECK(lost > 1);
  std::filesystem::remove(path);
}

TEST_CASE("the line of thrust in space leaves the middle by height and tilt, along both axes") {
  SolidModelBuilder builder;
  Material stone;
  stone.name = "stone", stone.density = 2000;
  builder.add_material(stone);
  builder.add_law("joint", found_dry);
  builder.set_contact("stone", "stone", "joint");
  const Vec3 down(0.1, -0.05, -1);
  builder.gravity = standard_gravity * down;
  SolidSpec ground = part_of("base", box_at({8, 8, 1}, {0, 0, -0.5}), {});
  ground.support.fill(Support::fixed);
  builder.add_body(ground);
  builder.add_body(part_of("low", box_at({2, 2, 1}, {0, 0, 0.5}), {}));
  builder.add_body(part_of("high", box_at({2, 2, 1}, {0, 0, 1.5}), {}));
  Simulation<3> sim(builder.build());
  StageOptions rest;
  rest.duration = 2, rest.rest_share = 0.8;
  sim.run(rest, {});
  sim.refresh();
  std::vector<SolidResultant> touching;
  for (std::size_t i = 0; i < sim.work().general_touching.size(); ++i)
    touching.push_back(solid_resultant(sim.model(), sim.state(), sim.work(), i));
  const std::vector<ThrustPoint<3>> line = thrust_line(std::vector<int>{0, 1, 2}, touching),
                                    back = thrust_line(std::vector<int>{2, 1, 0}, touching);
  REQUIRE(line.size() == 2);
  REQUIRE(back.size() == 2);
  const std::array<double, 2> arm{1, 0.5};
  for (const std::size_t i : {0, 1}) {
    CHECK(near(line[i].point.x(), arm[i] * 0.1, 1e-3));
    CHECK(near(line[i].point.y(), -arm[i] * 0.05, 1e-3));
    CHECK((line[i].force + 2000 * 4 * (2.0 - static_cast<double>(i)) * sim.model().gravity.field).norm() <
          1e-4 * line[i].force.norm());
  }
  CHECK((back[1].force + line[0].force).norm() < 1e-9 * line[0].force.norm());
  CHECK(thrust_line(std::vector<int>{0, 2}, touching).empty());
}

}  // namespace
}  // namespace trilith::testing
