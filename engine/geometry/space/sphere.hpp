// Spheres: what they are, and the measures of what several of them fill together.
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

/// Refuses a centre that is not finite and a radius that is not above 0, with an InputError that `owner` begins.
void check_sphere(const Sphere& sphere, std::string_view owner);

/// Volume, centroid and inertia (density 1) of the union of spheres: what several share counts once. At least one.
///
/// A sphere alone, and spheres that share nothing, are exact. Else level cuts through the union are summed up: each cut
/// is a union of discs, of which area and moments are exact, by Green's theorem along the arcs that bound it; over the
/// height Gauss's rule is taken between the heights at which a sphere or the circle that two of them share begins or
/// ends. Two spheres come out to 1e-9, three and more that share a point to some 1e-6.
SolidMoments sphere_moments(std::span<const Sphere> spheres);

}  // namespace trilith
