// A bearing that replaces the contact of its two bodies, on springs so soft that the bodies sink into each other: as
// they tilt, contact begins from zero force.
#include <doctest/doctest.h>

#include <cmath>

#include "model/io/state_words.hpp"
#include "model/space_builder/solid_model_builder.hpp"
#include "near.hpp"
#include "physics/scene.hpp"
#include "physics/space/solid_bodies.hpp"

namespace trilith {
namespace {

using testing::near;
using testing::near_zero;

/// Fixed steps in either dimension.
template <int D>
struct Steps {
  Steps(const Model<D>& m, const State<D>& s, double dt) : model(m), state(s) {
    options.dt = dt;
    evaluate(model, state, work, state.last_dt);
  }
  Steps(const Model<D>& m, double dt) : Steps(m, initial_state(m), dt) {}
  void step() {
    commit(model, state, work);
    advance(model, state, work, options);
    evaluate(model, state, work, state.last_dt);
  }
  [[nodiscard]] Energy energy() const { return energy_now(model, state, work, options); }
  [[nodiscard]] bool touches() const { return !work.general_touching.empty(); }

  Model<D> model;
  State<D> state;
  Work<D> work;
  StepOptions options;
};

/// Results of a rocking block.
struct Rocking {
  double residual = 0;     ///< largest change of the balance [J]
  double tilt = 0;         ///< [rad]
  double deepest = 0;      ///< largest penetration replaced by the bearings [m]
  double first_force = 0;  ///< at the first contact [N]
  int touched = 0;         ///< number of steps with contact
};

double tilt_of(const State<2>& state) {
  return std::abs(state.rotation[1]);
}
double tilt_of(const State<3>& state) {
  return std::acos(std::min(1.0, turn_of(state.rotation[1]).z().z()));
}

template <int D>
Rocking rock(Steps<D>& run, double seconds) {
  Rocking seen;
  const double begin = run.energy().balance();
  for (const double end = run.state.time + seconds; run.state.time < end;) {
    const bool touched = run.touches();
    run.step();
    seen.residual = std::max(seen.residual, std::abs(run.energy().balance() - begin));
    seen.tilt = std::max(seen.tilt, tilt_of(run.state));
    for (const BearingMemory<D>& b : run.work.bearing) seen.deepest = std::max(seen.deepest, b.stood_for);
    if (!run.touches()) continue;
    if (!touched && seen.touched == 0) seen.first_force = run.work.general_touching[0].force.norm();
    ++seen.touched;
  }
  return seen;
}

constexpr double sinking_springs = 2.94e6;  // of each of two [N/m]: 4,800 kg sink by 8 mm at rest, and by 16 mm when
                                            // released

/// A block of 4,800 kg, 1 m wide and 2 m high, on two springs 0.8 m apart.
Model<2> block_on_springs(double stiffness, double spin) {
  testing::Scene scene(Frictional{1e9, 5e8, 0.5, 0});
  scene.fixed("base", testing::box(-2, -0.5, 3, 0));
  BodySpec block;
  block.name = "block", block.outline = testing::box(0, 0, 1, 2), block.mass = 4800, block.spin = spin;
  scene.add(block);
  for (const double x : {0.1, 0.9}) {
    BearingSpec spring;
    spring.name = x < 0.5 ? "left" : "right", spring.body_a = "base", spring.body_b = "block";
    spring.point_a = spring.point_b = {x, 0};
    spring.law = {Linear{stiffness, 0}, Linear{stiffness, 0}, Linear{0, 0}};
    spring.replaces_contact = true;
    scene.builder.add_bearing(spring);
  }
  return scene.builder.build();
}

/// The same in space, 1 m deep, on four springs.
Model<3> stone_on_springs(double stiffness, const Vec3& spin) {
  SolidModelBuilder builder;
  const auto solid = [](const std::string& name, const Vec3& sides, const Vec3& centre) {
    SolidSpec spec;
    spec.name = name, spec.pieces = {testing::box_at(sides, centre)}, spec.mass = 4800, spec.floating = true;
    return spec;
  };
  SolidSpec base = solid("base", {5, 5, 0.5}, {0, 0, -0.25}), block = solid("block", {1, 1, 2}, {0, 0, 1});
  base.support.fill(Support::fixed);
  block.spin = spin;
  builder.add_body(base), builder.add_body(block);
  builder.add_law("rough", Frictional{1e9, 5e8, 0.5, 0});
  builder.set_contact("*", "*", "rough");
  const Linear half{stiffness / 2, 0}, none{0, 0};
  for (const double x : {-0.4, 0.4})
    for (const double y : {-0.4, 0.4}) {
      BearingSpecOf<3> spring;
      spring.name = "spring" + std::to_string(x) + std::to_string(y), spring.body_a = "base", spring.body_b = "block";
      spring.point_a = spring.point_b = Vec3(x, y, 0);
      spring.law = {half, half, half, none, none, none};
      spring.replaces_contact = true;
      builder.add_bearing(spring);
    }
  return builder.build();
}

/// During rocking the springs alone carry the block as long as no corner penetrates deeper than the bearings; contact
/// then begins without an impact, and the ledger closes. Contact over the full penetration of 8 mm at once would store
/// 32 kJ.
template <int D>
void check_rocking(const Rocking& seen, double put_in) {
  CAPTURE(seen.residual);
  CAPTURE(seen.tilt);
  CAPTURE(seen.deepest);
  CAPTURE(seen.first_force);
  CAPTURE(seen.touched);
  CHECK(seen.tilt > face_pair_max_tilt);
  CHECK(seen.deepest > 0.008);
  CHECK(seen.deepest < 0.03);
  CHECK(seen.touched > 0);
  CHECK(seen.first_force < 0.02 * 1e9 * 0.008);  // of the contact force of 8 mm over its base
  CHECK(seen.residual < 2e-3 * put_in);
}

TEST_CASE("a bearing replaces contact: a block that rocks on soft springs gains no energy from its settlement") {
  const double weight = 4800 * standard_gravity, put_in = weight * 0.016;
  SUBCASE("in the plane") {
    for (const double spin : {0.3, 1.0}) {
      Steps<2> run(block_on_springs(sinking_springs, spin), 2e-5);
      check_rocking<2>(rock(run, 1.0), put_in + 0.5 * 2000 * spin * spin);
    }
  }
  SUBCASE("in space") {
    for (const Vec3& spin : {Vec3(0, 0.6, 0), Vec3(0.7, 0.4, 0.2)}) {
      Steps<3> run(stone_on_springs(sinking_springs, spin), 2e-5);
      check_rocking<3>(rock(run, 0.5), put_in + 0.5 * 2000 * spin.squaredNorm());
    }
  }
}

TEST_CASE("a bearing replaces contact: on stiff springs a block rocks on its corner as it would without") {
  // Springs that compress by 3 um replace almost no contact. An edge at 0.5 m off the middle penetrates no deeper than
  // by the rotation of the block on the springs, 0.5 sqrt(2000 / (2 1e10 0.4^2)) rad at most.
  Steps<2> run(block_on_springs(1e10, 0.5), 2e-6);
  const Rocking seen = rock(run, 0.05);
  CHECK(seen.deepest < 0.5 * 0.5 * std::sqrt(2000 / 3.2e9) + 5e-6);
  CHECK(seen.tilt < 0.002);
  CHECK(seen.residual < 1e-3 * 250);
}

TEST_CASE("a bearing replaces contact: shared contact is released when the bodies separate") {
  Steps<2> run(block_on_springs(sinking_springs, 0), 2e-5);
  double lowest = 0;
  for (int i = 0; i < 20000; ++i) {
    run.step();
    const double sunk = run.model.start_position[1].y() - run.state.position[1].y();
    lowest = std::max(lowest, sunk);
    // Flat at all times: the bearing replaces the current penetration, and there is no contact.
    CHECK(near_zero(run.work.bearing[0].stood_for - std::max(0.0, sunk), 1e-9));
    CHECK_FALSE(run.touches());
  }
  CHECK(near(lowest, 0.016, 1e-2));
  run.state.velocity[1].y() = 1;  // upwards by 18 mm and more
  bool parted = false;
  for (int i = 0; i < 5000; ++i) run.step(), parted = parted || run.work.bearing[1].stood_for == 0;
  CHECK(parted);
}

template <int D>
void check_kept(Steps<D> run) {
  while (!run.touches()) run.step();
  commit(run.model, run.state, run.work);
  REQUIRE(run.state.bearing[0].stood_for > 0);
  const State<D> again = state_from_words(run.model, state_words(run.state), "checkpoint");
  CHECK(again.bearing[0].stood_for == run.state.bearing[0].stood_for);
  CHECK(state_hash(again) == state_hash(run.state));
  Steps<D> on(run.model, again, run.options.dt), dropped(run.model, again, run.options.dt);
  for (int i = 0; i < 500; ++i) {
    on.step();
    dropped.step();
    dropped.work = {}, evaluate(dropped.model, dropped.state, dropped.work, dropped.state.last_dt);
  }
  CHECK(state_hash(on.state) == state_hash(dropped.state));
}

TEST_CASE(
    "a bearing replaces contact: the replaced contact is saved, and freeing scratch memory does not change the "
    "results") {
  check_kept(Steps<2>(block_on_springs(sinking_springs, 1.0), 2e-5));
  check_kept(Steps<3>(stone_on_springs(sinking_springs, {0.7, 0.4, 0.2}), 2e-5));
}

}  // namespace
}  // namespace trilith
