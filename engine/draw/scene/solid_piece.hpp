// Convex pieces of solids as they are made for a picture: cut by planes, with what of their faces is to be seen.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "base/space.hpp"

namespace trilith::draw {

/// All points p with normal . p = offset. `normal` is of length 1.
struct CutPlane {
  Vec3 normal = Vec3::UnitX();
  double offset = 0;  ///< m
  [[nodiscard]] double above(const Vec3& p) const { return normal.dot(p) - offset; }
};

/// What a face is: part of the solid's skin; the section that a cut shows; or a border between two pieces of one solid,
/// which is never seen.
enum class FaceKind { skin, section, border };

/// A plane polygon with 3 corners or more; convex, or the section of a skin of any shape. `is_edge[i]`: the side from
/// corner i to the next is an edge of the solid, and not only where it was divided.
struct PieceFace {
  std::vector<Vec3> corners;
  std::vector<bool> is_edge;
  Vec3 normal = Vec3::Zero();  ///< outwards, of length 1
  FaceKind kind = FaceKind::skin;
};

/// A body or a part of it: convex, the skin of a solid of any shape, or one face that is seen.
struct SolidPiece {
  int body = 0;
  std::vector<PieceFace> faces;
  std::vector<Vec3> borders = {};  ///< normals of borders that have no face
};

/// What lies below and what lies above a plane, each with a face of `kind` where it was cut; nullopt where nothing is.
/// What lies in the plane within `slack` [m] counts to neither.
std::pair<std::optional<SolidPiece>, std::optional<SolidPiece>> divided(const SolidPiece& piece, const CutPlane& plane,
                                                                        double slack, FaceKind kind);

/// A solid as convex pieces: itself where it is convex, else cut along the planes of faces that have a part of it above
/// them. `slack` [m]: what rounding may leave above a face.
std::vector<SolidPiece> convex_pieces(SolidPiece solid, double slack);

/// True where nothing of a piece lies above the plane of a face of it by more than `slack` [m].
bool is_convex(const SolidPiece& piece, double slack);

/// Diagonal of the box around a piece [m].
double piece_size(const SolidPiece& piece);

}  // namespace trilith::draw
