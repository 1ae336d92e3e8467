#include "build/space/solid_block.hpp"

#include <fmt/format.h>

#include <array>

#include "base/error.hpp"
#include "geometry/space/convex_hull.hpp"
#include "geometry/space/cut_solid.hpp"

namespace trilith {
namespace {

constexpr std::array<const char*, 3> own_axis{"x", "y", "z"};

struct DepthSpan {
  double low, high;
};

DepthSpan depth_span(double from, double depth, bool centred, const std::string& owner) {
  require_finite(from, owner + ": from");
  require_positive(depth, owner + ": depth", "m");
  return centred ? DepthSpan{from - depth / 2, from + depth / 2} : DepthSpan{from, from + depth};
}

}  // namespace

SolidPart build_box(const SolidBox& box) {
  const std::string owner = builder_title("block", box.name);
  for (int k = 0; k < 3; ++k)
    require_positive(box.size[k], fmt::format("{}: size along {}", owner, own_axis[static_cast<std::size_t>(k)]), "m");
  require_place(box.at, owner);
  const UnitQuaternion rotation = checked_turn(box.turn, owner);
  const Vec3 low = box.anchor == BoxAnchor::centre ? Vec3(-box.size / 2) : Vec3::Zero();
  const Vec3 high = box.anchor == BoxAnchor::centre ? Vec3(box.size / 2) : box.size;
  SolidPart part{box.name, {box_between(low, high)}, box.groups};
  place_part(part, rotation, box.at);
  return part;
}

NotedSolid build_extrusion(const Extrusion& extrusion) {
  const std::string owner = builder_title("extrusion", extrusion.name);
  const auto [low, high] = depth_span(extrusion.from, extrusion.depth, extrusion.centred, owner);
  require_place(extrusion.at, owner);
  const UnitQuaternion rotation = checked_turn(extrusion.turn, owner);
  CheckedPolygon checked = check_polygon(extrusion.outline, owner);
  SolidPart part{extrusion.name, prisms_between(checked.outline, extrusion.plane, low, high), extrusion.groups};
  place_part(part, rotation, extrusion.at);
  return {std::move(part), std::move(checked.notes)};
}

SolidPart extrude_part(const Part& part, const PartDepth& depth) {
  const auto [low, high] = depth_span(depth.from, depth.depth, depth.centred, builder_title("part", part.name));
  return {part.name, prisms_between(part.outline, OutlinePlane::upright, low, high), part.groups};
}

std::vector<SolidPart> extrude_parts(const std::vector<Part>& parts, const PartDepth& depth) {
  std::vector<SolidPart> solids;
  for (const Part& part : parts) solids.push_back(extrude_part(part, depth));
  return solids;
}

NotedSolid build_hull(const HullSolid& hull) {
  const std::string owner = builder_title("hull", hull.name);
  if (!(hull.flat >= 1e-12 && hull.flat <= 0.01))
    throw InputError(fmt::format("{}: flat is {:g}, must be from 1e-12 to 0.01 of the size", owner, hull.flat));
  Polyhedron solid = convex_hull(hull.points, owner, hull.flat);
  NotedSolid out{{hull.name, {}, hull.groups}, {}};
  // The faces of the hull may deviate by its `flat`; bodies require a smaller value.
  if (hull.flat > kFlatFace / 4) {
    PlanarSolid planar = with_plane_faces(solid);
    if (planar.moved > kFlatFace / 4 * solid_size(solid.corners)) {
      out.notes.push_back(
          fmt::format("{}: its faces were made plane: corners moved by up to {:.3g} m", owner, planar.moved));
      solid = std::move(planar.solid);
    }
  }
  check_convex(solid, owner);
  out.part.pieces.push_back(std::move(solid));
  return out;
}

namespace {

SolidParts noted_part(NotedSolid solid) {
  SolidParts made = one_part(std::move(solid.part));
  made.notes = std::move(solid.notes);
  return made;
}

}  // namespace

SolidParts SolidBox::parts() const {
  check_keys(*this, builder_title(kind, name));
  return one_part(build_box(*this));
}

SolidParts Extrusion::parts() const {
  check_keys(*this, builder_title(kind, name));
  return noted_part(build_extrusion(*this));
}

SolidParts HullSolid::parts() const {
  check_keys(*this, builder_title(kind, name));
  return noted_part(build_hull(*this));
}

}  // namespace trilith
