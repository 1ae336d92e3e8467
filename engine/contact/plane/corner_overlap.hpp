// One corner of a convex piece below one face of another, or one corner of each inside the other: the usual contacts of
// rubble, four pairs at once in SIMD lanes.
//
//         p                     n
//          \                   /
//     ----- P1 ------ B ----- P2 ----
//     <- f    \       :      /          below f
//               \     :    /
//                 \   :  /
//                   \ : /
//                     v
//
// The corner v of one piece, the wedge, lies below the face f of the other, the owner, and nothing else of either lies
// in the other. The overlap is the triangle P1 v P2. It has four pressed sections, as contact/plane/overlap_press.hpp
// would find: P1 v and v P2 along the wedge, P2 B and B P1 along f, each below the nearer edge of the wedge. Both edges
// are equally near at B.
//
// Input: the corner and the face from an earlier search, which may be outdated. Output: the result of respond_overlap()
// up to rounding, wherever the shape is clearly valid; all other pairs are left to that function. Validity depends on
// the present positions alone, so the cached corner does not affect the result.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <variant>

#include "contact/plane/overlap_pair.hpp"

namespace trilith {

/// True for a law whose kernel is exactly Coulomb, which corner contact requires.
inline bool is_plain_friction(const ContactLaw& law) {
  return std::visit([]<class L>(const L&) { return std::is_same_v<typename L::Kernel, Coulomb>; }, law);
}

/// True for a piece that corner contact supports: rigid, all edges surface, its edges placed, explicit steps.
inline bool has_plain_corners(const PlacedPiece& piece) {
  const std::size_t edges = piece.corner.size();
  return piece.corner_velocity.empty() && piece.over_step == nullptr &&
         piece.sides.surface == (edges < 64 ? (std::uint64_t{1} << edges) - 1 : ~std::uint64_t{0});
}

/// Forces of such a contact at the corners: at the ends of the edge before the wedge's corner, and of the owner's face
/// [N].
struct alignas(32) CornerPush {
  std::array<Vec2, 2> on_wedge, on_owner;
};

/// One pair, and where its result is stored.
struct CornerCase {
  const PlacedPiece *a, *b;     ///< supported by corner contact
  CornerOnFace at;              ///< with a valid corner
  const ContactMemory* before;  ///< of a general contact, or empty
  ContactMemory* after;         ///< the new memory
  OverlapResponse* out;         ///< without its memory
  CornerPush* push;
};

/// Largest number of pairs in one call.
inline constexpr int most_corner_cases = lane_count;

/// Computes up to most_corner_cases pairs with one law and equal `at.both`. Bit i of the result: pair i was computed;
/// for the others nothing is written.
std::uint32_t respond_corners(std::span<const CornerCase> pairs, const PlainFriction& law);

}  // namespace trilith
