// The term-wise tangent stiffness in space against differences of all forces: falling stones and balls, meshes on
// meshes and on stones, mortar, bearings, frames, follower loads, mass damping.
#include <doctest/doctest.h>

#include <cmath>

#include "assembly/compared_tangents.hpp"
#include "assembly/node_forces.hpp"
#include "assembly/tangent/fd_perturbation.hpp"
#include "assembly/tangent/tangent.hpp"
#include "base/error.hpp"
#include "contact/held_joint.hpp"
#include "geometry/space/convex_hull.hpp"
#include "integrate/implicit/implicit_step.hpp"
#include "law/bearing/direction_samples.hpp"
#include "physics/space/space_solids.hpp"

namespace trilith::testing {
namespace {

/// The tangent by finite differences of all forces, one unknown at a time.
Eigen::MatrixXd by_differences(const Model<3>& model, State<3>& state, const DofGraph<3>& coupling,
                               const TangentOptions& o) {
  const int size = coupling.size();
  Eigen::MatrixXd out(size, size);
  Work<3> work;
  for (int j = 0; j < size; ++j) {
    const Freedom column = coupling.freedom[static_cast<std::size_t>(j)];
    const double by = perturbation_of(model, column, o);
    std::array<Eigen::VectorXd, 2> force{Eigen::VectorXd(size), Eigen::VectorXd(size)};
    for (const std::size_t side : {0, 1}) {
      const Moved<3> moved(state, column, side == 0 ? by : -by, o.rate);
      evaluate(model, state, work, o.dt);
      for (int i = 0; i < size; ++i)
        force[side][i] = net_force(model, state, work, coupling.freedom[static_cast<std::size_t>(i)]);
    }
    out.col(j) = -o.force / (2 * by) * (force[0] - force[1]);
    const Dofs<3> own = inertia_column(model, state, column, o.inertia, o.rate);
    for (std::size_t k = 0; k < own.size(); ++k)
      if (const int i = coupling.unknown[static_cast<std::size_t>(column.node)][k]; i >= 0) out(i, j) += own[k];
  }
  return out;
}

/// worst_difference() of the two tangents at a state.
double worst_entry(const Model<3>& model, State<3> state, double dt, double rate, double disturbance) {
  Work<3> work;
  evaluate(model, state, work, dt);
  Tangent<3> tangent;
  const TangentOptions options{dt, rate, 1, 1e3, disturbance};
  const std::uint64_t before = state_hash(state);
  const std::vector<Vec3> force = work.force;
  tangent.assemble(model, state, work, options);
  CHECK(state_hash(state) == before);
  CHECK(work.force == force);
  const Eigen::MatrixXd terms(tangent.matrix()), all = by_differences(model, state, tangent.coupling(), options);
  return worst_difference(terms, all);
}

/// Largest difference at `times` instants of a run of `seconds`, of the explicit state and of the implicit state that
/// starts from it.
double worst_on_the_way(const Model<3>& model, double dt, double seconds, int times, double disturbance) {
  SolidRun run(model, dt);
  double worst = 0;
  for (int i = 0; i < times; ++i) {
    run.run(seconds / times);
    State<3> state = run.state();
    worst = std::max(worst, worst_entry(model, state, dt, 1 / dt, disturbance));
    Work<3> work;
    evaluate(model, state, work, dt);
    begin_implicit(model, state, work);
    worst = std::max(worst, worst_entry(model, state, dt, 1 / dt, disturbance));
  }
  return worst;
}

SolidModelBuilder on_a_floor(const ContactLaw& law) {
  SolidModelBuilder builder;
  builder.add_material({"stone", 2400, {}});
  builder.add_material(elastic_in("soft", 2000, 2e7, 0.2, 1e-4));
  builder.add_law("all", law);
  builder.set_contact("*", "*", "all");
  SolidSpec floor;
  floor.name = "floor", floor.material = "stone", floor.pieces = {box_solid(Vec3(-2, -2, -1), Vec3(2, 2, 0))};
  floor.support.fill(Support::fixed);
  builder.add_body(floor);
  return builder;
}

SolidSpec stone_at(const std::string& name, std::vector<Polyhedron> pieces, const Vec3& velocity, const Vec3& spin) {
  SolidSpec spec;
  spec.name = name, spec.material = "stone", spec.pieces = std::move(pieces), spec.floating = true;
  spec.velocity = velocity, spec.spin = spin;
  return spec;
}

/// Two blades that share a ridge above and leave a hollow below.
std::vector<Polyhedron> chevron(const UnitQuaternion& turn, const Vec3& at) {
  std::vector<Polyhedron> both;
  for (const double side : {-1.0, 1.0}) {
    std::vector<Vec3> corners;
    for (const double y : {-0.2, 0.2})
      for (const Vec3& c : {Vec3(0, y, 0.1), Vec3(0, y, -0.1), Vec3(0.3 * side, y, 0), Vec3(0.3 * side, y, -0.2)})
        corners.push_back(at + Turn3(turn).apply(c));
    both.push_back(convex_hull(corners, "chevron"));
  }
  return both;
}

TEST_CASE("the tangent in space matches finite differences: poured random stones, balls and stones of two pieces") {
  std::mt19937_64 bits(5);
  SolidModelBuilder builder = on_a_floor(frictional(5e6, 3e6, 0.6, 1e-3));
  for (int i = 0; i < 4; ++i) {
    const Polyhedron shape = random_convex_solid(bits, {.smallest = 0.3, .largest = 0.5});
    const Vec3 at(0.35 * (i % 2), 0.35 * (i / 2), 0.25 + 0.2 * i);
    builder.add_body(
        stone_at("stone " + std::to_string(i), {placed(shape, {}, at)}, Vec3(0, 0, -1), Vec3(1, 0.5, 0.2)));
  }
  for (int i = 0; i < 3; ++i) {
    SolidSpec ball = stone_at("ball " + std::to_string(i), {}, Vec3(0.1, 0, -1), Vec3(0, 1, 0));
    ball.spheres = {{Vec3(-0.5 + 0.15 * i, 0.1 * i, 0.2 + 0.25 * i), 0.15}};
    builder.add_body(ball);
  }
  for (int i = 0; i < 2; ++i)
    builder.add_body(stone_at("chevron " + std::to_string(i),
                              chevron(rotation_by(Vec3(3.1, 0.1, 0.2)), Vec3(1.2, 0.1 * i, 0.15 + 0.35 * i)),
                              Vec3(0.2, 0, -0.5), Vec3(0.1, 0.2, 0.3)));
  builder.overlap_allowed = 0.9;
  builder.mass_damping = 2;
  CHECK(worst_on_the_way(builder.build(), 1e-4, 0.4, 8, 6e-9) < 1e-6);
}

TEST_CASE("the tangent in space matches finite differences: boxes of elements that fall on stones and on each other") {
  for (const ElementShape shape : all_shapes) {
    SolidModelBuilder builder = on_a_floor(frictional(5e6, 3e6, 0.4, 1e-3));
    builder.add_body(
        stone_at("stone", {box_at(Vec3(0.5, 0.5, 0.3), Vec3(0, 0, 0.16))}, Vec3(0, 0, -0.5), Vec3::Zero()));
    for (int i = 0; i < 2; ++i) {
      SolidSpec box = box_of(
          "box " + std::to_string(i),
          box_at(Vec3(0.4, 0.3, 0.3), Vec3(0.1 * i, 0.05, 0.5 + 0.32 * i), rotation_by(Vec3(0.1, 0.05 + 0.3 * i, 0.2))),
          "soft", {2, 1, 1}, shape);
      box.velocity = Vec3(0.1, 0, -1), box.spin = Vec3(0.2, 0.1, 0);
      builder.add_body(box);
    }
    builder.overlap_allowed = 0.9;
    const Model<3> model = builder.build();
    INFO("shape ", static_cast<int>(shape));
    CHECK(worst_on_the_way(model, 2e-5, 0.08, 4, 6e-9) < 1e-6);
  }
}

TEST_CASE("the tangent in space matches finite differences: mortar that is intact, torn and crushed") {
  for (const ContactLaw& law :
       {ContactLaw(soft_mortar(2e8, 1e8, 0.7, 2e4, 1e4, 5, 20)), ContactLaw(brittle_mortar(2e8, 2e8, 0.7, 1e5, 1e5))}) {
    SolidModelBuilder builder = on_a_floor(law);
    for (int i = 0; i < 3; ++i)
      builder.add_body(stone_at("brick " + std::to_string(i),
                                {box_at(Vec3(0.25, 0.12, 0.08), Vec3(0.05 * i, 0, 0.04 + 0.08 * i))},
                                Vec3(0, 0.3 * i, 0), Vec3(0, 0, 0.5 * i)));
    CHECK(worst_on_the_way(builder.build(), 2e-5, 0.02, 8, 1.5e-9) < 1e-6);
  }
}

TEST_CASE("the tangent in space matches finite differences: bearings, a frame on them and follower loads") {
  for (const DirectionSample& sample : direction_samples(2e3))
    for (const std::size_t direction : {0UL, 2UL, 4UL}) {
      SolidModelBuilder builder = on_a_floor(frictional(5e6, 3e6, 0.4, 1e-3));
      builder.add_material(member_material(2400, 3e8, 0.2, 1e-4));
      builder.add_body(stone_at("block", {box_at(Vec3(0.5, 0.5, 0.3), Vec3(0, 0, 0.149))}, Vec3::Zero(), Vec3::Zero()));
      builder.add_body(
          chain_body("girder", {Vec3(-1, 0, 0.6), Vec3(0, 0, 0.6), Vec3(1, 0.3, 0.6)}, plain_section(0.2, 0.3), 2));
      BearingSpecOf<3> link;
      link.name = "link", link.body_a = "block", link.body_b = "girder";
      link.point_a = Vec3(0, 0, 0.299), link.point_b = Vec3(0, 0, 0.45);
      link.law[0] = link.law[1] = Linear{1e5, 0}, link.law[2] = Linear{1e6, 0};
      link.law[direction] = sample.law;
      builder.overlap_allowed = 0.9;
      try {
        builder.add_bearing(link);
      } catch (const InputError&) {
        continue;  // laws that slide along their own axis
      }
      Model<3> model = builder.build();
      SolidLoadSpec load;
      load.name = "push", load.force = Vec3(2e3, 1e3, -3e3), load.at = Vec3(0.1, 0.1, 0.2), load.follows = true;
      loads_of<PointLoad<3>>(model) = make_solid_loads(model, 1, load);
      INFO(sample.name, ", direction ", direction);
      CHECK(worst_on_the_way(model, 1e-5, 0.01, 3, 6e-9) < 1e-6);
    }
}

}  // namespace
}  // namespace trilith::testing
