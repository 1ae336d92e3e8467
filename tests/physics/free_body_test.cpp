// VALIDATION T4: a rigid body that spins freely in space, with weight, supports and checkpoints.
#include "physics/free_bodies.hpp"

#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "model/io/checkpoint.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

const Vec3 t4_inertia(1, 2, 3), t4_spin(0.1, 2, 0.1);
const UnitQuaternion askew = rotation_by({0.3, -1.2, 2.1});

/// Times of the sign changes of the spin about the middle axis [s].
std::vector<double> tumbles(FreeRun& run, double dt, double until) {
  std::vector<double> out;
  double before = run.own_spin()[1];
  for (double t = dt; t < until; t += dt) {
    run.step();
    const double now = run.own_spin()[1];
    if (before * now < 0) out.push_back(t - dt * now / (now - before));
    before = now;
  }
  return out;
}

/// T4 in a world turned by `rotation`.
FreeRun t4_run(const UnitQuaternion& rotation, double dt) {
  return {free_body(5, t4_inertia, rotation, Turn3(rotation).apply(t4_spin)), dt};
}

std::filesystem::path file_named(const char* name) {
  return std::filesystem::temp_directory_path() / (std::string(name) + std::to_string(::getpid()) + ".state");
}

}  // namespace

TEST_CASE("T4: a body spun about its middle axis turns over at 4.058 and 11.035 and 18.011 s") {
  FreeRun run = t4_run({}, 0.01);
  const Vec3 momentum = run.momentum();
  CHECK(near(momentum.norm(), 4.01248, 1e-5));
  CHECK(near(run.energy()[EnergyTerm::kinetic], 4.02, 1e-12));
  const std::vector<double> times = tumbles(run, 0.01, 20);
  REQUIRE(times.size() == 3);
  CHECK(near(times[0], 4.058, 5e-3));
  CHECK(near(times[1], 11.035, 5e-3));
  CHECK(near(times[2], 18.011, 5e-3));
}

TEST_CASE("T4: energy and angular momentum are conserved for 40 s") {
  FreeRun run = t4_run(askew, 0.01);
  const Vec3 momentum = run.momentum();
  for (int i = 0; i < 4000; ++i) {
    run.step();
    REQUIRE(near(run.energy()[EnergyTerm::kinetic], 4.02, 1e-3));
    REQUIRE((run.momentum() - momentum).norm() < 1e-11 * momentum.norm());  // rounding over 4000 steps
  }
}

TEST_CASE("a body tumbles the same way in a frame rotated by any angle") {
  FreeRun plain = t4_run({}, 0.01), turned = t4_run(askew, 0.01);
  plain.steps(500), turned.steps(500);
  const UnitQuaternion expected = askew * plain.state().rotation[0], found = turned.state().rotation[0];
  const UnitQuaternion between = inverse(expected) * found;
  CHECK(angle_of(between).norm() < 1e-9);  // a tumbling body amplifies rounding a thousandfold in 5 s
}

TEST_CASE("half the step gives a quarter of the error of a tumbling body") {
  const auto rotation_at = [](double dt) {
    FreeRun run = t4_run({}, dt);
    run.steps(static_cast<int>(std::lround(3 / dt)));
    return run.state().rotation[0];
  };
  const UnitQuaternion exact = rotation_at(0.0005);
  const auto error = [&](double dt) { return angle_of(inverse(exact) * rotation_at(dt)).norm(); };
  const double coarse = error(0.02), fine = error(0.01);
  CHECK(coarse > 1e-5);
  CHECK(coarse / fine > 3.9);
  CHECK(coarse / fine < 4.1);
}

TEST_CASE("the axis of a symmetric body precesses at (J3 - J1) / J1 of its spin") {
  const Vec3 inertia(2, 2, 3), spin(0.2, 0, 4);
  FreeRun run(free_body(1, inertia, {}, spin), 0.002);
  const double rate = (3.0 - 2) / 2 * 4;
  for (const double t : {0.5, 1.0, 1.5}) {
    run.steps(250);
    CHECK(near(run.own_spin()[0], 0.2 * std::cos(rate * t), 2e-3));
    CHECK(near(run.own_spin()[1], 0.2 * std::sin(rate * t), 2e-3));
    CHECK(near(run.own_spin()[2], 4, 1e-6));
  }
}

TEST_CASE("a spinning body that is thrown up falls along its parabola and its energy balance closes") {
  Model<3> model = free_body(5, t4_inertia, askew, t4_spin);
  model.gravity.field = {0, 0, -standard_gravity};
  model.start_velocity = {Vec3(1, -2, 6)};
  FreeRun run(model, 1e-3);
  const double before = run.energy().balance();
  run.steps(1000);
  // The first step is half a step longer than the age of its velocity; leapfrog sums this to g dt t / 2.
  const Vec3 x = run.state().position[0];
  CHECK(near(x.x(), 1, 1e-12));
  CHECK(near(x.y(), -2, 1e-12));
  CHECK(near(x.z(), 6 - 0.5 * standard_gravity, 2e-3));
  const Energy energy = run.energy();
  CHECK(near(energy.balance(), before, 1e-4));
  CHECK(near(energy[EnergyTerm::gravity], 5 * standard_gravity * x.z(), 1e-9));
}

TEST_CASE("a body held against roll turns about its free axis alone") {
  Model<3> model = free_body(5, t4_inertia, askew, Vec3(0, 0, 2));
  model.support[0][3] = model.support[0][4] = Support::fixed;
  FreeRun run(model, 1e-3);
  run.steps(1000);
  CHECK(run.state().spin[0] == Vec3(0, 0, 2));
  CHECK(angle_of(inverse(rotation_by({0, 0, 2}) * askew) * run.state().rotation[0]).norm() < 1e-12);
}

TEST_CASE("a tumbling body saved and continued gives the same bits as one run without interruption") {
  const Model<3> model = free_body(5, t4_inertia, askew, t4_spin);
  FreeRun whole(model, 0.01);
  whole.steps(100);
  const std::filesystem::path path = file_named("tumbling");
  save_state(whole.state(), model, path);
  FreeRun rest(model, load_state(model, path), 0.01);
  CHECK(state_hash(rest.state()) == state_hash(whole.state()));
  whole.steps(100), rest.steps(100);
  CHECK(state_hash(rest.state()) == state_hash(whole.state()));
  Model<3> heavier = model;
  heavier.mass[0] *= 2;
  CHECK_THROWS_AS(load_state(heavier, path), InputError);
  std::filesystem::remove(path);
}

TEST_CASE("every number of the motion of a body in space counts in the hash") {
  const State<3> state = initial_state(free_body(5, t4_inertia, askew, t4_spin));
  const std::uint64_t hash = state_hash(state);
  for (int k = 0; k < 3; ++k) {
    State<3> moved = state, faster = state, spun = state;
    moved.position[0][k] += 1e-9, faster.velocity[0][k] += 1e-9, spun.spin[0][k] += 1e-9;
    for (const State<3>* s : {&moved, &faster, &spun}) CHECK(state_hash(*s) != hash);
  }
  State<3> turned = state;
  turned.rotation[0].y += 1e-9;
  CHECK(state_hash(turned) != hash);
}
