// Beams in space in contact with solids and on bearings: the skin follows the nodes.
#include <doctest/doctest.h>

#include "model/pose.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"
#include "physics/space/space_frames.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

const Frictional touch{5e8, 2e8, 0.5, 2e-4};

/// A model with gravity, of frames and boxes of one material with contact.
SolidModelBuilder scene(const Material& material, const Frictional& law = touch) {
  SolidModelBuilder builder;
  builder.add_material(material);
  builder.add_law("touch", law);
  builder.set_contact("*", "*", "touch");
  return builder;
}

SolidSpec box_spec(const std::string& name, const Vec3& low, const Vec3& high, bool fixed) {
  SolidSpec spec;
  spec.name = name, spec.material = "steel", spec.pieces = {box_solid(low, high)};
  if (fixed) spec.support.fill(Support::fixed);
  spec.floating = true;
  return spec;
}

double step_for_all(const Model<3>& model, double share = 0.5) {
  const State<3> state = initial_state(model);
  Work<3> work;
  evaluate(model, state, work, 0);
  return share * stable_step(model, state, work).dt;
}

/// Sum of the contact forces on a body [N].
Vec3 force_on(SolidRun& run, int body) {
  const Body& b = run.model().bodies[static_cast<std::size_t>(body)];
  Vec3 sum = Vec3::Zero();
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
    sum += run.work().solids.force[static_cast<std::size_t>(n)];
  return sum;
}

}  // namespace

TEST_CASE("a girder of beams lies on two piers, which carry its weight by halves, and sags as a simple beam does") {
  const double length = 6, young = 2e9;
  const Material material = member_material(2000, young, 0.2);
  SolidModelBuilder builder = scene(material, Frictional{1e9, 5e8, 0.0, 1e-4});
  builder.mass_damping = 30;
  for (const double x : {-0.2, length - 0.2})
    builder.add_body(box_spec(x < 0 ? "left" : "right", Vec3(x, -0.5, -1), Vec3(x + 0.4, 0.5, 0), true));
  const Section3 section = plain_section(0.3, 0.4);
  SolidSpec girder = chain_body("girder", {Vec3(-0.2, 0, 0.2), Vec3(length + 0.2, 0, 0.2)}, section, 16);
  builder.add_body(girder);
  const Model<3> model = builder.build();
  SolidRun run(model, step_for_all(model));
  run.run(1);
  const double weight = body_mass(model, 2) * standard_gravity;
  CHECK(near(force_on(run, 0).z(), -weight / 2, 1e-2));
  CHECK(near(force_on(run, 1).z(), -weight / 2, 1e-2));
  CHECK(near(force_on(run, 2).z(), weight, 5e-3));
  // The beam rotates over the inner edges of the piers, where nearly all of the force acts.
  const double span = length - 0.4, line = 2000 * section.area * standard_gravity;
  const double sag = 5 * line * std::pow(span, 4) / (384 * young * section.second_moment[1]);
  const std::size_t middle = 2 + 2 + 7;
  const double moved = model.start_position[middle].z() - run.place(static_cast<int>(middle)).z();
  MESSAGE("sags by " << moved << " m, a simple beam between the edges by " << sag);
  CHECK(moved > 0.85 * sag);
  CHECK(moved < 1.15 * sag);
}

TEST_CASE("a stone slides down a beam in space under friction as on a plane") {
  const double slope = 0.6, mu = 0.3;
  const Material material = member_material(2000, 2e10, 0.2);
  SolidModelBuilder builder = scene(material, Frictional{5e8, 5e8, mu, 2e-4});
  builder.gravity = standard_gravity * Vec3(std::sin(slope), 0, -std::cos(slope));
  SolidSpec rail = chain_body("rail", {Vec3(0, 0, -0.25), Vec3(6, 0, -0.25)}, plain_section(0.5, 0.5), 12);
  for (SpaceJoint& joint : rail.frame->joints) joint.support = clamped;
  rail.support.fill(Support::fixed);
  builder.add_body(rail);
  builder.add_body(box_spec("stone", Vec3(0.6, -0.15, 0), Vec3(1.0, 0.15, 0.2), false));
  Model<3> model = builder.build();
  SolidRun run(model, step_for_all(model));
  const double time = 0.8, start = 0.8;
  run.run(time);
  const int stone = model.bodies[1].first_node;
  const double way = 0.5 * standard_gravity * (std::sin(slope) - mu * std::cos(slope)) * time * time;
  CHECK(near(run.place(stone).x() - start, way, 1e-2));
  CHECK(near_zero(run.place(stone).y(), 1e-6));
}

