// Joints, storeys and forces on bodies, against closed forms.
#include <doctest/doctest.h>

#include <numeric>

#include "base/error.hpp"
#include "near.hpp"
#include "physics/scene.hpp"
#include "results/reading/reader.hpp"
#include "results/sample_run.hpp"
#include "run/record/body_forces.hpp"
#include "run/record/joints.hpp"
#include "run/record/recording.hpp"
#include "run/record/storeys.hpp"

using namespace trilith;
using testing::box;
using testing::near;
using testing::near_zero;
using testing::Scene;

namespace {

const Bonded mortar{1e10, 4e9, 0.6, 1e-5, 1e5, 1e5};
const Frictional dry{1e10, 4e9, 0.6, 1e-5};

void add(Scene& scene, const std::string& name, const Polygon& outline, std::vector<std::string> groups, bool fixed) {
  BodySpec spec;
  spec.name = name, spec.outline = outline, spec.groups = std::move(groups);
  if (fixed) spec.support = testing::held;
  scene.add(std::move(spec));
}

/// Three blocks of 2 m x 1 m on a fixed base, each a storey; the second is a slab.
Scene tower(const ContactLaw& law, double turn = 0) {
  Scene scene(law, turn);
  add(scene, "base", box(-2, -1, 4, 0), {"base"}, true);
  add(scene, "low", box(0, 0, 2, 1), {"storey 1"}, false);
  add(scene, "slab", box(0, 1, 2, 2), {"storey 2", "slabs"}, false);
  add(scene, "high", box(0.5, 2, 1.5, 3), {"storey 3"}, false);
  return scene;
}

/// The Work with the skin points of `state` placed.
Work<2> placed(const Model<2>& model, const State<2>& state) {
  Simulation<2> sim(model, state);
  sim.refresh();
  return sim.work();
}

double sum_of_weights(const Model<2>& model) {
  double mass = 0;
  for (int n = 0; n < model.nodes(); ++n)
    if (model.moves(n)) mass += model.mass[n];
  return mass * standard_gravity;
}

}  // namespace

TEST_CASE("joints are the faces that lie on each other at the start, with the ends they share") {
  for (const double turn : {0.0, 0.7, -2.1}) {
    Scene scene = tower(mortar, turn);
    const std::vector<Joint> joints = find_joints(scene.builder.build());
    REQUIRE(joints.size() == 3);
    const std::array<double, 3> length{2, 2, 1};
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(near((joints[i].place[1] - joints[i].place[0]).norm(), length[i], 1e-12));
      CHECK(joints[i].bonds == 3);
      const Vec2 middle = scene.to_scene(0.5 * (joints[i].place[0] + joints[i].place[1]));
      CHECK(near(middle.x(), 1, 1e-12));
      CHECK(near_zero(middle.y() - static_cast<double>(i), 1e-12));
    }
  }
}

TEST_CASE("faces apart at the start are not a joint, and a joint of dry stones has no bond") {
  Scene scene(dry);
  add(scene, "base", box(-2, -1, 4, 0), {}, true);
  add(scene, "on", box(0, 0, 1, 1), {}, false);
  BodySpec above;
  above.name = "above", above.outline = box(0, 1.1, 1, 2), above.floating = true;
  scene.add(std::move(above));
  const Model<2> model = scene.builder.build();
  const std::vector<Joint> joints = find_joints(model);
  REQUIRE(joints.size() == 1);
  CHECK(joints[0].bonds == 0);
  CHECK(joint_damage(joints[0], initial_state(model)) == 0);
}

TEST_CASE("a lifted, shifted and rotated body has the opening and slip of geometry, in any direction") {
  for (const double turn : {0.0, 1.0, 2.5}) {
    Scene scene = tower(mortar, turn);
    const Model<2> model = scene.builder.build();
    const std::vector<Joint> joints = find_joints(model);
    State<2> state = initial_state(model);
    const int high = testing::node_of(model, "high");
    const double lift = 0.003, shift = 0.002, angle = 0.01;
    state.position[high] += scene.to_world({shift, lift});
    state.rotation[high] += angle;
    const JointDisplacement m = joint_displacement(joints[2], placed(model, state));
    // The bottom corners are at 0.5 m horizontally and 0.5 m below the centroid.
    const double c = std::cos(angle), s = std::sin(angle);
    CHECK(near(m.opening, lift + 0.5 * s + 0.5 * (1 - c), 1e-9));
    CHECK(near(std::abs(m.slip), shift + 0.5 * s, 1e-9));
    for (const std::size_t other : {0, 1}) {
      CHECK(std::abs(joint_displacement(joints[other], placed(model, state)).opening) < 1e-12);
      CHECK(std::abs(joint_displacement(joints[other], placed(model, state)).slip) < 1e-12);
    }
  }
}

