// Corners and edges shared by the pieces of a body, and ridges among them.
#include "model/builder/shared_edges.hpp"

#include <doctest/doctest.h>

#include "model/contact/skin_places.hpp"
#include "model/space_builder/space_builder.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Positions of all ridges of a plane model.
std::vector<Vec2> places(const Model<2>& model, const SharedEdges& ridges) {
  std::vector<Vec2> at;
  if (ridges.empty()) return at;
  for (std::size_t r = 0; r + 1 < ridges.piece_first.size(); ++r) {
    const int p = ridges.pieces_of(static_cast<int>(r))[0];
    for (const SharedEdgePart& part : ridges.parts_of(p))
      if (part.ridge == static_cast<int>(r))
        at.push_back(skin_start(model, model.corner_skin[model.piece_first[p] + part.from]));
  }
  return at;
}

std::vector<Vec2> places_of(const Polygon& outline) {
  Scene scene(Frictional{1e9, 5e8, 0.6, 0});
  scene.fixed("stone", outline);
  const Model<2> model = scene.builder.build();
  return places(model, shared_edges(model));
}

std::vector<Vec2> places_of_mesh(const Mesh& mesh) {
  Scene scene(Frictional{1e9, 5e8, 0.6, 0});
  BodySpec spec;
  spec.name = "mesh", spec.kind = BodyKind::mesh, spec.mesh = mesh, spec.support = held, spec.material = "elastic";
  scene.builder.add_material({"elastic", 2000, Solid{LinearElastic{1e9, 0.2}}});
  scene.add(spec);
  const Model<2> model = scene.builder.build();
  return places(model, shared_edges(model));
}

}  // namespace

TEST_CASE("a convex stone has no ridge, a chevron has one at its top and none in its hollow") {
  CHECK(places_of(box(0, 0, 1, 1)).empty());
  const std::vector<Vec2> at = places_of({{-0.3, -0.3}, {0, -0.15}, {0.3, -0.3}, {0, 0}});
  REQUIRE(at.size() == 1);
  CHECK(at[0].norm() < 1e-12);
}

TEST_CASE("a hollow of 8 degrees is a flat shared edge, one of 14 is not") {
  // Two pieces, divided from the hollow at the top to the middle of the bottom or its corners.
  const auto hollow = [](double angle) {
    const double deep = std::tan(0.5 * angle * degree);
    int found = 0;
    for (const Vec2& x : places_of({{-1, -1}, {1, -1}, {1, 0}, {0, -deep}, {-1, 0}}))
      found += (x - Vec2(0, -deep)).norm() < 1e-12 ? 1 : 0;
    return found;
  };
  CHECK(hollow(8) == 1);
  CHECK(hollow(14) == 0);
}

TEST_CASE(
    "nodes that two elements share on a straight side are ridges, corners of one element and inner nodes are not") {
  Mesh mesh;
  for (const double y : {0.0, 1.0, 2.0})
    for (const double x : {0.0, 1.0, 2.0}) mesh.node.emplace_back(x, y);
  for (const int first : {0, 1, 3, 4}) mesh.element.push_back({first, first + 1, first + 4, first + 3});
  const std::vector<Vec2> at = places_of_mesh(mesh);
  CHECK(at.size() == 4);
  for (const Vec2& x : at) CHECK(near((x - Vec2(1, 1)).norm(), 1, 1e-12));
}

TEST_CASE(
    "a chevron of two prisms has its ridge with both ends, and on either end face the flat edge between the two") {
  SolidBody body;
  body.name = "chevron", body.density = 2000;
  const std::vector<Vec2> left{{-0.3, -0.3}, {0, -0.15}, {0, 0}}, right{{0, -0.15}, {0.3, -0.3}, {0, 0}};
  body.pieces = {prism(left, 0, 2), prism(right, 0, 2)};
  SpaceBuilder builder;
  builder.add(body);
  const Model<3> model = builder.build();
  const SharedEdges ridges = shared_edges(model);
  const auto place = [&](int corner) { return skin_start(model, model.corner_skin[corner]); };
  int corners = 0, along = 0, flat = 0;
  for (const SharedEdgePart& part : ridges.parts_of(0)) {
    CHECK(ridges.pieces_of(part.ridge).size() == 2);
    const Vec3 from = place(part.from), way = place(part.to) - from;
    CHECK(std::abs(from.x()) < 1e-12);
    if (part.from == part.to) {
      ++corners;
      CHECK(std::abs(from.y()) < 1e-12);
    } else {
      std::abs(way.z()) > 1 ? ++along : ++flat;
      if (std::abs(way.z()) > 1) CHECK(std::abs(from.y()) < 1e-12);
    }
  }
  CHECK(corners == 2);
  CHECK(along == 1);
  CHECK(flat == 2);
}
