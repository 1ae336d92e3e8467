// Natural frequencies in space (VALIDATION M1, M4, M5, M7 to M10, F6, F7): blocks on joints, a slab on columns, a grid
// of masses, hanging chains, beams and frames, with and without load.
#include "modal/modes.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include "modal/mode_damping.hpp"
#include "near.hpp"
#include "physics/members/grid_frequencies.hpp"
#include "physics/space/space_frames.hpp"
#include "physics/space/space_implicit.hpp"
#include "statics/equilibrium.hpp"

namespace trilith::testing {
namespace {

struct Standing {
  Model<3> model;
  State<3> state;
};

/// A stack of blocks on a fixed base, at rest under gravity [m/s2], in a world rotated by `world`.
Standing standing_blocks(const Vec3& sides, int count, double gravity, double beta = 0,
                         const UnitQuaternion& world = {}) {
  SpaceBuilder builder;
  const Turn3 turn(world);
  builder.gravity(turn.apply(Vec3(0, 0, -gravity)));
  const auto at = [&](const Polyhedron& shape) { return placed(shape, world, Vec3::Zero()); };
  builder.add(fixed_stone("base", at(box_solid(Vec3(-1, -1, -0.5), Vec3(1, 1, 0)))));
  for (int i = 0; i < count; ++i)
    builder.add(stone("block " + std::to_string(i + 1), at(box_at(sides, Vec3(0, 0, (i + 0.5) * sides.z()))), 2400));
  builder.contact(0, 0, frictional(1e9, 4e8, 0.7, beta), "joint");
  Standing out{builder.build(), {}};
  out.state = initial_state(out.model);
  EquilibriumOptions how;
  how.tolerance = 1e-11;
  const Equilibrium found = find_equilibrium(out.model, out.state, how);
  REQUIRE(found.converged);
  return out;
}

void check_frequencies_in_space(const std::vector<NaturalMode<3>>& found, const std::vector<double>& expected,
                                double tolerance) {
  REQUIRE(found.size() >= expected.size());
  std::string text;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(near(found[i].frequency(), expected[i], tolerance));
    text += fmt::format(" {:.5g}", found[i].frequency());
  }
  MESSAGE(text);
}

TEST_CASE("M4: a block on a joint in space sways and rocks both ways, twists and heaves") {
  for (const UnitQuaternion& world : {UnitQuaternion{}, rotation_by({0.4, -1.1, 0.7})}) {
    const Standing now = standing_blocks({0.4, 0.4, 1.2}, 1, standard_gravity, 0, world);
    const std::vector<NaturalMode<3>> found = modes(now.model, now.state, 10);
    CHECK(found.size() == 6);
    // With the geometric stiffness of the weight, as the block stands under it.
    check_frequencies_in_space(found, {15.0359, 15.0359, 59.3135, 93.7829, 116.916, 116.916}, 5e-4);
    const double mass = 0.4 * 0.4 * 1.2 * 2400;
    Vec3 sum = Vec3::Zero();
    for (const NaturalMode<3>& mode : found)
      for (int k = 0; k < 3; ++k) sum[k] += mode.mass[static_cast<std::size_t>(k)];
    for (int k = 0; k < 3; ++k) CHECK(near(sum[k], mass, 1e-6));
    CHECK(near(free_mass(now.model, now.state)[2], mass, 1e-12));
  }
  // Without the weight.
  const Standing light = standing_blocks({0.4, 0.4, 1.2}, 1, 1e-2);
  check_frequencies_in_space(modes(light.model, light.state, 6), {15.0450, 15.0450, 59.3135, 93.7829, 116.919, 116.919},
                             5e-4);
}

TEST_CASE("M5: two cubes on each other in space have their twelve frequencies") {
  const Standing now = standing_blocks({0.5, 0.5, 0.5}, 2, 0.1);
  check_frequencies_in_space(
      modes(now.model, now.state, 12),
      {22.1055, 22.1055, 56.790, 89.793, 96.3095, 96.3095, 148.678, 186.093, 186.093, 224.931, 224.931, 235.081}, 5e-4);
}

TEST_CASE("a block on a joint in space has the damping of its law") {
  const double beta = 2e-4;
  const Standing now = standing_blocks({0.4, 0.4, 1.2}, 1, 1, beta);
  const std::vector<NaturalMode<3>> found = modes(now.model, now.state, 6);
  const std::vector<ModeDamping> damping = mode_damping(now.model, now.state, found);
  // Stiffness-proportional damping: ratio beta w / 2 of all modes.
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(near(damping[i].contacts, beta * M_PI * found[i].frequency(), 1e-3));
    CHECK(near(damping[i].total(), damping[i].contacts, 1e-9));
  }
}

