// Points of the intersection of two solids with few faces, and the planes of both (geometry/plane/edge_overlap.hpp).
#pragma once

#include <array>
#include <cstdint>

#include "base/simd/four_by_four.hpp"
#include "base/simd/lane_rows.hpp"
#include "geometry/plane/edge_overlap.hpp"

namespace trilith {

/// Offset of unused planes [m].
inline constexpr double far_plane = 1e100;

TRILITH_INLINE Lanes first_half(const DepthRow& row) {
  Lanes v;
  __builtin_memcpy(&v, row.below.data(), sizeof v);
  return v;
}
TRILITH_INLINE Lanes second_half(const DepthRow& row) {
  Lanes v;
  __builtin_memcpy(&v, row.below.data() + lane_count, sizeof v);
  return v;
}

/// The planes of a solid in lanes: n . x = c, x measured from the origin.
struct PlanesInLanes {
  std::array<Triple<Lanes>, 2> normal;
  std::array<Lanes, 2> offset;

  TRILITH_INLINE PlanesInLanes(const PlacedSolid& solid, const Vec3& origin) {
    const FaceLoops& faces = solid.solid->shape.faces;
    const std::size_t count = solid.normals.size();  // at least four
    const auto corner_of = [&](std::size_t f) TRILITH_INLINE_LAMBDA {
      const Vec3& x = solid.corners[static_cast<std::size_t>(faces.corner[static_cast<std::size_t>(faces.start[f])])];
      return Lanes{x.x(), x.y(), x.z(), 0};
    };
    const FourByFour points(corner_of(0), corner_of(1), corner_of(2), corner_of(3));
    normal[0] = load_neighbours(solid.normals.data());
    offset[0] = offset_of(normal[0], points, origin);
    std::array<Lanes, lane_count> n{}, x{};
    for (std::size_t f = lane_count; f < count; ++f) {
      const Vec3& v = solid.normals[f];
      n[f - lane_count] = Lanes{v.x(), v.y(), v.z(), 0}, x[f - lane_count] = corner_of(f);
    }
    const FourByFour normals(n[0], n[1], n[2], n[3]), others(x[0], x[1], x[2], x[3]);
    normal[1] = {normals.v[0], normals.v[1], normals.v[2]};
    const LaneMask used = LaneMask{4, 5, 6, 7} < static_cast<std::int64_t>(count);
    offset[1] = select(used, offset_of(normal[1], others, origin), Lanes{} + far_plane);
  }
  TRILITH_INLINE static Lanes offset_of(const Triple<Lanes>& n, const FourByFour& on, const Vec3& origin) {
    return n.x * (on.v[0] - origin.x()) + n.y * (on.v[1] - origin.y()) + n.z * (on.v[2] - origin.z());
  }
  TRILITH_INLINE void depths(double x, double y, double z, DepthRow& row) const {
    for (std::size_t half = 0; half < 2; ++half) {
      const Triple<Lanes>& n = normal[half];
      const Lanes below = offset[half] - (n.x * x + n.y * y + n.z * z);
      __builtin_memcpy(row.below.data() + half * lane_count, &below, sizeof below);
    }
  }
};

/// The points of the shared solid: arms and depths.
class SharedPoints {
 protected:
  TRILITH_INLINE SharedPoints(const PlacedSolid& a, const PlacedSolid& b, EdgeOverlap& to)
      : solid_{&a, &b}, origin_(a.corners[0]), planes_{PlanesInLanes(a, origin_), PlanesInLanes(b, origin_)}, out_(to) {
    out_.points = 0;
  }

  [[nodiscard]] TRILITH_INLINE Lanes corner_arm(std::size_t s, std::size_t corner) const {
    const Vec3& x = solid_[s]->corners[corner];
    return Lanes{x.x() - origin_.x(), x.y() - origin_.y(), x.z() - origin_.z(), 0};
  }
  /// Least depth that rounding cannot change to the other side of a face [m].
  [[nodiscard]] TRILITH_INLINE double least_depth() const {
    const double size = solid_[0]->solid->size + solid_[1]->solid->size;
    return 1e-9 * size + 1e-13 * (origin_.cwiseAbs().maxCoeff() + size);
  }

  /// Whether the mean of all points is so deep in both solids that no axis can separate them, whatever the rounding.
  /// The normal of two edges a millionth off parallel may be wrong by 1e-10. Moves the origin to a point of the shared
  /// solid.
  TRILITH_INLINE bool is_sure() {
    const double enough = least_depth(), n = out_.points;
    for (std::size_t s = 0; s < 2; ++s) {
      Lanes sum{}, rest{};
      for (std::size_t i = 0; i < static_cast<std::size_t>(out_.points); ++i)
        sum += first_half(out_.depth[s][i]), rest += second_half(out_.depth[s][i]);
      if (any(flip(smaller<Lanes>(sum, rest) > n * enough))) return false;
    }
    const Lanes first = out_.arm[0];
    for (std::size_t i = 0; i < static_cast<std::size_t>(out_.points); ++i) out_.arm[i] -= first;
    out_.origin = origin_ + Vec3(first[0], first[1], first[2]);
    return true;
  }

  std::array<const PlacedSolid*, 2> solid_;
  Vec3 origin_;
  std::array<PlanesInLanes, 2> planes_;
  EdgeOverlap& out_;
};

/// edge_overlap() by a known topology; false where it no longer holds.
bool overlap_as_before(const PlacedSolid& a, const PlacedSolid& b, const OverlapTopology& known, EdgeOverlap& out);

}  // namespace trilith
