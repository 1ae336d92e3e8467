// Divides a face of the shared solid into parts, in each of which one face of the other solid is nearest; for solids
// with few faces.
//
// Input: the corners of the face, with their depths below all faces of the other solid. Output: convex parts that cover
// it, over each of which the depth below the nearest face is linear. The faces of the other solid are compared one
// after the other with the previous ones. Where the linear difference of two depths has both signs over a part, its
// zero line divides the part.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "base/simd/lane_bits.hpp"
#include "geometry/plane/edge_overlap.hpp"
#include "geometry/space/triangle_lanes.hpp"

namespace trilith {

/// A corner of a part of a pressed face: its arm, and its depths below the faces that may be nearest.
struct PartCorner {
  Lanes arm, depth;

  PartCorner() = default;
  TRILITH_INLINE PartCorner(const Lanes& at, const Lanes& below) : arm(at), depth(below) {}
  // Copied as lanes: a copy in halves of a register would stall the loads that follow.
  TRILITH_INLINE PartCorner(const PartCorner& o) : arm(o.arm), depth(o.depth) {}
  TRILITH_INLINE PartCorner& operator=(const PartCorner& o) {
    arm = o.arm, depth = o.depth;
    return *this;
  }
};

/// A convex part of a pressed face, and the face that is nearest to it among those compared so far.
struct NearestPart {
  static constexpr int most = 24;
  int count, nearest;
  std::array<PartCorner, most> corner;

  TRILITH_INLINE void add(const PartCorner& c) { corner[static_cast<std::size_t>(count++)] = c; }
};

/// A face of the shared solid in parts, in each of which one face of the other solid is nearest.
class NearestParts {
 public:
  /// Adds the triangles of a loop, whose face has the normal and sign `face`. False where too many faces of the other
  /// may be nearest for the buffer.
  TRILITH_INLINE bool add_to(TriangleLanes& triangles, const Lanes& face, const EdgeOverlap& shared, std::size_t loop,
                             const std::array<DepthRow, EdgeOverlap::most_points>& depth) {
    const EdgeOverlap::Loop& rim = shared.loop[loop];
    if (rim.count > NearestPart::most - 2 * most_nearest || !list_nearest(rim, depth)) return false;
    if (faces_ == 1) {
      add_fan(triangles, face, rim.count, [&](int k) TRILITH_INLINE_LAMBDA {
        const std::size_t point = rim.point[static_cast<std::size_t>(k)];
        Lanes v = shared.arm[point];
        v[3] = larger(depth[point].below[face_[0]], 0.0);
        return v;
      });
      return true;
    }
    divide(shared, rim, depth);
    for (int i = 0; i < parts_; ++i) {
      const NearestPart& part = part_[room_[static_cast<std::size_t>(i)]];
      add_fan(triangles, face, part.count, [&](int k) TRILITH_INLINE_LAMBDA {
        Lanes v = part.corner[static_cast<std::size_t>(k)].arm;
        v[3] = part.corner[static_cast<std::size_t>(k)].depth[part.nearest];
        return v;
      });
    }
    return true;
  }

 private:
  static constexpr int most_nearest = lane_count, most_parts = 8, most_rooms = 2 * most_parts - 1;

  /// Triangles of a convex polygon about its first corner.
  template <class Corner>
  TRILITH_INLINE static void add_fan(TriangleLanes& triangles, const Lanes& face, int count, Corner&& corner) {
    const Lanes first = corner(0);
    Lanes last = corner(1);
    for (int k = 2; k < count; ++k) {
      const Lanes next = corner(k);
      triangles.add(face, first, last, next);
      last = next;
    }
  }

