// Breaking bearings in a model: reported once, booked in the ledger, and the bearing object stays.
#include <doctest/doctest.h>

#include "near.hpp"
#include "physics/scene.hpp"

namespace trilith {
namespace {

using testing::box;
using testing::near;
using testing::Scene;

struct Broken {
  BearingStatus status = BearingStatus::intact;
  int told = 0, ended = 0;
  double told_at = 0;  ///< displacement at the event [m]
  double dissipated = 0, force = 0, speed = 0;
};

/// A mass that moves off along x at 2 m/s from a base, held by `law`.
Broken fly_off(const DirectionLaw& law) {
  Scene scene(Frictional{1e6, 1e6, 0.5, 0});
  scene.set_gravity({0, 0});
  scene.fixed("base", box(-1, -1, 1, 0));
  BodySpec body;
  body.name = "mass", body.outline = box(-0.5, 1, 0.5, 2), body.mass = 1000, body.velocity = {2, 0};
  body.support = {Support::free, Support::free, Support::fixed};
  scene.add(body);
  scene.builder.set_contact("*", "*", "none");
  BearingSpec link;
  link.name = "link", link.body_a = "base", link.body_b = "mass";
  link.point_a = link.point_b = {0, 0.5};
  link.law = {law, {}, {}};
  scene.builder.add_bearing(link);
  Simulation<2> sim(scene.builder.build());
  Broken seen;
  RunListener<2> listener;
  listener.on_event = [&](const Event& e, const Instant<2>&) {
    if (e.type == EventType::bearing_yielded) ++seen.told, seen.told_at = e.value;
    if (e.type == EventType::bearing_failed) ++seen.ended;
  };
  testing::run_for(sim, 0.2, 1e-5, listener);
  seen.status = sim.state().bearing[0].status;
  seen.dissipated = sim.state().given[EnergyTerm::bearing_inner];
  seen.force = sim.work().bearing_force[0].norm();
  seen.speed = sim.state().velocity[1].x();
  return seen;
}

TEST_CASE(
    "a broken cable or key is reported once as yielded and dissipates its stored energy, and its bearing remains") {
  const double k = 1e6, strength = 2e4, slack = 0.01, mass = 1000;
  const double stored = 0.5 * strength * strength / k;
  for (const DirectionLaw& law :
       {DirectionLaw(Cable{k, slack, 0, strength, 0, 1}), DirectionLaw(ShearKey{k, strength, 0, 0})}) {
    const Broken seen = fly_off(law);
    const double from = std::holds_alternative<Cable>(law) ? slack : 0;
    CHECK(seen.status == BearingStatus::yielded);
    CHECK(seen.told == 1);
    CHECK(seen.ended == 0);
    CHECK(near(seen.told_at, from + strength / k, 2e-3));
    CHECK(near(seen.dissipated, stored, 2e-3));
    CHECK(seen.force == 0);
    CHECK(near(0.5 * mass * (4 - seen.speed * seen.speed), stored, 2e-3));
  }
}

}  // namespace
}  // namespace trilith
