#include "contact/plane/edge_lanes.hpp"

#include "contact/plane/overlap_press.hpp"

namespace trilith {
namespace {

/// Edges of a piece with four corners, the most frequent number: one per lane.
TRILITH_INLINE void place_four_edges(const Vec2* corner, EdgeRow* row) {
  const auto two = [&](int first) TRILITH_INLINE_LAMBDA {
    const LanePair low = load_pair(corner[first].data()), high = load_pair(corner[first + 1].data());
    return Lanes(__builtin_shufflevector(low, high, 0, 1, 2, 3));
  };
  const auto next = [](const Lanes& v)
                        TRILITH_INLINE_LAMBDA { return Lanes(__builtin_shufflevector(v, v, 1, 2, 3, 0)); };
  const Lanes first = two(0), last = two(2);
  const Lanes x = __builtin_shufflevector(first, last, 0, 2, 4, 6),
              y = __builtin_shufflevector(first, last, 1, 3, 5, 7);
  const Lanes along_x = next(x) - x, along_y = next(y) - y;
  const Lanes length = root(along_x * along_x + along_y * along_y);
  const FourByFour rows(x, y, along_y / length, -along_x / length);
  for (int e = 0; e < lane_count; ++e) __builtin_memcpy(&row[e], &rows.v[e], sizeof rows.v[e]);
}

}  // namespace

/// Edges of a convex piece, four at once: start and unit outward normal (the edge rotated to the right, because corners
/// are counter-clockwise).
[[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]] void place_edges(std::span<const Vec2> corner,
                                                                             EdgeRow* row) {
  const int count = static_cast<int>(corner.size());
  if (count == lane_count) return place_four_edges(corner.data(), row);
  for (int from = 0; from < count; from += lane_count, row += lane_count) {
    Lanes along_x, along_y;
    for (int lane = 0; lane < lane_count; ++lane) {
      const int e = from + lane < count ? from + lane : 0, w = e + 1 < count ? e + 1 : 0;
      const LanePair at = load_pair(corner[e].data()), along = load_pair(corner[w].data()) - at;
      store_pair(&row[lane].x, at);
      along_x[lane] = along[0], along_y[lane] = along[1];
    }
    const Lanes length = root(along_x * along_x + along_y * along_y);
    const Lanes nx = along_y / length, ny = -along_x / length;
    for (int lane = 0; lane < lane_count; ++lane) store_pair(&row[lane].nx, LanePair{nx[lane], ny[lane]});
  }
}

}  // namespace trilith
