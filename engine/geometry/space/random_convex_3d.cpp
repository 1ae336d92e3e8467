#include "geometry/space/random_convex_3d.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/space/convex_hull.hpp"

namespace trilith {

/// Rejection sampling: uniform in the volume, and the same on every machine.
Vec3 random_in_ball(std::mt19937_64& bits) {
  while (true) {
    const double x = random_between(bits, -1, 1), y = random_between(bits, -1, 1), z = random_between(bits, -1, 1);
    const Vec3 p(x, y, z);
    if (const double square = p.squaredNorm(); square < 1 && square > 1e-6) return p;
  }
}

// A point of the ball in four dimensions, projected to its surface.
UnitQuaternion random_rotation(std::mt19937_64& bits) {
  while (true) {
    const double w = random_between(bits, -1, 1), x = random_between(bits, -1, 1);
    const double y = random_between(bits, -1, 1), z = random_between(bits, -1, 1);
    const double square = w * w + x * x + y * y + z * z;
    if (square > 1 || square < 1e-6) continue;
    const double scale = 1 / std::sqrt(square);
    return {scale * w, scale * x, scale * y, scale * z};
  }
}

namespace {

Polyhedron in_random_pose(std::mt19937_64& bits, const Polyhedron& solid) {
  const Vec3 centre = solid_moments(solid).centroid;
  return placed(placed(solid, {}, -centre), random_rotation(bits), Vec3::Zero());
}

/// Random directions, no two within `apart` of each other (as points of the unit sphere).
std::vector<Vec3> spread_directions(std::mt19937_64& bits, int count, double apart) {
  std::vector<Vec3> out;
  while (static_cast<int>(out.size()) < count) {
    const Vec3 p = random_in_ball(bits).normalized();
    if (std::all_of(out.begin(), out.end(), [&](const Vec3& q) { return (p - q).norm() > apart; })) out.push_back(p);
  }
  return out;
}

/// Flatter samples of the unit sphere are rejected [m3].
constexpr double least_of_sphere = 0.1;

}  // namespace

/// The hull of points on a sphere, stretched to an ellipsoid and rotated.
Polyhedron random_convex_solid(std::mt19937_64& bits, const RandomSolid& wanted) {
  const int n = random_count(bits, wanted.fewest_corners, wanted.most_corners);
  const double size = random_between(bits, wanted.smallest, wanted.largest) / 2;
  const double second = random_between(bits, 1, wanted.slenderest), third = random_between(bits, 1, wanted.slenderest);
  while (true) {
    const auto directions = spread_directions(bits, n, 1 / std::sqrt(static_cast<double>(n)));
    Polyhedron solid = convex_hull(directions, "random solid");
    if (solid_moments(solid).volume < least_of_sphere) continue;
    for (Vec3& p : solid.corners) p = size * Vec3(p.x(), p.y() / second, p.z() / third);
    return in_random_pose(bits, solid);
  }
}

Polyhedron random_prism(std::mt19937_64& bits, double low, double high, const RandomConvex& wanted) {
  const Polygon outline = random_convex(bits, wanted);
  return in_random_pose(bits, prism(outline, 0, random_between(bits, low, high)));
}

}  // namespace trilith
