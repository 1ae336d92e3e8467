// Elements of equal shape share their tables of numbers; four evaluated at a time give the same result as one.
#include "model/builder/shared_numbers.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "assembly/single_terms.hpp"
#include "model/element/element_rows.hpp"
#include "near.hpp"
#include "physics/space/solids.hpp"
#include "physics/space/space_solids.hpp"

namespace trilith::testing {
namespace {

constexpr std::size_t quad_numbers = element_shape_numbers + element_stiffness_numbers;

/// A builder with two materials that differ in stiffness alone, far from the origin.
struct Far {
  ModelBuilder builder;
  Vec2 corner{1234.567, -89.1};

  Far() {
    builder.gravity = Vec2::Zero();
    builder.add_material(elastic("soft", 1000, 1e7, 0.3, Plane::stress, ElementForm::assumed, 1e-4));
    builder.add_material(elastic("hard", 1000, 2e7, 0.3));
  }
  void add(const std::string& name, const std::string& material, const Vec2& size, int nx, int ny,
           double thickness = 1) {
    corner.x() += 7.3;
    BodySpec spec = grid_body(name, rectangle(corner, corner + size), material, nx, ny);
    spec.thickness = thickness;
    builder.add_body(std::move(spec));
  }
};

TEST_CASE("equal elements share their data at any place") {
  Far far;
  far.add("a", "soft", {0.6, 0.3}, 3, 2);
  CHECK(far.builder.build().element_number.size() == quad_numbers);
  for (int i = 0; i < 40; ++i) far.add("unit " + std::to_string(i), "soft", {0.4, 0.3}, 2, 2);
  CHECK(far.builder.build().element_number.size() == quad_numbers);
  // Another size, solid or thickness has its own numbers, and later elements find either table again.
  far.add("long", "soft", {0.6 * (1 + 1e-9), 0.3}, 3, 2);
  far.add("hard", "hard", {0.6, 0.3}, 3, 2);
  far.add("thick", "soft", {0.6, 0.3}, 3, 2, 0.5);
  far.add("again", "soft", {0.6, 0.3}, 3, 2);
  CHECK(far.builder.build().element_number.size() == 4 * quad_numbers);
}

/// All nodes displaced by a few thousandths, with velocities of a few hundredths.
template <int D>
State<D> disturbed(const Model<D>& model) {
  State<D> state = initial_state(model);
  for (int n = 0; n < model.nodes(); ++n)
    for (int k = 0; k < D; ++k) {
      state.position[n][k] += 2e-3 * std::sin(1.7 * n + k);
      state.velocity[n][k] = 0.03 * std::cos(2.3 * n - k);
    }
  return state;
}

TEST_CASE("elements computed four at a time have the bits of elements computed singly") {
  Far far;
  far.add("rows of five", "soft", {0.5, 0.3}, 5, 3);
  far.add("four", "hard", {0.4, 0.2}, 2, 2);
  far.add("one", "soft", {0.1, 0.1}, 1, 1);
  const Model<2> model = far.builder.build();
  const State<2> state = disturbed(model);
  Work<2> work, by_one;
  internal_forces(model, state, work);
  by_one.element_force.assign(model.mass.size(), Vec2::Zero());
  by_one.element_damping.assign(model.mass.size(), Vec2::Zero());
  for (int e = 0; e < static_cast<int>(model.elements.size()); ++e) element_forces(model, state, by_one, e);
  for (std::size_t n = 0; n < model.mass.size(); ++n) {
    CHECK(work.element_force[n] == by_one.element_force[n]);
    CHECK(work.element_damping[n] == by_one.element_damping[n]);
  }
  CHECK(work.element_damping[0].norm() > 0);
}

TEST_CASE("elements that share the data of their shape have the forces of elements with separate data, to rounding") {
  // Between two elements of a shape there are more others than the search checks.
  Far far;
  for (int i = 0; i < 30; ++i) far.add("unit " + std::to_string(i), "soft", {0.4 + 0.01 * i, 0.3}, 2, 1);
  for (int i = 0; i < 30; ++i) far.add("like " + std::to_string(i), "soft", {0.4 + 0.01 * i, 0.3}, 2, 1);
  const Model<2> model = far.builder.build();
  CHECK(model.element_number.size() == 60 * quad_numbers);
  Far near_one;
  near_one.add("a", "soft", {0.4, 0.3}, 2, 1);
  near_one.add("b", "soft", {0.4, 0.3}, 2, 1);
  const Model<2> shared = near_one.builder.build();
  REQUIRE(shared.elements.front().first_number == shared.elements.back().first_number);
  const auto force = [&](const Model<2>& m, int body) {
    State<2> state = initial_state(m);
    const int first = m.bodies[static_cast<std::size_t>(body)].first_node;
    for (int n = 0; n < 6; ++n) state.position[first + n] += 1e-3 * Vec2(std::sin(1.7 * n), std::cos(2.9 * n));
    Work<2> work;
    internal_forces(m, state, work);
    return Vec2(work.element_force[first + 2]);
  };
  CHECK((force(shared, 0) - force(model, 0)).norm() < 1e-8 * force(shared, 0).norm());
  CHECK((force(shared, 1) - force(model, 30)).norm() < 1e-8 * force(shared, 1).norm());
}

TEST_CASE("bricks of a row share their element data, bricks of a distorted mesh do not") {
  constexpr std::size_t brick_numbers = 6 * 8 + 24 * 24;
  const Material material = elastic_in("m", 1000, 1e7, 0.3);
  const Model<3> row = alone_in_space(
      material, box_of("row", box_solid(Vec3(100.1, 20.3, 3.7), Vec3(100.7, 20.5, 4.0)), "m", {6, 1, 1}));
  CHECK(row.space_elements.size() == 6);
  CHECK(row.element_number.size() == brick_numbers);
  const Model<3> bent =
      alone_in_space(material, mesh_spec("bent", "m", distorted_box({1, 1, 1}, {2, 2, 2}, ElementShape::brick, 0.1)));
  CHECK(bent.space_elements.size() == 8);
  CHECK(bent.element_number.size() == 8 * brick_numbers);
}

}  // namespace
}  // namespace trilith::testing
