// Two hundred random stones poured into a box.
#include <algorithm>

#include "geometry/plane/random_convex.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

// Fewer stones under sanitizers, which are slower.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int stones = 40;
#else
constexpr int stones = 200;
#endif
constexpr double box_width = 6, wall_height = 12;

/// Random polygons in rows above the floor of a box of three fixed walls, without initial contacts.
Simulation<2> pour(int count) {
  Scene scene(Frictional{5e7, 2.5e7, 0.5, 1e-3});
  scene.fixed("floor", rectangle({-1, -1}, {box_width + 1, 0}));
  scene.fixed("left", rectangle({-1, 0}, {0, wall_height}));
  scene.fixed("right", rectangle({box_width, 0}, {box_width + 1, wall_height}));
  std::mt19937_64 bits(41);
  RandomConvex wanted;
  wanted.smallest = 0.3, wanted.largest = 0.5, wanted.slenderest = 1.5;
  const int columns = 10;
  const double pitch = box_width / columns;
  for (int i = 0; i < count; ++i) {
    BodySpec stone;
    stone.name = "stone" + std::to_string(i);
    const Vec2 place((i % columns + 0.5) * pitch, 0.4 + 0.56 * (i / columns));
    stone.outline = placed(random_convex(bits, wanted), random_direction(bits), place);
    stone.velocity = {random_between(bits, -1, 1), -1};
    stone.spin = random_between(bits, -3, 3);
    stone.floating = true;
    scene.add(stone);
  }
  return scene.start();
}

}  // namespace

TEST_CASE("200 random polygons poured into a box come to rest in it") {
  Simulation<2> sim = pour(stones);
  // Pour; then damp the remaining rocking: stiffness damping reduces a slow rocking tenfold in about six seconds only.
  StageOptions fall, calm;
  fall.name = "fall";
  fall.duration = 2.5;
  fall.energy_interval = calm.energy_interval = 0.25;
  calm.name = "calm";
  calm.duration = 20;
  calm.rest_share = 0.8;
  calm.until_rest = true;
  calm.still_speed = 1e-5;
  Energy first, last;
  double worst = 0;
  bool any = false;
  RunListener<2> listener;
  listener.on_energy = [&](const Instant<2>&, const Energy& e) {
    if (!any) first = e, any = true;
    last = e;
    worst = std::max(worst, std::abs(e.balance() - first.balance()));
  };
  sim.run(fall, listener);
  const StageReport report = sim.run(calm, listener);
  const double left = std::abs(last.balance() - first.balance());
  const double passed = first[EnergyTerm::kinetic] - last[EnergyTerm::gravity];
  MESSAGE("at rest after ", report.ended, " s: ", std::string(name_of(report.end)), ", speed ", report.speed,
          " m/s, ratio ", report.ratio, "; ", passed, " J supplied, residual ", left, " J (", left / passed,
          "), at worst ", worst, " J");
  CHECK(report.end == StageEnd::rest);
  CHECK(report.speed < 1e-5);
  const Model<2>& model = sim.model();
  int outside = 0;
  for (const Body& body : model.bodies) {
    if (!model.moves(body.first_node)) continue;
    const Vec2& p = sim.state().position[body.first_node];
    outside += p.x() < 0 || p.x() > box_width || p.y() < 0 || p.y() > wall_height ? 1 : 0;
  }
  CHECK(outside == 0);
  CHECK(left < 0.01 * passed);
}
