// The edges of a placed convex piece for the general contact: one by one, and in groups of four lanes.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "base/simd/lane_rows.hpp"
#include "base/space.hpp"

namespace trilith {

inline constexpr int max_piece_corners = 64;

/// One edge: its start corner [m] and its unit outward normal [1]. It ends where the next one begins.
struct alignas(32) EdgeRow {
  double x, y, nx, ny;
};

/// The start corners of four edges and their unit outward normals, in lanes.
struct alignas(32) EdgeLanes {
  Lanes x, y, nx, ny;

  TRILITH_INLINE EdgeLanes(const EdgeRow& e0, const EdgeRow& e1, const EdgeRow& e2, const EdgeRow& e3) {
    const FourByFour rows(load_lanes(&e0.x), load_lanes(&e1.x), load_lanes(&e2.x), load_lanes(&e3.x));
    x = rows.v[0], y = rows.v[1], nx = rows.v[2], ny = rows.v[3];
  }
  /// From contiguous edges.
  TRILITH_INLINE explicit EdgeLanes(const EdgeRow* first) : EdgeLanes(first[0], first[1], first[2], first[3]) {}
  TRILITH_INLINE explicit EdgeLanes(const EdgeRow* const* e) : EdgeLanes(*e[0], *e[1], *e[2], *e[3]) {}
};

/// Number of groups of four for this many edges.
constexpr int edge_blocks(int edges) {
  return (edges + lane_count - 1) / lane_count;
}

/// The edges of a piece, and which of them carry pressure.
struct PieceSides {
  const EdgeRow* row = nullptr;  ///< [edge_blocks(edges) * lane_count]; nullptr: not placed yet
  std::uint64_t surface = 0;     ///< bit e: edge e is part of the body's surface
};

/// Bit e: edge e counts as surface. A piece cut out of the interior of a body has no surface edge: then every edge
/// counts.
inline std::uint64_t surface_bits(std::span<const std::uint8_t> is_face) {
  std::uint64_t bits = 0;
  for (std::size_t e = 0; e < is_face.size(); ++e) bits |= std::uint64_t{is_face[e] != 0 ? 1U : 0U} << e;
  return bits != 0 || is_face.empty() ? bits : ~std::uint64_t{0} >> (64 - is_face.size());
}

/// Writes the edges of a piece to `row`, edge_blocks(corner.size()) groups of four. The normal is the edge rotated by
/// -90 degrees over its length. Unused entries repeat the first edge, so that a condition on all edges holds for all
/// lanes.
void place_edges(std::span<const Vec2> corner, EdgeRow* row);

/// Least distance of the points outside of an edge [m]; 0 where a point is inside.
inline double distance_outside(const EdgeRow& edge, std::span<const Vec2> points) {
  double deepest = -std::numeric_limits<double>::infinity();
  for (const Vec2& p : points) deepest = larger(deepest, edge.nx * (edge.x - p.x()) + edge.ny * (edge.y - p.y()));
  return deepest <= 0 ? larger(-deepest, std::numeric_limits<double>::min()) : 0.0;
}

}  // namespace trilith
