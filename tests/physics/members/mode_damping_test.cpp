// Modal damping ratios against their closed forms.
#include "modal/mode_damping.hpp"

#include "assembly/start.hpp"
#include "modal/modes.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"
#include "physics/members/implicit.hpp"

namespace trilith::testing {
namespace {

std::vector<ModeDamping> damping_of(const Model<2>& model, int count, std::vector<Mode>& found) {
  const State<2> state = start_state(model);
  found = modes(model, state, count);
  return mode_damping(model, state, found);
}

/// A block connected by its joint alone: no weight; an unbreakable bond keeps full contact.
Model<2> block_on_mortar(double beta, double mass_damping) {
  Scene scene(Bonded{1e9, 4e8, 0.6, beta, 1e12, 1e12});
  scene.set_gravity({0, 0});
  scene.builder.mass_damping = mass_damping;
  scene.fixed("base", box(-2, -1, 2, 0));
  scene.block("block", box(-0.2, 0, 0.2, 1.2), 1152);
  return scene.builder.build();
}

}  // namespace

TEST_CASE("a mass on a spring with a dashpot has c / (2 sqrt(k m)) of critical damping") {
  for (const double share : {0.01, 0.3}) {
    const double k = 1e6, m = 250, c = share * 2 * std::sqrt(k * m);
    std::vector<Mode> found;
    const auto damping = damping_of(MassOnLaw{Linear{k, c}, m}.model(), 1, found);
    REQUIRE(damping.size() == 1);
    CHECK(near(damping[0].bearings, share, 1e-6));
    CHECK(near(damping[0].total(), share, 1e-6));
    CHECK(near_zero(damping[0].contacts, 1e-9));
  }
}

TEST_CASE("damping of a joint in proportion to its stiffness gives each mode beta w / 2") {
  const double beta = 2e-5;
  std::vector<Mode> found;
  const auto damping = damping_of(block_on_mortar(beta, 0), 3, found);
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(near(damping[i].contacts, 0.5 * beta * std::sqrt(found[i].square), 1e-4));
    CHECK(near_zero(damping[i].mass, 0));
  }
}

TEST_CASE("damping of the mass gives each mode its part over twice its frequency") {
  std::vector<Mode> found;
  const auto damping = damping_of(block_on_mortar(0, 1.5), 3, found);
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(near(damping[i].mass, 1.5 / (2 * std::sqrt(found[i].square)), 1e-12));
    CHECK(near_zero(damping[i].contacts, 1e-9));
  }
}

TEST_CASE("damping of a frame's material gives each mode beta w / 2") {
  const double beta = 1e-4;
  BodySpec spec = beam_body("beam", {0, 0}, {3, 0}, rectangle_section(0.1, 0.2), "steel", 8);
  spec.frame->joints[0].support.fill(Support::fixed);
  std::vector<Mode> found;
  const auto damping = damping_of(of_frames(elastic_material("steel", 7850, 2.1e11, 0, beta), {spec}), 3, found);
  for (std::size_t i = 0; i < found.size(); ++i)
    CHECK(near(damping[i].elements, 0.5 * beta * std::sqrt(found[i].square), 1e-3));
}

TEST_CASE("an unsupported body has no damping ratio") {
  std::vector<Mode> found;
  BodySpec spec = beam_body("beam", {0, 0}, {3, 0}, rectangle_section(0.1, 0.2), "steel", 4);
  const auto damping = damping_of(of_frames(elastic_material("steel", 7850, 2.1e11), {spec}), 2, found);
  for (const ModeDamping& d : damping) CHECK(std::abs(d.total()) < 1e-9);
}

}  // namespace trilith::testing
