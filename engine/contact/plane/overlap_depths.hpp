// Depths of the corners of one convex piece below the edges of another, four edges at once.
//
// Input: the edges of the owner (corner c_f, outward normal n_f) and the corners x_v of the other piece. Output: the
// depth n_f . (c_f - x_v) of corner v below face f, positive inside. Further, for each corner a bit set of the faces
// that it is outside of. Along an edge (v, w), where the depths are linear, the part inside all faces and the face that
// is nearest there.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "contact/plane/overlap_press.hpp"

namespace trilith {

/// Bit i: lane i of the mask is true.
TRILITH_INLINE std::uint64_t bits_of_mask(const LaneMask& m) {
  const LaneMask bits = m & LaneMask{1, 2, 4, 8}, pairs = bits | __builtin_shufflevector(bits, bits, 2, 3, 0, 1);
  return static_cast<std::uint64_t>(pairs[0] | pairs[1]);
}
/// The inverse: lanes from the lowest four bits.
TRILITH_INLINE LaneMask mask_of_bits(std::uint64_t bits) {
  const auto all = static_cast<std::int64_t>(bits);
  return (LaneMask{all, all, all, all} & LaneMask{1, 2, 4, 8}) != LaneMask{};
}
TRILITH_INLINE double least_lane(const Lanes& v) {
  const Lanes pairs = smaller(v, Lanes(__builtin_shufflevector(v, v, 2, 3, 0, 1)));
  return smaller(pairs[0], pairs[1]);
}
TRILITH_INLINE double largest_lane(const Lanes& v) {
  const Lanes pairs = larger(v, Lanes(__builtin_shufflevector(v, v, 2, 3, 0, 1)));
  return larger(pairs[0], pairs[1]);
}

/// The surface face that is nearest from some position along an edge on, and the position up to which it stays nearest.
struct NearestFace {
  int face;
  double slope, until;
};

/// A separating face, and the least distance that it gives [m].
struct ApartBy {
  int face = -1;
  double gap = 0;
};

/// For pieces with any number of corners: four faces at once. `most`: capacity for corners, a multiple of four.
template <int most>
struct alignas(32) DepthsOfMany {
  static_assert(most % lane_count == 0 && most <= max_piece_corners);
  std::array<Lanes, static_cast<std::size_t>(most) * most / lane_count> value;  ///< [corner][four faces]
  std::array<std::uint64_t, most> outside;  ///< [corner] bit f: outside of face f; unused lanes equal face 0
  int corners, fours;                       ///< of the other piece; of the owner's faces

  [[nodiscard]] TRILITH_INLINE int blocks() const { return most == lane_count ? 1 : fours; }
  [[nodiscard]] TRILITH_INLINE const Lanes& at(int corner, int block) const {
    return value[static_cast<std::size_t>(corner * blocks() + block)];
  }
  [[nodiscard]] TRILITH_INLINE double at(int corner, int block, int lane) const {
    return reinterpret_cast<const double*>(value.data())[(corner * blocks() + block) * lane_count + lane];
  }

  /// Returns a bit set of the faces that have all corners outside, possibly including unused lanes.
  TRILITH_INLINE std::uint64_t fill(const PieceSides& owner, int faces, const PieceSides& /*sides*/,
                                    std::span<const Vec2> other) {
    corners = static_cast<int>(other.size()), fours = edge_blocks(faces);
    std::fill_n(outside.begin(), corners, std::uint64_t{0});
    for (int k = 0; k < blocks(); ++k) {
      const EdgeLanes f(owner.row + k * lane_count);
      for (int v = 0; v < corners; ++v) {
        const Lanes depth = f.nx * (f.x - other[v].x()) + f.ny * (f.y - other[v].y());
        value[static_cast<std::size_t>(v * blocks() + k)] = depth;
        outside[static_cast<std::size_t>(v)] |= bits_of_mask(depth <= Lanes{}) << (k * lane_count);
      }
    }
    std::uint64_t apart = ~std::uint64_t{0};
    for (int v = 0; v < corners; ++v) apart &= outside[static_cast<std::size_t>(v)];
    return apart;
  }

