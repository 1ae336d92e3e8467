// Cracks between solids: joints detected from faces at the start, their later state, and visibility in pictures.
#include "draw/results/solid_cracks.hpp"

#include <doctest/doctest.h>

#include "draw/results/results_picture.hpp"
#include "near.hpp"
#include "results/sample_run.hpp"
#include "results/tumbling_boxes.hpp"

using namespace trilith;
using namespace trilith::draw;
using namespace trilith::testing;

namespace {

/// A stone of 2 m x 1 m x 1 m on one of 4 m x 1 m x 1 m, which stands free on z = 0; the upper one moves by `way` [m].
std::vector<FlyingBox> two_stones(const Vec3& way) {
  return {{{2, 0.5, 0.5}, {0, 0, 0.5}}, {{1, 0.5, 0.5}, {0.5, 0, 1.5}, way}};
}

struct Made {
  results::Header header;
  results::Frame frame;  ///< after 1 s
};

Made made_of(const std::vector<FlyingBox>& boxes) {
  const Folder folder;
  record_boxes(folder / "run.h5", boxes, 2, 1, false);
  const results::ResultsReader reader(folder / "run.h5");
  return {reader.header(), reader.frame(1)};
}

std::vector<CrackMark> marks_after(const Vec3& way, const PairBonds& bonds = {}) {
  const Made made = made_of(two_stones(way));
  std::vector<CrackMark> out;
  for (const SolidCrack& crack :
       solid_cracks(solid_joints(made.header), results::Placement(made.header, made.frame), bonds, {false, false}))
    out.push_back(crack.mark);
  return out;
}

Scene picture_of(const Vec3& way, const std::optional<CutPlane>& cut, const char* from) {
  const Folder folder;
  record_boxes(folder / "run.h5", two_stones(way), 2, 1, false);
  SceneChoice choice;
  choice.cracks = true;
  choice.from = view_direction(from);
  choice.cut = cut;
  return results_scene(results::ResultsReader(folder / "run.h5"), 1, choice);
}

/// Cracks on the faces of a picture from the front, with x to the right and z upwards.
std::vector<SceneCrack> cracks_from_front(const Vec3& way, const std::optional<CutPlane>& cut) {
  std::vector<SceneCrack> out;
  for (const SceneFace& face : picture_of(way, cut, "front").faces)
    out.insert(out.end(), face.cracks.begin(), face.cracks.end());
  return out;
}

}  // namespace

TEST_CASE("two solids have a joint where their faces touch, with its opening and slip") {
  const Made made = made_of(two_stones({0.003, 0.004, 0.002}));
  const std::vector<SolidJoint> joints = solid_joints(made.header);
  REQUIRE(joints.size() == 1);
  CHECK(joints[0].a.body == 0);
  CHECK(joints[0].b.body == 1);
  CHECK(near(joints[0].size, std::sqrt(5.0), 1e-12));
  const SolidJointMotion motion = motion_of(joints[0], results::Placement(made.header, made.frame));
  CHECK(near(motion.opening, 0.002, 1e-9));
  CHECK(near(motion.slip, 0.005, 1e-9));
}

TEST_CASE("solids that are apart at the start or both held or only share an edge have no joint") {
  std::vector<FlyingBox> apart = two_stones(Vec3::Zero());
  apart[1].start.z() += 0.1;
  CHECK(solid_joints(made_of(apart).header).empty());
  std::vector<FlyingBox> held = two_stones(Vec3::Zero());
  for (FlyingBox& box : held) box.support = "fixed";
  CHECK(solid_joints(made_of(held).header).empty());
  std::vector<FlyingBox> edge = two_stones(Vec3::Zero());
  edge[1].start.x() = 3;
  CHECK(solid_joints(made_of(edge).header).empty());
}

TEST_CASE("a joint that rotates open reports the opening of its farthest corner") {
  std::vector<FlyingBox> boxes = two_stones(Vec3::Zero());
  const double angle = 1e-4;
  boxes[1].spin = {0, angle, 0};  // about its middle: one side rises, the other sinks
  const Made made = made_of(boxes);
  const SolidJointMotion motion = motion_of(solid_joints(made.header)[0], results::Placement(made.header, made.frame));
  CHECK(near(motion.opening, angle * 1, 1e-3));
  CHECK(near(motion.slip, angle * 0.5, 1e-3));
}

TEST_CASE("cracks of solids have the classes of those in the plane and bonded ones are drawn once lost") {
  using Marks = std::vector<CrackMark>;
  const auto twice = [](CrackMark mark) { return Marks{mark, mark}; };  // one for each body
  CHECK(marks_after({0, 0, 5e-5}) == Marks{});
  CHECK(marks_after({0, 0, 5e-4}) == twice(CrackMark::fine));
  CHECK(marks_after({1e-3, 0, 3e-3}) == twice(CrackMark::opened));
  CHECK(marks_after({0, 0, 3e-2}) == twice(CrackMark::wide));
  CHECK(marks_after({0, -2e-3, 1e-4}) == twice(CrackMark::slid));
  CHECK(marks_after({0, 0, 5e-5}, {{{0, 1}}, {}}) == twice(CrackMark::fine));
  CHECK(marks_after({0, 0, 5e-4}, {{}, {{0, 1}}}) == Marks{});
  CHECK(marks_after({0, 0, 5e-4}, {{{0, 1}}, {{0, 1}}}) == twice(CrackMark::fine));
  CHECK(marks_after({0, 0, 3}) == Marks{});  // no neighbours
}

TEST_CASE("a crack is drawn where its joint reaches a visible face or a section") {
  // The long side of each body from the front: at z = 1 m, and 2 mm higher, from x = -0.5 m to 1.5 m.
  const std::vector<SceneCrack> front = cracks_from_front({0, 0, 0.002}, std::nullopt);
  REQUIRE(front.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(near(std::abs(front[i].a.x() - front[i].b.x()), 2, 2e-3));
    CHECK(near(front[i].a.y(), front[i].b.y(), 1e-12));
    CHECK(near(front[i].a.y(), i == 0 ? 1 : 1.002, 1e-9));
    CHECK(front[i].mark == CrackMark::opened);
  }
  // Cut lengthwise: the same on the sections.
  const std::vector<SceneCrack> cut = cracks_from_front({0, 0, 0.002}, CutPlane{Vec3::UnitY(), 0.1});
  REQUIRE(cut.size() == 2);
  CHECK(near(std::abs(cut[0].a.x() - cut[0].b.x()), 2, 2e-3));
  // From below the lower body's face covers it.
  const Scene below = picture_of({0, 0, 0.002}, std::nullopt, "0,-90");
  CHECK(below.faces.back().body == 0);
  CHECK(below.faces.back().cracks.empty());
}
