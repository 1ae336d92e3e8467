// Mean stress of bodies on bearings, from the forces on them.
#include "run/record/body_forces.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "assembly/contact/contact_resultants.hpp"
#include "law/bearing/linear.hpp"
#include "near.hpp"
#include "physics/space/solids.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A body 0.5 m wide and 0.4 m high hangs from a fixed beam, and a rigid block hangs from the body, each on two
/// bearings whose ends are `rod` [m] apart.
struct Hanging {
  int nx, ny;           // elements of the upper body; 0: it is rigid
  bool upper_is_first;  // order of the two bodies in the bearings
  double rod;           // [m]
};

constexpr double slice = 0.7, upper_width = 0.5, upper_height = 0.4, lower_height = 0.6;

void hang(Scene& scene, const std::string& name, const std::string& first, const std::string& second,
          const Vec2& at_first, const Vec2& at_second) {
  BearingSpec b;
  b.name = name, b.body_a = first, b.body_b = second, b.point_a = at_first, b.point_b = at_second;
  b.law = {Linear{1e4, 1e3}, Linear{1e8, 1e5}, Linear{}};  // so soft along the bodies that they are hardly strained
  scene.builder.add_bearing(b);
}

/// Mean stress of the upper body at rest.
MeanStress stress_of(const Hanging& h) {
  Scene scene(Frictional{1e8, 5e7, 0.5, 0});
  scene.builder.thickness = slice;
  scene.builder.set_contact("*", "*", "none");
  scene.builder.add_material(elastic("soft", 2000, 2e9, 0));
  scene.fixed("beam", box(-1, 2, 1, 3));
  const double top = 2 - h.rod, bottom = top - upper_height, hook = bottom - h.rod;
  const Polygon outline = box(-upper_width / 2, bottom, upper_width / 2, top);
  BodySpec upper = grid_body("upper", outline, "soft", h.nx, h.ny);
  if (h.nx == 0) upper.kind = BodyKind::rigid, upper.divisions = {};
  scene.add(upper);
  BodySpec lower;
  lower.name = "lower", lower.outline = box(-upper_width / 2, hook - lower_height, upper_width / 2, hook),
  lower.floating = true;
  scene.add(lower);
  for (const double x : {-upper_width / 4, upper_width / 4}) {
    const std::string side = x < 0 ? "left" : "right";
    const Vec2 beam(x, 2), above(x, top), below(x, bottom), block(x, hook);
    if (h.upper_is_first) {
      hang(scene, "top " + side, "upper", "beam", above, beam);
      hang(scene, "bottom " + side, "upper", "lower", below, block);
    } else {
      hang(scene, "top " + side, "beam", "upper", beam, above);
      hang(scene, "bottom " + side, "lower", "upper", block, below);
    }
  }
  Simulation<2> sim = scene.start();
  CHECK(settle(sim, 50, 1e-8).end == StageEnd::rest);
  sim.refresh();
  std::vector<TouchingContact> touching;
  contact_resultants(sim.model(), sim.state(), sim.work(), touching);
  return mean_stress(sim.model(), sim.state(), sim.work(), touching)[sim.model().find_body("upper")];
}

}  // namespace

TEST_CASE("a body that hangs on bearings has the mean stress of the weight below it") {
  // Tension by the block's weight at the foot, and by the block's and its own weight at the head: half of its own on
  // average.
  const double weight = 2000 * standard_gravity * upper_width * slice * upper_height,
               block = 2000 * standard_gravity * upper_width * slice * lower_height;
  const double expected = (block + 0.5 * weight) / (upper_width * slice);
  for (const auto& cells : {std::pair{0, 0}, std::pair{1, 1}, std::pair{4, 2}})
    for (const bool upper_is_first : {false, true})
      for (const double rod : {0.0, 0.25}) {
        CAPTURE(cells.first);
        CAPTURE(upper_is_first);
        CAPTURE(rod);
        const MeanStress stress = stress_of({cells.first, cells.second, upper_is_first, rod});
        CHECK(near(stress.yy, expected, 1e-4));  // its upper_height grows by the share yy/E = 1e-5
        CHECK(near_zero(stress.xx, 1e-4 * expected));
        CHECK(near_zero(stress.xy, 1e-4 * expected));
      }
}
