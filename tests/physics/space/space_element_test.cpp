// Single elements in space: patch tests, rotation, bending, mass, rejected meshes.
#include <doctest/doctest.h>

#include <cmath>

#include "near.hpp"
#include "physics/space/space_solids.hpp"

namespace trilith::testing {
namespace {

std::string name_of_shape(ElementShape shape) {
  return std::string(info_of(shape).name);
}

TEST_CASE("patch test: distorted bricks and tetrahedra carry a linear field exactly") {
  const double young = 1e7, poisson = 0.25;
  Eigen::Matrix3d gradient;  // symmetric, so that the elements do not turn
  gradient << 1.0, 0.3, -0.2, 0.3, -0.5, 0.4, -0.2, 0.4, 0.7;
  gradient *= 1e-3;
  SpaceVector strain;
  strain << gradient(0, 0), gradient(1, 1), gradient(2, 2), 2 * gradient(0, 1), 2 * gradient(1, 2), 2 * gradient(2, 0);
  const SpaceVector expected = elastic_in_space(young, poisson) * strain;
  for (const ElementShape shape : all_shapes) {
    CAPTURE(name_of_shape(shape));
    SolidSpec spec = mesh_spec("patch", "m", distorted_box(Vec3(2, 1.5, 1), {3, 3, 3}, shape, 0.08));
    // The skin is displaced by the field and fixed; the inner nodes are free.
    spec.supports = {{Vec3(0, 0, 0), Vec3(0, 1.5, 1), {Support::fixed, Support::fixed, Support::fixed}},
                     {Vec3(2, 0, 0), Vec3(2, 1.5, 1), {Support::fixed, Support::fixed, Support::fixed}},
                     {Vec3(0, 0, 0), Vec3(2, 0, 1), {Support::fixed, Support::fixed, Support::fixed}},
                     {Vec3(0, 1.5, 0), Vec3(2, 1.5, 1), {Support::fixed, Support::fixed, Support::fixed}},
                     {Vec3(0, 0, 0), Vec3(2, 1.5, 0), {Support::fixed, Support::fixed, Support::fixed}},
                     {Vec3(0, 0, 1), Vec3(2, 1.5, 1), {Support::fixed, Support::fixed, Support::fixed}}};
    const Model<3> model = alone_in_space(elastic_in("m", 1000, young, poisson), spec);
    State<3> state = initial_state(model);
    Work<3> work;
    for (int n = 0; n < model.nodes(); ++n) state.position[n] += gradient * model.start_position[n];
    internal_forces(model, state, work);
    // The field is in equilibrium: no force on any inner node.
    double left = 0, held = 0;
    for (int n = 0; n < model.nodes(); ++n)
      (model.moves(n) ? left : held) = std::max(model.moves(n) ? left : held, work.element_force[n].norm());
    CHECK(held > 0);
    CHECK(left < 1e-9 * held);
    CHECK(stress_error(model, state, expected) < 1e-9);
  }
}

/// A box of bricks; the bricks at its low end along x are split into wedges, inner nodes are displaced.
SpaceMesh bricks_and_wedges() {
  const SpaceMesh bricks = distorted_box(Vec3(2, 1.5, 1), {3, 3, 3}, ElementShape::brick, 0.08);
  SpaceMesh mixed{bricks.node, {}};
  for (std::size_t e = 0; e < bricks.cell.size(); ++e) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& x : nodes_of(bricks, e)) middle += x / 8;
    const SpaceMesh one{bricks.node, {bricks.cell[e]}};
    const SpaceMesh parted = divided_into(middle.x() < 1 ? ElementShape::wedge : ElementShape::brick, one);
    mixed.cell.insert(mixed.cell.end(), parted.cell.begin(), parted.cell.end());
  }
  return mixed;
}

