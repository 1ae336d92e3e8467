// Bearings in space: invariants, rotation, closed forms, and successors after failure.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "assembly/bearing_motion.hpp"
#include "events/find_events.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "model/io/state_words.hpp"
#include "model/space_builder/solid_model_builder.hpp"
#include "near.hpp"
#include "physics/space/solid_bodies.hpp"

namespace trilith {
namespace {

using testing::box_at;
using testing::near;
using testing::near_zero;
using testing::SolidRun;

SolidSpec solid(const std::string& name, const Vec3& sides, const Vec3& centre, double mass, bool fixed = false) {
  SolidSpec spec;
  spec.name = name, spec.pieces = {box_at(sides, centre)}, spec.mass = mass, spec.floating = true;
  if (fixed) spec.support.fill(Support::fixed);
  return spec;
}

BearingSpecOf<3> link(const Vec3& a, const Vec3& b, const UnitQuaternion& axes = {}) {
  BearingSpecOf<3> spec;
  spec.name = "link", spec.body_a = "a", spec.body_b = "b", spec.point_a = a, spec.point_b = b, spec.angle = axes;
  return spec;
}

/// Two free solids at a distance, without weight, linked by a bearing.
Model<3> linked_pair(const BearingSpecOf<3>& spec) {
  SolidModelBuilder builder;
  builder.gravity = Vec3::Zero();
  SolidSpec a = solid("a", {1, 0.6, 0.4}, {0, 0, 0}, 120), b = solid("b", {0.5, 0.8, 1.1}, {1.8, 0.3, -0.2}, 75);
  a.velocity = {0.4, -0.1, 0.2}, b.velocity = {-0.5, 0.3, -0.1};
  a.spin = {0.7, -0.3, 0.9}, b.spin = {-1.1, 0.6, 0.2};
  builder.add_body(a), builder.add_body(b);
  builder.add_bearing(spec);
  return builder.build();
}

/// Bearings of many kinds, with horizontal laws of both directions among them.
std::vector<BearingSpecOf<3>> many_space_links() {
  const UnitQuaternion axes = rotation_by({0.3, -0.5, 1.1});
  std::vector<BearingSpecOf<3>> links{link({0.5, 0.1, 0}, {1.6, 0, 0}, axes), link({1, 0.2, 0}, {1, 0.2, 0}),
                                      link({-0.6, 0.4, 0.3}, {2.4, -0.3, 0.5}, axes)};
  for (BearingSpecOf<3>& l : links)
    l.law = {Linear{4e3, 30},    ElasticPlastic{6e3, 200, 0.1, 10}, Linear{5e3, 5}, Linear{300, 3}, Linear{200, 0},
             Gap{400, 0.1, 1, 0}};
  links[1].law[0] = links[1].law[1] = std::monostate{}, links[1].horizontal = Pendulum{2, 0.1, 3e3, 4};
  links[2].law[0] = links[2].law[1] = std::monostate{};
  links[2].horizontal = BoucWen{.stiffness = 4e3, .yield = 100, .hardening = 0.1, .exponent = 2, .shape = 0.5};
  return links;
}

/// A mass on a bearing over a fixed base, free along and across without rotation, under its weight [N].
struct Isolated {
  double mass = 1000;
  SolidModelBuilder builder;
  BearingSpecOf<3> spec = link({0, 0, 0}, {0, 0, 0});

