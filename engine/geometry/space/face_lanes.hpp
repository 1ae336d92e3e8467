// The polygons shared by four pairs of plane faces, and integrals over them, one pair in each SIMD lane.
//
// The method follows geometry/space/face_overlap_3d.hpp, but the polygon is stored by its edges with both ends. Edges
// have fixed slots: first the edges of a's face, then one for each line that cuts the polygon (an edge of b's face, or
// the line where the overlap is 0). No slot depends on another one. So four pairs of faces whose edges cross in
// different orders execute the same operations, and a lane has the same bits as a single pair.
//
//       q3 ______ p3=q2
//         |      \ .
//     ----x-------x----    line
//         |________\ .
//        p0        q0=p1
//
// Cut by a line: each edge that crosses it has one end moved to the crossing. An edge beyond the line is no longer
// alive. A new edge runs along the line between the two crossings. Neighbours share their common corner to the bit, so
// the remainder is closed. A polygon that rounding makes cross a line more than twice is marked `rough`; its results
// must not be used.
//
// Integrals over the polygon are sums over its edges (Green's theorem), in any order of the edges. With w = p x q about
// some point: `2 A = sum of w,  6 Mx = sum of w (px + qx)`, and so on to third order.
#pragma once

#include <array>

#include "base/simd/lane_vectors.hpp"
#include "geometry/space/face_overlap_3d.hpp"

namespace trilith {

/// Two faces in each lane. Unused corners repeat the last one.
struct FacesInLanes {
  int corners_a = 0, corners_b = 0;  ///< largest number of any lane, 3 to max_face_corners
  std::array<Triple<Lanes>, max_face_corners> a, b;
  Triple<Lanes> normal_a, normal_b;
};

/// See MeanPlane.
struct PlaneInLanes {
  Triple<Lanes> origin, x, y, normal;
  Lanes overlap;
  Pair2<Lanes> slope;

  [[nodiscard]] TRILITH_INLINE Pair2<Lanes> project(const Triple<Lanes>& p) const {
    const Triple<Lanes> arm = p - origin;
    return {x.dot(arm), y.dot(arm)};
  }
  [[nodiscard]] TRILITH_INLINE Triple<Lanes> along(const Pair2<Lanes>& p) const { return x * p.x + y * p.y; }
};

/// A function that is linear over the mean plane.
struct LinearInLanes {
  Lanes at;
  Pair2<Lanes> slope;

  TRILITH_INLINE Lanes operator()(const Pair2<Lanes>& p) const { return at + slope.dot(p); }
};

/// A convex polygon as counter-clockwise edges. Edges that are alive in no lane are removed.
struct EdgesInLanes {
  static constexpr int most = 2 * max_face_corners + 2;
  int count = 0;
  int lines = 0;  ///< number of edges and cutting lines so far; the index of the next line
  LaneMask rough{};
  std::array<Pair2<Lanes>, most> from, to;
  std::array<LaneMask, most> alive;
  std::array<int, most> line;  ///< the line on which an edge lies