  /// Divides a loop between the nearest faces.
  TRILITH_INLINE void divide(const EdgeOverlap& shared, const EdgeOverlap::Loop& rim,
                             const std::array<DepthRow, EdgeOverlap::most_points>& depth) {
    parts_ = 1, rooms_ = 1, room_[0] = 0;
    NearestPart& whole = part_[0];
    whole.count = 0, whole.nearest = 0;
    for (int i = 0; i < rim.count; ++i) {
      const std::size_t point = rim.point[static_cast<std::size_t>(i)];
      const auto& below = depth[point].below;
      const Lanes depths{below[face_[0]], below[face_[1]], below[face_[2]], below[face_[3]]};
      whole.add({shared.arm[point], larger<Lanes>(depths, Lanes{})});
    }
    for (int k = 1; k < faces_; ++k)
      for (int i = 0, before = parts_; i < before; ++i) give_to(k, static_cast<std::size_t>(i));
  }

  /// A face is nearest nowhere if the whole rim is deeper below it than below some other face.
  TRILITH_INLINE bool list_nearest(const EdgeOverlap::Loop& rim,
                                   const std::array<DepthRow, EdgeOverlap::most_points>& depth) {
    const double* first_row = depth[rim.point[0]].below.data();
    std::array<Lanes, 2> low, high;
    __builtin_memcpy(&low, first_row, sizeof low);
    high = low;
    for (int i = 1; i < rim.count; ++i) {
      const double* row = depth[rim.point[static_cast<std::size_t>(i)]].below.data();
      for (std::size_t half = 0; half < 2; ++half) {
        Lanes v;
        __builtin_memcpy(&v, row + half * lane_count, sizeof v);
        low[half] = smaller<Lanes>(low[half], v), high[half] = larger<Lanes>(high[half], v);
      }
    }
    const Lanes least = smaller<Lanes>(high[0], high[1]);
    const double reach = larger(0.0, smaller(smaller(least[0], least[1]), smaller(least[2], least[3])));
    unsigned bits = lane_bits(low[0] <= reach, low[1] <= reach);
    faces_ = 0;
    if (bits == 0 || std::popcount(bits) > most_nearest) return false;
    face_.fill(static_cast<std::uint8_t>(std::countr_zero(bits)));
    for (; bits != 0; bits &= bits - 1)
      face_[static_cast<std::size_t>(faces_++)] = static_cast<std::uint8_t>(std::countr_zero(bits));
    return true;
  }

  /// Splits off the portion of a part that is nearer to another face.
  TRILITH_INLINE void give_to(int face, std::size_t which) {
    NearestPart& part = part_[room_[which]];
    std::array<double, NearestPart::most> height;
    double highest = 0, lowest = 0;
    for (int i = 0; i < part.count; ++i) {
      const Lanes& depth = part.corner[static_cast<std::size_t>(i)].depth;
      const double h = depth[face] - depth[part.nearest];
      height[static_cast<std::size_t>(i)] = h, highest = larger(highest, h), lowest = smaller(lowest, h);
    }
    if (!(lowest < 0)) return;
    if (!(highest > 0)) {
      part.nearest = face;
      return;
    }
    room_[which] = static_cast<std::size_t>(rooms_++);
    NearestPart& kept = part_[room_[which]];
    room_[static_cast<std::size_t>(parts_++)] = static_cast<std::size_t>(rooms_);
    NearestPart& other = part_[static_cast<std::size_t>(rooms_++)];
    kept.count = 0, kept.nearest = part.nearest, other.count = 0, other.nearest = face;
    for (int i = 0; i < part.count; ++i) {
      const int next = i + 1 == part.count ? 0 : i + 1;
      const PartCorner &p = part.corner[static_cast<std::size_t>(i)], &q = part.corner[static_cast<std::size_t>(next)];
      const double hp = height[static_cast<std::size_t>(i)], hq = height[static_cast<std::size_t>(next)];
      if (hp >= 0) kept.add(p);
      if (hp <= 0) other.add(p);
      if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) {
        const double t = hp / (hp - hq);
        const PartCorner at(p.arm + t * (q.arm - p.arm), p.depth + t * (q.depth - p.depth));
        kept.add(at), other.add(at);
      }
    }
  }

  int faces_ = 0, parts_ = 0, rooms_ = 0;
  std::array<std::uint8_t, most_nearest> face_{};
  std::array<std::size_t, most_parts> room_;  // slot of each part
  std::array<NearestPart, most_rooms> part_;
};

}  // namespace trilith
