// Collects triangles of the shared solid's faces, with their depths below the other solid, into SIMD lanes.
//
// Input: corners as arms, with the depth as fourth number. Output: groups of four triangles, component by component.
// Aligned to 32 bytes because functions for wide registers read objects that narrow functions made; the compiler does
// not ensure this alignment itself.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/simd/four_by_four.hpp"
#include "base/simd/lane_vectors.hpp"

namespace trilith {

/// Four triangles, one in each lane; the depth is linear over each.
struct alignas(32) FourTriangles {
  std::array<Triple<Lanes>, 3> arm;  ///< of the corners, counter-clockwise about the normal [m]
  std::array<Lanes, 3> depth;        ///< at the corners [m]
  Triple<Lanes> normal;              ///< unit normal, out of the solid that owns the face
  Lanes sign;                        ///< direction along the normal in which the second solid is pushed, 1 or -1
};

/// Collects triangles until there are four; the buffer grows as needed.
class alignas(32) TriangleLanes {
 public:
  TRILITH_INLINE explicit TriangleLanes(std::vector<FourTriangles>& room) : room_(room) {}

  /// `face`: the normal and the sign; `p`, `q`, `r`: the corners with their depths.
  TRILITH_INLINE void add(const Lanes& face, const Lanes& p, const Lanes& q, const Lanes& r) {
    const auto i = static_cast<std::size_t>(count_);
    face_[i] = face, corner_[0][i] = p, corner_[1][i] = q, corner_[2][i] = r;
    if (++count_ == lane_count) flush();
  }

  /// All added triangles; unused lanes of the last group repeat its first triangle without area.
  TRILITH_INLINE std::span<const FourTriangles> all() {
    if (count_ > 0) {
      for (auto i = static_cast<std::size_t>(count_); i < lane_count; ++i) {
        face_[i] = face_[0];
        for (auto& corner : corner_) corner[i] = corner_[0][0];
      }
      flush();
    }
    return {room_.data(), fours_};
  }

 private:
  TRILITH_INLINE static void turn(const std::array<Lanes, lane_count>& rows, Triple<Lanes>& xyz, Lanes& last) {
    const FourByFour columns(rows[0], rows[1], rows[2], rows[3]);
    xyz.x = columns.v[0], xyz.y = columns.v[1], xyz.z = columns.v[2];
    last = columns.v[3];
  }
  TRILITH_INLINE void flush() {
    count_ = 0;
    if (fours_ == room_.size()) room_.resize(2 * fours_ + 8);
    FourTriangles& four = room_[fours_++];
    turn(face_, four.normal, four.sign);
    for (std::size_t k = 0; k < 3; ++k) turn(corner_[k], four.arm[k], four.depth[k]);
  }

  std::vector<FourTriangles>& room_;
  std::size_t fours_ = 0;
  int count_ = 0;
  std::array<Lanes, lane_count> face_;
  std::array<std::array<Lanes, lane_count>, 3> corner_;
};

}  // namespace trilith
