// Natural frequencies of blocks on joints, of masses on springs, of beams (VALIDATION M2, M4 to M6).
#include "modal/modes.hpp"

#include "near.hpp"
#include "physics/members/frames.hpp"

namespace trilith::testing {
namespace {

struct Settled {
  Model<2> model;
  State<2> state;
};

/// A stack of cubes or blocks on a fixed base, with an out-of-plane thickness, settled under weak gravity.
Settled settled_stack(double width, double height, int count, double gravity) {
  ModelBuilder builder;
  builder.thickness = width;
  builder.gravity = {0, -gravity};
  builder.add_material({"stone", 2400});
  builder.add_law("joint", Frictional{1e9, 4e8, 0.7, 1e-4});
  builder.set_contact("*", "*", "joint");
  BodySpec base;
  base.name = "base", base.outline = box(-1, -0.5, 1, 0), base.material = "stone", base.support = held;
  builder.add_body(base);
  for (int i = 0; i < count; ++i) {
    BodySpec block;
    block.name = "block " + std::to_string(i + 1), block.material = "stone";
    block.outline = box(-width / 2, i * height, width / 2, (i + 1) * height);
    builder.add_body(block);
  }
  Simulation<2> sim(builder.build());
  settle(sim, 20, 1e-12);
  return {sim.model(), sim.state()};
}

void check_frequencies(const std::vector<Mode>& found, const std::vector<double>& expected, double tolerance) {
  REQUIRE(found.size() >= expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(near(found[i].frequency(), expected[i], tolerance));
}

TEST_CASE("M4: a block on a joint rocks, heaves and sways, with its weight in the stiffness") {
  const Settled now = settled_stack(0.4, 1.2, 1, standard_gravity);
  const std::vector<Mode> found = modes(now.model, now.state, 10);
  CHECK(found.size() == 3);
  check_frequencies(found, {15.0359, 93.7829, 116.916}, 5e-4);
  CHECK(near(found[1].mass[1], 0.4 * 0.4 * 1.2 * 2400, 1e-6));
  CHECK(near(found[0].mass[0] + found[2].mass[0], 0.4 * 0.4 * 1.2 * 2400, 1e-6));
}

TEST_CASE("M5: two cubes on each other have the frequencies of their planar matrices") {
  const Settled now = settled_stack(0.5, 0.5, 2, 0.1);
  check_frequencies(modes(now.model, now.state, 6), {22.1055, 89.793, 96.3095, 186.093, 224.931, 235.081}, 5e-4);
}

TEST_CASE("M6: a shear frame of three storeys") {
  Scene scene(Frictional{1e6, 1e6, 0.5, 0});
  scene.set_gravity({0, 0});
  scene.builder.set_contact("*", "*", "none");
  scene.fixed("floor 0", box(-1, -1, 1, -0.9));
  for (int i = 1; i <= 3; ++i) {
    BodySpec body;
    body.name = "floor " + std::to_string(i), body.outline = box(-1, i - 0.1, 1, i), body.mass = 1000;
    body.support = {Support::free, Support::fixed, Support::fixed};
    scene.add(body);
    BearingSpec columns;
    columns.name = "storey " + std::to_string(i);
    columns.body_a = "floor " + std::to_string(i - 1), columns.body_b = body.name;
    columns.point_a = {0, i - 1.0}, columns.point_b = {0, i - 0.05};
    columns.law = {Linear{1e6, 0}, {}, {}};
    scene.builder.add_bearing(columns);
  }
  const Model<2> model = scene.builder.build();
  check_frequencies(modes(model, initial_state(model), 3), {2.23986, 6.27595, 9.06901}, 1e-4);
}

TEST_CASE("M2, B6: a cantilever by itself and with masses at its tip") {
  struct Row {
    double ratio, root;
  };
  const double length = 3, young = 2.1e11, density = 7850, area = 0.02, second = 0.1 * 0.008 / 12;
  for (const Row& row : {Row{0, 1.87510}, Row{0.5, 1.41996}, Row{1, 1.24792}, Row{2, 1.07620}}) {
    BodySpec spec = beam_body("beam", {0, 0}, {length, 0}, rectangle_section(0.1, 0.2), "steel", 40);
    spec.frame->joints[0].support = held;
    spec.frame->joints[1].mass = row.ratio * density * area * length;
    const Model<2> model = of_frames(elastic_material("steel", density, young), {spec});
    const double expected =
        row.root * row.root / (2 * M_PI) * std::sqrt(young * second / (density * area)) / (length * length);
    const std::vector<Mode> found = modes(model, initial_state(model), 3);
    MESSAGE("M2 tip mass " << row.ratio << ": " << found[0].frequency() << " Hz, closed form " << expected << " Hz");
    CHECK(near(found[0].frequency(), expected, 0.005));
    if (row.ratio > 0) continue;
    CHECK(near(found[1].frequency() / found[0].frequency(), 6.2669, 0.01));
  }
}

TEST_CASE("M10: a beam on two supports swings slower under a push and faster under a pull") {
  const double length = 6, young = 3e10, second = 0.3 * 0.001 / 12, critical = M_PI * M_PI * young * second / 36;
  std::array<double, 3> plain{};
  struct Row {
    double share;
    std::array<double, 3> factor;
  };
  for (const Row& row :
       {Row{0, {1, 1, 1}}, Row{0.5, {.70711, .93541, .97183}}, Row{-0.3, {1.14018, 1.03682, 1.01653}}}) {
    BodySpec spec = beam_body("beam", {0, 0}, {length, 0}, rectangle_section(0.3, 0.1), "concrete", 24);
    spec.frame->joints[0].support = hinged;
    spec.frame->joints[1].support = {Support::free, Support::fixed, Support::free};
    Model<2> model = of_frames(elastic_material("concrete", 2400, young), {spec});
    add_load(model, "beam", {length, 0}, {-row.share * critical, 0});
    std::size_t tip = 0;
    for (int n = 0; n < model.nodes(); ++n)
      if (model.start_position[n].x() > model.start_position[tip].x()) tip = static_cast<std::size_t>(n);
    std::vector<NodeDofs> load = no_load(model);
    load[tip][0] = -row.share * critical;
    const std::vector<Mode> found = modes(model, balance(model, initial_state(model), load), 3);
    for (std::size_t i = 0; i < 3; ++i) {
      if (row.share == 0) plain[i] = found[i].frequency();
      CHECK(near(found[i].frequency() / plain[i], row.factor[i], 0.002));
    }
  }
}

TEST_CASE("modes computed one by one equal modes computed at once") {
  BodySpec spec = beam_body("beam", {0, 0}, {10, 0}, rectangle_section(0.3, 0.5), "concrete", 120);
  spec.frame->joints[0].support = held;
  const Model<2> model = of_frames(elastic_material("concrete", 2400, 3e10), {spec});
  const std::vector<Mode> few = modes(model, initial_state(model), 5), all = modes(model, initial_state(model), 200);
  REQUIRE(few.size() == 5);
  CHECK(all.size() == 200);
  for (std::size_t i = 0; i < few.size(); ++i) CHECK(near(few[i].frequency(), all[i].frequency(), 1e-6));
}

TEST_CASE("modes are rejected where nothing can move and for a count of 0") {
  Scene scene(Frictional{1e6, 1e6, 0.5, 0});
  scene.fixed("base", box(-1, -1, 1, 0));
  const Model<2> model = scene.builder.build();
  CHECK_THROWS_WITH_AS(modes(model, initial_state(model), 3), "modes: no degree of freedom is free", InputError);
  CHECK_THROWS_AS(modes(model, initial_state(model), 0), InputError);
}

}  // namespace
}  // namespace trilith::testing
