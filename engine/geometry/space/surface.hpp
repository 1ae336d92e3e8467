// Surfaces as files have them, made solids of: corners joined, shells told apart, faces turned outwards, triangles in
// one plane made one face. All of it in a time that goes with the number of faces, times its logarithm.
#pragma once

#include <span>
#include <vector>

#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// For each place of `faces.corner`, where an edge begins, the place where the same edge begins on the face beside it;
/// -1: no face is there. Where more than two faces have an edge, as of two solids that touch along it, those that
/// follow each other in the list belong together.
std::vector<int> edges_across(const FaceLoops& faces);

/// Corners nearer to each other than `within` [m] become the first of them; faces that lose all but two corners go.
/// Every corner that is left belongs to a face.
Polyhedron with_joined_corners(const Polyhedron& surface, double within);

/// Which connected shell each face belongs to, and which must be read the other way round so that all of a shell agree
/// and it has a volume above 0.
struct Shells {
  int count = 0;
  std::vector<int> of;      ///< [faces]
  std::vector<char> turn;   ///< [faces] 1: read it the other way round
  std::vector<char> whole;  ///< [shells] 1: closed, with an inside and an outside
};
Shells shells_of(const Polyhedron& surface, std::span<const int> across);

/// One solid of each shell, its faces turned as `shells` says.
std::vector<Polyhedron> solids_of(const Polyhedron& surface, const Shells& shells);

/// A closed solid with those neighbouring faces made one that lie in a plane to within `flat` times its size, the
/// largest first, and corners left out that fewer than three faces are left with. Faces with holes are left as they
/// were.
Polyhedron with_joined_faces(const Polyhedron& solid, double flat);

/// Where faces beside each other stand out of each other's planes. A closed solid where none does is convex.
struct HollowEdge {
  double out = 0;  ///< most by which a corner of a face stands out of the plane of the face beside it, m
  double by = 0;   ///< depth of the deepest dent, m: the lesser of what two faces stand out of each other's planes, for
                   ///< the plane of a narrow face says little where corners are rounded
  Vec3 at = Vec3::Zero();  ///< of the dent, or where `out` is
};
HollowEdge hollow_edge(const Polyhedron& solid, std::span<const int> across);

}  // namespace trilith