  explicit Isolated(const DirectionLaw& horizontal) {
    builder.add_body(solid("a", {4, 4, 0.5}, {0, 0, -0.25}, 1e5, true));
    SolidSpec top = solid("b", {1, 1, 1}, {0, 0, 0.5}, mass);
    for (const int k : {3, 4, 5}) top.support[k] = Support::fixed;
    builder.add_body(top);
    spec.horizontal = horizontal, spec.law[2] = Linear{4e8, 0};
  }
  /// At rest under its weight.
  [[nodiscard]] State<3> start(const Model<3>& model) const {
    State<3> state = initial_state(model);
    state.position[1].z() -= mass * standard_gravity / 4e8;
    return state;
  }
};

}  // namespace

TEST_CASE("bearings in space: forces and couples on both bodies cancel, about any point") {
  std::mt19937_64 bits(7);
  for (const BearingSpecOf<3>& spec : many_space_links()) {
    SolidRun run(linked_pair(spec), 1e-3);
    run.run(0.3);
    double size = 0;
    for (const Vec3& f : run.work().force) size += f.norm();
    REQUIRE(size > 1);
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (const std::size_t n : {0, 1}) {
      force += run.work().force[n];
      moment += run.work().moment[n] + cross(run.state().position[n], run.work().force[n]);
    }
    CHECK(force.norm() <= 1e-12 * size);
    CHECK(moment.norm() <= 1e-12 * size);
  }
}

TEST_CASE("bearings in space: momentum and angular momentum are conserved, for any length and any laws") {
  for (const BearingSpecOf<3>& spec : many_space_links()) {
    SolidRun run(linked_pair(spec), 1e-3);
    run.step();
    const Vec3 momentum = run.momentum(), turning = run.angular_momentum();
    run.run(2);
    CHECK((run.momentum() - momentum).norm() < 1e-12 * 120);
    CHECK((run.angular_momentum() - turning).norm() < 1e-12 * 120);
  }
}

TEST_CASE(
    "bearings in space: an elastic link conserves energy in large rotations, with an error of second order in the "
    "step") {
  BearingSpecOf<3> spec = link({0.5, 0.1, 0}, {1.6, 0, 0}, rotation_by({0.3, -0.5, 1.1}));
  spec.law = {Linear{4e3, 0}, Linear{3e3, 0}, Linear{5e3, 0}, Linear{30, 0}, Linear{20, 0}, Linear{40, 0}};
  const auto drift = [&](double dt) {
    SolidRun run(linked_pair(spec), dt);
    const double begin = run.energy().balance();
    double worst = 0;
    while (run.time() < 3) run.step(), worst = std::max(worst, std::abs(run.energy().balance() - begin));
    double turned = 0;
    for (const std::size_t k : {3, 4, 5})
      turned = std::max(turned, std::abs(bearing_motion(run.model(), run.state(), 0).displacement[k]));
    CHECK(turned > 0.5);
    return worst / begin;
  };
  const double coarse = drift(1e-3), fine = drift(5e-4);
  CHECK(coarse < 2e-3);
  CHECK(fine < 0.3 * coarse);
  MESSAGE("energy drifts by " << coarse << " and, at half the step, by " << fine);
}

TEST_CASE("bearings in space: a common rotation of both bodies causes no force") {
  for (const BearingSpecOf<3>& spec : many_space_links()) {
    const Model<3> model = linked_pair(spec);
    State<3> state = initial_state(model);
    Work<3> work;
    const UnitQuaternion turn = rotation_by({0.9, -1.4, 0.6});
    const Vec3 spin(0.3, -0.2, 0.9);
    for (const std::size_t n : {0, 1}) {
      state.position[n] = turn_of(turn).apply(state.position[n]) + Vec3(3, -2, 1);
      state.rotation[n] = turn * state.rotation[n];
      state.velocity[n] = cross(spin, Vec3(state.position[n] - Vec3(1, 1, 0))), state.spin[n] = spin;
    }
    evaluate(model, state, work, 1e-3);
    CHECK(work.bearing_displacement[0].norm() < 1e-12);
    CHECK(work.bearing_force[0].norm() < 1e-8);
    CHECK(work.bearing_moment[0].norm() < 1e-9);
  }
}

TEST_CASE("bearings in space: a rotational spring counts full turns, about any axis") {
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0.6, 0, 0.8)}) {
    SolidModelBuilder builder;
    builder.gravity = Vec3::Zero();
    builder.add_body(solid("a", {1, 1, 1}, {0, 0, 0}, 100, true));
    SolidSpec b = solid("b", {0.6, 0.6, 0.6}, {0, 0, 2}, 50);  // a cube has the same inertia about any axis
    b.spin = 6 * axis;
    builder.add_body(b);
    BearingSpecOf<3> spec = link({0, 0, 2}, {0, 0, 2});
    spec.law[3] = spec.law[4] = spec.law[5] = Linear{1, 0};
    builder.add_bearing(spec);
    SolidRun run(builder.build(), 1e-3);
    const double inertia = run.model().inertia[1].x(), w = std::sqrt(1 / inertia), reach = 6 / w;
    REQUIRE(reach > 3 * M_PI);
    double largest = 0;
    const double half = M_PI / w;
    while (run.time() < half) {
      run.step();
      const auto d = bearing_motion(run.model(), run.state(), 0).displacement;
      largest = std::max(largest, Vec3(d[3], d[4], d[5]).norm());
    }
    CHECK(near(largest, reach, 1e-4));
    CHECK(near(run.spin(1).dot(axis), -6, 1e-3));  // swung back to its start
  }
}

