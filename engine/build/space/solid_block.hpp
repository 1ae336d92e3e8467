// Single solids: a box in any pose, an extruded outline, a plane part with depth, the convex hull of points.
#pragma once

#include <string>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// The point of a box that `at` refers to; the box is rotated about it.
enum class BoxAnchor {
  lower_corner,  ///< least x, y and z, before rotation
  centre
};

/// A box with its own x, y and z.
struct SolidBox {
  std::string name = {};
  Vec3 size = Vec3::Zero();  ///< along its own x, y and z [m], each above 0
  Vec3 at = Vec3::Zero();    ///< position of the anchor [m]
  BoxAnchor anchor = BoxAnchor::lower_corner;
  SolidTurn turn = {};  ///< about the anchor
  std::vector<std::string> groups = {};

  static constexpr std::string_view kind = "block";
  static constexpr std::string_view sentence = "a box in any pose";
  static constexpr bool is_single = true;
  static constexpr auto keys() {
    using K = KeysOf<SolidBox>;
    return std::tuple(
        Refused{"width", "'width' is for blocks in the plane; in space give size = {x, y, z}"},
        Refused{"height", "'height' is for blocks in the plane; in space give size = {x, y, z}"},
        K::Vector{&SolidBox::size, "size", "size along its own x, y and z [m]", must_be_given},
        K::Vector{&SolidBox::at, "at", "position of the anchor"},
        K::Choice<BoxAnchor, 2>{&SolidBox::anchor, "anchor", "corner or centre", {"lower_corner", "centre"}},
        K::OwnTable<SolidTurn, TurnKeys>{&SolidBox::turn, "turn", turn_wanted,
                                         "rotation about the anchor: { axis = {x, y, z}, angle = }"});
  }
  /// build_box.
  [[nodiscard]] SolidParts parts() const;
};

/// One piece. Without rotation, and with the lower corner at the origin, its coordinates are 0 and the size to the bit.
/// Throws InputError for sizes that are not above 0 and numbers that are not finite.
SolidPart build_box(const SolidBox& box);

/// An outline extruded along the axis perpendicular to its plane.
struct Extrusion {
  std::string name = {};
  Polygon outline = {};  ///< simple, in either orientation, convex or not [m]
  OutlinePlane plane = OutlinePlane::upright;
  double from = 0;         ///< its start along y (upright) or z (level) [m]
  double depth = 0;        ///< along that axis [m], above 0
  bool centred = false;    ///< `from` is its middle
  Vec3 at = Vec3::Zero();  ///< the outline's origin [m]
  SolidTurn turn = {};     ///< about `at`
  std::vector<std::string> groups = {};

  static constexpr std::string_view kind = "extrusion";
  static constexpr std::string_view sentence =
      "an outline extruded along an axis. A concave outline gives several pieces";
  static constexpr bool is_single = true;
  static constexpr auto keys() {
    using K = KeysOf<Extrusion>;
    return std::tuple(
        K::Points{&Extrusion::outline, "outline", "corners in order"},
        K::Choice<OutlinePlane, 2>{&Extrusion::plane,
                                   "plane",
                                   "outline in x and z with depth along y, or in x and y with depth along z",
                                   {"upright", "level"}},
        K::Number{&Extrusion::from, "from", "m", "begin along that axis"},
        K::Number{&Extrusion::depth, "depth", "m", "depth along that axis", above_zero, must_be_given},
        K::Flag{&Extrusion::centred, "centred", "`from` is the middle of the depth"},
        K::Vector{&Extrusion::at, "at", "origin of the outline"},
        K::OwnTable<SolidTurn, TurnKeys>{&Extrusion::turn, "turn", turn_wanted,
                                         "rotation about `at`: { axis = , angle = }"});
  }
  /// build_extrusion.
  [[nodiscard]] SolidParts parts() const;
};

/// A solid, and the repairs of its outline, one line each, see check_polygon.
struct NotedSolid {
  SolidPart part;
  std::vector<std::string> notes;
};

/// The outline is divided into convex pieces (see convex_parts), which share faces to the bit. Corners between
/// collinear edges remain. Volume: area times depth. Throws InputError for an invalid outline and numbers out of range.
NotedSolid build_extrusion(const Extrusion& extrusion);

/// Depth of a plane part.
struct PartDepth {
  double depth = 0;      ///< along y [m], above 0
  double from = 0;       ///< its start [m]
  bool centred = false;  ///< `from` is its middle
};

/// A plane part as a solid: the plane's y becomes z. Name and groups remain. Parts that share corners to the bit share
/// faces to the bit. Throws InputError for numbers out of range.
SolidPart extrude_part(const Part& part, const PartDepth& depth);

/// All parts of a plane builder, with one depth.
std::vector<SolidPart> extrude_parts(const std::vector<Part>& parts, const PartDepth& depth);

/// The convex hull of points.
struct HullSolid {
  std::string name = {};
  std::vector<Vec3> points = {};  ///< [m], at least 4 that are not in a plane
  double flat = kFlatFace;        ///< see convex_hull; 1e-5 for coordinates rounded to 6 digits; 1e-12 to 0.01
  std::vector<std::string> groups = {};

  static constexpr std::string_view kind = "hull";
  static constexpr std::string_view sentence = "the convex hull of points";
  static constexpr bool is_single = true;
  static constexpr auto keys() {
    using K = KeysOf<HullSolid>;
    return std::tuple(K::Vectors{&HullSolid::points, "points", "at least four points, not in a plane"},
                      K::Number{&HullSolid::flat,
                                "flat",
                                "1",
                                "distance from a plane, as a share of the size, below which points are in it",
                                {1e-12, 0.01}});
  }
  /// build_hull.
  [[nodiscard]] SolidParts parts() const;
};

/// One piece with exactly plane faces. If points deviate from the plane of their face by more than kFlatFace, the
/// planes remain and the corners move to their intersections, with a note of the distance. Throws InputError as
/// convex_hull does.
NotedSolid build_hull(const HullSolid& hull);

}  // namespace trilith
