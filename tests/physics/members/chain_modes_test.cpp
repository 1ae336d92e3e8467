// VALIDATION M7, M8, M9: natural frequencies of grids, of a slab in plan, of hanging chains.
#include <algorithm>

#include "modal/modes.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"
#include "physics/members/grid_frequencies.hpp"
#include "statics/equilibrium.hpp"

namespace trilith::testing {
namespace {

void check_lowest(const std::string& what, const std::vector<Mode>& found, const std::vector<double>& expected,
                  double tolerance) {
  REQUIRE(found.size() >= expected.size());
  std::string line = what + ":";
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (i < 4) line += fmt::format(" {:.5f} ({:.5f})", found[i].frequency(), expected[i]);
    CHECK(near(found[i].frequency(), expected[i], tolerance));
  }
  MESSAGE(line << " Hz");
}

/// Masses of 10 kg in a grid of up to three directions, with springs between neighbours and to walls on all sides. Each
/// mass moves along x alone, so its drawn position has no influence, and layers are drawn next to each other.
Model<2> sprung_grid(const std::array<int, 3>& count, const std::array<double, 3>& stiffness) {
  Scene scene(Frictional{1e6, 1e6, 0.5, 0});
  scene.set_gravity({0, 0});
  scene.builder.set_contact("*", "*", "none");
  scene.fixed("wall", box(-2, -2, 100, -1));
  const auto place = [](const std::array<int, 3>& at) { return Vec2(at[0] + 20.0 * at[2], at[1]); };
  const auto name = [&](const std::array<int, 3>& at) -> std::string {
    for (int k = 0; k < 3; ++k)
      if (at[k] < 0 || at[k] >= count[k]) return "wall";
    return fmt::format("{} {} {}", at[0], at[1], at[2]);
  };
  std::array<int, 3> at{};
  for (at[0] = 0; at[0] < count[0]; ++at[0])
    for (at[1] = 0; at[1] < count[1]; ++at[1])
      for (at[2] = 0; at[2] < count[2]; ++at[2]) {
        const Vec2 p = place(at);
        BodySpec body;
        body.name = name(at), body.outline = box(p.x() - 0.1, p.y() - 0.1, p.x() + 0.1, p.y() + 0.1), body.mass = 10;
        body.support = {Support::free, Support::fixed, Support::fixed}, body.floating = true;
        scene.add(body);
      }
  int springs = 0;
  for (int way = 0; way < 3; ++way)
    for (at[0] = way == 0 ? -1 : 0; at[0] < count[0]; ++at[0])
      for (at[1] = way == 1 ? -1 : 0; at[1] < count[1]; ++at[1])
        for (at[2] = way == 2 ? -1 : 0; at[2] < count[2]; ++at[2]) {
          std::array<int, 3> next = at;
          ++next[way];
          BearingSpec spring;
          spring.name = fmt::format("spring {}", ++springs), spring.body_a = name(at), spring.body_b = name(next);
          spring.point_a = spring.body_a == "wall" ? Vec2(0, -1.5) : place(at);
          spring.point_b = spring.body_b == "wall" ? Vec2(0, -1.5) : place(next);
          spring.law = {Linear{stiffness[way], 0}, {}, {}};
          scene.builder.add_bearing(spring);
        }
  return scene.builder.build();
}

TEST_CASE("M7: a grid of masses on springs has the frequencies of its sines") {
  const std::array<int, 3> count{3, 2, 2};
  const std::array<double, 3> stiffness{1e6, 2e6, 3e6};
  const std::vector<double> expected = grid_frequencies(count, stiffness);
  const Model<2> model = sprung_grid(count, stiffness);
  const std::vector<Mode> found = modes(model, initial_state(model), 12);
  REQUIRE(found.size() == 12);
  check_lowest("M7", found, expected, 1e-4);
  check_lowest("M7", found, {118.949, 133.159, 145.991, 155.824}, 1e-4);
  CHECK(near(found.back().frequency(), 215.972, 1e-4));
  // A single layer of many masses.
  const Model<2> flat = sprung_grid({7, 5, 1}, {1e6, 2e6, 0});
  check_lowest("M7, 7 by 5", modes(flat, initial_state(flat), 35), grid_frequencies({7, 5, 1}, {1e6, 2e6, 0}), 1e-4);
}

TEST_CASE("M8: a slab on four different columns, in plan, sways and twists") {
  Scene scene(Frictional{1e6, 1e6, 0.5, 0});
  scene.set_gravity({0, 0});
  scene.builder.set_contact("*", "*", "none");
  BodySpec slab;
  slab.name = "slab", slab.outline = box(0, 0, 6, 4), slab.mass = 20e3, slab.floating = true;
  scene.add(slab);
  for (const double x : {0.0, 6.0})
    for (const double y : {0.0, 4.0}) {
      const std::string name = fmt::format("{} {}", x, y);
      const double out = x > 0 ? 1 : -1;
      scene.fixed("foot " + name, box(std::min(x, x + out), y - 0.5, std::max(x, x + out), y + 0.5));
      BearingSpec column;
      column.name = "column " + name, column.body_a = "foot " + name, column.body_b = "slab";
      column.point_a = column.point_b = {x, y};
      column.law = {Linear{1e6, 0}, Linear{x > 0 ? 2e6 : 1e6, 0}, {}};
      scene.builder.add_bearing(column);
    }
  const Model<2> model = scene.builder.build();
  const std::vector<Mode> found = modes(model, initial_state(model), 5);
  CHECK(found.size() == 3);
  check_lowest("M8", found, {2.25079, 2.57587, 4.62851}, 1e-4);
}

/// The lowest `count` modes at rest under the weight.
std::vector<Mode> hanging_modes(const Model<2>& model, int count) {
  State<2> state = initial_state(model);
  REQUIRE(find_equilibrium(model, state).converged);
  return modes(model, state, count);
}

/// Point masses of 5 kg on `links` bars of negligible mass, hung at the top.
Model<2> chain_of_masses(int links, double link) {
  BodySpec spec;
  spec.name = "chain", spec.kind = BodyKind::frame, spec.material = "m", spec.floating = true;
  FrameSpec frame;
  frame.joints.push_back({.name = "top", .place = {0, 0}, .support = held});
  for (int i = 1; i <= links; ++i) {
    frame.joints.push_back({.name = fmt::format("mass {}", i),
                            .place = {0, -link * i},
                            .mass = 5,
                            .support = {Support::free, Support::free, Support::fixed}});
    FrameMember bar;
    bar.from = i - 1, bar.to = i, bar.section = given_section(1e-4, 1e-9, 0.01), bar.divisions = 2;
    bar.pinned = {true, true};
    frame.members.push_back(bar);
  }
  spec.frame = frame;
  Model<2> model = of_frames(elastic_material("m", 10, 2e11), {spec});
  model.gravity.field = {0, -standard_gravity};
  return model;
}

/// Slender rods, each a rigid body, connected by hinges.
Model<2> chain_of_rods(int rods, double length) {
  Scene scene(Frictional{1e6, 1e6, 0.5, 0});
  scene.builder.set_contact("*", "*", "none");
  scene.fixed("rod 0", box(-1, 0, 1, 1));
  for (int i = 1; i <= rods; ++i) {
    const double top = -length * (i - 1);
    BodySpec rod;
    rod.name = fmt::format("rod {}", i), rod.outline = box(-0.01, top - length, 0.01, top), rod.mass = 3 * length;
    rod.inertia = *rod.mass * length * length / 12, rod.floating = true;
    scene.add(rod);
    BearingSpec hinge;
    hinge.name = fmt::format("hinge {}", i), hinge.body_a = fmt::format("rod {}", i - 1), hinge.body_b = rod.name;
    hinge.point_a = hinge.point_b = {0, top}, hinge.law = {Linear{1e8, 0}, Linear{1e8, 0}, {}};
    scene.builder.add_bearing(hinge);
  }
  return scene.builder.build();
}

TEST_CASE("M9: hanging chains of masses and of rods swing by their weight alone") {
  check_lowest("M9, 3 masses", hanging_modes(chain_of_masses(3, 0.5), 3), {.45449, 1.06762, 1.76774}, 0.001);
  check_lowest("M9, 2 rods", hanging_modes(chain_of_rods(2, 1), 2), {.42648, 1.14392}, 0.001);
  check_lowest("M9, 4 rods", hanging_modes(chain_of_rods(4, 0.5), 4), {.42453, 1.02373, 1.79717, 2.95906}, 0.001);
  check_lowest("M9, chain", hanging_modes(chain_of_rods(120, 2.0 / 120), 3), {.42376, .97270, 1.52489}, 0.001);
}

}  // namespace
}  // namespace trilith::testing