TEST_CASE("a joint's damage is the part of its bond that is lost") {
  Scene scene = tower(mortar);
  Simulation<2> sim = scene.start();
  const std::vector<Joint> joints = find_joints(sim.model());
  State<2> state = sim.state();
  CHECK(joint_damage(joints[0], state) == 0);
  for (const auto& [left, damage] : {std::pair{1U, 0.5}, {2U, 0.5}, {0U, 1.0}}) {
    for (std::size_t i = 0; i < state.contacts.size(); ++i)
      if (state.contacts.key[i] == joints[1].contact) state.contacts.memory[i].bonds = left;
    CHECK(joint_damage(joints[1], state) == damage);
    CHECK(joint_damage(joints[0], state) == 0);
  }
}

TEST_CASE("storeys are found by their groups, with heights and drifts") {
  Scene scene = tower(mortar);
  const Model<2> model = scene.builder.build();
  const std::vector<Storey> storeys = find_storeys(model);
  REQUIRE(storeys.size() == 3);
  for (int i = 0; i < 3; ++i) {
    CHECK(storeys[i].number == i + 1);
    CHECK(near(storeys[i].height, 1, 1e-12));
    CHECK(near(storeys[i].bottom, i, 1e-12));
  }
  const std::vector<int> base = find_base(model);
  CHECK(base == std::vector<int>{0});
  State<2> state = initial_state(model);
  const std::array<double, 4> sway{0.1, 0.13, 0.11, 0.2};  // of base, low, slab, high
  for (std::size_t n = 0; n < 4; ++n) state.position[n].x() += sway[n];
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(near(storey_drift(model, state, storeys, base, i).x(), sway[i + 1] - sway[i], 1e-9));
  CHECK(near(top_drift(model, state, storeys, base).x(), 0.1, 1e-9));
  CHECK(storey_in({"wall", "storey 12"}) == 12);
  CHECK(storey_in({"storey", "storey x", "storey 0", "storey 2b", "story 2"}) == 0);
}

TEST_CASE("base shear equals the contact forces on the base and the inertia of the structure") {
  for (const double turn : {0.0, 0.4}) {
    Scene scene = tower(mortar, turn);
    Simulation<2> sim = scene.start();
    Model<2>& model = sim.edit_model();
    scene.drive_along_x(model, "base", *testing::motion_of(0.5, 1e-3, [](double t) { return 3 * std::sin(40 * t); }));
    const std::vector<int> base = find_base(model);
    std::vector<Vec2> before = sim.state().velocity;
    sim.refresh();
    Vec2 last_shear = force_on(model, sim.work(), base);  // velocities are half a step before their instant
    double largest = 0, worst_contacts = 0, worst_inertia = 0, last_dt = 0;
    std::vector<TouchingContact> touching;
    RunListener<2> listener = testing::each_step([&](const Instant<2>& now) {
      Vec2 inertia = Vec2::Zero();
      for (int n = 1; n < now.model.nodes(); ++n)
        inertia += now.model.mass[n] * ((now.state.velocity[n] - before[n]) / (0.5 * (last_dt + now.state.last_dt)) -
                                        now.model.gravity.field);
      before = now.state.velocity;
      last_dt = now.state.last_dt;
      worst_inertia = std::max(worst_inertia, (last_shear + inertia).norm());
      last_shear = force_on(now.model, now.work, base);
    });
    listener.on_history = [&](const Instant<2>& now) {
      const Vec2 shear = force_on(now.model, now.work, base);
      contact_resultants(now.model, now.state, now.work, touching);
      Vec2 contacts = Vec2::Zero();
      for (const TouchingContact& c : touching)
        if (c.body_a == 0 || c.body_b == 0) contacts += (c.body_a == 0 ? -1 : 1) * c.resultant.force;
      largest = std::max(largest, std::abs(scene.to_scene(shear).x()));
      worst_contacts = std::max(worst_contacts, (shear - contacts).norm());
    };
    StageOptions stage;
    stage.duration = 0.3;
    stage.dt = stage.history_interval = 1e-5;
    sim.run(stage, listener);
    const double size = std::hypot(largest, sum_of_weights(sim.model()));
    CHECK(largest > 1e4);
    CHECK(worst_contacts / size < 1e-9);
    CHECK(worst_inertia / size < 1e-9);
    MESSAGE("base shear up to " << largest << " N; off the contacts by " << worst_contacts / size << ", off inertia by "
                                << worst_inertia / size << " of it and the weight");
  }
}