  /// Among the faces in `apart` the one with the largest separation.
  [[nodiscard]] TRILITH_INLINE ApartBy widest(std::uint64_t apart) const {
    ApartBy widest;
    for (int k = 0; k < blocks(); ++k) {
      Lanes deepest = all_lanes(-std::numeric_limits<double>::infinity());
      for (int v = 0; v < corners; ++v) deepest = larger(deepest, at(v, k));
      const LaneMask counts = mask_of_bits(apart >> (k * lane_count));
      const Lanes gap = select(counts, larger(-deepest, all_lanes(std::numeric_limits<double>::min())), Lanes{});
      const double most_here = largest_lane(gap);
      if (most_here <= widest.gap) continue;
      widest = {k * lane_count + std::countr_zero(bits_of_mask(gap == all_lanes(most_here))), most_here};
    }
    return widest;
  }

  /// The part of edge (v, w) inside all faces; no face may have both ends outside.
  [[nodiscard]] TRILITH_INLINE EdgeSpan inside(int v, int w) const {
    const Lanes zero{}, one = all_lanes(1);
    Lanes from = zero, to = one;
    for (int k = 0; k < blocks(); ++k) {
      const Lanes d0 = at(v, k), d1 = at(w, k);
      const LaneMask enters = d0 < zero, leaves = d1 < zero;
      const Lanes share = d0 / select(enters | leaves, d0 - d1, one);
      from = larger(from, select(enters, share, zero));
      to = smaller(to, select(leaves, share, one));
    }
    return {largest_lane(from), least_lane(to)};
  }

  /// Next face of the lower envelope of depths along (v, w) at the relative position `at_share`. Along an envelope of
  /// lines the slopes decrease. So only faces with a slope below `steeper_than` count, and rounding at a crossing
  /// cannot select the last face again. Among faces with equal depth the steepest descent wins, then the first. Face
  /// -1: none.
  [[nodiscard]] TRILITH_INLINE NearestFace nearest(std::uint64_t surface, int v, int w, double at_share, double to,
                                                   double steeper_than) const {
    const Lanes none = all_lanes(std::numeric_limits<double>::infinity());
    const auto slope_of = [&](int k) TRILITH_INLINE_LAMBDA { return at(w, k) - at(v, k); };
    const auto depth_of = [&](int k) TRILITH_INLINE_LAMBDA { return at(v, k) + slope_of(k) * at_share; };
    const auto may_be = [&](int k) TRILITH_INLINE_LAMBDA { return mask_of_bits(surface >> (k * lane_count)); };
    Lanes depths = none;
    for (int k = 0; k < blocks(); ++k)
      depths = smaller(depths, select(may_be(k) & (slope_of(k) < steeper_than), depth_of(k), none));
    const double depth = least_lane(depths);
    const auto is_least = [&](int k) TRILITH_INLINE_LAMBDA {
      return may_be(k) & (slope_of(k) < steeper_than) & (depth_of(k) == all_lanes(depth));
    };
    Lanes slopes = none;
    for (int k = 0; k < blocks(); ++k) slopes = smaller(slopes, select(is_least(k), slope_of(k), none));
    const double slope = least_lane(slopes);
    std::uint64_t found = 0;
    for (int k = 0; k < blocks(); ++k)
      found |= bits_of_mask(is_least(k) & (slope_of(k) == all_lanes(slope))) << (k * lane_count);
    if (found == 0) return {-1, 0, to};
    Lanes until = all_lanes(to);
    for (int k = 0; k < blocks(); ++k) {
      const LaneMask steeper = may_be(k) & (slope_of(k) < slope);
      const Lanes run = (depth_of(k) - depth) / select(steeper, slope - slope_of(k), all_lanes(1));
      until = smaller(until, select(steeper, larger(all_lanes(at_share), at_share + run), none));
    }
    return {std::countr_zero(found), slope, least_lane(until)};
  }

