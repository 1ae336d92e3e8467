// A model in space accepts the parts of every builder as bodies.
#include <doctest/doctest.h>

#include "build/space/building.hpp"
#include "build/space/cross_vault.hpp"
#include "build/space/dome.hpp"
#include "build/space/drum.hpp"
#include "build/space/solid_block.hpp"
#include "build/space/solid_rubble.hpp"
#include "model/space_builder/space_builder.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Number of faces of a model's pieces that are inner cuts.
struct ModelFaces {
  int bodies = 0, inner = 0;
  double mass = 0;
};

ModelFaces faces_in_model(const std::vector<SolidPart>& parts) {
  SpaceBuilder builder;
  for (const SolidPart& part : parts) builder.add({.name = part.name, .pieces = part.pieces, .density = 2});
  const Model<3> model = builder.build();
  ModelFaces out;
  out.bodies = static_cast<int>(model.bodies.size());
  for (const ConvexSolid& solid : model.piece_solid)
    for (int f = 0; f < solid.shape.faces.count(); ++f) out.inner += solid.is_surface(f) ? 0 : 1;
  for (const double mass : model.mass) out.mass += mass;
  return out;
}

double mass_of_parts(const std::vector<SolidPart>& parts) {
  double volume = 0;
  for (const SolidPart& part : parts) volume += volume_of(part);
  return 2 * volume;
}

}  // namespace

TEST_CASE("a model in space takes every builder's parts, with the faces between pieces as inner cuts") {
  const Polygon ell{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};
  const std::vector<SolidPart> extruded{build_extrusion({.name = "L", .outline = ell, .depth = 0.3}).part};
  CHECK(faces_in_model(extruded).inner == 2);
  const std::vector<SolidPart> drums =
      build_column({.drums = 3, .height = 3, .sides = 50, .radius = 0.5, .top_radius = 0.4});
  CHECK(faces_in_model(drums).inner == 3 * 2);
  const std::vector<SolidPart> vault =
      build_cross_vault({.arch = {.voussoirs = 9, .radius = 2, .thickness = 0.3}, .stone_length = 0.5});
  // two pieces of each groin stone, four of the keystone
  CHECK(faces_in_model(vault).inner == 16 * 2 + 8);
  const std::vector<SolidPart> dome = build_dome({.rings = 4, .sectors = 40});
  CHECK(faces_in_model(dome).inner == 2);
  const std::vector<SolidPart> rubble = build_solid_rubble({.high = {1, 2, 1}, .stones = 60});
  SolidWall flemish;
  flemish.length = 3, flemish.masonry.bond = "flemish";
  flemish.storeys.push_back({.courses = 4});
  const std::vector<SolidPart> wall = build_solid_wall(flemish).parts;
  for (const auto& parts : {extruded, drums, vault, dome, rubble, wall}) {
    const ModelFaces found = faces_in_model(parts);
    CHECK(found.bodies == static_cast<int>(parts.size()));
    CHECK(near(found.mass, mass_of_parts(parts), 1e-12));
  }
}
