// Meshed bodies in space in flat contact: the contact pressure does not depend on how their elements meet.
#include <doctest/doctest.h>

#include <cmath>

#include "assembly/start.hpp"
#include "assembly/stored_energy.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "near.hpp"
#include "physics/space/space_solids.hpp"

namespace trilith::testing {
namespace {

constexpr double stiffness = 1e9, side = 0.4;

/// A meshed block of 0.4 m on a meshed slab of 1.2 m with elements of different sizes.
Model<3> block_on_slab(ElementShape shape, const std::array<int, 3>& divisions) {
  SolidModelBuilder builder;
  builder.gravity = Vec3::Zero();
  builder.add_material(elastic_in("m", 2000, 1e10, 0.2));
  builder.add_law("law", frictional(stiffness, 0.5 * stiffness, 0.5));
  builder.set_contact("*", "*", "law");
  builder.add_body(box_of("slab", box_solid(Vec3(-0.6, -0.6, -0.3), Vec3(0.6, 0.6, 0)), "m", {4, 3, 1}, shape));
  builder.add_body(box_of("block", box_solid(Vec3::Zero(), Vec3(side, side, 0.2)), "m", divisions, shape));
  return builder.build();
}

struct Pressed {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  // on the block, about the origin
  double area = 0;
  std::size_t rows = 0;
};

/// The block displaced by `by`, all nodes alike.
struct Moved {
  State<3> state;
  Work<3> work;