  /// Calls push(section) for the sections of edge e, from its first corner on.
  template <class Push>
  TRILITH_INLINE void stretches_of(int e, std::uint64_t surface, bool walker_is_b, Push&& push) const {
    const int w = e + 1 < corners ? e + 1 : 0;
    const EdgeSpan span = inside(e, w);
    double at_share = span.from, slope = std::numeric_limits<double>::infinity();
    // Each iteration handles one face, up to the position where the next one is nearer.
    while (at_share < span.to) {
      const NearestFace next = nearest(surface, e, w, at_share, span.to, slope);
      if (next.face < 0) break;  // the last face of the envelope is passed, up to rounding
      const int block = next.face / lane_count, lane = next.face % lane_count;
      push(OverlapStretch{{at_share, next.until}, at(e, block, lane), at(w, block, lane), e, next.face, walker_is_b});
      at_share = next.until, slope = next.slope;
    }
  }
  /// Counts the corners of the other piece inside the owner; `at` becomes the last of them with its nearest face.
  [[nodiscard]] TRILITH_INLINE int corners_inside(int corner_count, int faces, CornerOnFace& at) const {
    int count = 0;
    for (int v = 0; v < corner_count; ++v) {
      if (outside[static_cast<std::size_t>(v)] != 0) continue;
      int nearest = 0;
      for (int f = 1; f < faces; ++f)
        if (this->at(v, f / lane_count, f % lane_count) < this->at(v, nearest / lane_count, nearest % lane_count))
          nearest = f;
      at.corner = static_cast<std::uint8_t>(v), at.face = static_cast<std::uint8_t>(nearest);
      ++count;
    }
    return count;
  }
  /// Edges of the other piece for which no face has both ends outside.
  [[nodiscard]] TRILITH_INLINE std::uint64_t edges_inside() const {
    std::uint64_t edges = 0;
    for (int e = 0; e < corners; ++e) {
      const int w = e + 1 < corners ? e + 1 : 0;
      const bool out = (outside[static_cast<std::size_t>(e)] & outside[static_cast<std::size_t>(w)]) != 0;
      edges |= std::uint64_t{out ? 0U : 1U} << e;
    }
    return edges;
  }
};

/// For pieces with at most four corners: one lane for each corner of the other piece, or for the edge that begins
/// there.
struct alignas(32) DepthsOfFour {
  Lanes depth[lane_count], slope[lane_count];  ///< [face] at corners; from each corner to the next
  LaneMask out;                                ///< of edges: some face has both ends outside
  int faces;

  TRILITH_INLINE static Lanes next(const Lanes& v) { return __builtin_shufflevector(v, v, 1, 2, 3, 0); }

  /// Corresponds to DepthsOfMany::fill.
  TRILITH_INLINE std::uint64_t fill(const PieceSides& owner, int face_count, const PieceSides& other,
                                    std::span<const Vec2> /*corners*/) {
    const EdgeLanes ends(other.row);
    const Lanes zero{}, x = ends.x, y = ends.y;
    faces = face_count;
    out = LaneMask{};
    for (int f = 0; f < lane_count; ++f) {  // unused lanes repeat the first face
      const EdgeRow& row = owner.row[f];
      depth[f] = row.nx * (row.x - x) + row.ny * (row.y - y);
      const Lanes to = next(depth[f]);
      slope[f] = to - depth[f];
      out |= (depth[f] <= zero) & (to <= zero);
    }
    // A face with all corners outside has all edges outside too.
    if (bits_of_mask(out) != 15) return 0;
    std::uint64_t apart = 0;
    for (int f = 0; f < lane_count; ++f) apart |= std::uint64_t{bits_of_mask(depth[f] <= zero) == 15 ? 1U : 0U} << f;
    return apart;
  }
  [[nodiscard]] TRILITH_INLINE ApartBy widest(std::uint64_t apart) const {
    ApartBy widest;
    for (int f = 0; f < faces; ++f) {
      const double gap = larger(-largest_lane(depth[f]), std::numeric_limits<double>::min());
      if ((apart >> f & 1) != 0 && gap > widest.gap) widest = {f, gap};
    }
    return widest;
  }
  /// Corresponds to DepthsOfMany::corners_inside.
  [[nodiscard]] TRILITH_INLINE int corners_inside(int corner_count, int face_count, CornerOnFace& at) const {
    Lanes least = depth[0];
    LaneMask face{};
    for (int f = 1; f < lane_count; ++f) {  // unused lanes repeat the first face, which does not change the minimum
      const LaneMask nearer = depth[f] < least;
      least = select(nearer, depth[f], least);
      face = nearer ? LaneMask{} + f : face;
    }
    const std::uint64_t inside = bits_of_mask(least > Lanes{}) & ((std::uint64_t{1} << corner_count) - 1);
    if (inside == 0) return 0;
    const int v = std::countr_zero(inside);
    at.corner = static_cast<std::uint8_t>(v), at.face = static_cast<std::uint8_t>(face[v] < face_count ? face[v] : 0);
    return std::popcount(inside);
  }
  /// The sections of all edges of the walker, edge by edge, written from `list` on; returns their number.
  TRILITH_INLINE int stretches(std::uint64_t owner_surface, std::uint64_t walker_surface, bool walker_is_b,
                               OverlapStretch* list) const;

