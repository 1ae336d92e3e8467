// Makes solids from surfaces as files store them: merges corners, separates shells, orients faces outwards, and merges
// coplanar triangles. Time grows as the number of faces times its logarithm.
#pragma once

#include <span>
#include <vector>

#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// For each index of `faces.corner`, where an edge begins, the index where the neighbouring face begins the same edge;
/// -1 if there is no face. Where an edge has more than two faces, such as two solids that touch along it, consecutive
/// faces of the list are paired.
std::vector<int> edges_across(const FaceLoops& faces);

/// Merges corners nearer to each other than `within` [m] into the first one; faces left with two corners are removed.
/// Every remaining corner belongs to a face.
Polyhedron with_joined_corners(const Polyhedron& surface, double within);

/// The connected shell of each face, and the faces to be reversed so that each shell is consistently oriented with a
/// volume above 0.
struct Shells {
  int count = 0;
  std::vector<int> of;      ///< [faces]
  std::vector<char> turn;   ///< [faces] 1: to be reversed
  std::vector<char> whole;  ///< [shells] 1: closed and orientable
};
Shells shells_of(const Polyhedron& surface, std::span<const int> across);

/// One solid for each shell, its faces oriented as `shells` states.
std::vector<Polyhedron> solids_of(const Polyhedron& surface, const Shells& shells);

/// Merges neighbouring faces of a closed solid that are coplanar within `flat` times its size, the largest first, and
/// removes corners that belong to fewer than three faces afterwards. Groups that would give a face with holes stay
/// unmerged.
Polyhedron with_joined_faces(const Polyhedron& solid, double flat);

/// Neighbouring faces that extend outside of each other's planes. A closed solid without any is convex.
struct HollowEdge {
  double out = 0;  ///< largest height of a face's corner outside of the neighbouring face's plane [m]
  double by = 0;   ///< depth of the deepest dent [m]: the smaller height of the two faces over each other's planes,
                   ///< because the plane of a narrow face is uncertain where corners are rounded
  Vec3 at = Vec3::Zero();  ///< position of the dent, or of `out` [m]
};
HollowEdge hollow_edge(const Polyhedron& solid, std::span<const int> across);

}  // namespace trilith
