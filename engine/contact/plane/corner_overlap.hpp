// One corner of a convex piece under one face of another, or one corner of each in the other: the usual contacts of
// rubble, four pairs at once.
//
//         p                     n       The corner v of one piece, the wedge, lies below the face f of the other, the
//          \                   /        owner, and nothing else of either lies in the other. What they share is the
//     ----- P1 ------ B ----- P2 ----   triangle P1 v P2. Its pressed stretches are four, those that
//     <- f    \       :      /          contact/plane/overlap_press.hpp would find: P1 v and v P2 along the wedge,
//     below f;
//               \     :    /            P2 B and B P1 along f, each below the nearer edge of the wedge. B is where both
//                 \   :  /              edges are as near.
//                   \ : /
//                     v
//
// Comes in: which corner is below which face, as it was found once and may not hold any more. Goes out: what
// respond_overlap() gives, but for rounding, wherever it does hold and clearly so; the rest is left to that one.
// Whether it holds is found from where the pieces are, so it does not matter who remembered the corner, or whether
// anybody did.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <variant>

#include "contact/plane/overlap_pair.hpp"

namespace trilith {

/// True of a law whose kernel is Coulomb's and no more: corner contact is made for those.
inline bool is_plain_friction(const ContactLaw& law) {
  return std::visit([]<class L>(const L&) { return std::is_same_v<typename L::Kernel, Coulomb>; }, law);
}

/// True of a piece that corner contact is made for: rigid, every edge of it surface, its edges placed, explicit steps.
inline bool has_plain_corners(const PlacedPiece& piece) {
  const std::size_t edges = piece.corner.size();
  return piece.corner_velocity.empty() && piece.over_step == nullptr &&
         piece.sides.surface == (edges < 64 ? (std::uint64_t{1} << edges) - 1 : ~std::uint64_t{0});
}

/// Forces at the corners that such a contact presses on: those at the ends of the edge before the corner of the wedge,
/// and of the face of the owner [N].
struct alignas(32) CornerPush {
  std::array<Vec2, 2> on_wedge, on_owner;
};

/// One pair, and where its answer goes.
struct CornerCase {
  const PlacedPiece *a, *b;     ///< with plain corners
  CornerOnFace at;              ///< with a corner
  const ContactMemory* before;  ///< of a contact of general shape, or empty
  ContactMemory* after;         ///< what it remembers from now on
  OverlapResponse* out;         ///< but for its memory
  CornerPush* push;
};

/// Most pairs that are answered at once.
inline constexpr int most_corner_cases = lane_count;

/// Answers up to most_corner_cases pairs under one law, all with `at.both` alike. Bit i of what is returned: pair i was
/// answered; of the others nothing is written.
std::uint32_t respond_corners(std::span<const CornerCase> pairs, const PlainFriction& law);

}  // namespace trilith
