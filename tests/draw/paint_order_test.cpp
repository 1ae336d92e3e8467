// Hidden surfaces: the last face of a picture at a point is the first face on a ray from the eye.
#include <doctest/doctest.h>

#include <array>
#include <limits>

#include "base/error.hpp"
#include "draw/inside_outline.hpp"
#include "draw/results/results_picture.hpp"
#include "draw/scene/paint_order.hpp"
#include "draw/solid_samples.hpp"
#include "near.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::draw;
using namespace trilith::testing;

namespace {

/// Visible body at `p` of the picture; -1: none.
int seen_at(const Scene& scene, const Vec2& p) {
  for (auto face = scene.faces.rbegin(); face != scene.faces.rend(); ++face)
    if (contains(face->outline, p)) return face->body;
  return -1;
}

/// Position at which the line through `p` of the picture leaves the box towards the eye; -inf if the line misses the
/// box by `margin` [m].
double nearest_of(const FlyingBox& box, double time, const ViewAxes& view, const Vec2& p, double margin) {
  const Turn3 turn = turn_of(box.turn(time));
  const Vec3 from = turn.undo(p.x() * view.right + p.y() * view.up - box.place(time)), along = turn.undo(view.toward);
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (int k = 0; k < 3; ++k) {
    const double a = (-box.half[k] - margin - from[k]) / along[k], b = (box.half[k] + margin - from[k]) / along[k];
    low = std::max(low, std::min(a, b)), high = std::min(high, std::max(a, b));
  }
  return low < high ? high : -std::numeric_limits<double>::infinity();
}

/// Number of the `count` x `count` points that show another body than the first on a ray; points near an edge are left
/// out.
int wrong_points(const Scene& scene, const std::vector<FlyingBox>& boxes, double time, const ViewAxes& view, int count,
                 int& looked) {
  Vec2 low = scene.bodies[0].outline[0], high = low;
  for (const SceneBody& body : scene.bodies)
    for (const Vec2& p : body.outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  int wrong = 0;
  for (int i = 0; i < count * count; ++i) {
    const Vec2 share((i % count + 0.41) / count, (i / count + 0.37) / count);
    const Vec2 p = low + share.cwiseProduct(high - low);
    const std::array<double, 3> margins{-1e-4, 0, 1e-4};
    std::array<int, 3> first{-1, -1, -1};
    for (std::size_t m = 0; m < 3; ++m) {
      double best = -std::numeric_limits<double>::infinity();
      for (std::size_t b = 0; b < boxes.size(); ++b)
        if (const double at = nearest_of(boxes[b], time, view, p, margins[m]); at > best)
          best = at, first[m] = static_cast<int>(b);
    }
    if (first[0] != first[1] || first[1] != first[2]) continue;
    ++looked;
    wrong += seen_at(scene, p) != first[1];
  }
  return wrong;
}

/// Draws the boxes from a view and checks every point.
void check_hidden(const std::vector<FlyingBox>& boxes, const char* from) {
  const testing::Folder folder;
  record_boxes(folder / "run.h5", boxes, 1, 1, false);
  SceneChoice choice;
  choice.from = view_direction(from);
  const Scene scene = results_scene(results::ResultsReader(folder / "run.h5"), 0, choice);
  REQUIRE(scene.bodies.size() == boxes.size());
  int looked = 0;
  CHECK(wrong_points(scene, boxes, 0, ViewAxes(choice.from), 90, looked) == 0);
  CHECK(looked > 6000);
}

}  // namespace

TEST_CASE("in a heap of stones, a wall and a dome each point shows the stone that is nearest to the eye") {
  for (const std::string from : {"iso", "front", "top", "37,-20", "-123,61"}) {
    CAPTURE(from);
    check_hidden(heap(300), from.c_str());
    check_hidden(opening_dome(), from.c_str());
  }
  std::vector<FlyingBox> wall = falling_wall();
  wall[0].half = {1.4, 0.2, 0.05}, wall[0].start = {0, 0, -0.05};  // small enough to be drawn undivided
  for (const char* from : {"iso", "-60,20", "115,5"}) check_hidden(wall, from);
}

TEST_CASE("bars in a ring that overlap cyclically are drawn correctly, one of them in parts") {
  // Three bars along the sides of a triangle, each with one end over and one under its neighbours.
  std::vector<FlyingBox> bars;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / 3;
    const UnitQuaternion around = rotation_by({0, 0, angle});
    FlyingBox bar{{1.2, 0.12, 0.05}, turn_of(around).apply({0, -0.5, 0})};
    bar.rotation = around * rotation_by({0, 0.2, 0});
    bars.push_back(bar);
  }
  for (const char* from : {"top", "20,70", "-90,-80"}) check_hidden(bars, from);
  std::vector<SolidPiece> pieces;
  const testing::Folder folder;
  record_boxes(folder / "run.h5", bars, 1, 1, false);
  SceneChoice choice;
  choice.from = view_direction("top");
  const Scene scene = results_scene(results::ResultsReader(folder / "run.h5"), 0, choice);
  const auto drawn = scene.faces.size();
  CHECK(drawn > 6);    // two faces of each bar are visible from above ...
  CHECK(drawn <= 10);  // ... and one bar is divided into two parts
}

