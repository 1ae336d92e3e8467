// VALIDATION F12: a short bar hits a long one.
#include <algorithm>

#include "model/pose.hpp"
#include "near.hpp"
#include "physics/space/solids.hpp"

namespace trilith::testing {
namespace {

TEST_CASE("F12: a bar that hits one of twice its length stops, and half of its energy is vibration of the other") {
  const double young = 30e9, density = 2400, deep = 0.1, speed = 1;
  Scene scene(Frictional{1e14, 0, 0, 0});
  scene.set_gravity(Vec2::Zero());
  scene.builder.apart_time = 0;  // the end of contact is reported at once
  scene.builder.add_material(elastic("concrete", density, young, 0));
  BodySpec brief = grid_body("short", rectangle({-5 - 1e-6, 0}, {-1e-6, deep}), "concrete", 100, 1);
  brief.velocity = {speed, 0};
  scene.add(brief);
  scene.add(grid_body("long", rectangle({0, 0}, {10, deep}), "concrete", 200, 1));
  Simulation<2> sim = scene.start();
  const Model<2>& model = sim.model();
  double made = -1, lost = -1;
  StageOptions options;
  options.duration = 3.4e-3;
  sim.run(options, each_step([&](const Instant<2>& now) {
            for (const Event& e : now.work.events) {
              if (made < 0 && (e.type == EventType::contact_made || e.type == EventType::impact)) made = e.time;
              if (e.type == EventType::contact_lost) lost = e.time;
            }
          }));
  sim.refresh();
  const Pose a = body_pose(model, sim.state(), 0), b = body_pose(model, sim.state(), 1);
  // Kinetic and strain energy of the short bar.
  double moving = 0, strained = 0;
  const Body& bar = model.bodies[0];
  for (int n = bar.first_node; n < bar.first_node + bar.nodes; ++n)
    moving += 0.5 * model.mass[n] * sim.state().velocity[n].squaredNorm();
  for (int e = 0; e < 100; ++e) {
    const double s = element_stress(model, sim.state(), e).mean.xx;
    strained += 0.5 * s * s / young * bar.area / 100;
  }
  const double put_in = 0.5 * density * bar.area * speed * speed;
  const double carried = density * bar.area * b.velocity.squaredNorm(),
               rings =
                   sim.energy()[EnergyTerm::kinetic] + sim.energy()[EnergyTerm::strain] - moving - strained - carried;
  MESSAGE(fmt::format(
      "F12: in contact for {:.4f} ms (2.8284); short bar {:.4f} m/s, {:.4f} of the energy moves it and "
      "{:.4f} strains it; long one {:.4f} m/s (.5), {:.4f} of the energy rings in it (.5)",
      (lost - made) * 1e3, a.velocity.x(), moving / put_in, strained / put_in, b.velocity.x(), rings / put_in));
  CHECK(near(lost - made, 2.8284e-3, 0.03));
  CHECK(std::abs(a.velocity.x()) < 0.03 * speed);
  CHECK(moving < 0.03 * put_in);
  CHECK(strained < 0.03 * put_in);
  CHECK(near(b.velocity.x(), 0.5 * speed, 0.03));
  CHECK(near((b.velocity.x() - a.velocity.x()) / speed, 0.5, 0.03));
  CHECK(near(rings / put_in, 0.5, 0.03));
}

}  // namespace
}  // namespace trilith::testing
