// Damage of a wall by storey: both sides of each limit, with prescribed displacements of bodies.
#include "run/record/storey_damage.hpp"

#include <doctest/doctest.h>

#include "assembly/start.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using testing::box;
using testing::Scene;

namespace {

enum Piece { base, low_left, low_right, slab, high_left, high_right };

/// Two units and a slab on a fixed base, and two units on the slab: storeys of 5 and of 3 joints.
Model<2> wall() {
  Scene scene(Bonded{1e10, 4e9, 0.6, 1e-5, 1e5, 1e5});
  const auto add = [&](const std::string& name, const Polygon& outline, std::vector<std::string> groups) {
    BodySpec spec;
    spec.name = name, spec.outline = outline, spec.groups = std::move(groups);
    if (name == "base") spec.support = testing::held;
    scene.add(std::move(spec));
  };
  add("base", box(-2, -1, 6, 0), {"base"});
  add("low left", box(0, 0, 1, 1), {"units", "storey 1"});
  add("low right", box(1, 0, 2, 1), {"units", "storey 1"});
  add("slab", box(0, 1, 2, 2), {"slabs", "storey 1"});
  add("high left", box(0, 2, 1, 3), {"units", "storey 2"});
  add("high right", box(1, 2, 2, 3), {"units", "storey 2"});
  return scene.builder.build();
}

using Moves = std::vector<std::pair<int, Vec2>>;

/// The rows of `bodies` after each of `moves`.
std::vector<StoreyDamage> after(const Moves& moves, const DamageLimits& limits = {},
                                const std::vector<int>& bodies = {0, 1, 2, 3, 4, 5}) {
  const Model<2> model = wall();
  State<2> state = start_state(model);
  for (const auto& [body, by] : moves) state.position[model.bodies[static_cast<std::size_t>(body)].first_node] += by;
  Simulation<2> sim(model, state);
  sim.refresh();
  return damage_by_storey(model, state, sim.work(), bodies, Findings<2>(model), limits);
}

}  // namespace

TEST_CASE("a wall that has not moved has all its joints and units, by storey, and none is damaged") {
  const auto rows = after({});
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].storey == 1);
  CHECK(rows[1].storey == 2);
  CHECK(rows[0].joints == 5);
  CHECK(rows[1].joints == 3);
  for (const StoreyDamage& row : rows) {
    CHECK(row.units == 2);
    CHECK(row.joints_apart == 0);
    CHECK(row.units_out_of_place == 0);
  }
}

TEST_CASE("a joint is apart and a unit out of place beyond half an inch and an inch, and not below") {
  CHECK(after({{high_right, {0.0126, 0}}})[1].joints_apart == 0);
  const auto half = after({{high_right, {0.0128, 0}}});
  CHECK(half[1].joints_apart == 2);  // it slips on the slab, and opens against its neighbour
  CHECK(half[0].joints_apart == 0);
  CHECK(after({{high_right, {0.0253, 0}}})[1].units_out_of_place == 0);
  CHECK(after({{high_right, {0.0255, 0}}})[1].units_out_of_place == 1);
  CHECK(after({{high_left, {-0.0255, 0}}})[1].units_out_of_place == 1);
  CHECK(after({{high_right, {0.0128, 0}}}, {.apart = 0.02})[1].joints_apart == 0);
  CHECK(after({{high_right, {0.0128, 0}}}, {.out_of_place = 0.01})[1].units_out_of_place == 1);
}

TEST_CASE("a unit that falls is out of place, one that is lifted is not") {
  CHECK(after({{high_left, {0, -0.0255}}})[1].units_out_of_place == 1);
  CHECK(after({{high_left, {0, -0.0253}}})[1].units_out_of_place == 0);
  const auto lifted = after({{high_left, {0, 0.1}}});
  CHECK(lifted[1].units_out_of_place == 0);
  CHECK(lifted[1].joints_apart == 2);
}

TEST_CASE("units that move with their floor are in place") {
  const auto rows = after({{slab, {0.1, 0}}, {high_left, {0.1, 0}}, {high_right, {0.1, 0}}});
  CHECK(rows[1].joints_apart == 0);
  CHECK(rows[1].units_out_of_place == 0);
  CHECK(rows[0].joints_apart == 2);  // the joints under the slab
  const auto left_behind = after({{slab, {0.1, 0}}});
  CHECK(left_behind[1].units_out_of_place == 2);
  CHECK(left_behind[0].units_out_of_place == 0);
}

TEST_CASE("of some bodies of a wall only their storeys, and joints among them, count") {
  const auto rows = after({{high_right, {0.1, 0}}}, {}, {high_left, high_right});
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].storey == 2);
  CHECK(rows[0].joints == 1);
  CHECK(rows[0].joints_apart == 1);
  CHECK(rows[0].units_out_of_place == 1);
  CHECK(after({}, {}, {base}).empty());
}