TEST_CASE("patch test: bricks and wedges in one mesh stretch uniformly to rounding") {
  const double young = 1e7, poisson = 0.3, stretch = 1e-3;
  const Model<3> model =
      alone_in_space(elastic_in("m", 1000, young, poisson), mesh_spec("patch", "m", bricks_and_wedges()));
  CHECK(model.space_elements.size() > 27);
  State<3> state = initial_state(model);
  Work<3> work;
  for (int n = 0; n < model.nodes(); ++n)
    state.position[n] = Vec3(1 + stretch, 1 - poisson * stretch, 1 - poisson * stretch).cwiseProduct(state.position[n]);
  internal_forces(model, state, work);
  SpaceVector expected = SpaceVector::Zero();
  expected[0] = young * stretch;
  CHECK(stress_error(model, state, expected) < 1e-9);
}

TEST_CASE("patch test: a stretch of distorted elements is uniform to rounding") {
  const double young = 1e7, poisson = 0.3, stretch = 1e-3;
  for (const ElementShape shape : all_shapes) {
    CAPTURE(name_of_shape(shape));
    const Model<3> model =
        alone_in_space(elastic_in("m", 1000, young, poisson),
                       mesh_spec("patch", "m", distorted_box(Vec3(2, 1.5, 1), {3, 3, 3}, shape, 0.08)));
    State<3> state = initial_state(model);
    Work<3> work;
    for (int n = 0; n < model.nodes(); ++n) {
      const Vec3& x = model.start_position[n];
      state.position[n] = Vec3((1 + stretch) * x.x(), (1 - poisson * stretch) * x.y(), (1 - poisson * stretch) * x.z());
    }
    internal_forces(model, state, work);
    SpaceVector expected = SpaceVector::Zero();
    expected[0] = young * stretch;
    CHECK(stress_error(model, state, expected) < 1e-9);
    double inner = 0, ends = 0;
    for (int n = 0; n < model.nodes(); ++n) {
      const double x = model.start_position[n].x();
      (x > 1e-9 && x < 2 - 1e-9 ? inner : ends) =
          std::max(x > 1e-9 && x < 2 - 1e-9 ? inner : ends, work.element_force[n].norm());
    }
    CHECK(inner < 1e-9 * ends);
  }
}

TEST_CASE("a rigid rotation of elements in space by any angle causes no stress, no force and no energy") {
  const double young = 1e7;
  std::mt19937_64 bits(5);
  for (const ElementShape shape : all_shapes)
    for (const ElementForm form : {ElementForm::assumed, ElementForm::plain}) {
      CAPTURE(name_of_shape(shape));
      const Model<3> model = alone_in_space(elastic_in("m", 1000, young, 0.3, 0, form),
                                            mesh_spec("b", "m", distorted_box(Vec3(2, 1.5, 1), {2, 2, 2}, shape, 0.1)));
      State<3> state = initial_state(model);
      Work<3> work;
      for (int i = 0; i < 100; ++i) {
        const Turn3 turn = turn_of(random_turn(bits));
        for (int n = 0; n < model.nodes(); ++n)
          state.position[n] = Vec3(3, -2, 1) + turn.apply(model.start_position[n]);
        internal_forces(model, state, work);
        CHECK(largest_of(work.element_force) < 1e-9 * young);
        CHECK(work.element_stored < 1e-18 * young);
      }
    }
}

TEST_CASE("forces of elements in space are the gradient of the stored energy, with no resultant and no moment") {
  std::mt19937_64 bits(6);
  for (const ElementShape shape : all_shapes) {
    CAPTURE(name_of_shape(shape));
    const Model<3> model = alone_in_space(elastic_in("m", 1000, 1e6, 0.3),
                                          mesh_spec("b", "m", distorted_box(Vec3(1, 1.2, 0.9), {1, 1, 1}, shape, 0)));
    State<3> state = initial_state(model);
    Work<3> work;
    const Turn3 turn = turn_of(random_turn(bits));
    for (Vec3& x : state.position) x = turn.apply(x) + 0.08 * random_in_ball(bits);
    internal_forces(model, state, work);
    const std::vector<Vec3> force = work.element_force;
    const double size = largest_of(force);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    for (int n = 0; n < model.nodes(); ++n) {
      sum += force[n], moment += cross(state.position[n], force[n]);
      for (int k = 0; k < 3; ++k) {
        const double h = 1e-6, at = state.position[n][k];
        state.position[n][k] = at + h, internal_forces(model, state, work);
        const double more = work.element_stored;
        state.position[n][k] = at - h, internal_forces(model, state, work);
        const double less = work.element_stored;
        state.position[n][k] = at;
        CHECK(near_zero(force[n][k] + (more - less) / (2 * h), 1e-6 * size));
      }
    }
    CHECK(sum.norm() < 1e-11 * size);
    CHECK(moment.norm() < 1e-11 * size);
  }
}

