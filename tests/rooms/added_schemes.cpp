// The integrator that docs/architecture.md adds, run in the plane and in space. tests/rooms/add_a_law compiles this
// file in a copy of the tree that has it.
#include <doctest/doctest.h>

#include "model/space_builder/solid_model_builder.hpp"
#include "near.hpp"
#include "physics/scene.hpp"
#include "physics/space/solid_bodies.hpp"

namespace trilith::testing {
namespace {

/// x = g h^2 (1 + 2 + ... + n) after n steps of length h from rest, where leapfrog has g h^2 n^2 / 2; no energy is
/// lost.
template <int D>
void falls_as_the_sum_of_its_steps(Simulation<D> sim, int node) {
  StageOptions options;
  options.integrator = SymplecticEuler{};
  options.dt = 1e-3, options.duration = 0.1;
  const double from = sim.state().position[node][D - 1];
  RunListener<D> listener;
  listener.on_step = [&](const Instant<D>& now) {
    const auto n = static_cast<double>(now.state.step);
    CHECK(near(from - now.state.position[node][D - 1], standard_gravity * 1e-6 * n * (n + 1) / 2, 1e-9));
  };
  CHECK(sim.run(options, listener).end == StageEnd::time);
  CHECK(sim.state().step == 100);
  sim.refresh();
  const Energy energy = sim.energy();
  CHECK(near_zero(energy.balance(), 1e-9 * energy[EnergyTerm::kinetic]));
}

}  // namespace

TEST_CASE("a run by symplectic_euler falls by half a step more than leapfrog in the plane and in space") {
  Scene scene(Frictional{1e8, 1e8, 0.5, 0});
  scene.fixed("ground", box(-2, -1, 2, 0));
  BodySpec above;
  above.name = "stone", above.outline = box(-0.5, 1, 0.5, 2), above.mass = 300, above.floating = true;
  scene.add(above);
  falls_as_the_sum_of_its_steps<2>(scene.start(), 1);
  SolidModelBuilder builder;
  Material material;
  material.name = "stone", material.density = 2400;
  builder.add_material(material);
  builder.add_law("dry", Frictional{1e8, 1e8, 0.5, 0});
  builder.set_contact("stone", "stone", "dry");
  for (const bool is_ground : {true, false}) {
    SolidSpec spec;
    spec.name = is_ground ? "ground" : "stone", spec.material = "stone";
    spec.pieces = {is_ground ? box_at({4, 4, 1}, {0, 0, -0.5}) : box_at({1, 1, 1}, {0, 0, 1.5})};
    if (is_ground) spec.support.fill(Support::fixed);
    spec.floating = !is_ground;
    builder.add_body(spec);
  }
  falls_as_the_sum_of_its_steps<3>(Simulation<3>(builder.build()), 1);
}

}  // namespace trilith::testing
