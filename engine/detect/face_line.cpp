#include "detect/face_line.hpp"

#include <algorithm>
#include <cmath>

#include "base/portable.hpp"

namespace trilith {
namespace {

/// How far the neighbour from skin point `end` to `next` reaches along the common direction of the faces [m]; 0 where
/// it is tilted too much, or there is none.
double reach(const FaceOverlap<double>& o, const SkinMotion<2>* skin, int end, int next) {
  const double x = skin[next].x - skin[end].x, y = skin[next].y - skin[end].y;
  const double along = o.dx * x + o.dy * y, across = o.dy * x - o.dx * y;
  return std::abs(across) < face_pair_max_tilt * std::abs(along) ? along : 0;
}

double distance(const SkinMotion<2>* skin, int p, int q) {
  return p == q ? 0 : portable::hypot(skin[q].x - skin[p].x, skin[q].y - skin[p].y);
}

}  // namespace

bool is_flat_in_line(const FaceLine& line, const SkinMotion<2>* skin, const NearPair& pair) {
  const SkinMotion<2>&a0 = skin[pair.a0], &a1 = skin[pair.a1], &b0 = skin[pair.b0], &b1 = skin[pair.b1];
  return is_flat_in_line(
      line, skin, pair,
      FaceOverlap<double>({a0.x, a0.y, a1.x, a1.y, 0, 0, 0, 0}, {b0.x, b0.y, b1.x, b1.y, 0, 0, 0, 0}));
}

bool is_flat_in_line(const FaceLine& line, const SkinMotion<2>* skin, const NearPair& pair,
                     const FaceOverlap<double>& o) {
  const int before_a = line.before[pair.a0], after_a = line.after[pair.a1];
  const int before_b = line.before[pair.b0], after_b = line.after[pair.b1];
  if (before_a == pair.a0 && after_a == pair.a1 && before_b == pair.b0 && after_b == pair.b1) return false;
  // They look at each other, and are nearly parallel.
  if (!(o.inv_a > 0 && o.inv_b > 0 && o.tilt < face_pair_max_tilt)) return false;
  const double end_a = 1 / o.inv_a, end_b = o.sb1 + 1 / o.inv_b;
  // Along d the ends of A go on to lower s before a.0 and to higher s after a.1; B runs against it.
  const double low = std::max(std::min(0.0, reach(o, skin, pair.a0, before_a)),
                              o.sb1 + std::min(0.0, reach(o, skin, pair.b1, after_b))),
               high = std::min(end_a + std::max(0.0, reach(o, skin, pair.a1, after_a)),
                               end_b + std::max(0.0, reach(o, skin, pair.b0, before_b)));
  const double depth = -std::min(o.gap_lo, o.gap_hi);
  return high > low && depth * pair.corner <= (high - low) * face_pair_max_depth;
}

double length_in_line(const FaceLine& line, const SkinMotion<2>* skin, int a0, int a1, int b0, int b1) {
  if (!line.is_there()) return 0;
  return distance(skin, line.before[a0], a0) + distance(skin, a1, line.after[a1]) +
         distance(skin, line.before[b0], b0) + distance(skin, b1, line.after[b1]);
}

}  // namespace trilith