/// Tip deflection of a cantilever of 10 m x 1 m x 1 m under a force across it, over the deflection by beam theory with
/// shear [1].
double tip_ratio(double poisson, ElementForm form, ElementShape shape, const std::array<int, 3>& divisions) {
  const double young = 1e7, length = 10, force = 1;
  SolidSpec spec = box_of("beam", box_solid(Vec3(0, 0, 0), Vec3(length, 1, 1)), "m", divisions, shape);
  // The root is fixed so that it may widen: all nodes along x, the middle lines across.
  const Support f = Support::fixed, r = Support::free;
  spec.supports = {{Vec3(0, 0, 0), Vec3(0, 1, 1), {f, r, r}},
                   {Vec3(0, 0, 0), Vec3(0, 0, 0), {f, f, f}},
                   {Vec3(0, 1, 0), Vec3(0, 1, 0), {f, r, f}}};
  const Model<3> model = alone_in_space(elastic_in("m", 1000, young, poisson, 0, form), spec);
  SpaceEquilibrium balance(model);
  std::vector<int> tip;
  for (int n = 0; n < model.nodes(); ++n)
    if (model.start_position[n].x() > length - 1e-9) tip.push_back(n);
  for (const int n : tip) balance.force[n] = Vec3(0, 0, force / static_cast<double>(tip.size()));
  balance.solve(1, 1e-6);
  double sum = 0;
  for (const int n : tip) sum += balance.state().position[n].z() - model.start_position[n].z();
  const double inertia = 1.0 / 12, shear = young / (2 * (1 + poisson)) * 5.0 / 6;
  const double theory = force * (length * length * length / (3 * young * inertia) + length / shear);
  return sum / static_cast<double>(tip.size()) / theory;
}

TEST_CASE("a cantilever with one brick through its depth bends as in beam theory and plain bricks lock") {
  CHECK(near(tip_ratio(0.3, ElementForm::assumed, ElementShape::brick, {10, 1, 1}), 1, 0.01));
  CHECK(tip_ratio(0.3, ElementForm::plain, ElementShape::brick, {10, 1, 1}) < 0.75);
  CHECK(near(tip_ratio(0.3, ElementForm::assumed, ElementShape::quadratic_tetrahedron, {5, 1, 1}), 1, 0.05));
}

TEST_CASE("a cantilever of wedges is too stiff, with an error that falls with the element size") {
  const double coarse = tip_ratio(0.3, ElementForm::assumed, ElementShape::wedge, {10, 1, 1}),
               fine = tip_ratio(0.3, ElementForm::assumed, ElementShape::wedge, {40, 2, 2}),
               plain = tip_ratio(0.3, ElementForm::plain, ElementShape::wedge, {10, 1, 1});
  MESSAGE("of beam theory: " << plain << " plain, " << coarse << ", four times as fine " << fine);
  CHECK(plain < coarse);
  CHECK(coarse < fine);
  CHECK(fine < 1);
  CHECK(fine > 0.95);
}

TEST_CASE("a cantilever of nearly incompressible bricks does not lock") {
  CHECK(near(tip_ratio(0.499, ElementForm::assumed, ElementShape::brick, {10, 1, 1}), 1, 0.02));
  CHECK(tip_ratio(0.499, ElementForm::plain, ElementShape::brick, {10, 1, 1}) < 0.5);
}

