#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "geometry/least_size.hpp"
#include "geometry/space/polyhedron.hpp"

namespace trilith {
namespace {

const Vec3& corner_of_loop(const Polyhedron& solid, int i) {
  return solid.corners[static_cast<std::size_t>(i)];
}

/// Coordinates must be finite and small enough for sums and products.
void require_finite_corners(const Polyhedron& solid, std::string_view owner) {
  for (std::size_t i = 0; i < solid.corners.size(); ++i) {
    const Vec3& p = solid.corners[i];
    if (!(p.cwiseAbs().array() <= 1e12).all())
      throw InputError(fmt::format("{}: corner {} is ({}, {}, {}) m, must be finite and within 1e12 m", owner, i + 1,
                                   p.x(), p.y(), p.z()));
  }
}

/// A face is a loop of at least three distinct existing corners.
void require_loop(const Polyhedron& solid, int face, std::string_view owner) {
  const auto loop = solid.faces[face];
  const int corners = static_cast<int>(solid.corners.size());
  if (loop.size() < 3)
    throw InputError(fmt::format("{}: face {} has {} corners, at least 3 are needed", owner, face + 1, loop.size()));
  for (std::size_t k = 0; k < loop.size(); ++k) {
    if (loop[k] < 0 || loop[k] >= corners)
      throw InputError(fmt::format("{}: face {} names corner {}, but there are corners 1 to {}", owner, face + 1,
                                   loop[k] + 1, corners));
    if (std::count(loop.begin(), loop.end(), loop[k]) > 1)
      throw InputError(fmt::format("{}: face {} names corner {} twice; name each corner of a face once", owner,
                                   face + 1, loop[k] + 1));
  }
}

/// A corner without a face would only count in sizes and boxes.
void refuse_unused(const Polyhedron& solid, std::string_view owner) {
  std::vector<std::uint8_t> used(solid.corners.size(), 0);
  for (const int i : solid.faces.corner) used[static_cast<std::size_t>(i)] = 1;
  const auto unused = std::find(used.begin(), used.end(), 0);
  if (unused != used.end())
    throw InputError(fmt::format("{}: corner {} belongs to no face; remove it", owner, unused - used.begin() + 1));
}

/// Each edge occurs once in each direction.
void require_closed(const Polyhedron& solid, std::string_view owner) {
  const auto edges = solid_edges(solid.faces);
  for (const SolidEdge& e : edges)
    for (const SolidEdge& other : edges) {
      const bool same = other.from == e.from && other.to == e.to, back = other.from == e.to && other.to == e.from;
      if (&other != &e && (same || back))
        throw InputError(
            fmt::format("{}: faces {} and {} both run from corner {} to {}: one of them is reversed, or the edge has "
                        "more than two faces. Give the corners of each face counter-clockwise as seen from outside",
                        owner, e.left + 1, (same ? other.left : other.right) + 1, e.from + 1, e.to + 1));
    }
  for (const SolidEdge& e : edges)
    if (e.right < 0)
      throw InputError(
          fmt::format("{}: the surface is open: the edge from corner {} to {} has face {} only; add the face on its "
                      "other side",
                      owner, e.from + 1, e.to + 1, e.left + 1));
}

/// Face f has an area, and the distance of its corners from its mean plane is at most `flat` times the size of the
/// solid. The mean plane passes through the mean of the corners, normal to the area vector.
void require_plane(const Polyhedron& solid, int face, double size, double flat, std::string_view owner) {
  const auto loop = solid.faces[face];
  const Vec3 area = area_vector(solid.corners, loop);
  if (!(area.norm() > kFlatFace * size * size))
    throw InputError(
        fmt::format("{}: face {} has an area of {:.3g} m2, too small for a face; remove it or move its corners", owner,
                    face + 1, area.norm()));
  const Vec3 normal = area.normalized();
  Vec3 middle = Vec3::Zero();
  for (const int i : loop) middle += corner_of_loop(solid, i) / static_cast<double>(loop.size());
  for (const int i : loop) {
    const double off = std::abs(normal.dot(corner_of_loop(solid, i) - middle));
    if (off > flat * size)
      throw InputError(
          fmt::format("{}: face {} is not plane: corner {} lies {:.6g} m off its plane, allowed {:.3g} m; "
                      "split the face into triangles",
                      owner, face + 1, i + 1, off, flat * size));
  }
}

/// Largest distance of a corner outside of a face.
struct Outlier {
  double by = 0;
  int corner = 0, face = 0;
};

/// The solid is convex if no corner lies above the highest corner of any face, seen along the normal of the face.
Outlier farthest_outlier(const Polyhedron& solid) {
  Outlier worst;
  for (int f = 0; f < solid.faces.count(); ++f) {
    const auto loop = solid.faces[f];
    const Vec3 normal = area_vector(solid.corners, loop).normalized();
    double height = normal.dot(corner_of_loop(solid, loop[0]));
    for (const int i : loop) height = std::max(height, normal.dot(corner_of_loop(solid, i)));
    for (std::size_t i = 0; i < solid.corners.size(); ++i) {
      const double by = normal.dot(solid.corners[i]) - height;
      if (by > worst.by) worst = {by, static_cast<int>(i), f};
    }
  }
  return worst;
}

}  // namespace

/// Cheap checks run first, and each relies on the previous ones: corners, loops, planes, closed surface, and last the
/// sign of the volume, which is negative where all faces are reversed.
void check_polyhedron(const Polyhedron& solid, std::string_view owner, double flat) {
  if (solid.faces.count() < 4)
    throw InputError(fmt::format("{}: has {} faces, needs at least 4", owner, solid.faces.count()));
  require_finite_corners(solid, owner);
  for (int f = 0; f < solid.faces.count(); ++f) require_loop(solid, f, owner);
  refuse_unused(solid, owner);
  const double size = solid_size(solid.corners);
  if (size < kLeastSize)
    throw InputError(
        fmt::format("{}: is {:.3g} m large, must be at least {:g} m; check its unit", owner, size, kLeastSize));
  for (int f = 0; f < solid.faces.count(); ++f) require_plane(solid, f, size, flat, owner);
  require_closed(solid, owner);
  const double volume = solid_moments(solid).volume;
  if (volume < 0)
    throw InputError(fmt::format("{}: its volume is {:.6g} m3, so it is inside out; reverse the corners of every face",
                                 owner, volume));
  if (!(volume > kFlatFace * size * size * size))
    throw InputError(fmt::format("{}: its volume is {:.3g} m3, too small for its size of {:.3g} m; make it thicker",
                                 owner, volume, size));
}

void check_convex(const Polyhedron& solid, std::string_view owner, double flat) {
  check_polyhedron(solid, owner, flat);
  const Outlier worst = farthest_outlier(solid);
  const double allowed = flat * solid_size(solid.corners);
  if (worst.by > allowed)
    throw InputError(fmt::format(
        "{}: is not convex: corner {} lies {:.6g} m outside of face {}, allowed {:.3g} m; split it into convex pieces",
        owner, worst.corner + 1, worst.by, worst.face + 1, allowed));
}

}  // namespace trilith
