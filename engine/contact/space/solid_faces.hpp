// Two solids that lie on each other by one pair of faces: pressure in proportion to the overlap over the true polygon.
//
// The form that contact/space/solid_pressure.hpp tends to where faces are parallel and the overlap is thin, for a tenth
// of the work. Which form holds is a function of the pose alone. The stress is kn c over the part of the shared polygon
// where the overlap c is above 0 (geometry/space/face_overlap_3d.hpp); with damping kn (c + beta dc/dt), never below 0.
#pragma once

#include <array>
#include <cstdint>

#include "contact/space/solid_pressure.hpp"
#include "geometry/space/face_overlap_3d.hpp"

namespace trilith {

/// Limits of what counts as lying flat on each other, as in the plane (law/contact/face_overlap.hpp).
inline constexpr double flat_faces_max_tilt = 0.005;   ///< of the faces against each other [rad]
inline constexpr double flat_faces_max_depth = 0.005;  ///< overlap over the width of the shared polygon [1]
/// Below this cosine two outward normals look at each other within the tilt.
inline constexpr double opposed_enough = -(1 - 0.5 * flat_faces_max_tilt * flat_faces_max_tilt);

/// Most corners of the faces of a brick.
inline constexpr int few_corners = 4;

/// The one pair of faces of two solids that may lie flat on each other, if there is one, and for how long no other pair
/// may. Which pair it is follows from the pose; it is kept to save the search.
struct FacePair {
  static constexpr int none = -1, several = -2;
  int a = several, b = several;
  double until = -1;  ///< while corners of both have gone no further than this together (as SolidWork::way counts) [m]
  // Of two faces what their kernel asks again and again, next to each other in memory.
  double near = 0;  ///< see near_faces [m]
  /// Where `few`: which of their solid's corners they have, the last again.
  std::array<std::uint8_t, few_corners> corner_a{}, corner_b{};
  int node_a = -1, node_b = -1;  ///< what their solids go with, for who asks for them
  std::int32_t kind = 0;         ///< of what kind they were last, see FlatResponses: a result asks nothing of it
  bool few = false;              ///< no more than few_corners each
  bool b_is_larger = false;      ///< see near_faces
};

/// `way`: how far corners of both have gone together up to now [m].
FacePair facing_pair(const PlacedSolid& a, const PlacedSolid& b, double way);

/// Of a pair of faces that may lie flat: a corner of the smaller solid's is this near to the plane of the other [m].
/// What they share lies within the smaller one's, so twice what tilt and depth come to over its size.
inline double near_faces(const PlacedSolid& a, const PlacedSolid& b) {
  const double size = a.solid->size < b.solid->size ? a.solid->size : b.solid->size;
  return 4 * flat_faces_max_tilt * size;
}

/// True where two solids touch flatly by one pair of surface faces and no other; fills `out`. Of pieces of meshes whose
/// surface goes on in line also where only their neighbours do: then `out` shares nothing.
bool flat_faces(const PlacedSolid& a, const PlacedSolid& b, FaceOverlap3& out);

/// True where two faces look at each other at a gap or an overlap of at most `reach` [m] and share an area at least
/// `width` wide [m], be they pressed or not; of several pairs the one that shares the most area. Fills `out`.
bool meeting_faces(const PlacedSolid& a, const PlacedSolid& b, double reach, double width, FaceOverlap3& out);

/// Pressure of flat faces under a law that is linear.
SolidPressure face_pressure(const MovingSolid& a, const MovingSolid& b, const PlainFriction& law,
                            const FaceOverlap3& faces);

/// Elastic energy of that pressure [J].
double face_energy(const PlainFriction& law, const FaceOverlap3& faces);

/// Whether the law's pressure goes with the overlap, and nothing beside, which the form of faces asks for.
bool is_linear(const ContactLaw& law);

}  // namespace trilith
