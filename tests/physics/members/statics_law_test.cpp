// Statics with history-dependent laws, with deformable bodies, and with invalid input.
#include "base/error.hpp"
#include "near.hpp"
#include "physics/members/implicit.hpp"
#include "physics/members/statics_frames.hpp"
#include "physics/space/solids.hpp"

namespace trilith::testing {
namespace {

/// A block of 100 kg, 1 m long, with a force of 1 N to the right near its bottom.
Model<2> pulled_block() {
  Scene scene(Frictional{1e9, 5e8, 0.6, 1e-5});
  scene.fixed("base", box(-5, -1, 5, 0));
  scene.block("block", box(0, 0, 1, 0.4), 100);
  Model<2> model = scene.builder.build();
  add_load(model, "block", {0.5, 0.2}, {1, 0});
  return model;
}

TEST_CASE("a load path that is stopped ends at its last point, and before its first point leaves the state as it was") {
  const Model<2> model = pulled_block();
  for (const int most : {0, 400}) {
    State<2> state = initial_state(model);
    const std::uint64_t hash = state_hash(state);
    int asked = 0;
    LoadPathOptions o;
    o.followed = {{{node_of(model, "block"), 0}, 1}};
    o.first = 1e-8, o.longest = 1e-8, o.most_points = 100000;
    o.is_stopped = [&] { return ++asked > most; };
    const LoadPath path = follow_loads(model, state, o);
    CHECK(path.end == PathEnd::stopped);
    CHECK(path.iterations <= most + 1);
    CHECK(path.points.empty() == (most == 0));
    CHECK((state_hash(state) == hash) == (most == 0));
  }
}

TEST_CASE("a block pulled under displacement control slides at mu W, and keeps its slip when it is released") {
  const Model<2> model = pulled_block();
  const int block = node_of(model, "block");
  const double limit = 0.6 * 100 * standard_gravity;
  const double stretch = limit / 5e8, turn = 12 * limit * 0.2 / 1e9;  // of the joint's springs at the limit
  State<2> state = initial_state(model);
  LoadPathOptions o;
  o.control = PathControl::displacement, o.followed = {{{block, 0}, 1}};
  o.first = 0.1 * stretch, o.longest = 1e-4, o.to = 1e-3;
  const LoadPath out = follow_loads(model, state, o);
  REQUIRE(out.end == PathEnd::arrived);
  CHECK(near(out.points.back().factor, limit, 1e-6));
  CHECK(near(out.points.back().displacement, 1e-3, 1e-6));
  for (const PathPoint& p : out.points) CHECK(p.factor <= limit * (1 + 1e-6));

  o.control = PathControl::load, o.begin = out.points.back().factor, o.first = -0.2 * limit, o.to = 0;
  o.longest = 0;
  const LoadPath back = follow_loads(model, state, o);
  REQUIRE(back.end == PathEnd::arrived);
  CHECK(back.points.back().factor == 0);
  CHECK(near(-back.points.back().displacement, stretch + 0.2 * turn, 1e-3));
  CHECK(state.contacts.size() == 1);
  CHECK(near(state.contacts.memory[0].slip, 1e-3 - stretch, 0.01));
  MESSAGE(
      fmt::format("pulled block: {:.6f} N ({:.6f}); {} points, {} iterations, {} cuts; springs back {:.4g} m ({:.4g})",
                  out.points.back().factor, limit, out.points.size(), out.iterations, out.cuts,
                  -back.points.back().displacement, stretch + 0.2 * turn));
}

TEST_CASE("load control ends at the friction limit") {
  const Model<2> model = pulled_block();
  State<2> state = initial_state(model);
  LoadPathOptions o;
  o.control = PathControl::load, o.first = 100, o.to = 1000;
  const LoadPath path = follow_loads(model, state, o);
  CHECK(path.end == PathEnd::stuck);
  CHECK(near(path.points.back().factor, 0.6 * 100 * standard_gravity, 0.01));
}

TEST_CASE("the falling branch of a softening link is followed") {
  Table table;
  table.displacement = {-1, 0, 0.01, 0.03, 0.05}, table.force = {-1e5, 0, 1000, 400, 400};
  for (const PathControl control : {PathControl::displacement, PathControl::arc}) {
    Model<2> model = MassOnLaw{table}.model();
    add_load(model, "mass", {0, 1.5}, {1, 0});
    State<2> state = initial_state(model);
    LoadPathOptions o;
    o.control = control, o.followed = {{{node_of(model, "mass"), 0}, 1}};
    o.first = o.longest = 1e-3;
    o.goes_on = [](const PathPoint& p, const State<2>&) { return p.displacement < 0.0295; };
    const LoadPath path = follow_loads(model, state, o);
    REQUIRE(path.end == PathEnd::arrived);
    CHECK(near(factor_at(path, 0.005), 500, 1e-6));
    CHECK(near(factor_at(path, 0.02), 700, 1e-6));
    REQUIRE(path.limits.size() == 1);
    CHECK(near(path.limits[0].displacement, 0.01, 0.1));
  }
}

TEST_CASE("a mean of displacements controls the path of a toggle past both its limits") {
  const Model<2> model = toggle(.5, .03, .02, .01, 210e9);
  State<2> state = initial_state(model);
  LoadPathOptions o;
  o.control = PathControl::displacement;
  for (const double x : {-0.25, 0.25}) o.followed.push_back({{node_at(model, {x, 0.015}), 1}, -0.5});
  o.first = 1e-4, o.longest = 2e-4, o.to = 0.025;
  const LoadPath path = follow_loads(model, state, o);
  REQUIRE(path.end == PathEnd::arrived);
  REQUIRE(path.limits.size() == 2);
  CHECK(near(path.limits[0].factor, 3404.0, 0.005));
  CHECK(near(path.limits[1].factor, 196.6, 0.02));
}

TEST_CASE("a deformable column brought to rest by statics is shortened by its own weight") {
  const double young = 1e9, density = 2000, height = 4, kn = 1e10;
  Scene scene(Frictional{kn, kn, 0.6, 1e-5});
  scene.builder.add_material(elastic("soft", density, young, 0));
  scene.fixed("base", box(-2, -1, 2, 0));
  BodySpec spec = grid_body("column", box(0, 0, 1, height), "soft", 2, 8);
  spec.floating = false;
  scene.add(spec);
  const Model<2> model = scene.builder.build();
  State<2> state = initial_state(model);
  const Equilibrium e = find_equilibrium(model, state);
  REQUIRE(e.converged);
  const double pressed = density * standard_gravity * height / kn;
  const double shortened = density * standard_gravity * height * height / (2 * young);
  const int top = node_at(model, {0.5, height});
  CHECK(near(height - state.position[top].y(), pressed + shortened, 1e-3));
  MESSAGE(fmt::format("column: {:.6g} m ({:.6g}); {} iterations in {} steps", height - state.position[top].y(),
                      pressed + shortened, e.iterations, e.steps));
}

TEST_CASE("the energy balance has the work of loads and weight during statics and stays closed") {
  const Model<2> model = pulled_block();
  State<2> state = initial_state(model);
  LoadPathOptions o;
  o.control = PathControl::displacement, o.followed = {{{node_of(model, "block"), 0}, 1}};
  o.first = 1e-7, o.longest = 1e-4, o.to = 1e-3;
  const LoadPath path = follow_loads(model, state, o);
  REQUIRE(path.end == PathEnd::arrived);
  Model<2> loaded = model;
  scale_loads(loaded, "", path.points.back().factor);
  Simulation<2> sim(loaded, state);
  sim.refresh();
  const Energy energy = sim.energy();
  const double friction = 0.6 * 100 * standard_gravity * 1e-3;
  CHECK(near(energy[EnergyTerm::load], friction, 0.01));
  CHECK(near(energy[EnergyTerm::contact_friction], friction, 0.01));
  CHECK(energy[EnergyTerm::kinetic] == 0);
  CHECK(std::abs(energy.balance()) < 1e-9 * friction);
  CHECK(energy[EnergyTerm::rest_damping] < 0.01 * friction);
}

TEST_CASE("statics rejects invalid input") {
  const Model<2> model = pulled_block();
  State<2> state = initial_state(model);
  LoadPathOptions o;
  o.control = PathControl::load, o.first = 1, o.to = 2, o.loads = "none such";
  CHECK_THROWS_AS(follow_loads(model, state, o), InputError);
  o.loads = "", o.first = 0;
  CHECK_THROWS_AS(follow_loads(model, state, o), InputError);
  o.first = 1, o.control = PathControl::displacement;
  CHECK_THROWS_AS(follow_loads(model, state, o), InputError);
  o.followed = {{{0, 0}, 1}};  // the base, which is fixed
  CHECK_THROWS_AS(follow_loads(model, state, o), InputError);
  EquilibriumOptions rest;
  rest.tolerance = 0;
  CHECK_THROWS_AS(find_equilibrium(model, state, rest), InputError);
}

}  // namespace
}  // namespace trilith::testing
