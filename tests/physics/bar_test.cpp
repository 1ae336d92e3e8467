// Bars of many elements: waves, impacts, spin.
#include "model/check/energy_check.hpp"
#include "near.hpp"
#include "physics/space/solids.hpp"

namespace trilith::testing {
namespace {

constexpr double young = 30e9, density = 2400, length = 10, deep = 0.1;

Polygon bar(double x) {
  return rectangle({x, 0}, {x + length, deep});
}

/// Mean stress sxx of the elements between two start positions x [m].
double stress_between(const Model<2>& model, const State<2>& state, double from, double to) {
  double sum = 0;
  int count = 0;
  for (int e = 0; e < static_cast<int>(model.elements.size()); ++e) {
    const double x = 0.5 * (model.start_position[model.elements[e].node[0]].x() +
                            model.start_position[model.elements[e].node[2]].x());
    if (x < from || x > to) continue;
    sum += element_stress(model, state, e).mean.xx;
    ++count;
  }
  return sum / count;
}

TEST_CASE("B7: a wave runs along a bar at sqrt(E/rho) with the stress rho c v, and is back after 2 L/c") {
  const double c = std::sqrt(young / density), speed = 1;
  const Model<2> made = alone(elastic("m", density, young, 0), grid_body("bar", bar(0), "", 200, 1));
  Model<2> model = made;
  // The struck end moves at 1 m/s from the start on.
  const auto moving = std::make_shared<GroundMotion>(std::vector<double>(2000, 0.0), 1e-5, MotionStart{speed, 0});
  for (const double y : {0.0, deep}) {
    const int n = node_at(model, {0, y});
    model.support[n][0] = Support::driven;
    model.drive_of[n][0] = static_cast<int>(model.drives.size());
    model.drives.push_back({n, 0, 0, 0, moving});
  }
  Simulation<2> sim(model);
  EnergyCheck check;
  StageOptions options;
  options.duration = 8e-3, options.energy_interval = 1e-4;
  const int free_end = node_at(model, {length, 0});
  double arrival = -1, back = -1, stress = 0;
  RunListener<2> listener = each_step([&](const Instant<2>& now) {
    if (arrival < 0 && now.state.velocity[free_end].x() > speed) arrival = now.state.time;
    // Behind the front the whole bar is compressed; the front reflected at the free end unloads it.
    if (now.state.time > 0.4 * length / c && stress == 0)
      stress = stress_between(now.model, now.state, 0.1 * length, 0.3 * length);
    if (back < 0 && now.state.time > 1.2 * length / c &&
        stress_between(now.model, now.state, 0, 0.02 * length) > -0.5 * density * c * speed)
      back = now.state.time;
  });
  double first = 0;
  bool begun = false;
  listener.on_energy = [&](const Instant<2>&, const Energy& e) {
    if (!begun) first = e.balance(), begun = true;
    check.add(e, e.balance() - first);
  };
  sim.run(options, listener);
  MESSAGE("front at the far end after ", arrival * 1e3, " ms (", length / c * 1e3, "), stress ", -stress * 1e-6,
          " MPa (", density * c * speed * 1e-6, "), back after ", back * 1e3, " ms (", 2e3 * length / c,
          "), energy residual ", 100 * check.share(), " %");
  CHECK(near(arrival, length / c, 0.02));
  CHECK(near(-stress, density * c * speed, 0.02));
  CHECK(near(back, 2 * length / c, 0.02));
  CHECK(check.share() < 1e-3);
}

TEST_CASE("B8: two equal bars touch for 2 L/c under rho c v/2, and swap their speeds") {
  const double c = std::sqrt(young / density), speed = 1;
  Scene scene(Frictional{1e14, 0, 0, 0});
  scene.set_gravity(Vec2::Zero());
  scene.builder.apart_time = 0;  // the end of contact is reported at once
  scene.builder.add_material(elastic("concrete", density, young, 0));
  BodySpec left = grid_body("left", bar(-length - 1e-6), "concrete", 100, 1);
  left.velocity = {speed, 0};
  scene.add(left);
  scene.add(grid_body("right", bar(0), "concrete", 100, 1));
  Simulation<2> sim = scene.start();
  double made = -1, lost = -1, stress = 0, square = 0;
  StageOptions options;
  options.duration = 7e-3;
  sim.run(options, each_step([&](const Instant<2>& now) {
            for (const Event& e : now.work.events) {
              if (made < 0 && (e.type == EventType::contact_made || e.type == EventType::impact)) made = e.time;
              if (e.type == EventType::contact_lost) lost = e.time;
            }
            if (made > 0 && now.state.time - made > 0.3 * length / c && stress == 0)
              stress = -stress_between(now.model, now.state, 0.02 * length, 0.2 * length);
            square = now.state.time;
          }));
  const Pose a = body_pose(sim.model(), sim.state(), 0), b = body_pose(sim.model(), sim.state(), 1);
  MESSAGE("in contact for ", (lost - made) * 1e3, " ms (", 2e3 * length / c, "), stress ", stress * 1e-6, " MPa (",
          0.5e-6 * density * c * speed, "), speeds ", a.velocity.x(), " and ", b.velocity.x());
  CHECK(near(lost - made, 2 * length / c, 0.03));
  CHECK(near(stress, 0.5 * density * c * speed, 0.03));
  CHECK(std::abs(a.velocity.x()) < 0.03 * speed);
  CHECK(near(b.velocity.x(), speed, 0.03));
}

TEST_CASE("B2: a spinning bar keeps its stretch, its energy and its angular momentum for ten turns") {
  const double long_ = 1, soft = 1e7, light = 1000, spin = 10;
  BodySpec spec = grid_body("bar", rectangle({-0.5, -0.02}, {0.5, 0.02}), "", 20, 1);
  spec.spin = spin;
  const Model<2> model = alone(elastic("m", light, soft, 0), spec);
  State<2> state = initial_state(model);
  // The bar starts with its stretch u(x) = rho w^2 (L^2/4 x - x^3/3)/(2 E).
  for (int n = 0; n < model.nodes(); ++n) {
    const double x = model.start_position[n].x();
    state.position[n].x() += light * spin * spin * (long_ * long_ / 4 * x - x * x * x / 3) / (2 * soft);
    state.velocity[n] = cross(spin, state.position[n]);
  }
  const auto angular = [&](const State<2>& s) {
    double sum = 0;
    for (int n = 0; n < model.nodes(); ++n) sum += model.mass[n] * cross(s.position[n], s.velocity[n]);
    return sum;
  };
  const double momentum = angular(state);
  Simulation<2> sim(model, state);
  double least = 1e9, most = 0, low = 1e9, high = 0, worst = 0;
  StageOptions options;
  options.duration = 10 * 2 * M_PI / spin;
  options.energy_interval = 0.01;
  options.safety = 0.9;
  RunListener<2> listener = each_step([&](const Instant<2>& now) {
    if (now.state.step % 50 != 0) return;
    double middle = 0;
    for (int e = 0; e < 20; ++e) {
      const double x = 0.5 * (model.start_position[model.elements[e].node[0]].x() +
                              model.start_position[model.elements[e].node[1]].x());
      if (std::abs(x) < 0.05) middle += 0.5 * element_stress(now.model, now.state, e).mean.xx;
    }
    least = std::min(least, middle), most = std::max(most, middle);
    worst = std::max(worst, std::abs(angular(now.state) / momentum - 1));
  });
  listener.on_energy = [&](const Instant<2>&, const Energy& e) {
    const double all = e[EnergyTerm::kinetic] + e[EnergyTerm::strain];
    low = std::min(low, all), high = std::max(high, all);
  };
  sim.run(options, listener);
  MESSAGE("stress in the middle ", least, " to ", most, " Pa (12500), energy drift ", 100 * (high / low - 1),
          " %, angular momentum ", 100 * worst, " %");
  CHECK(near(least, 12500, 0.02));
  CHECK(near(most, 12500, 0.02));
  CHECK(high / low - 1 < 0.01);
  CHECK(worst < 1e-3);
}

}  // namespace
}  // namespace trilith::testing
