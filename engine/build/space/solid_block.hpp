// Single solids: a box in any pose, what an outline sweeps over, a part of the plane with depth, the hull of points.
#pragma once

#include <string>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// Which point of a box `at` gives; the box is turned about that point.
enum class BoxAnchor {
  lower_corner,  ///< where x, y and z are least, before it is turned
  centre
};

/// A box with its own x, y and z.
struct SolidBox {
  std::string name = {};
  Vec3 size = Vec3::Zero();  ///< along its own x, y and z, m, each above 0
  Vec3 at = Vec3::Zero();    ///< position of the anchor, m
  BoxAnchor anchor = BoxAnchor::lower_corner;
  SolidTurn turn = {};  ///< about the anchor
  std::vector<std::string> groups = {};
};

/// One piece. Without a turn, and the lower corner at the origin, its coordinates are 0 and the size to the bit. Throws
/// InputError for sizes that are not above 0 and numbers that are not finite.
SolidPart build_box(const SolidBox& box);

/// What an outline sweeps over along the axis at right angles to its plane.
struct Extrusion {
  std::string name = {};
  Polygon outline = {};  ///< simple, either way round, convex or not, m
  OutlinePlane plane = OutlinePlane::upright;
  double from = 0;         ///< where it begins along y (upright) or z (level), m
  double depth = 0;        ///< along that axis, m, above 0
  bool centred = false;    ///< `from` is its middle
  Vec3 at = Vec3::Zero();  ///< the outline's origin, m
  SolidTurn turn = {};     ///< about `at`
  std::vector<std::string> groups = {};
};

/// A solid, and what had to be repaired of its outline, one line each, see check_polygon.
struct NotedSolid {
  SolidPart part;
  std::vector<std::string> notes;
};

/// As many convex pieces as the outline is parted into (see convex_parts); they share faces to the bit. Corners between
/// collinear edges stay. Volume: area times depth. Throws InputError for an outline that is none and numbers out of
/// range.
NotedSolid build_extrusion(const Extrusion& extrusion);

/// How a part of the plane gets a depth.
struct PartDepth {
  double depth = 0;      ///< along y, m, above 0
  double from = 0;       ///< where it begins, m
  bool centred = false;  ///< `from` is its middle
};

/// A part of the plane as a solid: x stays, the plane's y becomes z. Name and groups stay. Parts that share corners to
/// the bit share faces to the bit. Throws InputError for numbers out of range.
SolidPart extrude_part(const Part& part, const PartDepth& depth);

/// All parts of a builder of the plane, with one depth.
std::vector<SolidPart> extrude_parts(const std::vector<Part>& parts, const PartDepth& depth);

/// The convex hull of points.
struct HullSolid {
  std::string name = {};
  std::vector<Vec3> points = {};  ///< m, at least 4 that are not in a plane
  double flat = kFlatFace;        ///< see convex_hull; 1e-5 for coordinates rounded to 6 digits; 1e-12 to 0.01
  std::vector<std::string> groups = {};
};

/// One piece with exactly plane faces: where points stand off the plane of their face by more than kFlatFace allows,
/// planes stay and corners move to where they meet, with a note that says how far. Throws InputError as convex_hull
/// does.
NotedSolid build_hull(const HullSolid& hull);

}  // namespace trilith
