#include "geometry/plane/half_plane.hpp"

#include <algorithm>

namespace trilith {
namespace {

/// A stretch of the outline inside the half-plane, from a crossing of the line to the next one.
struct Chain {
  Polygon points;
  double in = 0, out = 0;  ///< where it enters and leaves, along the line
  bool used = false;
};

/// Where the edge from a to b crosses the line.
Vec2 crossing(const Vec2& a, double da, const Vec2& b, double db) {
  return a + da / (da - db) * (b - a);
}

/// A concave outline may come in more than once, each time a chain:
///
///              .--.      .--.          inside: depth below 0
///      ======[ 1 ]======[ 2 ]=====     line; a chain enters at `in` and leaves at `out`, places along it
///             |  `------'  |           outside
std::vector<Chain> chains_of(const Polygon& outline, const std::vector<double>& depth, const Vec2& along) {
  const std::size_t n = outline.size();
  std::vector<Chain> chains;
  std::size_t start = 0;  // begin where the outline enters
  while (start < n && !(depth[start] >= 0 && depth[(start + 1) % n] < 0)) ++start;
  if (start == n) return chains;  // it enters nowhere: all inside, all outside, or no numbers
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

/// Index of the chain that the line leads to from where chain `from` left. Crossings taken in order along the line
/// bound stretches of the inside in pairs.
/// Along the line inside and outside take turns: sorted crossings 0 and 1 bound the first stretch inside, 2 and 3 the
/// next. A piece goes from where its chain leaves along such a stretch to where another one enters.
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
  return from;  // crossings that coincide: close the chain on itself
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
    // Round one piece: chain after chain, until the line leads back to one that is used.
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
