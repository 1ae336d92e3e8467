#include "step/near_faces.hpp"

#include <algorithm>

#include "step/face_columns.hpp"

namespace trilith {
namespace {

/// Makes the last rows of a list good to be read by fours.
void pad(std::vector<int>& rows, std::size_t count) {
  if (count == 0) return;
  for (std::size_t i = 0; i + 1 < lane_count; ++i) rows[count + i] = rows[count - 1];
}

/// True where the line along one of the two faces keeps the two pieces apart, for certain: both ends of the other face
/// lie beyond it, and no corner next to them can reach back. What does not touch now remembers nothing and does
/// nothing.
TRILITH_INLINE LaneMask clearly_apart(const SkinMotion<2>* skin, const NearPair* const* p) {
  const Lanes slack = Lanes{} + 1e-12;  // of the face's length, far above the rounding of positions
  Lanes ax0, ay0, ax1, ay1, bx0, by0, bx1, by1;
  load_ends(skin, p, &NearPair::a0, &SkinMotion<2>::x, ax0, ay0);
  load_ends(skin, p, &NearPair::a1, &SkinMotion<2>::x, ax1, ay1);
  load_ends(skin, p, &NearPair::b0, &SkinMotion<2>::x, bx0, by0);
  load_ends(skin, p, &NearPair::b1, &SkinMotion<2>::x, bx1, by1);
  const Lanes corner{p[0]->corner, p[1]->corner, p[2]->corner, p[3]->corner};
  const Lanes ax = ax1 - ax0, ay = ay1 - ay0, bx = bx1 - bx0, by = by1 - by0;
  const Lanes x0 = bx0 - ax0, y0 = by0 - ay0, x1 = bx1 - ax0, y1 = by1 - ay0;
  const Lanes cosine = ax * bx + ay * by, sine = ax * by - ay * bx;
  // Height of b's ends over a's face, and of a's ends over b's, times its length.
  const Lanes over_a = smaller(ay * x0 - ax * y0, ay * x1 - ax * y1);
  const Lanes over_b = smaller(bx * y0 - by * x0, bx * y0 - by * x0 + sine);
  // With `corner` at most 1 the surface edges next to a face turn away by 45 degrees or more, so at a tilt below
  // atan(1/2) they do not lead back over the line.
  const LaneMask parallel = (corner <= 1.0 + Lanes{}) & (magnitude(sine) < -0.5 * cosine);
  return parallel & ((over_a > slack * (ax * ax + ay * ay)) | (over_b > slack * (bx * bx + by * by)));
}

/// Of the first `count` of a padded list keeps those that are not clearly apart, in their order.
[[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]] std::size_t keep_near(const SkinMotion<2>* skin,
                                                                                  const NearPair* pairs, int* rows,
                                                                                  std::size_t count) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; i += lane_count) {
    const int four[lane_count] = {rows[i], rows[i + 1], rows[i + 2], rows[i + 3]};
    const NearPair* const p[lane_count] = {&pairs[four[0]], &pairs[four[1]], &pairs[four[2]], &pairs[four[3]]};
    const LaneMask apart = clearly_apart(skin, p);
    for (int lane = 0; lane < lane_count; ++lane) {
      rows[kept] = four[lane];
      kept += i + static_cast<std::size_t>(lane) < count && apart[lane] == 0 ? 1 : 0;
    }
  }
  return kept;
}

}  // namespace

/// Rows that touched, or keep something, go first and are always worked on; of the rest only what may touch now. Both
/// in their order. What comes out is padded to be read by fours.
std::size_t sort_out(const ContactHistory& before, const Work<2>& work, const std::vector<int>& facing,
                     std::vector<int>& rows, std::vector<int>& fresh) {
  rows.resize(facing.size() + lane_count);
  fresh.resize(facing.size() + lane_count);
  std::size_t touched = 0, rest = 0;
  for (const int row : facing) {  // without branches: which rows touch is hard to guess
    const bool was = (before.memory[row].state & (contact_touching | contact_kept)) != 0;
    rows[touched] = fresh[rest] = row;
    touched += was ? 1 : 0;
    rest += was ? 0 : 1;
  }
  pad(fresh, rest);
  const std::size_t near = keep_near(work.skin.data(), work.pairs.data(), fresh.data(), rest);
  std::copy_n(fresh.begin(), near, rows.begin() + static_cast<std::ptrdiff_t>(touched));
  pad(rows, touched + near);
  return touched + near;
}

}  // namespace trilith
