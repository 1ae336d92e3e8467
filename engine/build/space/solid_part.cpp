#include "build/space/solid_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "base/rotation_3d.hpp"
#include "geometry/plane/convex_parts.hpp"
#include "geometry/space/face_overlap_3d.hpp"

namespace trilith {

SolidParts one_part(SolidPart part) {
  SolidParts made;
  made.parts.push_back(std::move(part));
  return made;
}

void require_buildable(double parts, std::string_view what) {
  if (!(parts <= most_parts))
    throw InputError(
        fmt::format("{}: would have about {:.3g} parts, at most {:g} are allowed; check its sizes and their units, or "
                    "build it in sections",
                    what, parts, most_parts));
}

double volume_of(const SolidPart& part) {
  double volume = 0;
  for (const Polyhedron& piece : part.pieces) volume += solid_moments(piece).volume;
  if (!part.spheres.empty()) volume += sphere_moments(part.spheres).volume;
  return volume;
}

const Vec3& require_place(const Vec3& place, std::string_view what) {
  constexpr std::array<const char*, 3> axis{"x", "y", "z"};
  for (int k = 0; k < 3; ++k) require_finite(place[k], fmt::format("{}: {}", what, axis[static_cast<std::size_t>(k)]));
  return place;
}

namespace {

bool is_no_turn(const UnitQuaternion& q) {
  return q.x == 0 && q.y == 0 && q.z == 0;
}

}  // namespace

UnitQuaternion checked_turn(const SolidTurn& turn, std::string_view owner) {
  const UnitQuaternion& q = turn.quaternion;
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!std::isfinite(length) || length == 0)
    throw InputError(fmt::format("{}: quaternion ({:g}, {:g}, {:g}, {:g}) has no length; it must be finite and not 0",
                                 owner, q.w, q.x, q.y, q.z));
  const double angle = require_finite(turn.angle, fmt::format("{}: angle", owner));
  if (angle == 0)
    return is_no_turn(q) ? UnitQuaternion{} : UnitQuaternion{q.w / length, q.x / length, q.y / length, q.z / length};
  if (!is_no_turn(q))
    throw InputError(fmt::format("{}: both an angle and a quaternion are given; give one of them", owner));
  require_place(turn.axis, fmt::format("{}: axis", owner));
  const double reach = turn.axis.cwiseAbs().maxCoeff();
  if (reach == 0) throw InputError(fmt::format("{}: axis is (0, 0, 0), must not be zero", owner));
  const Vec3 scaled = turn.axis / reach;
  return rotation_by(angle * (scaled / scaled.norm()));
}

void place_part(SolidPart& part, const UnitQuaternion& rotation, const Vec3& shift) {
  const bool turns = !is_no_turn(rotation), moves = shift != Vec3::Zero();
  const Turn3 turn = turn_of(rotation);
  for (Polyhedron& piece : part.pieces)
    for (Vec3& p : piece.corners) {
      if (turns) p = turn.apply(p);
      if (moves) p += shift;
    }
  for (Sphere& s : part.spheres) {
    if (turns) s.centre = turn.apply(s.centre);
    if (moves) s.centre += shift;
  }
}

Polyhedron box_between(const Vec3& low, const Vec3& high) {
  const std::array<Vec3, 4> floor{low, Vec3(high.x(), low.y(), low.z()), Vec3(high.x(), high.y(), low.z()),
                                  Vec3(low.x(), high.y(), low.z())};
  std::array<Vec3, 4> ceiling = floor;
  for (Vec3& p : ceiling) p.z() = high.z();
  return lofted(floor, ceiling)[0];
}

namespace {

/// The solid between the corners `of` of two polygons.
Polyhedron loft_of(std::span<const Vec3> low, std::span<const Vec3> high, const std::vector<int>& of) {
  const int n = static_cast<int>(of.size());
  Polyhedron solid;
  for (const int i : of) solid.corners.push_back(low[static_cast<std::size_t>(i)]);
  for (const int i : of) solid.corners.push_back(high[static_cast<std::size_t>(i)]);
  std::vector<int> loop(of.size());
  std::iota(loop.begin(), loop.end(), n);
  const std::vector<int> above = loop;
  std::iota(loop.rbegin(), loop.rend(), 0);
  solid.faces.add(loop), solid.faces.add(above);
  for (int i = 0; i < n; ++i) {
    const int next = i + 1 == n ? 0 : i + 1;
    solid.faces.add(std::array{i, next, n + next, n + i});
  }
  return solid;
}

/// Bisects a convex polygon until no part has more corners than a face may have.
void part_corners(const std::vector<int>& of, std::vector<std::vector<int>>& parts) {
  if (of.size() <= static_cast<std::size_t>(max_face_corners)) {
    parts.push_back(of);
    return;
  }
  const auto middle = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
  std::vector<int> second(middle, of.end());
  second.push_back(of.front());
  part_corners({of.begin(), middle + 1}, parts);
  part_corners(second, parts);
}

}  // namespace

std::vector<Polyhedron> lofted(std::span<const Vec3> low, std::span<const Vec3> high) {
  std::vector<int> all(low.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::vector<int>> parts;
  part_corners(all, parts);
  std::vector<Polyhedron> pieces;
  for (const std::vector<int>& of : parts) pieces.push_back(loft_of(low, high, of));
  return pieces;
}

/// An upright outline that is counter-clockwise appears so from its near end, where y is least.
std::vector<Polyhedron> prisms_between(const Polygon& outline, OutlinePlane plane, double low, double high) {
  const bool upright = plane == OutlinePlane::upright;
  std::vector<Polyhedron> pieces;
  for (const ConvexPiece& part : convex_parts(outline)) {
    std::vector<Vec3> from, to;
    for (const int i : part.corners) {
      const Vec2& p = outline[static_cast<std::size_t>(i)];
      from.push_back(upright ? Vec3(p.x(), high, p.y()) : Vec3(p.x(), p.y(), low));
      to.push_back(upright ? Vec3(p.x(), low, p.y()) : Vec3(p.x(), p.y(), high));
    }
    for (Polyhedron& piece : lofted(from, to)) pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace trilith