TEST_CASE("bearings in space: a friction pendulum swings at 2 pi sqrt(R/g) in every azimuth and round the dish") {
  const double radius = 1.5, w = std::sqrt(standard_gravity / radius), swing = 0.05;
  Isolated top(Pendulum{.radius = radius, .mu = 0, .stiffness = 1e6});
  top.builder.add_bearing(top.spec);
  const Model<3> model = top.builder.build();
  for (const double azimuth : {0.0, 0.5, M_PI / 4, 2.0}) {
    State<3> state = top.start(model);
    const Vec3 way(std::cos(azimuth), std::sin(azimuth), 0);
    state.velocity[1] = w * swing * way;
    SolidRun run(model, state, 5e-4);
    run.run(M_PI / w / 2);
    CHECK(near(run.place(1).dot(way), swing, 1e-4));
    run.run(M_PI / w / 2);
    CHECK(near_zero(run.place(1).dot(way), 1e-3 * swing));
    CHECK(near_zero(run.place(1).dot(cross(Vec3(0, 0, 1), way)), 1e-9));
  }
  State<3> orbit = top.start(model);
  orbit.position[1].x() = swing, orbit.velocity[1].y() = w * swing;
  SolidRun run(model, orbit, 5e-4);
  for (int quarter = 1; quarter <= 8; ++quarter) {
    run.run(M_PI / w / 2);
    CHECK(near(std::hypot(run.place(1).x(), run.place(1).y()), swing, 2e-3));
    const double angle = std::atan2(run.place(1).y(), run.place(1).x());
    CHECK(near_zero(std::remainder(angle - quarter * M_PI / 2, 2 * M_PI), 5e-3));
  }
}

TEST_CASE("bearings in space: a slider stops a mass after v^2 / (2 mu g), whatever the azimuth") {
  const double mu = 0.1, speed = 1;
  Isolated top(Friction{.mu = mu, .stiffness = 1e7});
  top.builder.add_bearing(top.spec);
  const Model<3> model = top.builder.build();
  for (const double azimuth : {0.0, 0.6, M_PI / 4}) {
    State<3> state = top.start(model);
    const Vec3 way(std::cos(azimuth), std::sin(azimuth), 0);
    state.velocity[1] = speed * way;
    SolidRun run(model, state, 2e-4);
    const double begin = run.energy().balance();
    run.run(1.5);
    // With two laws of single directions it would stop earlier, because their friction is mu (|cos| + |sin|) along the
    // path.
    CHECK(near(run.place(1).dot(way), speed * speed / (2 * mu * standard_gravity), 2e-3));
    CHECK(near_zero(run.energy().balance() - begin, 1e-3 * 0.5 * top.mass * speed * speed));
  }
}

