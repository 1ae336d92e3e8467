// Rates of a bearing against differences of its displacements, and its limits in both senses.
#include <doctest/doctest.h>

#include "assembly/bearing_motion.hpp"
#include "near.hpp"
#include "physics/scene.hpp"
#include "physics/space/solids.hpp"

using namespace trilith;
using testing::box;
using testing::near_zero;
using testing::Scene;

namespace {

/// Two free bodies, rigid or of one element each, without gravity and contact. The link joins points 1.4 m apart.
Scene turning_pair(BearingSpec link, const Vec2& velocity = {0.4, -0.1}, double spin = 0.7, bool deforms = false) {
  Scene scene(Frictional{1e6, 1e6, 0.5, 0});
  scene.set_gravity({0, 0});
  BodySpec a, b;
  a.name = "a", a.outline = box(0, 0, 1, 0.6), a.mass = 120, a.velocity = velocity, a.spin = spin;
  b.name = "b", b.outline = box(2, 0, 3, 1), b.mass = 75, b.velocity = -1.2 * velocity, b.spin = -1.6 * spin;
  if (deforms) {
    scene.builder.add_material(testing::elastic("soft", 100, 1e6, 0.2));
    for (BodySpec* body : {&a, &b}) body->kind = BodyKind::quad, body->material = "soft", body->mass.reset();
  }
  scene.add(a), scene.add(b);
  link.name = "link", link.body_a = "a", link.body_b = "b", link.point_a = {1, 0.3}, link.point_b = {2.4, 0.1};
  scene.builder.add_bearing(link);
  scene.builder.set_contact("*", "*", "none");
  return scene;
}

}  // namespace

TEST_CASE("the rates of a bearing between turning bodies are the derivatives of its displacements") {
  BearingSpec link;
  link.law = {Linear{4e3, 30}, Linear{2e3, 10}, Linear{500, 5}}, link.angle = 0.4;
  for (const bool deforms : {false, true}) {
    CAPTURE(deforms);
    const Model<2> model = turning_pair(link, {0.4, -0.1}, 0.7, deforms).builder.build();
    const State<2> state = initial_state(model);
    constexpr double h = 1e-5;
    const auto later = [&](double time) {
      State<2> moved = state;
      for (std::size_t n = 0; n < moved.position.size(); ++n)
        moved.position[n] += time * moved.velocity[n], moved.rotation[n] += time * moved.spin[n];
      return bearing_motion(model, moved, 0).displacement;
    };
    const auto before = later(-h), after = later(h);
    const BearingMotion<2> now = bearing_motion(model, state, 0);
    for (std::size_t k = 0; k < 3; ++k) CHECK(near_zero(now.rate[k] - (after[k] - before[k]) / (2 * h), 1e-8));
  }
}

TEST_CASE("a bearing fails at its limit in either sense") {
  for (const double sense : {1.0, -1.0}) {
    CAPTURE(sense);
    BearingSpec link;
    link.law = {Linear{4e3, 0}, Linear{4e3, 0}, Linear{500, 0}}, link.limit[along] = 0.01;
    Simulation<2> sim(turning_pair(link, {-0.1 * sense, 0}, 0).builder.build());
    testing::run_for(sim, 0.02, 1e-3);
    CHECK(sim.state().bearing[0].status == BearingStatus::intact);
    testing::run_for(sim, 0.06, 1e-3);
    CHECK(sim.state().bearing[0].status == BearingStatus::failed);
  }
}
