// Growing weight, and contacts that separate only for a moment.
#include <doctest/doctest.h>

#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A block of 1000 kg released `height` [m] above a fixed base.
Scene falling_block(double height) {
  Scene scene(Frictional{1e8, 5e7, 0.5, 0});
  scene.fixed("base", {{-1, -1}, {1, -1}, {1, 0}, {-1, 0}});
  BodySpec block;
  block.name = "block", block.mass = 1000, block.floating = true;
  block.outline = {{-0.5, height}, {0.5, height}, {0.5, height + 1}, {-0.5, height + 1}};
  scene.add(block);
  return scene;
}

struct Count {
  int made = 0, lost = 0;
};

Count contacts_of(Scene& scene, double duration) {
  Count count;
  Simulation<2> sim = scene.start();
  run_for(sim, duration, 0, each_step([&](const Instant<2>& now) {
            for (const Event& e : now.work.events) {
              if (e.type == EventType::contact_made || e.type == EventType::impact) ++count.made;
              if (e.type == EventType::contact_lost) ++count.lost;
            }
          }));
  return count;
}

}  // namespace

TEST_CASE("bounces shorter than the model's apart_time are one contact, longer ones are lost and made again") {
  // Dropped by 0.1 mm, a block with undamped contact is off the base for 2 sqrt(2 h / g) = 9 ms after each bounce.
  for (const double apart : {0.0, 0.005, 0.02}) {
    CAPTURE(apart);
    Scene scene = falling_block(1e-4);
    scene.builder.apart_time = apart;
    const Count count = contacts_of(scene, 0.5);
    CHECK(count.made == (apart < 0.009 ? count.lost + (count.made > count.lost ? 1 : 0) : 1));
    CHECK((count.lost > 10) == (apart < 0.009));
  }
}

TEST_CASE(
    "weight that grows slowly presses a block into its joint without overshoot, weight that is there at once by half") {
  const double resting = 1000 * standard_gravity / 1e8;
  for (const bool grows : {true, false}) {
    Scene scene = falling_block(0);
    Simulation<2> sim = scene.start();
    if (grows) sim.edit_model().gravity.grow_end = 0.5;
    double deepest = 0;
    run_for(sim, 0.6, 0, each_step([&](const Instant<2>& now) {
              deepest = std::max(deepest, 0.5 - now.state.position[node_of(now.model, "block")].y());
            }));
    CHECK(near(deepest, grows ? resting : 2 * resting, 0.03));
  }
}
