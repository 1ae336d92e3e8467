// The edges of a convex piece where it stands, as the general contact reads them: four by four, and one by one.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "base/lanes.hpp"
#include "base/space.hpp"

namespace trilith {

inline constexpr int max_piece_corners = 64;

/// Four edges of a piece, a lane each: the corner each begins at [m] and its unit outward normal [1]. Lanes beyond the
/// last edge repeat the first one, so that what holds for all edges holds for all lanes.
struct alignas(32) EdgeLanes {
  Lanes x, y, nx, ny;
};

/// One edge: the corner it begins at [m] and its unit outward normal [1]. It ends where the next one begins.
struct alignas(32) EdgeRow {
  double x, y, nx, ny;
};

/// How many fours hold so many edges.
constexpr int edge_blocks(int edges) {
  return (edges + lane_count - 1) / lane_count;
}

/// Where the edges of a piece are and which of them press. The pointers are nullptr where nobody has placed them yet.
struct PieceSides {
  const EdgeLanes* four = nullptr;  ///< [edge_blocks(edges)]
  const EdgeRow* row = nullptr;     ///< [edge_blocks(edges) * lane_count]
  std::uint64_t surface = 0;        ///< bit e: edge e is part of the body's surface
};

/// Bit e: edge e counts as surface. A piece cut out of the inside of a body has none of its own: then every edge
/// pushes back.
inline std::uint64_t surface_bits(std::span<const std::uint8_t> is_face) {
  std::uint64_t bits = 0;
  for (std::size_t e = 0; e < is_face.size(); ++e) bits |= std::uint64_t{is_face[e] != 0 ? 1U : 0U} << e;
  return bits != 0 || is_face.empty() ? bits : ~std::uint64_t{0} >> (64 - is_face.size());
}

/// Writes the edges of a piece to `four` and `row`, edge_blocks(corner.size()) fours of them.
/// The normal is the edge turned by -90 degrees over its length.
void place_edges(std::span<const Vec2> corner, EdgeLanes* four, EdgeRow* row);

/// How far all these points lie outside of an edge at least [m]; 0 where one of them does not.
inline double distance_outside(const EdgeRow& edge, std::span<const Vec2> points) {
  double deepest = -std::numeric_limits<double>::infinity();
  for (const Vec2& p : points) deepest = larger(deepest, edge.nx * (edge.x - p.x()) + edge.ny * (edge.y - p.y()));
  return deepest <= 0 ? larger(-deepest, std::numeric_limits<double>::min()) : 0.0;
}

}  // namespace trilith
