#include "model/check/thickness.hpp"

#include "geometry/plane/polygon.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

Model<2> one_body(const Polygon& outline) {
  Scene scene(Frictional{1e8, 5e7, 0.6, 0});
  BodySpec spec;
  spec.name = "one", spec.outline = outline, spec.floating = true;
  scene.add(spec);
  return scene.builder.build();
}

}  // namespace

TEST_CASE("the least width of a convex outline is the width of its narrowest strip") {
  CHECK(near(least_width(box(0, 0, 3, 0.2)), 0.2, 1e-12));
  CHECK(near(least_width(Polygon{{0, 0}, {4, 0}, {0, 3}}), 2.4, 1e-12));
  Polygon turned;
  for (const Vec2& p : box(-2, -0.05, 1, 0.05)) turned.push_back(Turn(0.7).apply(p));
  CHECK(near(least_width(turned), 0.1, 1e-12));
}

TEST_CASE("a body of one piece is as thick as its least width") {
  const Model<2> model = one_body(box(0, 1, 2, 1.3));
  REQUIRE(model.pieces() == 1);
  CHECK(near(model.piece_thickness[0], 0.3, 1e-12));
  CHECK(near(model.least_thickness, 0.3, 1e-12));
}

TEST_CASE("an inner cut is not an end of a body - a low step on a thick base is as thick as both") {
  // A step of 0.1 x 1 on a base 0.8 thick.
  const Model<2> model = one_body({{0, 0}, {3, 0}, {3, 0.8}, {2, 0.8}, {2, 0.9}, {1, 0.9}, {1, 0.8}, {0, 0.8}});
  REQUIRE(model.pieces() > 1);
  CHECK(model.least_thickness >= 0.8 - 1e-12);
}

TEST_CASE("the thin leg of an angle has its own thickness, not the thickness of the whole angle") {
  const Model<2> model = one_body({{0, 0}, {2, 0}, {2, 0.5}, {0.02, 0.5}, {0.02, 3}, {0, 3}});
  REQUIRE(model.pieces() > 1);
  CHECK(near(model.least_thickness, 0.02, 1e-9));
}

TEST_CASE("a body without contacts does not reduce the least thickness of the model") {
  ModelBuilder builder;
  builder.add_material({"stone", 2000});
  builder.add_material({"paper", 1000});
  builder.add_law("joint", Frictional{1e8, 5e7, 0.6, 0});
  builder.set_contact("stone", "stone", "joint");
  const auto add = [&](const std::string& name, const Polygon& outline, const std::string& material) {
    BodySpec spec;
    spec.name = name, spec.outline = outline, spec.material = material, spec.floating = true;
    builder.add_body(spec);
  };
  add("thick", box(0, 0, 1, 1), "stone");
  add("thin", box(5, 0, 6, 0.001), "paper");
  CHECK(near(builder.build().least_thickness, 1, 1e-12));
}
