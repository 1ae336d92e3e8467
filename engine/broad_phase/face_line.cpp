#include "broad_phase/face_line.hpp"

#include <algorithm>
#include <cmath>

#include "base/portable.hpp"

namespace trilith {
namespace {

double distance(const SkinMotion<2>* skin, int p, int q) {
  return p == q ? 0 : portable::hypot(skin[q].x - skin[p].x, skin[q].y - skin[p].y);
}

}  // namespace

bool is_flat_in_line(const FaceLine& line, const SkinMotion<2>* skin, const NearPair& pair) {
  const SkinMotion<2>&a0 = skin[pair.a0], &a1 = skin[pair.a1], &b0 = skin[pair.b0], &b1 = skin[pair.b1];
  const FaceOverlap<double> o({a0.x, a0.y, a1.x, a1.y, 0, 0, 0, 0}, {b0.x, b0.y, b1.x, b1.y, 0, 0, 0, 0});
  const int before_a = line.before[pair.a0], after_a = line.after[pair.a1];
  const int before_b = line.before[pair.b0], after_b = line.after[pair.b1];
  const bool some = before_a != pair.a0 || after_a != pair.a1 || before_b != pair.b0 || after_b != pair.b1;
  const SkinMotion<2>&pa = skin[before_a], &na = skin[after_a], &pb = skin[before_b], &nb = skin[after_b];
  return are_flat_in_line<double>(
      o, {pa.x - a0.x, pa.y - a0.y, na.x - a1.x, na.y - a1.y, pb.x - b0.x, pb.y - b0.y, nb.x - b1.x, nb.y - b1.y, some},
      pair.corner);
}

double length_in_line(const FaceLine& line, const SkinMotion<2>* skin, int a0, int a1, int b0, int b1) {
  if (!line.is_there()) return 0;
  return distance(skin, line.before[a0], a0) + distance(skin, a1, line.after[a1]) +
         distance(skin, line.before[b0], b0) + distance(skin, b1, line.after[b1]);
}

}  // namespace trilith