  Moved(const Model<3>& model, const Vec3& by) : state(initial_state(model)) {
    const Body& block = model.bodies[static_cast<std::size_t>(model.find_body("block"))];
    for (int n = block.first_node; n < block.first_node + block.nodes; ++n) state.position[n] += by;
    evaluate(model, state, work, 0.0);
  }
};

/// Force and moment by the slab on the displaced block.
Pressed pressed_at(const Model<3>& model, const Vec3& by) {
  const Moved moved(model, by);
  Pressed out;
  for (const GeneralContact<3>& g : moved.work.general_touching) {
    const double sign = model.piece_body[moved.work.pairs[g.row].piece_b] == 1 ? 1 : -1;
    out.force += sign * g.force, out.moment += sign * cross(g.centre, g.force);
    out.area += g.size, ++out.rows;
  }
  return out;
}

TEST_CASE("meshed faces in space press by area times depth however their elements lie on each other") {
  // Elements are at least 0.1 m long. Tetrahedra that end at the joint by an edge overlap in wedges as wide as the
  // penetration.
  constexpr double depth = 1e-5, wedges = depth / 0.1;
  for (const ElementShape shape : {ElementShape::brick, ElementShape::tetrahedron})
    for (const std::array<int, 3>& divisions : {std::array{2, 2, 1}, std::array{3, 2, 1}, std::array{4, 4, 1}}) {
      const Model<3> model = block_on_slab(shape, divisions);
      const double within = shape == ElementShape::brick ? 1e-9 : wedges;
      CAPTURE(std::string(info_of(shape).name));
      CAPTURE(divisions[0]);
      // Slivers of zero width, narrower than the penetration, as wide as it, and many times as wide.
      for (const double off : {0.0, 1e-12, 1e-8, 1e-6, depth, 1e-4, 1e-3, 0.0123}) {
        CAPTURE(off);
        const Pressed found = pressed_at(model, Vec3(off - 0.3, 0.7 * off - 0.2, -depth));
        const Vec3 middle(off - 0.1, 0.7 * off, 0);
        CHECK(near(found.force.z(), stiffness * depth * side * side, within));
        CHECK(std::hypot(found.force.x(), found.force.y()) < within * found.force.z());
        CHECK(near(found.area, side * side, within));
        CHECK((found.moment - cross(middle, found.force)).norm() < within * side * found.force.z());
      }
    }
}

TEST_CASE("the force of meshed faces in space is the gradient of their energy, flat or deep") {
  for (const ElementShape shape : {ElementShape::brick, ElementShape::tetrahedron}) {
    const Model<3> model = block_on_slab(shape, {3, 2, 1});
    CAPTURE(std::string(info_of(shape).name));
    // Flat contact at a penetration below 0.005 of the width, and general contact beyond. The wedges of tetrahedra that
    // have no face on the skin and end at the joint by an edge are left out.
    for (const double depth : {1e-4, 4e-3}) {
      const double within = shape == ElementShape::brick ? 1e-6 : depth / 0.1;
      CAPTURE(depth);
      const double step = 1e-3 * depth;
      const auto energy = [&](double z) {
        const Moved moved(model, Vec3(-0.28, -0.21, -z));
        return contact_energy(model, moved.state, moved.work);
      };
      const double slope = (energy(depth + step) - energy(depth - step)) / (2 * step);
      CHECK(near(pressed_at(model, Vec3(-0.28, -0.21, -depth)).force.z(), slope, within));
    }
  }
}

TEST_CASE("a meshed block slides on a meshed slab until friction has taken its motion") {
  constexpr double speed = 0.5, mu = 0.3;
  for (const ElementShape shape : {ElementShape::brick, ElementShape::tetrahedron}) {
    CAPTURE(std::string(info_of(shape).name));
    SolidModelBuilder builder;
    builder.add_material(elastic_in("m", 2000, 2e8, 0.2, 1e-5));
    builder.add_law("law", frictional(1e9, 5e8, mu, 1e-4));
    builder.set_contact("*", "*", "law");
    SolidSpec slab = box_of("slab", box_solid(Vec3(-0.5, -0.3, -0.2), Vec3(0.5, 0.3, 0)), "m", {4, 3, 1}, shape);
    slab.supports = {{Vec3(-1, -1, -1), Vec3(1, 1, -0.19), {Support::fixed, Support::fixed, Support::fixed}}};
    builder.add_body(slab);
    SolidSpec block = box_of("block", box_solid(Vec3(-0.2, -0.1, 0), Vec3(0.1, 0.1, 0.1)), "m", {2, 2, 1}, shape);
    block.velocity = Vec3(speed, 0, 0);
    builder.add_body(block);
    const Model<3> model = builder.build();
    Work<3> work;
    const State<3> begun = initial_state(model);
    evaluate(model, begun, work, 0.0);
    SolidRun run(model, 0.5 * stable_step(model, begun, work).dt);
    run.run(1.3 * speed / (mu * standard_gravity));
    const Body& body = model.bodies[1];
    double way = 0, mass = 0;
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
      way += model.mass[n] * (run.state().position[n].x() - model.start_position[n].x());
      mass += model.mass[n];
    }
    CHECK(near(way / mass, speed * speed / (2 * mu * standard_gravity), 0.01));
  }
}

TEST_CASE("a meshed block over the edge of a slab presses by the area that is left") {
  constexpr double depth = 1e-5;
  const Model<3> model = block_on_slab(ElementShape::brick, {4, 4, 1});
  // Over one edge, also by a sliver of its last elements, and over a corner.
  for (const double over : {1e-7, 1e-5, 0.0999, 0.1, 0.1001, 0.37}) {
    CAPTURE(over);
    const double left = side - over;
    CHECK(near(pressed_at(model, Vec3(0.6 - left, -0.2, -depth)).force.z(), stiffness * depth * left * side, 1e-3));
    CHECK(
        near(pressed_at(model, Vec3(0.6 - left, 0.6 - left, -depth)).force.z(), stiffness * depth * left * left, 1e-3));
  }
  CHECK(pressed_at(model, Vec3(0.6 + 1e-9, 0, -depth)).rows == 0);
  CHECK(pressed_at(model, Vec3(0, 0, 1e-9)).rows == 0);
}

}  // namespace
}  // namespace trilith::testing