  TRILITH_INLINE void put(std::size_t i, const Pair2<Lanes>& p, const Pair2<Lanes>& q, const LaneMask& is_there,
                          int along) {
    from[i] = p, to[i] = q, alive[i] = is_there, line[i] = along;
  }
  TRILITH_INLINE void add(const Pair2<Lanes>& p, const Pair2<Lanes>& q, const LaneMask& is_there) {
    put(static_cast<std::size_t>(count++), p, q, is_there, lines++);
  }
};

/// Integrals over a polygon of 1, p, p p and p p p about a point.
struct AreaInLanes {
  Lanes area{};
  Pair2<Lanes> first{};
  Lanes xx{}, xy{}, yy{};
};
struct MomentsInLanes : AreaInLanes {
  Lanes xxx{}, xxy{}, xyy{}, yyy{};
};

TRILITH_INLINE PlaneInLanes mean_plane(const FacesInLanes& faces) {
  const Triple<Lanes> between = faces.normal_a - faces.normal_b, sum = faces.normal_a + faces.normal_b,
                      apart = faces.b[0] - faces.a[0], edge = faces.a[1] - faces.a[0];
  const Lanes one = Lanes{} + 1.0, scale = 2.0 / root(between.square());
  PlaneInLanes plane;
  plane.normal = between * (0.5 * scale);
  const Triple<Lanes> along = edge - plane.normal * plane.normal.dot(edge);
  plane.x = along * (one / root(along.square()));
  plane.y = cross(plane.normal, plane.x);
  plane.overlap = scale * faces.normal_b.dot(apart);
  plane.slope = {-scale * plane.x.dot(sum), -scale * plane.y.dot(sum)};
  plane.origin = faces.a[0] - plane.normal * (0.5 * plane.overlap);
  return plane;
}

/// Keeps the part of the polygon where `side` is not below 0. Each corner begins one live edge, so testing the start
/// points is enough to find whether anything is cut.
TRILITH_INLINE void cut_edges(EdgesInLanes& polygon, const LinearInLanes& side) {
  const Lanes zero{}, one = zero + 1.0;
  std::array<Lanes, EdgesInLanes::most> at_from;
  LaneMask beyond{};
  const auto count = static_cast<std::size_t>(polygon.count);
  for (std::size_t i = 0; i < count; ++i) {
    at_from[i] = side(polygon.from[i]);
    beyond |= polygon.alive[i] & (at_from[i] < zero);
  }
  const int along = polygon.lines++;
  if (!any(beyond)) return;
  Pair2<Lanes> leaves{}, enters{};
  Lanes crossings{};
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Pair2<Lanes> p = polygon.from[i], q = polygon.to[i];
    const Lanes at_to = side(q);
    const LaneMask from_in = at_from[i] >= zero, to_in = at_to >= zero, was = polygon.alive[i],
                   out = was & from_in & flip(to_in), in = was & flip(from_in) & to_in, stays = was & (from_in | to_in);
    if (!any(stays)) continue;
    polygon.alive[kept] = stays;
    if (kept != i) polygon.put(kept, p, q, stays, polygon.line[i]);
    if (any(out | in)) {
      const Pair2<Lanes> x = p + (q - p) * (at_from[i] / (at_from[i] - at_to));
      leaves = select<Lanes>(out, x, leaves), enters = select<Lanes>(in, x, enters);
      polygon.to[kept] = select<Lanes>(out, x, q), polygon.from[kept] = select<Lanes>(in, x, p);
      crossings += select(out | in, one, zero);
    }
    ++kept;
  }
  polygon.rough |= crossings > one + one;
  polygon.put(kept, leaves, enters, crossings > zero, along);
  polygon.count = static_cast<int>(kept) + 1;
}

/// Lines with their own bit in the result of lines_of; further lines share these bits.
inline constexpr int told_lines = 16;

/// For each lane a bit set of the lines on which the remaining edges lie.
TRILITH_INLINE LaneMask lines_of(const EdgesInLanes& polygon) {
  LaneMask lines{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i)
    lines |= polygon.alive[i] & (LaneMask{} + (std::int64_t{1} << polygon.line[i]));
  return lines;
}

/// Each line is shifted outward by this share of its length. So edges that coincide up to rounding, as on the face of a
/// wall, cut nothing.
inline constexpr double line_slack = 1e-12;

/// The intersection of both faces in the mean plane: a's face cut by b's edges, which run the other way round.
TRILITH_INLINE void share_edges(const FacesInLanes& faces, const PlaneInLanes& plane, EdgesInLanes& shared) {
  const Lanes zero{};
  shared.count = shared.lines = 0, shared.rough = LaneMask{};
  const Pair2<Lanes> first = plane.project(faces.a[0]);
  Pair2<Lanes> p = first;
  for (int i = 1; i <= faces.corners_a; ++i) {
    const Pair2<Lanes> q = i < faces.corners_a ? plane.project(faces.a[static_cast<std::size_t>(i)]) : first;
    shared.add(p, q, (p.x != q.x) | (p.y != q.y));
    p = q;
  }
  const Pair2<Lanes> edge = shared.to[0] - shared.from[0];
  const Lanes size = magnitude(edge.x) + magnitude(edge.y);
  Pair2<Lanes> from = plane.project(faces.b[0]);
  for (int k = faces.corners_b - 1; k >= 0; --k) {
    const Pair2<Lanes> to = plane.project(faces.b[static_cast<std::size_t>(k)]), along = to - from;
    const Lanes length = magnitude(along.x) + magnitude(along.y);
    // along x (p - from), and the slack; 0 everywhere for an edge that only repeats a corner
    const LinearInLanes side{along.y * from.x - along.x * from.y + line_slack * length * (length + size),
                             {zero - along.y, along.x}};
    cut_edges(shared, side);
    from = to;
  }
}

