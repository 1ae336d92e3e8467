// Two convex pieces that may overlap: depths of each one's corners in the other, and their pressure.
//
// Input: both pieces in position, with their edges placed; a law and its memory. Output: forces at the corners of both,
// and sums over the sections inside the other piece (contact/plane/overlap_press.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "contact/plane/overlap_depths.hpp"

namespace trilith {

/// One contact, and its law's memory.
template <class K>
struct OverlapCase {
  const PlacedPiece &a, &b;
  const PieceSides &sides_a, &sides_b;
  const ContactMemory& before;
  const LawMemory<K>& own;
  const K& law;
  std::span<Vec2> on_a, on_b;
  CornerOnFace* alone;  ///< nullptr: not needed
  double held;          ///< depth up to which a bearing replaces it [m]
  const Vec2* along;    ///< see respond_overlap
};

/// The part of `span` where a depth that is linear from d0 to d1 over the whole edge exceeds `crushed`.
TRILITH_INLINE EdgeSpan above(double crushed, double d0, double d1, const EdgeSpan& span) {
  const auto depth = [&](double share) { return d0 + (d1 - d0) * share - crushed; };
  const double width = span.to - span.from;
  const PositivePart<double> part(depth(span.from), depth(span.to));
  return {span.from + width * part.from, span.from + width * part.to};
}

/// Keeps the part of each section that is deeper than the crushed depth; returns the number left.
TRILITH_INLINE int pressed_part(double crushed, OverlapStretch* list, int count) {
  if (!(crushed > 0)) return count;
  int left = 0;
  for (int i = 0; i < count; ++i) {
    OverlapStretch s = list[i];
    s.span = above(crushed, s.d0, s.d1, s.span);
    if (s.span.from < s.span.to) list[left++] = s;
  }
  return left;
}

/// Two pieces that may overlap, and the depths of each one's corners in the other. `most`: capacity for corners.
template <class K, int most>
struct Overlapping {
  const PlacedPiece &a, &b;
  const PieceSides &sides_a, &sides_b;
  OverlapDepths<most> b_in_a, a_in_b;  // not initialised here: they are large

  TRILITH_INLINE explicit Overlapping(const OverlapCase<K>& of)
      : a(of.a), b(of.b), sides_a(of.sides_a), sides_b(of.sides_b) {}

  /// False where the two are apart; `by` is then the separating face.
  TRILITH_INLINE bool measure(ApartBy& by) {
    if (const std::uint64_t apart = b_in_a.fill(sides_a, edges(a), sides_b, b.corner); apart != 0) {
      by = b_in_a.widest(apart);
      return false;
    }
    if (const std::uint64_t apart = a_in_b.fill(sides_b, edges(b), sides_a, a.corner); apart != 0) {
      by = a_in_b.widest(apart);
      by.face += max_piece_corners;
      return false;
    }
    return true;
  }
  /// The only corner of either piece inside the other, or one of both; none where there are several or none.
  [[nodiscard]] TRILITH_INLINE CornerOnFace corner_alone() const {
    CornerOnFace of_b, of_a;
    const int in_a = b_in_a.corners_inside(edges(b), edges(a), of_b),
              in_b = a_in_b.corners_inside(edges(a), edges(b), of_a);
    of_b.wedge_is_b = true;
    if (in_a == 1 && in_b == 1) return {of_b.corner, of_a.corner, true, true};
    if (in_a + in_b != 1) return {};
    return in_a == 1 ? of_b : of_a;
  }
  /// `along`: as for respond_overlap.
  TRILITH_INLINE OverlapSums press(const K& law, double crushed, std::span<Vec2> on_a, std::span<Vec2> on_b,
                                   const Vec2* along = nullptr) const {
    OverlapPress<K> press{a, b, sides_a, sides_b, law, crushed, on_a, on_b};
    OverlapSums sums;
    Vec2& push = sums.push;
    const auto press_along = [&] {
      const double size = push.norm();
      press.normal = along != nullptr ? *along : size > 0 ? Vec2(push / size) : Vec2(Vec2::Zero());
      sums.normal = press.normal;
    };
    std::array<OverlapStretch, room> list;
    if constexpr (most == lane_count) {
      int count = b_in_a.stretches(sides_a.surface, sides_b.surface, true, list.data());
      count += a_in_b.stretches(sides_b.surface, sides_a.surface, false, list.data() + count);
      count = pressed_part(crushed, list.data(), count);
      push = press.springs(list.data(), count);
      press_along();
      press.press(list.data(), count, sums);
    } else {
      by_parts(crushed, list.data(), [&](int count) { push += press.springs(list.data(), count); });
      press_along();
      by_parts(crushed, list.data(), [&](int count) { press.press(list.data(), count, sums); });
    }
    return sums;
  }
  /// Mean overlap minus the overlap at which the mortar crushes [m]. `springs`: without damping. force / (kn length) is
  /// the overlap of parallel faces with this mean pressure; law.crush_limit is fc / kn.
  [[nodiscard]] TRILITH_INLINE double excess(const K& springs, double crushed) const {
    std::array<Vec2, most> on_a, on_b;  // required by the walk, unused
    on_a.fill(Vec2::Zero()), on_b.fill(Vec2::Zero());
    const OverlapSums sums = press(springs, crushed, on_a, on_b);
    const double limit = springs.crush_limit(crushed);
    return sums.length > 0 ? sums.force / (springs.kn * sums.length) - limit : -limit;
  }
  /// The new crushed depth of the mortar, at which the mean spring pressure does not exceed its strength. Below a
  /// bearing that replaces the contact up to the depth `held`, nothing is crushed.
  [[nodiscard]] TRILITH_INLINE double crushed_now(const K& law, const LawMemory<K>& own, double held) const {
    if constexpr (!K::crushes)
      return held;
    else {
      if (held > 0) return std::max(K::crushed(own), held);
      K springs = law;
      springs.beta = 0;
      return springs.crush(K::crushed(own), [&](double depth) { return excess(springs, depth); });
    }
  }

 private:
  static constexpr int room = most == lane_count ? 2 * most * most : 4 * most;

  /// Calls f(count) for the sections of pieces with many corners, in batches that fit in `list`.
  template <class F>
  TRILITH_INLINE void by_parts(double crushed, OverlapStretch* list, F&& f) const {
    int count = 0;
    for (const bool walker_is_b : {true, false}) {
      const OverlapDepths<most>& depths = walker_is_b ? b_in_a : a_in_b;
      const std::uint64_t owner = (walker_is_b ? sides_a : sides_b).surface;
      std::uint64_t edges = depths.edges_inside() & (walker_is_b ? sides_b : sides_a).surface;
      for (; edges != 0; edges &= edges - 1) {
        depths.stretches_of(std::countr_zero(edges), owner, walker_is_b,
                            [&](const OverlapStretch& stretch) { list[count++] = stretch; });
        // An edge may have one section for every face.
        if (count <= room - most) continue;
        f(pressed_part(crushed, list, count));
        count = 0;
      }
    }
    f(pressed_part(crushed, list, count));
  }
  static int edges(const PlacedPiece& piece) { return static_cast<int>(piece.corner.size()); }
};

}  // namespace trilith
