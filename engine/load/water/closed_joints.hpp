// The parts of faces that touch another body, which water does not reach in a sealed joint.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/space.hpp"

namespace trilith {

/// Gap up to which two faces are closed [m]: above the rounding of positions, and below any gap of importance.
inline constexpr double closed_gap = 1e-10;

/// A face: its first skin point in the plane, its piece and index in space.
using FaceKey = std::int64_t;
constexpr FaceKey face_key(int piece, int face) {
  return static_cast<FaceKey>(piece) << 16 | face;
}

/// A part of a face that is closed by another one.
template <int D>
struct ClosedPart;
template <>
struct ClosedPart<2> {
  FaceKey face;
  double from, to;  ///< relative positions on the face, from its first point [1]
};
template <>
struct ClosedPart<3> {
  FaceKey face;
  int first, count;  ///< a polygon: its rows of ClosedJoints::corner
};

/// Two faces with intact mortar. `halves`: in the plane, bit h for the half h of the shared length along face a.
struct BondedFaces {
  FaceKey a, b;
  unsigned halves;
};

/// Closed parts at one instant, sorted by face.
template <int D>
struct ClosedJoints {
  std::vector<ClosedPart<D>> parts;
  std::vector<Vec<D>> corner;       ///< in space: corners of the parts [m]
  std::vector<BondedFaces> bonded;  ///< sorted by a, then b
  std::vector<std::uint8_t> wet;    ///< [body] scratch: 1: water reaches it

  void clear() { parts.clear(), corner.clear(), bonded.clear(), wet.clear(); }
  [[nodiscard]] std::span<const ClosedPart<D>> of(FaceKey face) const {
    const auto below = [](const ClosedPart<D>& p, FaceKey f) { return p.face < f; };
    const auto begin = std::lower_bound(parts.begin(), parts.end(), face, below);
    const auto end = std::lower_bound(begin, parts.end(), face + 1, below);
    return {begin, end};
  }
  /// Bonded halves of two faces, in the order of a.
  [[nodiscard]] unsigned bonds(FaceKey a, FaceKey b) const {
    for (const BondedFaces& pair : bonded) {
      if (pair.a == a && pair.b == b) return pair.halves;
      if (pair.a == b && pair.b == a) return (pair.halves & 1U) << 1 | pair.halves >> 1;
    }
    return 0;
  }
};

}  // namespace trilith