 private:
  /// One step of all edges: each follows the face that is nearest at its `from`, up to where the next one is nearer.
  struct alignas(32) Leg {
    LaneMask face;
    Lanes from, until;
    std::uint64_t edges;  ///< bit set of the active edges
  };
  struct alignas(32) Spans {
    Lanes from, to;
  };
  [[nodiscard]] TRILITH_INLINE Spans inside() const;
  TRILITH_INLINE int legs(std::uint64_t owner_surface, const Spans& spans, std::uint64_t edges, Leg* leg) const;
};

/// DepthsOfMany::inside for all edges.
TRILITH_INLINE DepthsOfFour::Spans DepthsOfFour::inside() const {
  const Lanes zero{}, one = all_lanes(1);
  Spans spans{zero, one};
  for (int f = 0; f < lane_count; ++f) {
    const Lanes d0 = depth[f], d1 = next(d0);
    const LaneMask enters = d0 < zero, leaves = d1 < zero;
    const Lanes share = d0 / select(enters | leaves, d0 - d1, one);
    spans.from = larger(spans.from, select(enters, share, zero));
    spans.to = smaller(spans.to, select(leaves, share, one));
  }
  return spans;
}

/// DepthsOfMany::nearest step by step for all `edges`; returns the number of steps. Slopes decrease, so there are at
/// most as many steps as faces.
TRILITH_INLINE int DepthsOfFour::legs(std::uint64_t owner_surface, const Spans& spans, std::uint64_t edges,
                                      Leg* leg) const {
  const Lanes one = all_lanes(1), none = all_lanes(std::numeric_limits<double>::infinity());
  // Faces that are not surface are skipped by an infinite slope.
  Lanes rise[lane_count];
  for (int f = 0; f < lane_count; ++f) rise[f] = (owner_surface >> f & 1) != 0 ? slope[f] : none;
  LaneMask active = mask_of_bits(edges);
  Lanes from = spans.from, steeper_than = none;
  int turns = 0;
  for (std::uint64_t left = edges; turns < lane_count && left != 0; ++turns) {
    Lanes best = none, best_rise = none, here[lane_count];
    LaneMask face = LaneMask{} - 1;
    for (int f = 0; f < lane_count; ++f) {
      here[f] = depth[f] + slope[f] * from;
      const LaneMask nearer =
          (rise[f] < steeper_than) & ((here[f] < best) | ((here[f] == best) & (rise[f] < best_rise)));
      best = select(nearer, here[f], best), best_rise = select(nearer, rise[f], best_rise);
      face = nearer ? LaneMask{} + f : face;
    }
    Lanes until = spans.to;
    for (int f = 0; f < lane_count; ++f) {
      const LaneMask steeper = rise[f] < best_rise;
      const Lanes run = (here[f] - best) / select(steeper, best_rise - rise[f], one);
      until = smaller(until, select(steeper, larger(from + run, from), none));
    }
    active &= face >= LaneMask{};
    leg[turns] = {face, from, until, bits_of_mask(active)};
    from = until, steeper_than = best_rise;
    active &= from < spans.to;
    left = bits_of_mask(active);
  }
  return turns;
}

TRILITH_INLINE int DepthsOfFour::stretches(std::uint64_t owner_surface, std::uint64_t walker_surface, bool walker_is_b,
                                           OverlapStretch* list) const {
  if ((bits_of_mask(~out) & walker_surface) == 0) return 0;
  const Spans spans = inside();
  const std::uint64_t edges = bits_of_mask(~out & (spans.from < spans.to)) & walker_surface;
  Leg leg[lane_count];
  const int turns = legs(owner_surface, spans, edges, leg);
  int count = 0;
  const auto* depths = reinterpret_cast<const double*>(depth);
  for (std::uint64_t left = edges; left != 0; left &= left - 1) {
    const int e = std::countr_zero(left), w = (e + 1) % lane_count;
    for (int k = 0; k < turns && (leg[k].edges >> e & 1) != 0; ++k) {
      const int f = static_cast<int>(leg[k].face[e]);
      list[count++] = {
          {leg[k].from[e], leg[k].until[e]}, depths[f * lane_count + e], depths[f * lane_count + w], e, f, walker_is_b};
    }
  }
  return count;
}

template <int most>
using OverlapDepths = std::conditional_t<most == lane_count, DepthsOfFour, DepthsOfMany<most>>;

}  // namespace trilith
