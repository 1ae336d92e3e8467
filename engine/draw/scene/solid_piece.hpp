// Convex pieces of polyhedra for pictures: cut by planes, with the visible parts of their faces.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "base/space.hpp"

namespace trilith::draw {

/// All points p with normal . p = offset. `normal` is a unit vector.
struct CutPlane {
  Vec3 normal = Vec3::UnitX();
  double offset = 0;  ///< m
  [[nodiscard]] double above(const Vec3& p) const { return normal.dot(p) - offset; }
};

/// Kind of a face: part of the solid's skin, the section of a cut, or a border between two pieces of one solid, which
/// is never visible.
enum class FaceKind { skin, section, border };

/// A plane polygon with 3 corners or more; convex, or the section of a skin of any shape. `is_edge[i]`: the side from
/// corner i to the next is an edge of the solid, not only of a division.
struct PieceFace {
  std::vector<Vec3> corners;
  std::vector<bool> is_edge;
  Vec3 normal = Vec3::Zero();  ///< outward unit normal
  FaceKind kind = FaceKind::skin;
  std::optional<double> value = std::nullopt;  ///< see SceneFace
};

/// A body or a part of it: convex, the skin of a solid of any shape, or one visible face.
struct SolidPiece {
  int body = 0;
  std::vector<PieceFace> faces;
  std::vector<Vec3> borders = {};  ///< normals of borders without a face
};

/// The parts below and above a plane, each with a face of `kind` at the cut; none for an empty part. Parts within
/// `slack` [m] of the plane belong to neither.
std::pair<std::optional<SolidPiece>, std::optional<SolidPiece>> divided(const SolidPiece& piece, const CutPlane& plane,
                                                                        double slack, FaceKind kind);

/// A solid as convex pieces: itself if it is convex, otherwise cut along the planes of faces with a part of it above
/// them. `slack` [m]: rounding error above a face.
std::vector<SolidPiece> convex_pieces(SolidPiece solid, double slack);

/// True if no part of a piece lies above the plane of one of its faces by more than `slack` [m].
bool is_convex(const SolidPiece& piece, double slack);

/// Diagonal of the AABB of a piece [m].
double piece_size(const SolidPiece& piece);

}  // namespace trilith::draw
