#include "model/flatness.hpp"

#include <algorithm>
#include <cmath>

#include "base/portable.hpp"

namespace trilith {
namespace {

/// Counter-clockwise angle from one direction to another [rad].
double turn_between(const Vec2& in, const Vec2& out) {
  return portable::atan2(cross(in, out), in.dot(out));
}

/// cot(turn) below 45 degrees, 1 above: length along a face per unit of depth at a shallow corner.
double flatness_of(double turn) {
  return turn > 0.25 * M_PI ? 1.0 : 1.0 / portable::tan(std::max(turn, kStraightAngle));
}

}  // namespace

/// Drops corners between two collinear edges that are both skin or both inner, so that a face divided by the
/// decomposition is one again. Then each edge gets the flatter one of its two corners, where its neighbour there is a
/// face.
PieceEdges piece_edges(const Polygon& outline, const ConvexPiece& piece) {
  const std::size_t count = piece.corners.size();
  const auto point = [&](std::size_t c) -> const Vec2& { return outline[piece.corners[c % count]]; };
  const auto turn_at = [&](std::size_t c) {
    return turn_between(point(c) - point(c + count - 1), point(c + 1) - point(c));
  };
  PieceEdges edges;
  for (std::size_t c = 0; c < count; ++c) {
    const bool face_before = piece.faces[(c + count - 1) % count] >= 0, face = piece.faces[c] >= 0;
    if (std::abs(turn_at(c)) < kStraightAngle && face_before == face) continue;
    edges.corner.push_back(piece.corners[c]);
    edges.is_face.push_back(face ? 1 : 0);
  }
  const std::size_t kept = edges.corner.size();
  for (std::size_t c = 0; c < kept; ++c) {
    const auto at = [&](std::size_t k) -> const Vec2& { return outline[edges.corner[k % kept]]; };
    const Vec2 before = at(c) - at(c + kept - 1), along = at(c + 1) - at(c), after = at(c + 2) - at(c + 1);
    double flatness = 1;
    if (edges.is_face[(c + kept - 1) % kept] != 0)
      flatness = std::max(flatness, flatness_of(turn_between(before, along)));
    if (edges.is_face[(c + 1) % kept] != 0) flatness = std::max(flatness, flatness_of(turn_between(along, after)));
    edges.flatness.push_back(flatness);
  }
  return edges;
}

}  // namespace trilith