TEST_CASE("M8: a storey of a slab on four columns sways both ways and twists") {
  SolidModelBuilder builder;
  builder.gravity = Vec3::Zero();
  SolidSpec base, slab;
  base.name = "base", base.pieces = {box_at({8, 6, 0.2}, {0, 0, -1})}, base.mass = 1, base.floating = true;
  base.support.fill(Support::fixed);
  slab.name = "slab", slab.pieces = {box_at({6, 4, 0.2}, {0, 0, 0})}, slab.mass = 20000, slab.floating = true;
  slab.support = {Support::free, Support::free, Support::fixed, Support::fixed, Support::fixed, Support::free};
  builder.add_body(base), builder.add_body(slab);
  for (const double x : {-3.0, 3.0})
    for (const double y : {-2.0, 2.0}) {
      BearingSpecOf<3> column;
      column.name = fmt::format("column {} {}", x, y), column.body_a = "base", column.body_b = "slab";
      column.point_a = column.point_b = {x, y, 0};
      column.law[0] = Linear{1e6, 0}, column.law[1] = Linear{x < 0 ? 1e6 : 2e6, 0};
      builder.add_bearing(column);
    }
  const Model<3> model = builder.build();
  // The slab as a plate: 20 t (6^2 + 4^2) / 12 about its axis, equal to the inertia of its box.
  check_frequencies_in_space(modes(model, initial_state(model), 3), {2.25079, 2.57587, 4.62851}, 1e-4);
}

/// Masses of 10 kg in a grid, 1 m apart, that move along x alone. Bearings between neighbours and to walls on all sides
/// act along x.
Model<3> sprung_grid_in_space(const std::array<int, 3>& count, const std::array<double, 3>& stiffness) {
  SolidModelBuilder builder;
  builder.gravity = Vec3::Zero();
  SolidSpec wall;
  wall.name = "wall", wall.pieces = {box_at({9, 9, 0.2}, {1, 1, -5})}, wall.mass = 1, wall.floating = true;
  wall.support.fill(Support::fixed);
  builder.add_body(wall);
  const auto name = [&](const std::array<int, 3>& at) -> std::string {
    for (std::size_t k = 0; k < 3; ++k)
      if (at[k] < 0 || at[k] >= count[k]) return "wall";
    return fmt::format("{} {} {}", at[0], at[1], at[2]);
  };
  std::array<int, 3> at{};
  for (at[0] = 0; at[0] < count[0]; ++at[0])
    for (at[1] = 0; at[1] < count[1]; ++at[1])
      for (at[2] = 0; at[2] < count[2]; ++at[2]) {
        SolidSpec body;
        body.name = name(at), body.pieces = {box_at({0.2, 0.2, 0.2}, Vec3(at[0], at[1], at[2]))}, body.mass = 10;
        body.support.fill(Support::fixed), body.support[0] = Support::free, body.floating = true;
        builder.add_body(body);
      }
  int springs = 0;
  for (std::size_t way = 0; way < 3; ++way)
    for (at[0] = way == 0 ? -1 : 0; at[0] < count[0]; ++at[0])
      for (at[1] = way == 1 ? -1 : 0; at[1] < count[1]; ++at[1])
        for (at[2] = way == 2 ? -1 : 0; at[2] < count[2]; ++at[2]) {
          std::array<int, 3> next = at;
          ++next[way];
          BearingSpecOf<3> spring;
          spring.name = fmt::format("spring {}", ++springs), spring.body_a = name(at), spring.body_b = name(next);
          spring.point_a = Vec3(at[0], at[1], at[2]), spring.point_b = Vec3(next[0], next[1], next[2]);
          spring.law[0] = Linear{stiffness[way], 0};
          builder.add_bearing(spring);
        }
  return builder.build();
}

