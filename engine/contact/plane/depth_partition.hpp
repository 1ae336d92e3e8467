// Partition of a pressed face into cells, in each of which one face of the other solid is nearest.
//
// Input: a convex part of a face, as points with known depths below all faces of the other solid
// (geometry/plane/depth_table.hpp). Output: for each face f that is nearest somewhere, the polygon where depth_f <=
// depth_g for all other faces g. All depths are linear over it, so each g cuts it along a line; most cut nothing.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "base/simd/lanes.hpp"
#include "geometry/plane/depth_table.hpp"

namespace trilith {

/// A point of a pressed face: its arm from the reference point of moments, and its depth in the other solid.
struct PressedPoint {
  Vec3 arm;
  double depth;  // [m]
};

/// A convex polygon with capacity for a triangle cut by many planes.
struct PressedPolygon {
  static constexpr std::size_t most = 128;
  std::array<PressedPoint, most> corner;
  std::size_t count = 0;

  void add(const PressedPoint& p) {
    if (count < most) corner[count++] = p;
  }
};

/// Values of a function at the corners of a polygon.
using CornerHeights = std::array<double, PressedPolygon::most>;

inline PressedPoint between(const PressedPoint& p, const PressedPoint& q, double share) {
  return {p.arm + share * (q.arm - p.arm), p.depth + share * (q.depth - p.depth)};
}

/// The part of a polygon where a linear function is not negative.
inline void keep_above(const PressedPolygon& from, const CornerHeights& height, PressedPolygon& kept) {
  kept.count = 0;
  for (std::size_t i = 0; i < from.count; ++i) {
    const std::size_t next = i + 1 == from.count ? 0 : i + 1;
    const double hp = height[i], hq = height[next];
    if (hp >= 0) kept.add(from.corner[i]);
    if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) kept.add(between(from.corner[i], from.corner[next], hp / (hp - hq)));
  }
}

/// A convex part of a face of the walker: points of the shared solid in order.
struct Rim {
  static constexpr std::size_t most = 64;
  std::array<int, most> point;
  std::size_t count = 0;

  void add(int p) { point[count++] = p; }
};

/// The cells of a rim by nearest face of the owner. `noise` is well above the rounding error of a depth [m]. For most
/// faces the values at the corners show that they cut nothing or everything. The first cut uses the depths already
/// compared, before any point is copied.
class CellCutter {
 public:
  CellCutter(const DepthTable& owner, std::span<const Vec3> arms, const Rim& rim, double noise)
      : owner_(owner), arms_(arms), rim_(rim), noise_(noise) {
    for (std::size_t i = 0; i < rim.count; ++i) row_[i] = owner.row(rim.point[i]);
    list_near_faces();
  }

  [[nodiscard]] std::size_t faces() const { return faces_; }

  /// The cell of a face; null if it is empty.
  const PressedPolygon* cell(std::size_t f) {
    if (!list_cutters(f)) return nullptr;
    cell_ = &polygon_[0], spare_ = &polygon_[1];
    begin_cell();
    for (std::size_t c = 1; c < cutters_ && cell_->count > 2; ++c) cut_by(cutter_[c]);
    return cell_->count > 2 ? cell_ : nullptr;
  }

 private:
  static constexpr std::size_t most = 256;           // capacity for faces of the owner
  using RimHeights = std::array<double, Rim::most>;  ///< values of a function at the points of the rim

  /// A face is nearest nowhere if the whole rim is deeper below it than below some other face.
  void list_near_faces() {
    std::array<double, most> low;
    const auto columns = static_cast<std::size_t>(std::min(owner_.columns(), static_cast<int>(most)));
    double reach = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < columns; ++k) {
      double least = row_[0][k], most_of_all = least;
      for (std::size_t i = 1; i < rim_.count; ++i)
        least = std::min(least, row_[i][k]), most_of_all = std::max(most_of_all, row_[i][k]);
      low[k] = least, reach = std::min(reach, most_of_all);
    }
    reach = std::max(0.0, reach);
    for (std::size_t k = 0; k < columns; ++k)
      if (low[k] <= reach && !owner_.has_first_like(static_cast<int>(k))) column_[faces_++] = static_cast<int>(k);
  }

  /// Lists the faces that may cut the cell; false where one removes all of it. The difference of depths for the first
  /// of them is kept.
  bool list_cutters(std::size_t f) {
    cutters_ = 0;
    for (std::size_t i = 0; i < rim_.count; ++i) own_[i] = larger(row_[i][column_[f]], 0.0);
    for (std::size_t g = 0; g < faces_; ++g) {
      if (g == f) continue;
      RimHeights& height = height_[cutters_ == 0 ? 0 : 1];
      bool some_above = false, some_low = false;
      for (std::size_t i = 0; i < rim_.count; ++i) {
        const double at = row_[i][column_[g]] - own_[i];
        height[i] = at, some_above |= at >= -noise_, some_low |= at <= noise_;
      }
      if (!some_above) return false;
      if (some_low) cutter_[cutters_++] = column_[g];
    }
    return true;
  }

  [[nodiscard]] PressedPoint point(std::size_t i) const {
    return {arms_[static_cast<std::size_t>(rim_.point[i])], own_[i]};
  }

  /// The rim, cut by the first cutter if there is one.
  void begin_cell() {
    cell_->count = 0;
    for (std::size_t i = 0; i < rim_.count; ++i) {
      if (cutters_ == 0) {
        cell_->add(point(i));
        continue;
      }
      const std::size_t next = i + 1 == rim_.count ? 0 : i + 1;
      const double hp = height_[0][i], hq = height_[0][next];
      if (hp >= 0) cell_->add(point(i));
      if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) cell_->add(between(point(i), point(next), hp / (hp - hq)));
    }
  }

  void cut_by(int column) {
    CornerHeights height;
    bool all = true;
    for (std::size_t i = 0; i < cell_->count; ++i) {
      const PressedPoint& p = cell_->corner[i];
      height[i] = owner_.below(column, p.arm) - p.depth;
      all = all && height[i] >= 0;
    }
    if (all) return;
    keep_above(*cell_, height, *spare_);
    std::swap(cell_, spare_);
  }

  const DepthTable& owner_;
  std::span<const Vec3> arms_;
  const Rim& rim_;
  double noise_;
  std::array<const double*, Rim::most> row_;  // depths below all faces
  RimHeights own_;                            // depths below the given face
  std::array<RimHeights, 2> height_;          // depths minus own_, for the first cutter and another face
  std::array<int, most> column_, cutter_;
  std::size_t faces_ = 0, cutters_ = 0;
  std::array<PressedPolygon, 2> polygon_;
  PressedPolygon *cell_ = nullptr, *spare_ = nullptr;
};

}  // namespace trilith
