// The edges of a convex piece where it stands, as the general contact reads them: one by one, and four by four.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "base/simd/lane_rows.hpp"
#include "base/space.hpp"

namespace trilith {

inline constexpr int max_piece_corners = 64;

/// One edge: the corner it begins at [m] and its unit outward normal [1]. It ends where the next one begins.
struct alignas(32) EdgeRow {
  double x, y, nx, ny;
};

/// The corners that four edges begin at and their unit outward normals, a lane each.
struct alignas(32) EdgeLanes {
  Lanes x, y, nx, ny;

  TRILITH_INLINE EdgeLanes(const EdgeRow& e0, const EdgeRow& e1, const EdgeRow& e2, const EdgeRow& e3) {
    const FourByFour rows(load_lanes(&e0.x), load_lanes(&e1.x), load_lanes(&e2.x), load_lanes(&e3.x));
    x = rows.v[0], y = rows.v[1], nx = rows.v[2], ny = rows.v[3];
  }
  /// Of edges side by side.
  TRILITH_INLINE explicit EdgeLanes(const EdgeRow* first) : EdgeLanes(first[0], first[1], first[2], first[3]) {}
  TRILITH_INLINE explicit EdgeLanes(const EdgeRow* const* e) : EdgeLanes(*e[0], *e[1], *e[2], *e[3]) {}
};

/// How many fours hold so many edges.
constexpr int edge_blocks(int edges) {
  return (edges + lane_count - 1) / lane_count;
}

/// Where the edges of a piece are and which of them press.
struct PieceSides {
  const EdgeRow* row = nullptr;  ///< [edge_blocks(edges) * lane_count]; nullptr: nobody has placed them yet
  std::uint64_t surface = 0;     ///< bit e: edge e is part of the body's surface
};

/// Bit e: edge e counts as surface. A piece cut out of the inside of a body has none of its own: then every edge
/// pushes back.
inline std::uint64_t surface_bits(std::span<const std::uint8_t> is_face) {
  std::uint64_t bits = 0;
  for (std::size_t e = 0; e < is_face.size(); ++e) bits |= std::uint64_t{is_face[e] != 0 ? 1U : 0U} << e;
  return bits != 0 || is_face.empty() ? bits : ~std::uint64_t{0} >> (64 - is_face.size());
}

/// Writes the edges of a piece to `row`, edge_blocks(corner.size()) fours of them. The normal is the edge turned by -90
/// degrees over its length. Beyond the last edge the first is repeated, so that what holds for all edges holds for all
/// lanes.
void place_edges(std::span<const Vec2> corner, EdgeRow* row);

/// How far all these points lie outside of an edge at least [m]; 0 where one of them does not.
inline double distance_outside(const EdgeRow& edge, std::span<const Vec2> points) {
  double deepest = -std::numeric_limits<double>::infinity();
  for (const Vec2& p : points) deepest = larger(deepest, edge.nx * (edge.x - p.x()) + edge.ny * (edge.y - p.y()));
  return deepest <= 0 ? larger(-deepest, std::numeric_limits<double>::min()) : 0.0;
}

}  // namespace trilith
