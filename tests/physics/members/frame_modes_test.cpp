// VALIDATION M1, M3: natural frequencies of a free beam and of a portal.
#include "modal/modes.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"

namespace trilith::testing {
namespace {

/// Reduces the rotary inertia of the sections to a negligible share: an Euler-Bernoulli beam.
void without_turning_inertia(Model<2>& model) {
  for (double& inertia : model.inertia) inertia *= 1e-3;
}

std::vector<double> frequencies_of(const Model<2>& model, int count) {
  std::vector<double> out;
  for (const Mode& mode : modes(model, initial_state(model), count)) out.push_back(mode.frequency());
  return out;
}

void check_all(const std::string& what, const std::vector<double>& found, const std::vector<double>& expected,
               double tolerance) {
  REQUIRE(found.size() >= expected.size());
  std::string line = what + ":";
  for (std::size_t i = 0; i < expected.size(); ++i) {
    line += fmt::format(" {:.4f} ({})", found[i], expected[i]);
    CHECK(near(found[i], expected[i], tolerance));
  }
  MESSAGE(line << " Hz");
}

/// A beam of aluminium of 2 m, free at both ends, of 40 elements.
Model<2> free_beam(double width, double depth, bool shear) {
  BodySpec spec = beam_body("beam", {0, 0}, {2, 0}, rectangle_section(width, depth), "aluminium", 40);
  spec.frame->members[0].shear = shear;
  return of_frames(elastic_material("aluminium", 2700, 70e9, 0.25), {spec});
}

/// The frequencies of bending modes, which follow the three rigid-body modes.
std::vector<double> beyond_rigid(const Model<2>& model, int count) {
  std::vector<double> all = frequencies_of(model, count + 3);
  all.erase(all.begin(), all.begin() + 3);
  return all;
}

TEST_CASE("M1: a free beam has three rigid motions in the plane and then the frequencies of its theory") {
  for (const bool shear : {false, true})
    for (const bool upright : {false, true}) {
      const std::vector<double> all = frequencies_of(free_beam(upright ? 0.05 : 0.1, upright ? 0.1 : 0.05, shear), 4);
      MESSAGE(fmt::format("M1 rigid: {:.1e}, {:.1e}, {:.1e} Hz", all[0], all[1], all[2]));
      for (int i = 0; i < 3; ++i) CHECK(all[i] < 1e-3);
      CHECK(all[3] > 1);
    }
  Model<2> strong = free_beam(0.05, 0.1, false), weak = free_beam(0.1, 0.05, false);
  without_turning_inertia(strong), without_turning_inertia(weak);
  check_all("M1 Euler, strong", beyond_rigid(strong, 3), {130.848, 360.687, 707.09}, 0.005);
  check_all("M1 Euler, weak", beyond_rigid(weak, 1), {65.424}, 0.005);
  check_all("M1 Timoshenko, strong", beyond_rigid(free_beam(0.05, 0.1, true), 3), {129.691, 351.825, 674.48}, 0.005);
}

TEST_CASE("M1: a free beam has the axial frequencies of a free bar") {
  const Model<2> model = free_beam(0.05, 0.1, true);
  double axial = 0;
  for (const Mode& mode : modes(model, initial_state(model), 12)) {
    double along = 0, across = 0;
    for (const Vec2& d : mode.displacement) along += d.x() * d.x(), across += d.y() * d.y();
    if (axial == 0 && along > 1e6 * across && mode.frequency() > 1) axial = mode.frequency();
  }
  MESSAGE("M1 axial " << axial << " Hz (1272.94)");
  CHECK(near(axial, 1272.94, 0.005));
}

/// A portal of height 3 m and width 4 m, 8 elements per member. `stiffer`: factor on the area and axial stiffness of
/// its sections, at the same mass.
Model<2> portal_on(const std::array<Support, 3>& foot, double stiffer) {
  BodySpec spec;
  spec.name = "portal", spec.kind = BodyKind::frame, spec.material = "concrete", spec.floating = true;
  FrameSpec frame;
  frame.joints = {{.name = "a", .place = {0, 0}, .support = foot},
                  {.name = "b", .place = {0, 3}},
                  {.name = "c", .place = {4, 3}},
                  {.name = "d", .place = {4, 0}, .support = foot}};
  for (const int i : {0, 1, 2}) {
    const double depth = i == 1 ? 0.4 : 0.3;
    FrameMember member;
    member.from = i, member.to = i + 1, member.divisions = 8;
    member.section = given_section(stiffer * 0.2 * depth, 0.2 * depth * depth * depth / 12, depth);
    frame.members.push_back(member);
  }
  spec.frame = frame;
  return of_frames(elastic_material("concrete", 2400 / stiffer, 30e9), {spec});
}

TEST_CASE("M3: a portal with and without stretch of its members, on fixed and on pinned feet") {
  struct Row {
    std::string what;
    std::array<Support, 3> foot;
    double stiffer;
    std::vector<double> expected;
  };
  for (const Row& row : {Row{"fixed, rigid along", held, 1e4, {15.1215, 50.573, 110.828, 115.838}},
                         Row{"fixed", held, 1, {15.0926, 49.405, 110.388, 112.641}},
                         Row{"pinned, rigid along", hinged, 1e4, {7.1551, 44.967, 80.254}},
                         Row{"pinned", hinged, 1, {7.1405, 44.269, 80.069}}}) {
    Model<2> model = portal_on(row.foot, row.stiffer);
    without_turning_inertia(model);
    check_all("M3 " + row.what, frequencies_of(model, 4), row.expected, 0.002);
  }
}

}  // namespace
}  // namespace trilith::testing
