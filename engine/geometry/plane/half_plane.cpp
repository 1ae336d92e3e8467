#include "geometry/plane/half_plane.hpp"

#include <algorithm>

namespace trilith {
namespace {

/// A section of the outline inside the half-plane, between two crossings of the line.
struct Chain {
  Polygon points;
  double in = 0, out = 0;  ///< positions along the line where it enters and leaves
  bool used = false;
};

/// Intersection of the edge from a to b with the line.
Vec2 crossing(const Vec2& a, double da, const Vec2& b, double db) {
  return a + da / (da - db) * (b - a);
}

/// A concave outline may enter more than once, each time with a new chain:
///
///              .--.      .--.          inside: depth below 0
///      ======[ 1 ]======[ 2 ]=====     line; a chain enters at `in` and leaves at `out`, positions along it
///             |  `------'  |           outside
std::vector<Chain> chains_of(const Polygon& outline, const std::vector<double>& depth, const Vec2& along) {
  const std::size_t n = outline.size();
  std::vector<Chain> chains;
  std::size_t start = 0;  // start where the outline enters
  while (start < n && !(depth[start] >= 0 && depth[(start + 1) % n] < 0)) ++start;
  if (start == n) return chains;  // it never enters: all inside, all outside, or not finite
  for (std::size_t i = start; i < start + n; ++i) {
    const std::size_t a = i % n, b = (i + 1) % n;
    const bool a_inside = depth[a] < 0, b_inside = depth[b] < 0;
    if (!a_inside && b_inside) {
      const Vec2 p = crossing(outline[a], depth[a], outline[b], depth[b]);
      chains.push_back({{p}, along.dot(p)});
    }
    if (a_inside) chains.back().points.push_back(outline[a]);
    if (a_inside && !b_inside) {
      const Vec2 p = crossing(outline[a], depth[a], outline[b], depth[b]);
      chains.back().points.push_back(p), chains.back().out = along.dot(p);
    }
  }
  return chains;
}

/// Index of the chain that follows chain `from` along the line. Sorted along the line, crossings 0 and 1 bound the
/// first section inside, 2 and 3 the next. A piece continues from the point where its chain leaves, along such a
/// section, to the point where another chain enters.
std::size_t follower(const std::vector<Chain>& chains, std::size_t from) {
  struct Crossing {
    double at;
    std::size_t chain;
    bool enters;
  };
  std::vector<Crossing> all;
  for (std::size_t i = 0; i < chains.size(); ++i)
    all.push_back({chains[i].in, i, true}), all.push_back({chains[i].out, i, false});
  std::stable_sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
  for (std::size_t i = 0; i + 1 < all.size(); i += 2)
    for (const auto& [one, other] : {std::pair(all[i], all[i + 1]), std::pair(all[i + 1], all[i])})
      if (!one.enters && one.chain == from && other.enters) return other.chain;
  return from;  // coincident crossings: close the chain on itself
}

}  // namespace

Polygon without_doubles(const Polygon& outline, double same) {
  Polygon kept;
  for (const Vec2& p : outline)
    if (kept.empty() || (p - kept.back()).norm() > same) kept.push_back(p);
  while (kept.size() > 1 && (kept.back() - kept.front()).norm() <= same) kept.pop_back();
  if (kept.size() < 3) kept.clear();
  return kept;
}

std::vector<Polygon> cut_by(const Polygon& outline, const HalfPlane& half_plane, double same) {
  const Vec2 normal = half_plane.normal.normalized();
  const double offset = half_plane.offset / half_plane.normal.norm();
  std::vector<double> depth;
  for (const Vec2& p : outline) depth.push_back(normal.dot(p) - offset);
  if (std::none_of(depth.begin(), depth.end(), [](double d) { return d > 0; })) return {outline};
  if (std::none_of(depth.begin(), depth.end(), [](double d) { return d < 0; })) return {};

  std::vector<Chain> chains = chains_of(outline, depth, left_of(normal));
  std::vector<Polygon> pieces;
  for (std::size_t first = 0; first < chains.size(); ++first) {
    Polygon piece;
    // Around one piece: chain after chain, until the next chain is already used.
    for (std::size_t i = first; !chains[i].used; i = follower(chains, i)) {
      chains[i].used = true;
      piece.insert(piece.end(), chains[i].points.begin(), chains[i].points.end());
    }
    piece = without_doubles(piece, same);
    if (!piece.empty() && signed_area(piece) > same * same) pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace trilith
