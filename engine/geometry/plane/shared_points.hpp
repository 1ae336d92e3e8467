// Points of the intersection of two solids with few faces, and the planes of both (geometry/plane/edge_overlap.hpp).
#pragma once

#include <array>

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
    std::array<DepthRow, 4> rows{};  // x, y, z and c
    rows[3].below.fill(far_plane);
    for (std::size_t f = 0; f < solid.normals.size(); ++f) {
      const Vec3 &n = solid.normals[f],
                 &x = solid.corners[static_cast<std::size_t>(faces.corner[static_cast<std::size_t>(faces.start[f])])];
      rows[0].below[f] = n.x(), rows[1].below[f] = n.y(), rows[2].below[f] = n.z();
      rows[3].below[f] = n.x() * (x.x() - origin.x()) + n.y() * (x.y() - origin.y()) + n.z() * (x.z() - origin.z());
    }
    normal[0] = {first_half(rows[0]), first_half(rows[1]), first_half(rows[2])}, offset[0] = first_half(rows[3]);
    normal[1] = {second_half(rows[0]), second_half(rows[1]), second_half(rows[2])}, offset[1] = second_half(rows[3]);
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