TRILITH_INLINE Lanes cross(const Pair2<Lanes>& p, const Pair2<Lanes>& q) {
  return p.x * q.y - p.y * q.x;
}

/// Mean of the corners: a point in the polygon, about which integrals lose no digits.
TRILITH_INLINE Pair2<Lanes> middle_of(const EdgesInLanes& polygon) {
  const Lanes zero{}, one = zero + 1.0;
  const Pair2<Lanes> none{};
  Pair2<Lanes> sum{};
  Lanes count{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i) {
    sum = sum + select<Lanes>(polygon.alive[i], polygon.from[i], none);
    count += select(polygon.alive[i], one, zero);
  }
  return sum * (one / larger(count, one));
}

TRILITH_INLINE void move_edges(EdgesInLanes& polygon, const Pair2<Lanes>& by) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i)
    polygon.from[i] = polygon.from[i] - by, polygon.to[i] = polygon.to[i] - by;
}

/// Adds the contribution of an edge, times w, to the moments up to second order.
TRILITH_INLINE void add_edge(const Pair2<Lanes>& p, const Pair2<Lanes>& q, const Lanes& w, AreaInLanes& sums) {
  const Lanes sx = p.x + q.x, sy = p.y + q.y;
  sums.area += w;
  sums.first = sums.first + Pair2<Lanes>{w * sx, w * sy};
  sums.xx += w * (p.x * sx + q.x * q.x);
  sums.xy += w * (sx * sy + p.x * p.y + q.x * q.y);
  sums.yy += w * (p.y * sy + q.y * q.y);
}

TRILITH_INLINE void finish(AreaInLanes& sums) {
  sums.area *= 0.5;
  sums.first = sums.first * (Lanes{} + 1.0 / 6);
  sums.xx *= 1.0 / 12, sums.xy *= 1.0 / 24, sums.yy *= 1.0 / 12;
}

TRILITH_INLINE AreaInLanes area_of(const EdgesInLanes& polygon) {
  AreaInLanes sums;
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i) {
    const Pair2<Lanes>&p = polygon.from[i], &q = polygon.to[i];
    add_edge(p, q, select(polygon.alive[i], cross(p, q), Lanes{}), sums);
  }
  finish(sums);
  return sums;
}

TRILITH_INLINE MomentsInLanes moments_of(const EdgesInLanes& polygon) {
  MomentsInLanes sums;
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i) {
    const Pair2<Lanes>&p = polygon.from[i], &q = polygon.to[i];
    const Lanes w = select(polygon.alive[i], cross(p, q), Lanes{}), sx = p.x + q.x, sy = p.y + q.y;
    const Lanes pxx = p.x * p.x, qxx = q.x * q.x, pyy = p.y * p.y, qyy = q.y * q.y, px = p.x * q.x, py = p.y * q.y;
    add_edge(p, q, w, sums);
    sums.xxx += w * sx * (pxx + qxx), sums.yyy += w * sy * (pyy + qyy);
    const Lanes twice_p_x = p.x + p.x, twice_p_y = p.y + p.y, twice_q_x = q.x + q.x, twice_q_y = q.y + q.y;
    sums.xxy += w * (pxx * (sy + twice_p_y) + (px + px) * sy + qxx * (sy + twice_q_y));
    sums.xyy += w * (pyy * (sx + twice_p_x) + (py + py) * sx + qyy * (sx + twice_q_x));
  }
  finish(sums);
  sums.xxx *= 1.0 / 20, sums.yyy *= 1.0 / 20, sums.xxy *= 1.0 / 60, sums.xyy *= 1.0 / 60;
  return sums;
}

}  // namespace trilith
