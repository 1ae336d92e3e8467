// Result of all geometry builders in space: solids with names and groups, from which the caller makes bodies.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "build/builder_keys.hpp"
#include "build/plane/part.hpp"
#include "geometry/space/polyhedron.hpp"
#include "geometry/space/sphere.hpp"

namespace trilith {

/// One body of a structure in space, in its position; z is up. Its pieces are convex (see check_convex) and share faces
/// or nothing [m]. Faces have at most max_face_corners corners, so that the contact treats them as faces; builders
/// ensure this.
struct SolidPart {
  std::string name;
  std::vector<Polyhedron> pieces;
  std::vector<std::string> groups;
  std::vector<Sphere> spheres = {};  ///< in addition to the pieces; they may overlap each other
};

/// Parts, and the changes to their description, one line each.
struct SolidParts {
  std::vector<SolidPart> parts;
  std::vector<std::string> notes;
};

/// Limit of the parts of one builder call; more need too much memory and minutes without output.
inline constexpr double most_parts = 200'000;

/// One part, as the parts of a builder.
SolidParts one_part(SolidPart part);

/// Throws InputError if a builder would make more than most_parts. `what` begins the message, such as "wall 'w'".
void require_buildable(double parts, std::string_view what);

/// Volume of all pieces, and of the union of all spheres [m3].
double volume_of(const SolidPart& part);

/// Rotation of a solid about its anchor, by an axis and an angle or by a quaternion.
struct SolidTurn {
  Vec3 axis = {0, 0, 1};           ///< of any length but 0
  double angle = 0;                ///< counter-clockwise seen from the axis' tip [rad]
  UnitQuaternion quaternion = {};  ///< of any length but 0
};

/// Keys of a turn in scripts: axis and angle.
struct TurnKeys {
  static constexpr auto keys() {
    using K = KeysOf<SolidTurn>;
    return std::tuple(K::Vector{&SolidTurn::axis, "axis", "axis of the rotation"},
                      K::Number{&SolidTurn::angle, "angle", "rad", "about the axis", any_number, must_be_given});
  }
};
inline constexpr std::string_view turn_wanted = "{ axis = {x, y, z}, angle = }";

/// The rotation of `turn`. Throws InputError if axis or quaternion have no length, numbers are not finite, or both an
/// angle and a quaternion are given. `owner` begins every message.
UnitQuaternion checked_turn(const SolidTurn& turn, std::string_view owner);

/// Rotates every piece about the origin, then translates it by `shift` [m]. Without rotation coordinates change only by
/// the sum with the shift; without both no bit changes.
void place_part(SolidPart& part, const UnitQuaternion& rotation, const Vec3& shift);

/// Throws InputError unless all three coordinates are finite. `what` names the point with its owner.
const Vec3& require_place(const Vec3& place, std::string_view what);

/// Axis-parallel box with the coordinates of `low` and `high` to the bit, so that boxes with equal numbers lie flat on
/// each other. box_solid, in contrast, computes its far side as a sum.
Polyhedron box_between(const Vec3& low, const Vec3& high);

/// The solid between two convex polygons with equal numbers of corners, in planes, with pairwise parallel sides:
/// prisms, drums, slices of a cone. Counter-clockwise seen from `high`. Polygons with more than max_face_corners
/// corners are divided by cuts between corners into pieces that share them to the bit.
std::vector<Polyhedron> lofted(std::span<const Vec3> low, std::span<const Vec3> high);

/// The plane of an outline.
enum class OutlinePlane {
  upright,  ///< its second coordinate is z; it is extruded along y
  level     ///< its second coordinate is y; it is extruded along z
};

/// A simple counter-clockwise outline extruded from `low` to `high` along y or z [m], as convex pieces.
std::vector<Polyhedron> prisms_between(const Polygon& outline, OutlinePlane plane, double low, double high);

}  // namespace trilith
