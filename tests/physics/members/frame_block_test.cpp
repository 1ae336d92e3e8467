// Rigid blocks as joints of a frame: mass and inertia on a cantilever, free flight, contact on their faces.
#include "modal/modes.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"
#include "physics/members/implicit.hpp"

namespace trilith::testing {
namespace {

constexpr double young = 2e11, height = 3, density = 7850;

/// A light post of 3 m with a block of 1 m by 0.6 m on it; the post's axis enters the block from below.
BodySpec post_with_block() {
  BodySpec spec = beam_body("post", {0, 0}, {0, height}, rectangle_section(0.05, 0.1), "steel", 6);
  FrameJoint& head = spec.frame->joints[1];
  head.block = box(-0.5, height, 0.5, height + 0.6);
  head.place = {0, height + 0.3};
  return spec;
}

/// The two frequencies of a massless cantilever with a rigid body at its tip, whose centre is `arm` [m] beyond [Hz].
std::array<double, 2> two_frequencies(double stiffness, double mass, double inertia, double arm) {
  const double l = height;
  Eigen::Matrix2d k, m;
  k << 12 * stiffness / (l * l * l), -6 * stiffness / (l * l), -6 * stiffness / (l * l), 4 * stiffness / l;
  // Of the tip: displacement u and rotation; the centre moves by u + arm rotation.
  m << mass, mass * arm, mass * arm, inertia + mass * arm * arm;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> solver(k, m);
  return {std::sqrt(solver.eigenvalues()[0]) / (2 * M_PI), std::sqrt(solver.eigenvalues()[1]) / (2 * M_PI)};
}

TEST_CASE("a block as the head of a post has the frequencies of a mass with inertia on a cantilever") {
  BodySpec spec = post_with_block();
  spec.frame->joints[0].support = held;
  spec.density = 1e-3 * density;
  spec.frame->joints[1].density = density;
  const Model<2> model = of_frames(elastic_material("steel", density, young), {spec});
  const double mass = density * 0.6, inertia = mass * (1 + 0.36) / 12;
  CHECK(near(model.mass[1], mass, 1e-3));
  const double ei = young * 0.05 * 0.001 / 12;
  const std::array<double, 2> expected = two_frequencies(ei, mass, inertia, 0.3);
  const std::vector<Mode> found = modes(model, initial_state(model), 3);
  std::vector<double> bending;
  for (const Mode& mode : found)
    if (std::abs(mode.displacement[1].x()) + std::abs(mode.rotation[1]) > 10 * std::abs(mode.displacement[1].y()))
      bending.push_back(mode.frequency());
  REQUIRE(bending.size() >= 2);
  MESSAGE("frequencies " << bending[0] << ", " << bending[1] << " Hz (" << expected[0] << ", " << expected[1] << ")");
  CHECK(near(bending[0], expected[0], 2e-3));
  CHECK(near(bending[1], expected[1], 2e-3));
}

TEST_CASE("a frame with a block in free flight keeps its momenta, in explicit and in implicit steps") {
  for (const bool implicit : {false, true}) {
    BodySpec spec = post_with_block();
    spec.spin = 2, spec.velocity = {1, 0.5};
    const Model<2> model = of_frames(elastic_material("steel", density, young), {spec});
    const auto momenta = [&](const State<2>& s) {
      std::array<double, 3> sum{};
      for (int n = 0; n < model.nodes(); ++n) {
        sum[0] += model.mass[n] * s.velocity[n].x(), sum[1] += model.mass[n] * s.velocity[n].y();
        sum[2] += model.mass[n] * cross(s.position[n], s.velocity[n]) + model.inertia[n] * s.spin[n];
      }
      return sum;
    };
    Simulation<2> sim(model);
    const std::array<double, 3> before = momenta(sim.state());
    if (implicit)
      sim.run(adaptive_stage({}, 0.5, 1e-3));
    else
      run_for(sim, 0.5, 0);
    const std::array<double, 3> after = momenta(sim.state());
    for (const int k : {0, 1}) CHECK(near(after[k], before[k], 1e-9));
    MESSAGE((implicit ? "implicit" : "explicit") << " angular momentum " << after[2] / before[2]);
    CHECK(near(after[2], before[2], implicit ? 1e-3 : 1e-4));
  }
}

TEST_CASE("a block as a footing stands on the ground with its faces and carries its load") {
  Scene scene(Frictional{1e9, 5e8, 0.6, 1e-4});
  scene.builder.add_material(elastic_material("steel", density, young));
  scene.fixed("ground", box(-5, -1, 5, 0));
  BodySpec spec = beam_body("post", {0, 0.5}, {0, 3}, rectangle_section(0.3, 0.3), "steel", 4);
  spec.floating = false;
  FrameJoint& foot = spec.frame->joints[0];
  foot.block = box(-1, 0, 1, 0.5), foot.place = {0, 0.25};
  scene.builder.add_body(spec);
  const Model<2> model = scene.builder.build();
  // The post begins where its axis leaves the block.
  CHECK(near(model.beams.front().arm[0].y(), 0.25, 1e-12));
  Simulation<2> sim(model);
  const StageReport report = settle(sim, 20, 1e-7);
  CHECK(report.end == StageEnd::rest);
  const Body& body = model.bodies[1];
  double weight = 0;
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n) weight += model.mass[n] * standard_gravity;
  const double sunk = -(sim.state().position[body.first_node].y() - 0.25);
  CHECK(near(sunk, weight / (1e9 * 2 * model.thickness), 1e-4));
}

TEST_CASE("blocks of joints that are not convex, or not about their joint, are rejected") {
  const auto built = [](const Polygon& block, const Vec2& place) {
    BodySpec spec = post_with_block();
    spec.frame->joints[1].block = block, spec.frame->joints[1].place = place;
    return of_frames(elastic_material("steel", density, young), {spec});
  };
  CHECK_THROWS_AS(built(box(-0.5, 3, 0.5, 4), {0, 3}), InputError);
  CHECK_THROWS_AS(built({{-1, 3}, {1, 3}, {0, 3.2}, {0, 4}}, {0, 3.3}), InputError);
}

}  // namespace
}  // namespace trilith::testing
