// Planes of bodies in space: their arrangements, sections, and the two parts of a convex solid.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "element/solid/space_mesh.hpp"
#include "geometry/space/polyhedron.hpp"
#include "model/crack_planes.hpp"

namespace trilith {

/// The planes of `spec` for a convex solid, in the order in which they are numbered. Arrangements of equal parts are
/// across its longest principal axis.
std::vector<CrackPlane<3>> crack_planes(const CrackSpec<3>& spec, const Polyhedron& solid);

/// The same for a body of elements, whose axes follow from the masses of its nodes.
std::vector<CrackPlane<3>> crack_planes(const CrackSpec<3>& spec, const SpaceMesh& mesh);

/// Centre, axes, corners and moments of a section whose normal is set, from its corners in the axes of the body. They
/// are plane and counter-clockwise about the normal.
void set_section_polygon(const std::vector<Vec3>& corners, CrackSection<3>& section);

/// The two parts of a convex solid, behind a plane and ahead of it; none where the plane misses it or touches it. The
/// last face of each part is its section.
std::optional<std::array<Polyhedron, 2>> parts_of(const Polyhedron& solid, const CrackPlane<3>& plane);

/// The section of a plane through a rigid body of this solid and mass [kg], in its axes about its centroid; none where
/// parts_of finds none. `axes`: rotate the axes of the world to the axes of the body at the start. `number`: of the
/// plane.
std::optional<CrackSection<3>> crack_section(const Polyhedron& solid, double mass, const UnitQuaternion& axes,
                                             const CrackPlane<3>& plane, int number);

/// The reason why a plane does not divide the body, as missed_plane_text in the plane.
std::string missed_plane_text(const Polyhedron& solid, const CrackPlane<3>& plane, int number);

}  // namespace trilith