TEST_CASE("M7: a grid of masses in space has the frequencies of its sines") {
  const std::array<int, 3> count{3, 2, 2};
  const std::array<double, 3> stiffness{1e6, 2e6, 3e6};
  const Model<3> model = sprung_grid_in_space(count, stiffness);
  const std::vector<NaturalMode<3>> found = modes(model, initial_state(model), 12);
  check_frequencies_in_space(found, grid_frequencies(count, stiffness), 1e-4);
  check_frequencies_in_space(found, {118.949, 133.159, 145.991, 155.824}, 1e-4);
  CHECK(near(found.back().frequency(), 215.972, 1e-4));
}

/// Links of 3 kg/m connected by spherical hinges at their ends: slender rods, or the mass of each as a small ball at
/// its lower end. Their rotation about the vertical is fixed, because it has no stiffness.
Model<3> hanging_chain(int links, double length, bool rods) {
  SolidModelBuilder builder;
  builder.gravity = Vec3(0, 0, -standard_gravity);
  SolidSpec top;
  top.name = "link 0", top.pieces = {box_at({1, 1, 0.2}, {0, 0, 1})}, top.mass = 1, top.floating = true;
  top.support.fill(Support::fixed);
  builder.add_body(top);
  const double side = 0.01 * length;
  for (int i = 1; i <= links; ++i) {
    const double upper = -length * (i - 1);
    SolidSpec link;
    link.name = fmt::format("link {}", i), link.mass = 3 * length, link.floating = true;
    if (rods)
      link.pieces = {box_at({side, side, length}, {0, 0, upper - 0.5 * length})};
    else
      link.spheres = {{Vec3(0, 0, upper - length), side}};
    link.support[5] = Support::fixed;
    builder.add_body(link);
    BearingSpecOf<3> hinge;
    hinge.name = fmt::format("hinge {}", i), hinge.body_a = fmt::format("link {}", i - 1), hinge.body_b = link.name;
    hinge.point_a = hinge.point_b = {0, 0, upper};
    hinge.arm = length;  // a ball hangs on a massless arm
    for (std::size_t k = 0; k < 3; ++k) hinge.law[k] = Linear{1e8, 0};
    builder.add_bearing(hinge);
  }
  return builder.build();
}

/// A chain at rest under its weight has each of these frequencies [Hz] twice, along x and along y.
void check_hanging(const Model<3>& model, const std::vector<double>& expected) {
  State<3> state = initial_state(model);
  REQUIRE(find_equilibrium(model, state).converged);
  std::vector<double> twice;
  for (const double f : expected) twice.insert(twice.end(), 2, f);
  check_frequencies_in_space(modes(model, state, static_cast<int>(twice.size())), twice, 1e-3);
}

TEST_CASE("M9: hanging chains in space swing both ways by their weight alone") {
  check_hanging(hanging_chain(3, 0.5, false), {.45449, 1.06762, 1.76774});
  check_hanging(hanging_chain(2, 1, true), {.42648, 1.14392});
  check_hanging(hanging_chain(4, 0.5, true), {.42453, 1.02373, 1.79717, 2.95906});
  check_hanging(hanging_chain(80, 2.0 / 80, true), {.42376, .97270, 1.52489});
}

