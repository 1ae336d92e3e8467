// What every geometry builder in space returns: solids with names and groups, to be made bodies of by the caller.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "build/plane/part.hpp"
#include "geometry/space/polyhedron.hpp"
#include "geometry/space/sphere.hpp"

namespace trilith {

/// One body of a structure in space, where it stands; z is up. Its pieces are convex (see check_convex) and share faces
/// or nothing, m. As long as a face has no more corners than max_face_corners, contact takes it as a face: builders
/// keep to that.
struct SolidPart {
  std::string name;
  std::vector<Polyhedron> pieces;
  std::vector<std::string> groups;
  std::vector<Sphere> spheres = {};  ///< beside the pieces; they may overlap each other
};

/// Parts, and what was changed of their description, one line each.
struct SolidParts {
  std::vector<SolidPart> parts;
  std::vector<std::string> notes;
};

/// What one call of a builder may make; more takes a machine's memory and minutes before it says a word.
inline constexpr double most_parts = 200'000;

/// Throws InputError where a builder would make more than most_parts. `what` begins the message, such as "wall 'w'".
void require_buildable(double parts, std::string_view what);

/// Volume of all pieces, and of the union of all spheres, m3.
double volume_of(const SolidPart& part);

/// How a solid is turned about its anchor: about an axis by an angle, or by a quaternion; one of the two.
struct SolidTurn {
  Vec3 axis = {0, 0, 1};           ///< of any length but 0
  double angle = 0;                ///< counter-clockwise seen from the axis' tip, rad
  UnitQuaternion quaternion = {};  ///< of any length but 0
};

/// The rotation of `turn`. Throws InputError where axis or quaternion have no length, numbers are not finite, or both
/// an angle and a quaternion are given. `owner` begins every message.
UnitQuaternion checked_turn(const SolidTurn& turn, std::string_view owner);

/// Turns every piece about the origin, then moves it by `shift`, m. Without a turn no coordinate changes by more than
/// the sum with the shift, without both no bit.
void place_part(SolidPart& part, const UnitQuaternion& rotation, const Vec3& shift);

/// Throws InputError unless all three are finite. `what` names the point with its owner.
const Vec3& require_place(const Vec3& place, std::string_view what);

/// Axis-parallel box whose coordinates are those of `low` and `high` to the bit, so that boxes made of the same numbers
/// lie flat on each other. As box_solid, whose far side is found by a sum.
Polyhedron box_between(const Vec3& low, const Vec3& high);

/// What lies between two convex polygons of as many corners, in planes, whose sides are parallel pair by pair: prisms,
/// drums, slices of a cone. Counter-clockwise as seen from `high`. More than max_face_corners corners are parted by
/// upright cuts between corners into pieces that share them to the bit.
std::vector<Polyhedron> lofted(std::span<const Vec3> low, std::span<const Vec3> high);

/// Which plane an outline of two coordinates stands in.
enum class OutlinePlane {
  upright,  ///< its second coordinate is z; what is made of it lies along y
  level     ///< its second coordinate is y; what is made of it rises along z
};

/// A simple counter-clockwise outline from `low` to `high` along y or z, m, as convex pieces.
std::vector<Polyhedron> prisms_between(const Polygon& outline, OutlinePlane plane, double low, double high);

}  // namespace trilith
