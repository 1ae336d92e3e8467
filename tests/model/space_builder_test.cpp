#include "model/space_builder/space_builder.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

SolidBody body_of(std::vector<Polyhedron> pieces) {
  SolidBody body;
  body.name = "stone", body.pieces = std::move(pieces), body.density = 2000;
  return body;
}

/// Error message for a rejected body; empty if it is accepted.
std::string refusal(const SolidBody& body) {
  SpaceBuilder builder;
  SolidBody first = body_of({box_solid(Vec3::Zero(), Vec3::Ones())});
  first.name = "first";
  builder.add(first);
  try {
    builder.add(body);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a body of two boxes has the mass, the middle and the moments of the whole") {
  const SolidMass whole = mass_of({box_solid(Vec3(-1, -0.5, 0), Vec3(1, 0.5, 3))}, 1500);
  const SolidMass halves =
      mass_of({box_solid(Vec3(-1, -0.5, 0), Vec3(0.3, 0.5, 3)), box_solid(Vec3(0.3, -0.5, 0), Vec3(1, 0.5, 3))}, 1500);
  CHECK(near(whole.mass, 9000, 1e-12));
  CHECK(near(halves.mass, whole.mass, 1e-12));
  CHECK((halves.centroid - Vec3(0, 0, 1.5)).norm() < 1e-12);
  CHECK(near(whole.inertia.moments.x(), 9000.0 / 12 * (1 + 9), 1e-12));
  CHECK((halves.inertia.moments - whole.inertia.moments).norm() < 1e-9);
}

TEST_CASE("faces by which pieces of a body are connected are not part of the surface, all others are") {
  SpaceBuilder builder;
  builder.add(body_of({box_solid(Vec3(0, 0, 0), Vec3(2, 1, 1)), box_solid(Vec3(0.5, 0.2, 1), Vec3(1, 0.8, 2))}));
  const Model<3> model = builder.build();
  REQUIRE(model.pieces() == 2);
  int inner_below = 0, inner_above = 0;
  for (int f = 0; f < 6; ++f) {
    inner_below += model.piece_solid[0].is_surface(f) ? 0 : 1;
    inner_above += model.piece_solid[1].is_surface(f) ? 0 : 1;
  }
  CHECK(inner_below == 0);  // the upper one covers only a part of its face
  CHECK(inner_above == 1);
  // ... whose other side is then a contact face too; otherwise a body in both pieces would be pushed by only one of
  // them
  for (int f = 0; f < 6; ++f) CHECK(model.piece_solid[1].is_pressed(f));
}

TEST_CASE("a cut between pieces carries pressure on both sides or on neither, also along a row of pieces") {
  const auto pressed = [](const std::vector<Polyhedron>& pieces) {
    SpaceBuilder builder;
    builder.add(body_of(pieces));
    std::vector<int> of_piece;
    for (const ConvexSolid& piece : builder.build().piece_solid) {
      of_piece.push_back(0);
      for (int f = 0; f < piece.shape.faces.count(); ++f) of_piece.back() += piece.is_pressed(f) ? 1 : 0;
    }
    return of_piece;
  };
  const auto box = [](double from, double to, double height) {
    return box_solid(Vec3(from, 0, 0), Vec3(to, 1, height));
  };
  CHECK(pressed({box(0, 1, 1), box(1, 2, 1), box(2, 3, 1)}) == std::vector{5, 4, 5});
  CHECK(pressed({box(0, 1, 1), box(1, 2, 1), box(2, 3, 0.5)}) == std::vector{5, 5, 6});
}

TEST_CASE("invalid bodies in space are rejected with their name and the reason") {
  const Polyhedron box = box_solid(Vec3::Zero(), Vec3::Ones());
  SolidBody taken = body_of({box});
  taken.name = "first";
  CHECK(refusal(taken) == "there is a body 'first' already");
  CHECK(refusal(body_of({})) == "body 'stone' has no piece; it needs at least one");
  SolidBody light = body_of({box});
  light.density = 0;
  CHECK(refusal(light) == "body 'stone' has a density of 0 kg/m3; it must be above 0");
  SolidBody wild = body_of({box});
  wild.velocity.x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal(wild) == "body 'stone' has an initial velocity or spin that is not finite");
  Polyhedron open = box;
  open.faces = {};
  for (int f = 0; f < 5; ++f) open.faces.add(box.faces[f]);
  CHECK(refusal(body_of({box, open})).find("body 'stone', piece 2") == 0);
}

TEST_CASE("laws that rub, bond and crush hold between surfaces in space, which are numbered from 0") {
  SpaceBuilder builder;
  Cohesive mortar;
  mortar.kn = mortar.ks = 1e9, mortar.mu = 0.7, mortar.cohesion = mortar.tension = 1e5;
  mortar.energy_tension = mortar.energy_shear = 50;
  CHECK_NOTHROW(builder.contact(0, 0, mortar, "bed"));
  mortar.compression = 1e6;
  CHECK_NOTHROW(builder.contact(0, 0, mortar, "bed"));
  Frictional dry;
  dry.kn = 1e9;
  CHECK_NOTHROW(builder.contact(0, 0, dry, "dry"));
  CHECK_THROWS_AS(builder.contact(-1, 0, dry, "dry"), InputError);
}
