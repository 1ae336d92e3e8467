// VALIDATION I11: equilibrium of an arch by the statics solver, and of an arch too thin to stand.
#include <algorithm>

#include "assembly/contact/contact_resultants.hpp"
#include "assembly/evaluate.hpp"
#include "build/plane/arch.hpp"
#include "near.hpp"
#include "physics/masonry_scene.hpp"
#include "statics/equilibrium.hpp"

namespace trilith::testing {
namespace {

/// A semicircular arch of mid radius 1 m with 30 voussoirs. Joints ten times as stiff would leave an unbalanced force
/// of 1e-8 of the weight, the rounding of the voussoirs' positions.
Model<2> standing_arch(double thickness) {
  Arch arch;
  arch.voussoirs = 30, arch.thickness = thickness, arch.half_angle = 90 * degree, arch.sub_edges = 2;
  Scene scene(stiff_joint(10, M_PI / 30, 4e11));
  add_parts(scene, build_arch(arch), "abutments");
  return scene.builder.build();
}

/// Forces of the joints and the weight at a state.
struct ArchForces {
  double weight = 0, thrust = 0;  ///< of all free bodies [N]; horizontal at the crown [N]
  double left = 0;                ///< largest unbalanced force, and moment over the voussoir's size, of a voussoir [N]

  ArchForces(const Model<2>& model, const State<2>& state) {
    Work<2> work;
    evaluate(model, state, work, state.last_dt);
    std::vector<TouchingContact> joints;
    contact_resultants(model, state, work, joints);
    for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
      const int n = model.bodies[b].first_node;
      if (!model.moves(n)) continue;
      weight += model.mass[n] * standard_gravity;
      left = std::max({left, work.force[n].norm(), std::abs(work.moment[n]) / model.body_radius[b]});
    }
    const int crown = model.find_body("v15"), beyond = model.find_body("v16");
    for (const TouchingContact& c : joints)
      if (std::minmax(c.body_a, c.body_b) == std::minmax(crown, beyond)) thrust += std::abs(c.resultant.force.x());
  }
};

TEST_CASE("I11: from the unstressed state Newton sets an arch down with a thrust between its limits") {
  const Model<2> model = standing_arch(.15);
  State<2> state = initial_state(model);
  const Equilibrium e = find_equilibrium(model, state);
  REQUIRE(e.converged);
  const ArchForces forces(model, state);
  MESSAGE(fmt::format("I11, t/R .15: thrust {:.4f} of the weight, {:.1e} of it left over; {} iterations",
                      forces.thrust / forces.weight, forces.left / forces.weight, e.iterations));
  CHECK(forces.thrust > .1756 * forces.weight);
  CHECK(forces.thrust < .2271 * forces.weight);
  CHECK(forces.left < 1e-8 * forces.weight);
}

TEST_CASE("I11: for an arch too thin to stand statics finds no equilibrium and leaves the state unchanged") {
  const Model<2> model = standing_arch(.10);
  State<2> state = initial_state(model);
  const std::uint64_t hash = state_hash(state);
  const Equilibrium e = find_equilibrium(model, state);
  MESSAGE(fmt::format("I11, t/R .10: {}, {:.1e} left over, {} iterations", name_of(e.end), e.left, e.iterations));
  CHECK_FALSE(e.converged);
  CHECK(e.end != EquilibriumEnd::rests);
  CHECK(state_hash(state) == hash);
}

}  // namespace
}  // namespace trilith::testing
