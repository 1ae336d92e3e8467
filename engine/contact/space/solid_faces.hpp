// Two solids in flat contact at one pair of faces: pressure proportional to the overlap over the true polygon.
//
// This is the limit of contact/space/solid_pressure.hpp for parallel faces and a thin overlap, at a tenth of the cost.
// The choice of method depends on the pose alone. The stress is kn c over the part of the shared polygon where the
// overlap c is positive (geometry/space/face_overlap_3d.hpp); with damping kn (c + beta dc/dt), never negative.
#pragma once

#include <array>
#include <cstdint>

#include "contact/space/solid_pressure.hpp"
#include "geometry/space/face_overlap_3d.hpp"

namespace trilith {

/// Limits of flat contact, as in the plane (law/contact/face_overlap.hpp).
inline constexpr double flat_faces_max_tilt = 0.005;   ///< angle between the faces [rad]
inline constexpr double flat_faces_max_depth = 0.005;  ///< overlap over the width of the shared polygon [1]
/// Below this cosine two outward normals oppose each other within the tilt limit.
inline constexpr double opposed_enough = -(1 - 0.5 * flat_faces_max_tilt * flat_faces_max_tilt);

/// Number of corners of a brick's face.
inline constexpr int few_corners = 4;

/// The only pair of faces of two solids that may lie flat on each other, if any, and the motion for which no other pair
/// may. The pair depends on the pose alone; it is cached to save the search.
struct FacePair {
  static constexpr int none = -1, several = -2;
  int a = several, b = several;
  double until = -1;  ///< valid while the corners of both have moved by no more than this in total (measured as
                      ///< SolidWork::way) [m]
  // Data of two faces that their kernel needs repeatedly, contiguous in memory.
  double near = 0;  ///< see near_faces [m]
  /// If `few`: corner indices in their solid, the last one repeated.
  std::array<std::uint8_t, few_corners> corner_a{}, corner_b{};
  int node_a = -1, node_b = -1;  ///< nodes that move the solids, for the caller
  std::int32_t kind = 0;         ///< last kind, see FlatResponses: affects no result
  bool few = false;              ///< at most few_corners each
  bool b_is_larger = false;      ///< see near_faces
};

/// `way`: total distance that the corners of both have moved so far [m].
FacePair facing_pair(const PlacedSolid& a, const PlacedSolid& b, double way);

/// Condition for two faces that may lie flat: a corner of the smaller solid's face is within this distance of the other
/// plane [m]. The shared polygon lies within the smaller face, so this is twice the sum of both limits times its
/// size.
inline double near_faces(const PlacedSolid& a, const PlacedSolid& b) {
  const double size = a.solid->size < b.solid->size ? a.solid->size : b.solid->size;
  return 4 * flat_faces_max_tilt * size;
}

/// True where two solids touch flatly at one pair of surface faces and no other; fills `out`. Also for pieces of meshes
/// where only their coplanar neighbours touch: then the polygon in `out` is empty.
bool flat_faces(const PlacedSolid& a, const PlacedSolid& b, FaceOverlap3& out);

/// True where two faces, pressed or not, oppose each other at a gap or an overlap of at most `reach` [m] and share an
/// area at least `width` wide [m]. Among several pairs the largest shared area counts. Fills `out`.
bool meeting_faces(const PlacedSolid& a, const PlacedSolid& b, double reach, double width, FaceOverlap3& out);

/// Pressure of flat faces under a linear law.
SolidPressure face_pressure(const MovingSolid& a, const MovingSolid& b, const PlainFriction& law,
                            const FaceOverlap3& faces);

/// Elastic energy of that pressure [J].
double face_energy(const PlainFriction& law, const FaceOverlap3& faces);

/// Whether the law's pressure is proportional to the overlap alone, which the face method requires.
bool is_linear(const ContactLaw& law);

}  // namespace trilith
