// Depths of many points below all surface faces of a convex solid.
//
// Input: the placed solid, and points as arms from one origin. Output: a row for each point with its depth below the
// plane of each surface face, n . (p - x) for a corner p of the face, and the nearest face. Faces of neighbouring
// pieces that bound the body here too (`PlacedSolid::beside`) count as the solid's own.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "geometry/space/convex_solid.hpp"

namespace trilith {

/// Scratch buffer of a table, kept by the caller so that repeated calls allocate nothing.
struct DepthRoom {
  std::vector<double> plane;  ///< plane data of the faces, component by component: nx, ny, nz, px, py, pz
  std::vector<double> depth;  ///< row-major
  std::vector<int> face;      ///< [surface faces] face index in the solid, without the neighbours' faces
  std::vector<int> nearest;   ///< [points]
};

/// The table, in a buffer that must outlive it. Columns are the solid's surface faces, in their order, and then the
/// neighbours' faces.
class DepthTable {
 public:
  DepthTable(const PlacedSolid& solid, const Vec3& origin, std::span<const Vec3> arms, DepthRoom& room);

  [[nodiscard]] int columns() const { return columns_; }
  /// Depths of a point below all faces [columns] [m].
  [[nodiscard]] const double* row(int point) const { return depth_ + point * columns_; }
  /// Column of the face nearest to a point, the first of equal ones; -1 if the solid has no surface face.
  [[nodiscard]] int nearest(int point) const { return nearest_[point]; }
  /// Depth of any point below the face of a column [m].
  [[nodiscard]] double below(int column, const Vec3& arm) const {
    const double* of = plane_ + column;
    const int n = columns_;
    return of[0] * (of[3 * n] - arm.x()) + of[n] * (of[4 * n] - arm.y()) + of[2 * n] * (of[5 * n] - arm.z());
  }
  /// True for a face that is coplanar with an earlier face, which represents both.
  [[nodiscard]] bool has_first_like(int column) const {
    return solid_.solid->may_repeat && trilith::has_first_like(solid_, face_[column]);  // never for mesh pieces
  }

 private:
  const PlacedSolid& solid_;
  int columns_;
  const double *plane_, *depth_;
  const int *nearest_, *face_;
};

}  // namespace trilith
