#include "contact/edge_lanes.hpp"

namespace trilith {

/// Edges of a convex piece four at once: start, outward unit normal (the edge turned to the right, as corners run
/// counter-clockwise) and squared length. They are written twice, in columns for kernels that ask one point against
/// many edges, and in rows for those that take one edge after the other. Beyond the last edge the first is repeated.
[[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]] void place_edges(std::span<const Vec2> corner,
                                                                             EdgeLanes* four, EdgeRow* row) {
  const int count = static_cast<int>(corner.size());
  for (int from = 0; from < count; from += lane_count, ++four, row += lane_count) {
    EdgeLanes& out = *four;
    Lanes along_x, along_y;
    for (int lane = 0; lane < lane_count; ++lane) {
      const int e = from + lane < count ? from + lane : 0, w = e + 1 < count ? e + 1 : 0;
      const LanePair at = load_pair(corner[e].data()), along = load_pair(corner[w].data()) - at;
      store_pair(&row[lane].x, at);
      store_pair(&row[lane].along_x, along);
      out.x[lane] = at[0], out.y[lane] = at[1];
      along_x[lane] = along[0], along_y[lane] = along[1];
    }
    const Lanes length2 = along_x * along_x + along_y * along_y, length = root(length2);
    out.nx = along_y / length, out.ny = -along_x / length;
    for (int lane = 0; lane < lane_count; ++lane) {
      store_pair(&row[lane].nx, LanePair{out.nx[lane], out.ny[lane]});
      store_pair(&row[lane].length2, LanePair{length2[lane], 0});
    }
  }
}

}  // namespace trilith
