// Spheres, and the measures of a union of spheres.
#pragma once

#include <span>
#include <string_view>

#include "base/space.hpp"

namespace trilith {

struct SolidMoments;

struct Sphere {
  Vec3 centre = Vec3::Zero();  ///< [m]
  double radius = 0;           ///< [m]
};

/// Throws InputError, which begins with `owner`, for a centre that is not finite or a radius that is not above 0.
void check_sphere(const Sphere& sphere, std::string_view owner);

/// Volume, centroid and inertia (density 1) of the union of at least one sphere; shared volume counts once.
///
/// Exact for one sphere and for spheres that share nothing. Otherwise horizontal sections are integrated over the
/// height. A section is a union of discs, whose area and moments are exact by Green's theorem along its bounding arcs.
/// Gauss quadrature is used between the heights at which a sphere, or the intersection circle of two spheres, begins or
/// ends. Relative errors: 1e-9 for two spheres, about 1e-6 for three and more that share a point.
SolidMoments sphere_moments(std::span<const Sphere> spheres);

}  // namespace trilith
