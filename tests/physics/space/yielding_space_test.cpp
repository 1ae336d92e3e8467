// Fibre members in space: plastic loads in any direction, the plane's frame, implicit steps, energy ledger, saved
// history.
#include <unistd.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "model/io/checkpoint.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"
#include "physics/space/space_frames.hpp"
#include "physics/space/space_implicit.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double steel_modulus = 2e11, steel_yield = 3e8, column_height = 2;
const RectangleSection column_profile{0.2, 0.3};

UniaxialLaw steel_fibre(double hardening) {
  BilinearSteel law;
  law.young = steel_modulus, law.yield = steel_yield, law.hardening = hardening;
  return law;
}

MemberFibres fibres_of(double hardening, std::array<int, 2> cells) {
  MemberFibres fibres;
  fibres.spec.shape = column_profile, fibres.spec.law = steel_fibre(hardening);
  fibres.spec.layers = cells[0], fibres.spec.cells = cells;
  return fibres;
}

/// A column on a clamped foot, its section's depth along x, rotated with its world; a mass on its top.
Model<3> column_in(const UnitQuaternion& world, double damping, int divisions = 4, std::array<int, 2> cells = {4, 4}) {
  const Turn3 turn = turn_of(world);
  SolidSpec spec = chain_body("column", {Vec3::Zero(), turn.apply(Vec3(0, 0, column_height))},
                              section_in_space(column_profile), divisions);
  spec.frame->joints[0].support = clamped;
  spec.frame->joints[1].mass = 2e4, spec.frame->joints[1].inertia = 1e3;
  SpaceMember& member = spec.frame->members[0];
  member.orientation = turn.x(), member.yields = fibres_of(0.01, cells);
  return of_space_frames(member_material(7850, steel_modulus, 0.3, damping), {spec});
}
constexpr std::size_t column_top = 1;

/// A force at the top that grows to `force` [N] within a second and stays.
void push_top(Model<3>& model, const Vec3& force) {
  SolidLoadSpec load;
  load.name = "push", load.at = model.start_position[column_top], load.force = force;
  load.curve = {{0, 1}, {0, 1}};
  loads_of<PointLoad<3>>(model) = {make_solid_load(model, 0, load)};
  model.mass_damping = 4;
}

/// Displacement of the top under a push, one second after its full value [m].
double gone_under_push(double angle, double force, const UnitQuaternion& world = {}) {
  Model<3> model = column_in(world, 0);
  push_top(model, turn_of(world).apply(force * Vec3(std::cos(angle), std::sin(angle), 0)));
  Simulation<3> sim(model);
  StageOptions stage = steps_in_space(AlphaMethod::hht(-0.05), 2, 0.02);
  stage.tolerance = 1e-8;
  sim.run(stage);
  return (sim.state().position[column_top] - model.start_position[column_top]).norm();
}

struct ShakenColumn {
  Vec3 most = Vec3::Zero();
  double residual = 0, plastic = 0;
  std::vector<Event> yielded;
};

/// Free vibration from an initial velocity of the top along x and y.
ShakenColumn swing(const UnitQuaternion& world, double damping, const StageOptions& stage) {
  Model<3> model = column_in(world, damping);
  const Turn3 turn = turn_of(world);
  model.start_velocity[column_top] = turn.apply(Vec3(2, 3, 0));
  Simulation<3> sim(model);
  ShakenColumn out;
  RunListener<3> listener;
  listener.on_step = [&](const Instant<3>& now) {
    const Vec3 gone = turn.undo(now.state.position[column_top] - model.start_position[column_top]);
    out.most = out.most.cwiseMax(gone.cwiseAbs());
  };
  listener.on_event = [&](const Event& e, const Instant<3>&) {
    if (e.type == EventType::member_yielded) out.yielded.push_back(e);
  };
  double first = 0;
  bool begun = false;
  listener.on_energy = [&](const Instant<3>&, const Energy& e) {
    if (!begun) first = e.balance(), begun = true;
    out.residual = std::max(out.residual, std::abs(e.balance() - first));
    out.plastic = e[EnergyTerm::plastic];
  };
  sim.run(stage, listener);
  return out;
}

constexpr double thrown_energy = 0.5 * 2e4 * 13;  // [J]

StageOptions explicit_swing() {
  StageOptions stage = explicit_steps(0.15);
  stage.energy_interval = 1e-3;
  return stage;
}

}  // namespace

