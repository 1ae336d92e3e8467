// Triangles of the pressed faces of two solids on their way into lanes (contact/pressed_triangles.hpp).
//
// Comes in: corners with their depths, and how the two move against each other, v + w x r at the arm r. Goes out: the
// sums. A corner closes in along its face's normal n, out of the solid, at c = -s n . (v + w x r), s = 1 where the face
// is a's; the damped pressure d + beta c acts where it is above 0.
#pragma once

#include <array>

#include "contact/pressed_triangles.hpp"

namespace trilith {

/// How b moves against a.
struct ClosingMotion {
  Vec3 velocity, spin;  ///< at the origin of arms [m/s], [rad/s]
};

/// Triangles wait until there are four, each by the arms of its corners with the depth as a fourth number.
class TriangleLanes {
 public:
  TRILITH_INLINE TriangleLanes(double beta, const ClosingMotion& motion) : triangles_(beta), beta_(beta) {
    const Vec3 &v = motion.velocity, &w = motion.spin;
    velocity_ = four_of(v, v, v, v), spin_ = four_of(w, w, w, w);
  }

  /// `face`: the normal out of the solid whose face is pressed, and the way in which that pushes b.
  TRILITH_INLINE void add(const Lanes& face, const Lanes& p, const Lanes& q, const Lanes& r) {
    const auto i = static_cast<std::size_t>(count_);
    face_[i] = face, corner_[0][i] = p, corner_[1][i] = q, corner_[2][i] = r;
    if (++count_ == lane_count) flush();
  }

  TRILITH_INLINE PressedSums sums() {
    if (count_ > 0) {
      for (auto i = static_cast<std::size_t>(count_); i < lane_count; ++i) {
        face_[i] = face_[0];
        for (auto& corner : corner_) corner[i] = corner[0];  // a triangle without area
        for (std::size_t k = 1; k < 3; ++k) corner_[k][i] = corner_[0][0];
      }
      flush();
    }
    return triangles_.sums();
  }

 private:
  using Four = PressedTriangles::Four;

  TRILITH_INLINE static void turn(const std::array<Lanes, lane_count>& rows, Triple<Lanes>& xyz, Lanes& last) {
    const Lanes &a = rows[0], &b = rows[1], &c = rows[2], &d = rows[3];
    const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7),
                cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    xyz.x = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
    xyz.z = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
    xyz.y = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
    last = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
  }

  /// Springs and area of all four, and the damping where it leaves the pressure above 0 in all corners. Of those where
  /// it does in some, the part where it does is added by itself.
  TRILITH_INLINE void flush() {
    const int count = count_;
    count_ = 0;
    Four four;
    turn(face_, four.normal, four.sign);
    const Lanes one = Lanes{} + 1.0, zero{};
    const Triple<Lanes> turning = cross(four.normal, spin_);
    const Lanes moving = four.normal.dot(velocity_);
    LaneMask some{}, all = ~LaneMask{};
    for (std::size_t k = 0; k < 3; ++k) {
      turn(corner_[k], four.arm[k], four.depth[k]);
      four.closing[k] = -four.sign * (moving + four.arm[k].dot(turning));
      const Lanes damped = four.depth[k] + beta_ * four.closing[k];
      some |= damped > 0.0, all &= damped >= 0.0;
    }
    four.springs = one, four.damped = select(all, one, zero);
    triangles_.add_four(four);
    const LaneMask mixed = some & ~all;
    if (any(mixed))
      for (int i = 0; i < count; ++i)
        if (mixed[i] != 0) add_pressed_part(four, i);
  }

  /// The part of a triangle where the damped pressure is above 0.
  [[gnu::noinline]] void add_pressed_part(const Four& four, int lane) {
    struct Corner {
      Vec3 arm;
      double depth, closing, damped;
    };
    std::array<Corner, 3> of;
    for (std::size_t k = 0; k < 3; ++k) {
      const double depth = four.depth[k][lane], closing = four.closing[k][lane];
      of[k] = {lane_of(four.arm[k], lane), depth, closing, depth + beta_ * closing};
    }
    std::array<Corner, 4> kept;
    std::size_t n = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &p = of[k], &q = of[k == 2 ? 0 : k + 1];
      if (p.damped >= 0) kept[n++] = p;
      if ((p.damped > 0 && q.damped < 0) || (p.damped < 0 && q.damped > 0)) {
        const double t = p.damped / (p.damped - q.damped);
        kept[n++] = {p.arm + t * (q.arm - p.arm), p.depth + t * (q.depth - p.depth),
                     p.closing + t * (q.closing - p.closing), 0};
      }
    }
    const auto corner = [&](std::size_t i) -> TriangleCorner { return {kept[i].arm, kept[i].depth, kept[i].closing}; };
    for (std::size_t i = 2; i < n; ++i)
      triangles_.add(lane_of(four.normal, lane), four.sign[lane], TriangleShare::damped,
                     {corner(0), corner(i - 1), corner(i)});
  }

  PressedTriangles triangles_;
  double beta_;
  Triple<Lanes> velocity_, spin_;
  int count_ = 0;
  std::array<Lanes, lane_count> face_;
  std::array<std::array<Lanes, lane_count>, 3> corner_;
};

}  // namespace trilith