TEST_CASE("a non-convex solid is divided into convex pieces of the same volume and surface") {
  // An L of 2 m x 2 m, 1 m thick and 1 m deep, as a prism.
  const std::vector<Vec2> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const Polyhedron solid = prism(outline, 0, 1);
  SolidPiece whole;
  const std::vector<Vec3> normals = face_normals(solid);
  for (int f = 0; f < solid.faces.count(); ++f) {
    PieceFace face;
    for (const int corner : solid.faces[f]) face.corners.push_back(solid.corners[static_cast<std::size_t>(corner)]);
    face.is_edge.assign(face.corners.size(), true);
    face.normal = normals[static_cast<std::size_t>(f)];
    whole.faces.push_back(face);
  }
  const std::vector<SolidPiece> pieces = convex_pieces(whole, 1e-9);
  CHECK(pieces.size() == 2);
  double area = 0;
  for (const SolidPiece& piece : pieces)
    for (const PieceFace& face : piece.faces)
      for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
        area +=
            0.5 * cross(Vec3(face.corners[i] - face.corners[0]), Vec3(face.corners[i + 1] - face.corners[0])).norm();
  CHECK(near(area, 2 * 3 + 8, 1e-12));
}

TEST_CASE("a face that nearly lies in a plane is divided by it without loss") {
  // Corners of a square of 1 m with heights above the plane, in units of the tolerance.
  const std::vector<std::array<double, 4>> heights{{0.4, -0.4, 0.9, 1.7},  {-0.5, 0.1, 0.4, 1.4},  {0.2, 0.6, 1.1, 0.7},
                                                   {0.3, -0.2, 3.1, -2.8}, {-0.9, 1.2, 0.8, -1.3}, {5, 0.5, -4, 0.2},
                                                   {2, 1.5, 1.2, 1.8},     {-2, 2, 2.5, -1.5}};
  const std::array<Vec2, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (const double sense : {1.0, -1.0})
    for (const auto& height : heights) {
      const double slack = 1e-6;
      PieceFace face{{}, std::vector<bool>(4, true), Vec3::UnitZ()};
      for (std::size_t i = 0; i < 4; ++i)
        face.corners.emplace_back(square[i].x(), square[i].y(), sense * slack * height[i]);
      // Next to it a face divided by the plane, so that both sides have a part.
      const PieceFace wall{{{2, 0, -1}, {2, 1, -1}, {2, 1, 1}, {2, 0, 1}}, std::vector<bool>(4, true), Vec3::UnitX()};
      const auto [below, above] = divided({0, {face, wall}}, {Vec3::UnitZ(), 0}, slack, FaceKind::border);
      double area = 0;
      for (const SolidPiece* half : {&*below, &*above})
        for (const PieceFace& part : half->faces)
          for (std::size_t i = 1; part.kind == FaceKind::skin && i + 1 < part.corners.size(); ++i)
            area += 0.5 *
                    cross(Vec3(part.corners[i] - part.corners[0]), Vec3(part.corners[i + 1] - part.corners[0])).norm();
      CAPTURE(height[3] * sense);
      CHECK(near(area, 1 + 2, 1e-6));
    }
}

