// Depths of many points below all surface faces of a convex solid, each found once.
//
// Comes in: the solid where it stands, and points by their arms from one origin. Goes out: a row for each point, with
// its depth below the plane of each surface face, n . (p - x) for a corner p of it, and the face that is nearest to it.
// Faces of the pieces beside it that bound the body here too (PlacedSolid::beside) count as its own.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "geometry/space/convex_solid.hpp"

namespace trilith {

/// Room for a table, kept by the caller so that repeated calls allocate nothing.
struct DepthRoom {
  std::vector<double> plane;  ///< numbers of the faces, kind by kind: nx, ny, nz, px, py, pz
  std::vector<double> depth;  ///< row by row
  std::vector<int> face;      ///< [surface faces] their numbers in the solid, those beside it left out
  std::vector<int> nearest;   ///< [points]
};

/// The table itself, in a room that must outlive it. Columns are the solid's surface faces, in their order, and
/// those beside it.
class DepthTable {
 public:
  DepthTable(const PlacedSolid& solid, const Vec3& origin, std::span<const Vec3> arms, DepthRoom& room);

  [[nodiscard]] int columns() const { return columns_; }
  /// Depths of a point below all faces [columns] [m].
  [[nodiscard]] const double* row(int point) const { return depth_ + point * columns_; }
  /// Column of the face that is nearest to a point, the first of equals; -1 where the solid has no surface.
  [[nodiscard]] int nearest(int point) const { return nearest_[point]; }
  /// Depth of any other point below one of them [m].
  [[nodiscard]] double below(int column, const Vec3& arm) const {
    const double* of = plane_ + column;
    const int n = columns_;
    return of[0] * (of[3 * n] - arm.x()) + of[n] * (of[4 * n] - arm.y()) + of[2 * n] * (of[5 * n] - arm.z());
  }
  /// True of a face that lies in the plane of one before it, which stands for both.
  [[nodiscard]] bool has_first_like(int column) const {
    return solid_.solid->may_repeat && trilith::has_first_like(solid_, face_[column]);  // never so of pieces of meshes
  }

 private:
  const PlacedSolid& solid_;
  int columns_;
  const double *plane_, *depth_;
  const int *nearest_, *face_;
};

}  // namespace trilith