/// Frequencies of modes with nodal displacements mostly along one axis, by axis.
std::array<std::vector<double>, 3> frequencies_by_axis(const std::vector<NaturalMode<3>>& found) {
  std::array<std::vector<double>, 3> out;
  for (const NaturalMode<3>& mode : found) {
    Vec3 along = Vec3::Zero();
    for (const Vec3& v : mode.displacement) along += v.cwiseAbs();
    Eigen::Index most = 0;
    // A torsion mode displaces no node; a rigid-body mode has zero frequency.
    if (along.maxCoeff(&most) > 1e-2 && mode.frequency() > 1)
      out[static_cast<std::size_t>(most)].push_back(mode.frequency());
  }
  return out;
}

TEST_CASE("M1: a free beam in space has six rigid modes and swings about both axes and along as Timoshenko's beam") {
  // Lumped masses: the free ends carry half an element each, which lowers the frequencies of 40 elements by 0.3 % to
  // 0.9 %.
  SolidSpec spec = chain_body("beam", {Vec3::Zero(), Vec3(2, 0, 0)}, plain_section(0.05, 0.1), 80);
  spec.frame->members[0].shear = true;
  const Model<3> model = of_space_frames(member_material(2700, 7e10, 0.25), {spec});
  const std::vector<NaturalMode<3>> found = modes(model, initial_state(model), 24);
  for (std::size_t i = 0; i < 6; ++i) CHECK(std::sqrt(std::abs(found[i].square)) / (2 * M_PI) < 1e-3);
  auto by_axis = frequencies_by_axis(found);
  if (by_axis[1].front() > by_axis[2].front()) std::swap(by_axis[1], by_axis[2]);
  const std::vector<double>&weak = by_axis[1], &strong = by_axis[2];
  MESSAGE(fmt::format("weak {:.5g}, strong {:.5g} {:.5g} {:.5g}, axial {:.6g}; rigid {:.1e} Hz", weak[0], strong[0],
                      strong[1], strong[2], by_axis[0].front(), std::sqrt(std::abs(found[5].square)) / (2 * M_PI)));
  CHECK(near(weak[0], 65.424, 5e-3));
  CHECK(near(strong[0], 129.691, 5e-3));
  CHECK(near(strong[1], 351.825, 5e-3));
  CHECK(near(strong[2], 674.48, 5e-3));
  CHECK(near(by_axis[0].front(), 1272.94, 5e-3));
}

TEST_CASE("M10: a beam on two supports in space swings slower under a push and faster under a pull, both ways") {
  const double length = 6, young = 3e10;
  const Section3 section = plain_section(0.3, 0.1);
  const double weak = 0.3 * 0.001 / 12, critical = M_PI * M_PI * young * weak / 36;
  std::array<double, 3> plain{};
  struct Row {
    double share;
    std::array<double, 3> factor;
  };
  for (const Row& row :
       {Row{0, {1, 1, 1}}, Row{0.5, {.70711, .93541, .97183}}, Row{-0.3, {1.14018, 1.03682, 1.01653}}}) {
    SolidSpec spec = chain_body("beam", {Vec3::Zero(), Vec3(length, 0, 0)}, section, 24);
    spec.frame->joints[0].support = {Support::fixed, Support::fixed, Support::fixed,
                                     Support::fixed, Support::free,  Support::free};
    spec.frame->joints[1].support = {Support::free,  Support::fixed, Support::fixed,
                                     Support::fixed, Support::free,  Support::free};
    Model<3> model = of_space_frames(member_material(2400, young), {spec});
    model.load[1] = Vec3(-row.share * critical, 0, 0);
    State<3> state = initial_state(model);
    if (row.share != 0) REQUIRE(find_equilibrium(model, state).converged);
    const std::vector<NaturalMode<3>> found = modes(model, state, 20);
    // Across the thin side.
    const std::vector<double> thin = frequencies_by_axis(found)[2];
    REQUIRE(thin.size() >= 3);
    for (std::size_t i = 0; i < 3; ++i) {
      if (row.share == 0) plain[i] = thin[i];
      CHECK(near(thin[i] / plain[i], row.factor[i], 2e-3));
    }
  }
}