TEST_CASE("a plane divides a box into two closed boxes and leaves boxes outside unchanged") {
  const Polyhedron solid = box_solid({0, 0, 0}, {1, 2, 3});
  SolidPiece box;
  const std::vector<Vec3> normals = face_normals(solid);
  for (int f = 0; f < 6; ++f) {
    PieceFace face{{}, std::vector<bool>(4, true), normals[static_cast<std::size_t>(f)]};
    for (const int corner : solid.faces[f]) face.corners.push_back(solid.corners[static_cast<std::size_t>(corner)]);
    box.faces.push_back(face);
  }
  const auto area_of = [](const SolidPiece& piece, FaceKind kind) {
    double area = 0;
    for (const PieceFace& face : piece.faces)
      for (std::size_t i = 1; face.kind == kind && i + 1 < face.corners.size(); ++i)
        area += 0.5 * face.normal.dot(
                          cross(Vec3(face.corners[i] - face.corners[0]), Vec3(face.corners[i + 1] - face.corners[0])));
    return area;
  };
  const auto [below, above] = divided(box, {Vec3::UnitZ(), 1}, 1e-9, FaceKind::section);
  REQUIRE(below.has_value());
  REQUIRE(above.has_value());
  CHECK(below->faces.size() == 6);
  CHECK(near(area_of(*below, FaceKind::section), 2, 1e-12));
  CHECK(near(area_of(*above, FaceKind::section), 2, 1e-12));
  CHECK(near(area_of(*below, FaceKind::skin), 2 + 2 * (1 + 2), 1e-12));
  CHECK(near(area_of(*above, FaceKind::skin), 2 + 2 * 2 * (1 + 2), 1e-12));
  CHECK_FALSE(divided(box, {Vec3::UnitX(), 1}, 1e-9, FaceKind::section).second.has_value());
  CHECK_FALSE(divided(box, {Vec3::UnitX(), -2}, 1e-9, FaceKind::section).first.has_value());
  const Vec3 askew = Vec3(1, 1, 1).normalized();
  const auto [corner, rest] = divided(box, {askew, 0.5 * askew.x()}, 1e-9, FaceKind::section);
  CHECK(near(area_of(*corner, FaceKind::section), std::sqrt(3.0) / 8, 1e-12));
  CHECK(near(area_of(*rest, FaceKind::section), std::sqrt(3.0) / 8, 1e-12));
}

TEST_CASE("views have names or two angles, and their axes are at right angles") {
  const ViewAxes front(view_direction("front")), top(view_direction("top")), iso(view_direction("iso"));
  CHECK((front.right - Vec3::UnitX()).norm() < 1e-15);
  CHECK((front.up - Vec3::UnitZ()).norm() < 1e-15);
  CHECK((top.right - Vec3::UnitX()).norm() < 1e-15);
  CHECK((top.up - Vec3::UnitY()).norm() < 1e-15);
  CHECK((ViewAxes(view_direction("right")).right - Vec3::UnitY()).norm() < 1e-15);
  CHECK((ViewAxes(view_direction("left")).right + Vec3::UnitY()).norm() < 1e-15);
  CHECK((ViewAxes(view_direction("back")).right + Vec3::UnitX()).norm() < 1e-15);
  for (int k = 0; k < 3; ++k) CHECK(near(iso.flat(Vec3::Unit(k)).norm(), std::sqrt(2.0 / 3), 1e-12));
  CHECK(view_direction("30,-12.5").elevation == -12.5);
  CHECK_THROWS_WITH_AS(view_direction("fornt"), doctest::Contains("did you mean 'front'?"), InputError);
  for (const char* text : {"10,91", "1,2,3", "a,b", "nan,0", "0,"}) CHECK_THROWS_AS(view_direction(text), InputError);
}