TEST_CASE("bearings in space: a limit of the resultant fails one, and its waiting successor starts") {
  Isolated top(Linear{1e5, 0});
  top.spec.horizontal_limit = 0.05, top.spec.becomes_bearing = "next";
  BearingSpecOf<3> next = top.spec;
  next.name = "next", next.becomes_bearing.clear(), next.horizontal_limit = unbounded, next.starts_waiting = true;
  next.horizontal = Friction{.mu = 0.2, .stiffness = 1e6};
  top.builder.add_bearing(top.spec), top.builder.add_bearing(next);
  const Model<3> model = top.builder.build();
  State<3> state = top.start(model);
  state.velocity[1] = Vec3(0.6, 0.8, 0);
  SolidRun run(model, state, 1e-4);
  const double begin = run.energy().balance();
  std::vector<Event> events;
  while (run.time() < 1) {
    run.step();
    events.insert(events.end(), run.work().events.begin(), run.work().events.end());
  }
  std::erase_if(events, [](const Event& e) { return e.bearing < 0; });
  REQUIRE(events.size() == 3);
  CHECK(events[0].type == EventType::bearing_failed);
  CHECK(near(events[0].value, 0.05, 5e-3));
  CHECK(events[0].bearing == 0);
  CHECK(events[1].type == EventType::bearing_changed);
  CHECK(events[2].type == EventType::bearing_yielded);
  CHECK(events[2].bearing == 1);
  CHECK(run.state().bearing[0].status == BearingStatus::changed);
  CHECK(near(run.energy()[EnergyTerm::bearing_failure], 0.5 * 1e5 * 0.05 * 0.05, 5e-2));
  CHECK(near_zero(run.energy().balance() - begin, 2e-3 * 500));
  // Each direction has its own limit too.
  Isolated other(Linear{1e5, 0});
  other.spec.limit[1] = 0.02;
  other.builder.add_bearing(other.spec);
  const Model<3> across = other.builder.build();
  State<3> slow = other.start(across);
  slow.velocity[1] = Vec3(0.8, 0.6, 0);
  SolidRun second(across, slow, 1e-4);
  REQUIRE(second.run_until(1, [&] { return !second.work().events.empty(); }));
  CHECK(second.work().events[0].type == EventType::bearing_failed);
  CHECK(near(second.work().events[0].value, 0.02, 1e-2));
}

TEST_CASE("bearings in space: an intact bearing replaces flat contact, and the block drops on its seat after failure") {
  SolidModelBuilder builder;
  builder.add_body(solid("a", {4, 4, 0.5}, {0, 0, -0.25}, 1e5, true));
  SolidSpec top = solid("b", {1, 1, 1}, {0, 0, 0.5}, 1000);
  top.velocity = {0.6, 0.8, 0};
  builder.add_body(top);
  builder.add_law("rough", testing::frictional(1e8, 5e7, 0.5, 1e-3));
  builder.add_law("smooth", testing::frictional(1e8, 5e7, 0.1, 1e-3));
  builder.set_contact("*", "*", "rough");
  BearingSpecOf<3> spec = link({0, 0, 0}, {0, 0, 0});
  spec.law = {Linear{1e5, 0}, Linear{1e5, 0}, Linear{2e7, 1e4}, Linear{1e7, 1e4}, Linear{1e7, 1e4}, Linear{1e6, 1e3}};
  spec.horizontal_limit = 0.05, spec.replaces_contact = true, spec.contact_after = "smooth";
  builder.add_bearing(spec);
  SolidRun run(builder.build(), 1e-4);
  const double begin = run.energy().balance();
  bool touched = false;
  REQUIRE(run.run_until(1, [&] {
    const bool failed = run.state().bearing[0].status == BearingStatus::changed;
    touched = touched || (!failed && !run.work().general_touching.empty());
    return failed;
  }));
  CHECK_FALSE(touched);
  run.run(1);
  REQUIRE(run.work().general_touching.size() == 1);
  CHECK(run.work().pairs[static_cast<std::size_t>(run.work().general_touching[0].row)].law == 1);
  CHECK(near(run.work().general_touching[0].force.z(), 1000 * standard_gravity, 1e-2));
  CHECK(near_zero(run.energy().balance() - begin, 5e-3 * 500));
}

TEST_CASE(
    "bearings in space: saved states are restored completely, and freeing scratch memory does not change the results") {
  const Model<3> model = linked_pair(many_space_links()[2]);
  SolidRun run(model, 1e-3), dropped(model, 1e-3);
  run.run(0.5);
  for (int i = 0; i < 500; ++i) dropped.drop_work(), dropped.step();
  CHECK(state_hash(run.state()) == state_hash(dropped.state()));
  const State<3> again = state_from_words(model, state_words(run.state()), "checkpoint");
  CHECK(state_hash(again) == state_hash(run.state()));
  SolidRun on(model, again, 1e-3);
  on.run(0.2), run.run(0.2);
  CHECK(state_hash(on.state()) == state_hash(run.state()));
}