/// Load at which the stiffness of the lowest mode of a column or frame vanishes: the zero of w^2, which is nearly
/// linear in the load, by two loads close to it.
double buckling_load(const std::function<Model<3>(double)>& loaded, double guess) {
  const auto square = [&](double load) {
    const Model<3> model = loaded(load);
    State<3> state = initial_state(model);
    REQUIRE(find_equilibrium(model, state).converged);
    return modes(model, state, 1).front().square;
  };
  const double a = 0.97 * guess, b = 0.99 * guess, at_a = square(a), at_b = square(b);
  return a + (b - a) * at_a / (at_a - at_b);
}

TEST_CASE("F6: a column in space buckles at Euler's loads, as its lowest frequency goes to 0") {
  constexpr auto fixed = Support::fixed, free = Support::free;
  const std::array<Support, 6> pinned{fixed, fixed, fixed, fixed, free, free};
  struct Column {
    std::array<Support, 6> foot, head;
    double load;
  };
  for (const Column& c : {Column{clamped, {}, 29986}, Column{pinned, {free, fixed, fixed, fixed, free, free}, 119943},
                          Column{clamped, {free, fixed, fixed, fixed, free, free}, 245373},
                          Column{clamped, {free, fixed, fixed, fixed, fixed, fixed}, 479772}}) {
    const auto loaded = [&](double load) {
      SolidSpec spec = chain_body("column", {Vec3::Zero(), Vec3(3, 0, 0)}, plain_section(0.05, 0.05), 16);
      spec.frame->joints[0].support = c.foot, spec.frame->joints[1].support = c.head;
      Model<3> model = of_space_frames(member_material(7850, 2.1e11, 0.3), {spec});
      model.load[1] = Vec3(-load, 0, 0);
      return model;
    };
    const double found = buckling_load(loaded, c.load);
    MESSAGE("F6: " << found << " N (" << c.load << ")");
    CHECK(near(found, c.load, 5e-3));
  }
}

TEST_CASE("F7: a portal in space that is held in its plane sways at the loads of the closed form") {
  constexpr auto fixed = Support::fixed, free = Support::free;
  for (const auto& [foot, expected] :
       {std::pair(clamped, 807095.0),
        std::pair(std::array<Support, 6>{fixed, fixed, fixed, fixed, free, fixed}, 199204.0)}) {
    const auto loaded = [&, of_foot = foot](double load) {
      SolidSpec spec =
          chain_body("portal", {Vec3::Zero(), Vec3(0, 0, 4), Vec3(4, 0, 4), Vec3(4, 0, 0)}, plain_section(0.1, 0.1), 8);
      spec.frame->joints[0].support = spec.frame->joints[3].support = of_foot;
      // The corners are fixed out of the plane; otherwise the columns would buckle that way first.
      for (const std::size_t j : {1, 2}) spec.frame->joints[j].support = {free, fixed, free, fixed, free, fixed};
      Model<3> model = of_space_frames(member_material(7850, 2.1e11, 0.3), {spec});
      model.load[1] = model.load[2] = Vec3(0, 0, -load);
      return model;
    };
    const double found = buckling_load(loaded, expected);
    MESSAGE("F7: " << found << " N (" << expected << ")");
    CHECK(near(found, expected, 5e-3));
  }
}

TEST_CASE("modes in space are rejected where nothing can move") {
  SpaceBuilder builder;
  builder.gravity(Vec3::Zero());
  builder.add(fixed_stone("base", box_at({1, 1, 1}, Vec3::Zero())));
  builder.contact(0, 0, frictional(1e9, 1e9, 0.5), "joint");
  const Model<3> model = builder.build();
  CHECK_THROWS_WITH(static_cast<void>(modes(model, initial_state(model), 3)), "modes: no degree of freedom is free");
}

}  // namespace
}  // namespace trilith::testing
