// Pressure on solids in space: resultants, places, follower pressure.
#include <random>

#include "base/error.hpp"
#include "model/loads.hpp"
#include "near.hpp"
#include "physics/space/solid_bodies.hpp"

namespace trilith::testing {
namespace {

/// One free stone without weight.
Model<3> lone_stone(const Polyhedron& shape) {
  SpaceBuilder builder;
  builder.gravity(Vec3::Zero());
  builder.add(stone("b", shape));
  return builder.build();
}

struct SolidResultant {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  // about the node
};

SolidResultant pushed_solid(const Model<3>& model, const State<3>& state) {
  Work<3> work;
  evaluate(model, state, work, 0);
  return {work.load[0], work.load_moment[0]};
}

SolidPressureSpec pressure_of(double value) {
  SolidPressureSpec spec;
  spec.name = "p", spec.value = value;
  return spec;
}

TEST_CASE("pressure that follows all faces of a solid has no resultant, whatever its shape and pose") {
  std::mt19937_64 bits(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int round = 0; round < 20; ++round) {
    Model<3> model = lone_stone(random_convex_solid(bits));
    loads_of<PointLoad<3>>(model) = make_solid_pressure(model, 0, surface_faces(model, 0), pressure_of(3e5));
    CHECK(loads_of<PointLoad<3>>(model).size() == model.piece_solid[0].normals.size());
    State<3> state = initial_state(model);
    state.position[0] = {any(bits), any(bits), any(bits)};
    state.rotation[0] = rotation_by({3 * any(bits), 3 * any(bits), 3 * any(bits)});
    const SolidResultant r = pushed_solid(model, state);
    CHECK(near_zero(r.force.norm(), 1e-8));
    CHECK(near_zero(r.moment.norm(), 1e-8));
  }
}

TEST_CASE("pressure on one side of a box acts at its centre with value times area, fixed or following the box") {
  Model<3> model = lone_stone(box_at({2, 1, 0.5}, {3, 2, 1}));
  const std::vector<SolidFace> top = faces_towards(model, 0, Vec3::UnitZ());
  REQUIRE(top.size() == 1);
  State<3> state = initial_state(model);
  const UnitQuaternion quarter = rotation_by({std::numbers::pi / 2, 0, 0});  // up rotates to -y
  state.rotation[0] = quarter * state.rotation[0];
  for (const bool follows : {true, false}) {
    SolidPressureSpec spec = pressure_of(100);
    spec.follows = follows;
    loads_of<PointLoad<3>>(model) = make_solid_pressure(model, 0, top, spec);
    const SolidResultant before = pushed_solid(model, initial_state(model)), after = pushed_solid(model, state);
    CHECK(near_zero((before.force - Vec3(0, 0, -200)).norm(), 1e-10));
    CHECK(near_zero(before.moment.norm(), 1e-10));
    CHECK(near_zero((after.force - (follows ? Vec3(0, 200, 0) : Vec3(0, 0, -200))).norm(), 1e-10));
    // The middle of the face is 0.25 m from the centroid, towards -y at this state.
    CHECK(near_zero((after.moment - (follows ? Vec3(Vec3::Zero()) : Vec3(50, 0, 0))).norm(), 1e-10));
  }
}

TEST_CASE("pressure in space along a direction keeps it, and invalid pressures are rejected") {
  Model<3> model = lone_stone(box_at({2, 1, 0.5}, {0, 0, 0}));
  SolidPressureSpec spec = pressure_of(100);
  spec.direction = Vec3(0, 3, 4);
  const auto top = faces_towards(model, 0, Vec3::UnitZ());
  CHECK_THROWS_AS(make_solid_pressure(model, 0, top, spec), InputError);  // follower pressure with a direction
  spec.follows = false;
  loads_of<PointLoad<3>>(model) = make_solid_pressure(model, 0, top, spec);
  CHECK(near_zero((pushed_solid(model, initial_state(model)).force - Vec3(0, 120, 160)).norm(), 1e-10));
  spec.value = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(make_solid_pressure(model, 0, top, spec), InputError);
}

}  // namespace
}  // namespace trilith::testing
