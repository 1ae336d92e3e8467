// Planes of rigid bodies in the plane: their arrangements, sections, and the outlines of the two parts.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/plane/polygon.hpp"
#include "model/crack_planes.hpp"

namespace trilith {

/// The planes of `spec` for a body of this outline, in the order in which they are numbered.
std::vector<CrackPlane<2>> crack_planes(const CrackSpec<2>& spec, const Polygon& outline);

/// The two parts of an outline, behind a plane and ahead of it; none where the plane misses the body, touches it in a
/// corner, or divides a concave outline into more than two parts.
std::optional<std::array<Polygon, 2>> parts_of(const Polygon& outline, const CrackPlane<2>& plane);

/// The outlines of both parts of a body, whose faces at the section are apart by `opening`. `centroid`: of its mass.
std::optional<std::array<Polygon, 2>> parted_outlines(const Polygon& outline, const Vec2& centroid,
                                                      const CrackSection<2>& section, const CrackOpening& opening);

/// The section of a plane through a rigid body of this outline and mass [kg] about its centroid; none where parts_of
/// finds none. `number`: of the plane.
std::optional<CrackSection<2>> crack_section(const Polygon& outline, double mass, const CrackPlane<2>& plane,
                                             int number);

/// "cracks: plane 2, through (0.1, 0.2) with the normal (1, 0), ..." : the reason why a plane does not divide the body.
std::string missed_plane_text(const Polygon& outline, const CrackPlane<2>& plane, int number);

}  // namespace trilith
