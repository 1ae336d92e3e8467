// Mortar that sets in loaded joints: setting changes no stress, and the bond acts from this moment on.
#include <array>

#include "assembly/evaluate.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double kn = 1e8, ft = 20e3, cohesion = 30e3, pressing = 10e3;

const ContactLaw brittle = Bonded{kn, 0.5 * kn, 0.7, 1e-4, cohesion, ft, 0};
const ContactLaw softening = Cohesive{kn, 0.5 * kn, 0.7, 1e-4, cohesion, ft, 50, 100};

/// A block 1 m wide and 4 m high on a fixed base with a joint of fresh mortar, under 10 kN and a push of `push` [N] at
/// mid-height. The resultant acts 2 push / 10 kN [m] off the middle of the joint. The block is at rest.
struct PressedBlock {
  Scene scene;
  Simulation<2> sim;
  int node;

  PressedBlock(const ContactLaw& law, double push, double turn)
      : scene(law, turn), sim(make(scene, push)), node(node_of(sim.model(), "block")) {
    sim.lift_bonds();
    REQUIRE(settle(sim, 20, 1e-11).end == StageEnd::rest);
  }
  static Simulation<2> make(Scene& scene, double push) {
    scene.set_gravity(Vec2::Zero());
    scene.fixed("base", rectangle({-1, -0.5}, {2, 0}));
    BodySpec spec;
    spec.name = "block", spec.outline = rectangle({0, 0}, {1, 4}), spec.mass = 1000;
    spec.load = {push, -pressing};
    scene.add(spec);
    return scene.start();
  }
  [[nodiscard]] std::uint32_t bonds() const {
    return sim.state().contacts.memory.empty() ? 0 : sim.state().contacts.memory[0].bonds;
  }
  /// Force [N] and moment [N m] on the block, and the ledger's residual [J].
  std::array<double, 4> answer() {
    sim.drop_work();
    sim.refresh();
    const Energy energy = energy_now(sim.model(), sim.state(), sim.work(), {0, {}});
    return {sim.work().force[node].x(), sim.work().force[node].y(), sim.work().moment[node], energy.balance()};
  }
};

}  // namespace

TEST_CASE("mortar sets without a jolt: forces, moments and energy balance are unchanged for any opening") {
  // Beyond a sixth of the width off the middle the joint is partly open; at 1750 N less than half of it is closed.
  for (const ContactLaw& law : {brittle, softening})
    for (const double push : {0.0, 500.0, 1250.0, 1750.0, -1250.0}) {
      CAPTURE(push);
      PressedBlock block(law, push, 0.3);
      CHECK(block.bonds() == 0);
      const std::array<double, 4> before = block.answer();
      block.sim.set_bonds();
      CHECK(block.bonds() == 3);
      const std::array<double, 4> after = block.answer();
      for (const int k : {0, 1, 2}) CHECK(std::abs(after[k] - before[k]) < 1e-9 * pressing);
      const StageReport on = run_for(block.sim, 0.05);
      CHECK(on.speed < 1e-8);
      CHECK(std::abs(block.answer()[3] - before[3]) < 1e-6 * pressing * pressing / kn);
      CHECK(block.bonds() == 3);
    }
}

TEST_CASE(
    "mortar that set in a half open joint carries moments of the other sign, and the column stands where a dry one "
    "falls") {
  // The mortar sets at 0.35 m off the middle, then the push moves the resultant to 0.6 m: a dry block topples beyond
  // 0.5 m, a bond opens by ft / kn at the far edge.
  for (const bool sets : {true, false}) {
    PressedBlock block(Bonded{kn, 0.5 * kn, 0.7, 1e-4, cohesion, 2 * ft, 0}, 1750, 0);
    if (sets) block.sim.set_bonds();
    block.sim.edit_model().load[block.node].x() = 3000;
    run_for(block.sim, 2);
    const double lean = std::abs(block.sim.state().rotation[block.node]);
    CHECK(block.bonds() == (sets ? 3 : 0));
    CHECK((lean < 0.01) == sets);
  }
}

TEST_CASE("a bond made across a gap starts without stress, carries tension, and leaves the gap when it is lost") {
  for (const ContactLaw& law : {brittle, softening})
    for (const double gap : {0.0, 4e-6, 8e-6}) {
      CAPTURE(gap);
      Scene scene(law, 0);
      scene.set_gravity(Vec2::Zero());
      scene.fixed("base", rectangle({-1, -0.5}, {2, 0}));
      BodySpec spec;
      spec.name = "block", spec.outline = rectangle({0, gap}, {1, 0.5 + gap}), spec.mass = 100;
      scene.add(spec);
      Simulation<2> sim = scene.start();
      CHECK(sim.state().contacts.memory.at(0).bonds == 3);
      const int node = node_of(sim.model(), "block");
      const double rest = sim.state().position[node].y();
      const auto force_at = [&](double move) {
        State<2> state = sim.state();
        state.position[node].y() = rest + move;
        Work<2> work;
        evaluate(sim.model(), state, work, 0);
        return work.force[node].y();
      };
      CHECK(std::abs(force_at(0)) < 1e-6);
      CHECK(near(force_at(1e-5), -kn * 1e-5, 1e-9));
      CHECK(near(force_at(-1e-5), kn * 1e-5, 1e-9));
      CHECK(near(force_at(0.999 * ft / kn), -0.999 * ft, 1e-9));
      sim.lift_bonds();
      CHECK(force_at(0.5 * ft / kn) == 0);
      CHECK(near(force_at(-1e-5), kn * (1e-5 - gap), 1e-6));
    }
}