TEST_CASE("mean stress in a stack at rest is the weight above and half its own, over its section") {
  for (const double turn : {0.0, 0.8}) {
    Scene scene = tower(dry, turn);
    Simulation<2> sim = scene.start();
    testing::settle(sim);
    sim.refresh();
    std::vector<TouchingContact> touching;
    contact_resultants(sim.model(), sim.state(), sim.work(), touching);
    const std::vector<MeanStress> stress = mean_stress(sim.model(), sim.state(), sim.work(), touching);
    const double w = 2000 * standard_gravity;  // of 1 m2
    const std::array<double, 4> across{0, -(3 * w + w) / 2, -(w + w) / 2, -w / 2};
    CHECK(stress[0].minor() == 0);  // fixed: not known
    for (std::size_t i = 1; i < 4; ++i) {
      // Forces act within the contact: the shift is less than w 4 / kn = 8e-6 of the height.
      CHECK(near(stress[i].minor(), across[i], 8e-6));
      CHECK(std::abs(stress[i].major()) < 1e-6 * w);
      CHECK(near(stress[i].xx + stress[i].yy, across[i], 1e-5));
    }
  }
}

TEST_CASE("the line of thrust under a tilted block leaves its middle by half its height times the tilt") {
  Scene scene(dry);
  const double tilt = 0.2;
  scene.set_gravity(standard_gravity * Vec2(std::sin(tilt), -std::cos(tilt)));
  add(scene, "base", box(-2, -1, 4, 0), {}, true);
  add(scene, "low", box(0, 0, 2, 1), {}, false);
  add(scene, "high", box(0, 1, 2, 2), {}, false);
  Simulation<2> sim = scene.start();
  testing::settle(sim);
  sim.refresh();
  std::vector<TouchingContact> touching;
  contact_resultants(sim.model(), sim.state(), sim.work(), touching);
  const std::vector<int> chain{0, 1, 2}, back{2, 1, 0};
  const std::vector<ThrustPoint<2>> line = thrust_line(chain, touching), other = thrust_line(back, touching);
  REQUIRE(line.size() == 2);
  REQUIRE(other.size() == 2);
  CHECK(near(line[0].point.x(), 1 + 1 * std::tan(tilt), 1e-4));
  CHECK(near(line[1].point.x(), 1 + 0.5 * std::tan(tilt), 1e-4));
  CHECK(near(line[0].force.norm(), 2 * 2 * 2000 * standard_gravity, 1e-6));
  CHECK((other[1].force + line[0].force).norm() < 1e-6);
  CHECK(thrust_line(std::vector<int>{0, 2}, touching).empty());
}

TEST_CASE("joints, their motion and mean stress are recorded and read back") {
  const testing::Folder folder;
  Scene scene = tower(mortar);
  Simulation<2> sim = scene.start();
  RecordingOptions<2> options;
  options.sync = false;
  options.with_joints = true;
  Recording<2> recording(folder / "tower.h5", sim.model(), sim.state(), options);
  StageOptions stage;
  stage.duration = 0.1;
  stage.frame_interval = 0.02;
  sim.run(stage, recording.listener());
  recording.finish();
  const results::ResultsReader reader(folder / "tower.h5");
  const results::Header& header = reader.header();
  REQUIRE(header.joints.size() == 3);
  CHECK(header.joints[2].storey == 3);
  CHECK(header.joints[2].bonded == 1);
  CHECK(header.joints[2].end_0[1] == 2);
  REQUIRE(header.fields.size() == 4);
  CHECK(header.fields[3].name == "body_stress");
  CHECK(header.fields[3].width == 3);
  const results::Frame frame = reader.frame(reader.frame_count() - 1);
  REQUIRE(frame.fields.size() == 4);
  CHECK(frame.fields[0].size() == 3);
  CHECK(frame.fields[3].size() == 12);
  const std::vector<Joint> joints = find_joints(sim.model());
  sim.refresh();
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(frame.fields[0][i] == joint_displacement(joints[i], sim.work()).opening);
    CHECK(frame.fields[2][i] == joint_damage(joints[i], sim.state()));
  }
}