TEST_CASE("a column of fibres stands below its plastic load and collapses above it, along either axis and obliquely") {
  // A force along x bends the section about z. Under an oblique force at 45 degrees the neutral axis of a rectangle is
  // its diagonal.
  const double about_z = steel_yield * 0.2 * 0.09 / 4, about_y = steel_yield * 0.3 * 0.04 / 4;
  for (const auto& [angle, moment] : {std::pair(0.0, about_z), {M_PI / 2, about_y}}) {
    const double below = gone_under_push(angle, 0.9 * moment / column_height),
                 above = gone_under_push(angle, 1.15 * moment / column_height);
    const double inertia = angle == 0 ? 0.2 * 0.027 / 12 : 0.3 * 0.008 / 12;
    const double elastic = moment * column_height * column_height / (3 * steel_modulus * inertia);
    MESSAGE("pushed at ", angle, " rad: ", below / elastic, " times its elastic way at that load below, ",
            above / elastic, " above");
    CHECK(below < 1.5 * elastic);
    CHECK(above > 4 * elastic);
  }
  // Neither moment alone would yield; together they do: (M_y/Mp_y)^a + (M_z/Mp_z)^a with a between 1 and 2.
  const double angle = std::atan2(about_y, about_z), share = 0.95;
  const double force = share * std::hypot(about_z, about_y) / column_height;
  const double half = gone_under_push(angle, 0.5 * force);
  CHECK(gone_under_push(angle, force) > 8 * half);
}

TEST_CASE("a column of fibres that swings beyond yield closes its energy balance and is the same in a rotated frame") {
  const ShakenColumn upright = swing({}, 0, explicit_swing());
  CHECK(upright.plastic > 0.2 * thrown_energy);
  CHECK(upright.residual < 1e-3 * thrown_energy);
  const auto at_foot =
      std::find_if(upright.yielded.begin(), upright.yielded.end(), [](const Event& e) { return e.text == "0-1 at 0"; });
  REQUIRE(at_foot != upright.yielded.end());
  CHECK(at_foot->z == 0);
  CHECK(at_foot->value > 0.5 * steel_yield * 0.3 * 0.04 / 4);
  for (const Vec3& axis : {Vec3(0.7, -1.1, 0.4), Vec3(-2, 0.3, 1)}) {
    const ShakenColumn turned = swing(rotation_by(axis), 0, explicit_swing());
    CHECK((turned.most - upright.most).norm() < 1e-9);
    CHECK(near(turned.plastic, upright.plastic, 1e-9));
    CHECK(turned.yielded.size() == upright.yielded.size());
  }
  const ShakenColumn damped = swing({}, 2e-5, explicit_swing());
  CHECK(damped.residual < 1e-3 * thrown_energy);
  CHECK(damped.plastic < upright.plastic);
}

TEST_CASE("a column of fibres in space moves the same with implicit and explicit steps") {
  const ShakenColumn small = swing({}, 0, explicit_swing());
  StageOptions stage = careful_steps(0.15, 1e-3);
  stage.energy_interval = 1e-3;
  const ShakenColumn large = swing({}, 0, stage);
  CHECK((large.most - small.most).norm() < 0.01 * small.most.norm());
  CHECK(near(large.plastic, small.plastic, 0.02));
  CHECK(large.residual < 5e-3 * thrown_energy);
}

TEST_CASE("a column that bends in one plane equals the column in the plane") {
  BodySpec spec = beam_body("column", {0, 0}, {0, column_height}, section_of(FibreShape(column_profile)), "steel", 6);
  spec.frame->joints[0].support = held;
  spec.frame->joints[1].mass = 2e4, spec.frame->joints[1].inertia = 1e3;
  spec.frame->members[0].yields = fibres_of(0.01, {6, 1});
  Model<2> flat = of_frames(elastic_material("steel", 7850, steel_modulus, 0.3, 0), {spec});
  flat.start_velocity[1] = Vec2(3, 0);
  Model<3> deep = column_in({}, 0, 6, {6, 1});
  deep.start_velocity[column_top] = Vec3(3, 0, 0);
  Simulation<2> plane(flat);
  Simulation<3> space(deep);
  StageOptions stage = explicit_steps(0.1, 2e-6);
  plane.run(stage), space.run(stage);
  const double gone = plane.state().position[1].x();
  CHECK(std::abs(gone) > 0.03);
  CHECK(near(space.state().position[column_top].x(), gone, 1e-7));
  CHECK(std::abs(space.state().position[column_top].y()) < 1e-12);
  const std::vector<FibreReading> in_plane = member_fibres(plane.model(), plane.state(), 0);
  const std::vector<FibreReading3> in_space = member_fibres(space.model(), space.state(), 0);
  REQUIRE(in_plane.size() == in_space.size());
  for (std::size_t i = 0; i < in_plane.size(); ++i) {
    CHECK(near(in_space[i].along, in_plane[i].along, 1e-12));
    CHECK(near_zero(std::abs(in_space[i].moment[1]) - std::abs(in_plane[i].moment), 1e-4 * 1.35e6));
  }
}

TEST_CASE("a column of fibres saved and continued gives the same bits as one run without interruption") {
  Model<3> model = column_in(rotation_by({0.2, 0.4, -0.3}), 2e-5);
  model.start_velocity[column_top] = Vec3(1.5, 2, -1);
  SolidRun whole(model, 4e-6);
  whole.run(0.04);
  REQUIRE(whole.energy()[EnergyTerm::plastic] > 0);
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("fibres" + std::to_string(::getpid()) + ".state");
  save_state(whole.state(), model, path);
  SolidRun rest(model, load_state(model, path), 4e-6);
  std::filesystem::remove(path);
  whole.run(0.01), rest.run(0.01);
  CHECK(state_hash(rest.state()) == state_hash(whole.state()));
}
