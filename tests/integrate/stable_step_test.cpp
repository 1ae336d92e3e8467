// The stable step estimate against the step at which central differences diverge.
#include "integrate/explicit/stable_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <random>

#include "assembly/bounds/local_springs.hpp"
#include "assembly/evaluate.hpp"
#include "events/commit.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Whether a scene at rest, slightly disturbed, stays bounded at this step: energy of the motion against the energy of
/// the disturbance.
bool stays(const Model<2>& model, const State<2>& rest, double dt) {
  State<2> state = rest;
  state.last_dt = dt;
  Work<2> work;
  for (int n = 0; n < model.nodes(); ++n) {
    if (!model.moves(n)) continue;
    const double sign = n % 2 == 0 ? 1 : -1;
    state.velocity[n] = {1e-6 * sign, 1e-6};
    state.spin[n] = 1e-6 * sign;
  }
  for (int i = 0; i < 3000; ++i) {
    evaluate(model, state, work, dt);
    if (work.fastest_moving > 1e-3) return false;
    commit(model, state, work);
    advance(model, state, work, {dt, {}});
  }
  return true;
}

struct Limits {
  double estimate, real;  // [s]
};

Limits limits(Scene& scene) {
  Simulation<2> sim = scene.start();
  StageOptions options;
  options.duration = 5;
  options.rest_share = 0.8;
  options.until_rest = true;
  options.still_speed = 1e-7;
  options.still_hold = 0.01;
  CHECK(sim.run(options).end == StageEnd::rest);
  sim.refresh();
  const double estimate = stable_step(sim.model(), sim.state(), sim.work()).dt;
  double low = 0.5 * estimate, high = 8 * estimate;
  REQUIRE(stays(sim.model(), sim.state(), low));
  REQUIRE_FALSE(stays(sim.model(), sim.state(), high));
  while (high > 1.01 * low) {
    const double middle = std::sqrt(low * high);
    (stays(sim.model(), sim.state(), middle) ? low : high) = middle;
  }
  CHECK(stays(sim.model(), sim.state(), 0.99 * estimate));
  CHECK_FALSE(stays(sim.model(), sim.state(), 1.1 * low));
  return {estimate, low};
}

Frictional law(double beta) {
  return {1e9, 5e8, 0.6, beta};
}

void report(const std::string& what, double beta, const Limits& l) {
  MESSAGE(what, ", beta ", beta, " s: estimate ", l.estimate, " s, real limit ", l.real, " s, share ",
          l.estimate / l.real);
}

}  // namespace

TEST_CASE("the stable step of a block is on the safe side, and at least a quarter of the real limit") {
  for (const double beta : {0.0, 1e-4, 1e-3})
    for (const double width : {1.0, 0.3, 3.0}) {
      Scene scene(law(beta));
      scene.fixed("base", rectangle({-5, -1}, {5, 0}));
      scene.block("block", rectangle({0, 0}, {width, 1}), 2000 * width);
      const Limits l = limits(scene);
      report("block of width " + std::to_string(width), beta, l);
      CHECK(l.estimate < l.real);
      CHECK(l.estimate > 0.25 * l.real);
    }
}

TEST_CASE("the stable step of a stack and of a wall is on the safe side, and at least a third of the real limit") {
  for (const double beta : {0.0, 1e-4}) {
    Scene stack(law(beta));
    stack.fixed("base", rectangle({-5, -1}, {5, 0}));
    for (int i = 0; i < 6; ++i)
      stack.block("block" + std::to_string(i), rectangle({0, 0.5 * i}, {1, 0.5 * (i + 1)}), 1000);
    const Limits of_stack = limits(stack);
    report("stack of 6", beta, of_stack);
    CHECK(of_stack.estimate < of_stack.real);
    CHECK(of_stack.estimate > of_stack.real / 3);

    Scene wall(law(beta));
    wall.fixed("base", rectangle({-1, -1}, {3, 0}));
    for (int c = 0; c < 6; ++c)
      for (int i = 0; i < 4 + c % 2; ++i) {
        const double from = std::max(0.0, 0.4 * (i - 0.5 * (c % 2))), to = std::min(1.6, 0.4 * (i + 1 - 0.5 * (c % 2)));
        wall.block("brick" + std::to_string(c) + "." + std::to_string(i),
                   rectangle({from, 0.2 * c}, {to, 0.2 * (c + 1)}), 400 * (to - from));
      }
    const Limits of_wall = limits(wall);
    report("wall of 27", beta, of_wall);
    CHECK(of_wall.estimate < of_wall.real);
    CHECK(of_wall.estimate > of_wall.real / 3);
  }
}

TEST_CASE("the bound of a body's springs is at least the largest eigenvalue and at most 0.5 % above it") {
  std::mt19937_64 bits(61);
  std::normal_distribution<double> chance;
  std::uniform_int_distribution<int> springs(1, 8);
  double most = 0, least = 2, of_before = 0;
  Eigen::Matrix3d before = Eigen::Matrix3d::Zero();
  int unlike = 0;
  for (int trial = 0; trial < 50000; ++trial) {
    const double lever = trial % 3 == 0 ? 0.1 : trial % 3 == 1 ? 1 : 10;
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    for (int n = springs(bits); n > 0; --n) {
      const Eigen::Vector3d v(chance(bits), chance(bits), lever * chance(bits));
      m += 1e9 * v * v.transpose();
    }
    // In one vector with another matrix, whose iteration ends earlier or later.
    const std::array<double, 2> found = largest_eigenvalues(m, before);
    const double share = found[0] / Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).eigenvalues()[2];
    most = std::max(most, share), least = std::min(least, share);
    unlike += found[0] != largest_eigenvalues(before, m)[1] || found[1] != of_before;
    before = m, of_before = found[0];
  }
  CHECK(least > 1 - 1e-12);
  CHECK(most < 1.005);
  CHECK(unlike == 0);
  // The zero matrix; three equal eigenvalues, the slowest case of Newton's iteration; and two.
  CHECK(largest_eigenvalues(Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero()) == std::array{0.0, 0.0});
  const auto [three, two] = largest_eigenvalues(Eigen::Matrix3d::Identity(), Eigen::Vector3d(2, 2, 1).asDiagonal());
  CHECK(near(three, 1, 1e-12));
  CHECK(near(two, 2, 1e-12));
}
