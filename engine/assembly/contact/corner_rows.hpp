// Rows of general contact in the plane that wait for the kernel of corners (contact/plane/corner_overlap.hpp).
//
// Input: rows with one corner below a face, or with one corner of each piece in the other. Output: groups of such rows
// under one law, as many as the kernel computes at once.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "assembly/contact/contact_rows.hpp"
#include "contact/plane/corner_overlap.hpp"

namespace trilith {

/// Rows of one law with one corner below a face, or one corner of each piece in the other, now or before; they are
/// evaluated together.
struct CornerRows {
  std::array<CornerCase, most_corner_cases> pair;
  std::array<int, most_corner_cases> row;
  std::array<OverlapAnswer*, most_corner_cases> answer;
  std::size_t count = 0;
  int law = -1;                           ///< of the rows, and of `friction`
  std::optional<PlainFriction> friction;  ///< read once for many rows

  /// For a group that is empty.
  void begin(int l, const PlainFriction& of) { law = l, friction = of; }
  void add(int r, const CornerCase& of, OverlapAnswer& to) {
    pair[count] = of, row[count] = r, answer[count] = &to;
    ++count;
  }
};

/// Whether the kernel of corners supports a law. Rows usually have the law of the row before.
struct LawOfCorners {
  int law = -1;
  bool is_known = false;

  bool knows(const Model<2>& model, int l) {
    if (l != law) law = l, is_known = is_plain_friction(model.laws[l]);
    return is_known;
  }
};

/// True if the corner and face of the last evaluation, or one corner of each piece, still exist. With the pieces
/// exchanged the bits would differ, so that case is excluded.
inline bool there_is(const CornerOnFace& at, const PlacedPiece& a, const PlacedPiece& b) {
  if (at.both && !at.wedge_is_b) return false;
  const PlacedPiece &wedge = at.wedge_is_b ? b : a, &owner = at.wedge_is_b ? a : b;
  return at.corner < wedge.corner.size() && at.face < owner.corner.size();
}

}  // namespace trilith