TEST_CASE("bearings in space: the stable step follows from the stiffest spring and its body") {
  Isolated top(Linear{1e5, 0});
  top.builder.add_bearing(top.spec);
  const Model<3> model = top.builder.build();
  SolidRun run(model, top.start(model), 1e-5);
  const StableStep found = stable_step(run.model(), run.state(), run.work());
  // 4e8 N/m under 1000 kg: 2 / omega; its rotations are fixed, and count in the bound, which is at most a quarter low.
  const double exact = 2 / std::sqrt(4e8 / 1000);
  CHECK(found.dt <= exact * (1 + 1e-12));
  CHECK(found.dt > 0.7 * exact);
}

TEST_CASE("seats in space: lost sideways or lengthwise, once, when the end reaches the edge") {
  Isolated top(Linear{1, 0});
  top.builder.add_bearing(top.spec);
  // The base is 4 m wide: its edge across is at y = 2, along at x = 2.
  top.builder.add_seat({"along", "b", "a", {0, 0, 0}, {2, 0, 0}, {-3, 0, 0}});
  top.builder.add_seat({"across", "b", "a", {0, 0.5, 0}, {0, 2, 0}, {0, -1, 0}});
  const Model<3> model = top.builder.build();
  State<3> state = top.start(model);
  state.velocity[1] = Vec3(0.1, 1, 0);
  SolidRun run(model, state, 1e-3);
  CHECK(near(seat_length(model, state, model.seats[0]), 2, 1e-12));
  std::vector<Event> lost;
  while (run.time() < 2) {
    run.step();
    for (const Event& e : run.work().events)
      if (e.type == EventType::seat_lost) lost.push_back(e);
  }
  REQUIRE(lost.size() == 1);
  CHECK(lost[0].text == "across");
  CHECK(near(lost[0].time, 1.5, 1e-2));
  CHECK(near(lost[0].y, 2, 1e-2));
  CHECK(near(lost[0].value, std::hypot(0.1, 1), 1e-2));
  CHECK(near(seat_length(run.model(), run.state(), model.seats[0]), 1.8, 1e-2));
}

TEST_CASE("bearings in space: an invalid bearing is rejected in one line") {
  const auto refusal = [](const BearingSpecOf<3>& spec) -> std::string {
    try {
      linked_pair(spec);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  BearingSpecOf<3> spec = link({0.5, 0, 0}, {1.6, 0, 0});
  CHECK(refusal(spec).find("bearing 'link': has no law") == 0);
  spec.horizontal = Gap{1e5, 0.1, 0, 0};
  CHECK(refusal(spec).find("horizontal is gap, which has no circular form for both directions") != std::string::npos);
  spec.horizontal = Linear{1e5, 0}, spec.law[1] = Linear{1e5, 0};
  CHECK(refusal(spec).find("both horizontal and along or across are given") != std::string::npos);
  spec.law[1] = std::monostate{}, spec.point_b = {40, 0, 0};
  CHECK(refusal(spec).find("its point (40, 0, 0) is") != std::string::npos);
  spec.point_b = {1.6, 0, 0}, spec.horizontal_limit = 0;
  CHECK(refusal(spec).find("limit displacement is 0, must be above 0") != std::string::npos);
  spec.horizontal_limit = unbounded, spec.becomes_bearing = "other";
  CHECK(refusal(spec).find("becomes 'other' at its limit, but has none") != std::string::npos);
  spec.horizontal_limit = 1;
  CHECK(refusal(spec).find("becomes bearing 'other', which does not exist") != std::string::npos);
  spec.becomes_bearing = "", spec.body_b = "a";
  CHECK(refusal(spec).find("connects body 'a' with itself") != std::string::npos);
}

}  // namespace trilith