TEST_CASE("elements in space give a body its mass, centre and moments of inertia") {
  const Vec3 sides(2, 1, 0.5);
  const double density = 2000, mass = density * sides.prod();
  for (const ElementShape shape : all_shapes) {
    CAPTURE(name_of_shape(shape));
    const Model<3> model = alone_in_space(elastic_in("m", density, 1e9, 0.2),
                                          box_of("b", box_solid(Vec3::Zero(), sides), "m", {8, 4, 2}, shape));
    CHECK(near(body_mass(model, 0), mass, 1e-12));
    double least = unbounded;
    Vec3 centre = Vec3::Zero();
    for (int n = 0; n < model.nodes(); ++n)
      centre += model.mass[n] / mass * model.start_position[n], least = std::min(least, model.mass[n]);
    CHECK(least > 0);
    CHECK((centre - 0.5 * sides).norm() < 0.02);
    double about = 0;
    for (int n = 0; n < model.nodes(); ++n)
      about += model.mass[n] * (model.start_position[n] - centre).head<2>().squaredNorm();
    // Lumped masses lie farther out than the mass of their elements, which raises the inertia: error of second order in
    // the division.
    CHECK(near(about, mass / 12 * sides.head<2>().squaredNorm(), 0.051));
  }
}

TEST_CASE("the nodal mass shares of a ten-node tetrahedron are 1/36 and 4/27") {
  const SpaceMesh one = quadratic_of(
      {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, {{ElementShape::tetrahedron, {0, 1, 2, 3}}}});
  const Model<3> model = alone_in_space(elastic_in("m", 6, 1e9, 0.2), mesh_spec("t", "m", one));
  for (int n = 0; n < 10; ++n) CHECK(near(model.mass[n], n < 4 ? 1.0 / 36 : 4.0 / 27, 1e-12));
}

std::string refusal(SpaceMesh mesh) {
  try {
    (void)alone_in_space(elastic_in("m", 1000, 1e9, 0.2), mesh_spec("b", "m", std::move(mesh)));
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST_CASE("meshes in space that are not bodies are rejected in one clear line, mirrored elements reversed") {
  const SpaceMesh good = mesh_of(box_solid(Vec3::Zero(), Vec3(2, 1, 1)), {BodyKind::mesh, {2, 1, 1}}, "box");
  CHECK(refusal(good).empty());
  SpaceMesh inverted = good;
  std::swap(inverted.cell[1].node[0], inverted.cell[1].node[1]);
  CHECK(refusal(inverted).find("element 2 of the mesh (brick)") != std::string::npos);
  SpaceMesh mirrored = good;
  for (std::size_t i = 0; i < 4; ++i) std::swap(mirrored.cell[1].node[i], mirrored.cell[1].node[i + 4]);
  CHECK(refusal(mirrored).empty());
  SpaceMesh open = good;
  open.node.push_back(open.node[static_cast<std::size_t>(open.cell[1].node[0])]);
  open.cell[1].node[0] = static_cast<int>(open.node.size()) - 1;
  CHECK(refusal(open).find("are at the same place, so the mesh is open there") != std::string::npos);
  SpaceMesh apart = good;
  for (const Vec3& x : {Vec3(5, 0, 0), Vec3(6, 0, 0), Vec3(5, 1, 0), Vec3(5, 0, 1)}) apart.node.push_back(x);
  const int n = static_cast<int>(good.node.size());
  apart.cell.push_back({ElementShape::tetrahedron, {n, n + 1, n + 2, n + 3}});
  CHECK(refusal(apart).find("shares no face with the others") != std::string::npos);
  SpaceMesh missing = good;
  missing.cell[0].node[3] = 99;
  CHECK(refusal(missing).find("names node 100, there are nodes 1 to 12") != std::string::npos);
  SpaceMesh mixed = tetrahedra_of(good);
  const SpaceMesh quadratic = quadratic_of(mixed);
  mixed.node = quadratic.node, mixed.cell[0] = quadratic.cell[0];
  CHECK(refusal(mixed).find("have other nodes on the face they have in common") != std::string::npos);
}

TEST_CASE("a solid that is not a brick in topology is rejected as an element") {
  SolidSpec spec = box_of("post", prism(std::array{Vec2(0, 0), Vec2(1, 0), Vec2(0.5, 1)}, 0, 1), "m", {1, 1, 1});
  CHECK_THROWS_WITH_AS(
      (void)alone_in_space(elastic_in("m", 1000, 1e9, 0.2), spec),
      "body 'post': it has 6 corners and 5 faces, but a brick element has 8 and 6; leave it rigid, or give it a mesh",
      InputError);
}

}  // namespace
}  // namespace trilith::testing