TEST_CASE(
    "a girder of beams that falls obliquely on a pier loses only the damping energy, and the energy balance closes") {
  const Material material = member_material(2000, 5e9, 0.2, 1e-4);
  SolidModelBuilder builder = scene(material);
  builder.add_body(box_spec("pier", Vec3(-0.4, -0.4, -1), Vec3(0.4, 0.4, 0), true));
  SolidSpec girder = chain_body("girder", {Vec3(-1, -0.1, 0.5), Vec3(3, 0.2, 0.8)}, plain_section(0.3, 0.4), 8);
  builder.add_body(girder);
  const Model<3> model = builder.build();
  SolidRun run(model, step_for_all(model, 0.4));
  run.step();
  const double begun = run.energy().balance();
  bool touched = false;
  double most = 0;
  while (run.time() < 1) {
    for (int i = 0; i < 100; ++i) run.step();
    touched = touched || !run.work().general_touching.empty();
    most = std::max(most, std::abs(run.energy().balance() - begun));
  }
  const double fall = body_mass(model, 1) * standard_gravity * 0.5;
  MESSAGE("the ledger is off by " << most / fall << " of the energy of the fall");
  CHECK(touched);
  CHECK(most < 1e-2 * fall);
  CHECK(run.energy()[EnergyTerm::contact_damping] > 0);
}

TEST_CASE("a bearing between a joint of a frame and a solid carries the suspended weight") {
  const Material material = member_material(2000, 2e10, 0.2);
  SolidModelBuilder builder;
  builder.mass_damping = 30;
  builder.add_material(material);
  builder.add_body(box_spec("ground", Vec3(-5, -5, -1), Vec3(5, 5, 0), true));
  builder.add_body(chain_body("girder", {Vec3(-2, 0, 0.3), Vec3(2, 0, 0.3)}, plain_section(0.3, 0.4), 8));
  for (const double x : {-2.0, 2.0})
    for (const double y : {-0.15, 0.15}) {
      BearingSpecOf<3> spec;
      spec.name = fmt::format("bearing {} {}", x, y), spec.body_a = "ground", spec.body_b = "girder";
      spec.point_a = spec.point_b = Vec3(x, y, 0.1);
      spec.point_a.z() = 0;
      spec.law[0] = spec.law[1] = spec.law[2] = Linear{1e7, 1e5};
      builder.add_bearing(spec);
    }
  const Model<3> model = builder.build();
  SolidRun run(model, step_for_all(model));
  run.run(1);
  const double weight = body_mass(model, 1) * standard_gravity;
  for (std::size_t i = 0; i < 4; ++i) CHECK(near(run.work().bearing_force[i].z(), weight / 4, 1e-3));
}

TEST_CASE("a plane frame in space moves as the frame in the plane does") {
  const double young = 3e9, length = 3;
  const RectangleSection shape{0.2, 0.3};
  // In the plane: a released cantilever along x; in space the same in an oblique vertical plane.
  BodySpec flat = beam_body("bar", Vec2(0, 0), Vec2(length, 0), shape.numbers(), "steel", 6);
  flat.frame->joints[0].support = {Support::fixed, Support::fixed, Support::fixed};
  ModelBuilder plane;
  plane.add_material(elastic_material("steel", 2000, young, 0.2));
  plane.add_body(flat);
  const Model<2> model = plane.build();
  const Vec3 along = Vec3(0.6, 0.8, 0);
  SolidSpec spec = chain_body("bar", {Vec3::Zero(), Vec3(length * along)}, section_in_space(shape), 6);
  spec.frame->joints[0].support = clamped;
  SolidModelBuilder space;
  space.add_material(member_material(2000, young, 0.2));
  space.add_body(spec);
  const Model<3> in_space = space.build();
  const double dt = 2e-5;
  SolidRun run(in_space, dt);
  State<2> state = initial_state(model);
  Work<2> work;
  StepOptions options;
  options.dt = dt;
  evaluate(model, state, work, state.last_dt);
  double most = 0;
  for (int i = 0; i < 10000; ++i) {
    run.step();
    commit(model, state, work), advance(model, state, work, options), evaluate(model, state, work, state.last_dt);
    const Vec3 expected = state.position[1].x() * along + Vec3(0, 0, state.position[1].y());
    most = std::max(most, (run.place(1) - expected).norm());
  }
  MESSAGE("tips apart by " << most << " m");
  CHECK(most < 1e-9);
}
