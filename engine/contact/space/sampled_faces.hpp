// Two solids in flat contact under a law whose pressure is not proportional to the overlap, such as a power of it.
//
// This is contact/space/solid_faces.hpp for such laws: the same polygon, choice of method and damping. The pressure
// kn (e(c) + beta dc/dt), never negative, and its moments are sampled over the part where the overlap c is positive.
// The polygon is cut into triangles, and a triangle is cut further where the overlap at its corners differs much: e may
// have a singularity where c = 0.
#pragma once

#include <vector>

#include "contact/space/solid_pressure.hpp"
#include "geometry/space/face_overlap_3d.hpp"
#include "geometry/space/triangle_lanes.hpp"

namespace trilith {

/// True for laws whose flat faces are sampled: nonlinear, without crushing.
bool has_sampled_faces(const ContactLaw& law);

/// Pressure of flat faces. `triangles`: scratch.
SolidPressure sampled_face_pressure(const MovingSolid& a, const MovingSolid& b, const LawInUse& law,
                                    const FaceOverlap3& faces, std::vector<FourTriangles>& triangles);

/// Elastic energy of that pressure: kn times the integral of the work to reach the overlap [J].
double sampled_face_energy(const LawInUse& law, const FaceOverlap3& faces, std::vector<FourTriangles>& triangles);

}  // namespace trilith
