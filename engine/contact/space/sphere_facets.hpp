// A sphere in a convex polyhedron: pressure on the parts of the polyhedron's faces inside the sphere.
//
// Input: the sphere (centre c, radius R) and the placed polyhedron. On a face at the height h below c the part inside
// is the face's polygon within a disc about the foot of c, of radius a = sqrt(R^2 - h^2). A quantity p that depends on
// the distance m from c alone, m^2 = h^2 + rho^2, has a sum that is an integral around the foot.
//
//      integral of Q dtheta,   Q(rho) = integral of p rho drho = rho^2 mean(rho^2)
//
// Here rho follows the polygon's sides where they are inside the disc, and its rim elsewhere. The rim is the full
// circle minus the angles of the sides. Along a side at the distance q from the foot, dtheta = q dt / (q^2 + t^2), so
// the integrand mean(q^2 + t^2) q is smooth and Gauss quadrature applies. Output: the sums over all faces.
#pragma once

#include "base/portable.hpp"
#include "contact/space/sphere_lens.hpp"
#include "geometry/space/convex_solid.hpp"
#include "geometry/space/sphere_distance.hpp"

namespace trilith {

/// Sums over the faces inside a sphere.
struct SphereFacets {
  Vec3 pressed = Vec3::Zero();  ///< of p along the outward normals
  Vec3 area = Vec3::Zero();     ///< of the area along the outward normals [m2]
  double lever = 0;             ///< of p times the height of the centre
  double apart = -unbounded;    ///< largest height of the centre over a face, minus the radius [m]
};

/// p and 1 over a part of a face.
struct FaceSums {
  double pressed = 0, area = 0;
};

/// Over the part of a face in the disc of radius `rim` about `foot`; mean(rho^2) as above.
template <class Mean>
FaceSums face_in_disc(const PlacedSolid& solid, int face, const Vec3& foot, double rim, Mean&& mean) {
  const std::span<const int> loop = solid.solid->shape.faces[face];
  const Vec3& n = solid.normals[static_cast<std::size_t>(face)];
  const double square = rim * rim, rim_mean = square * mean(square);
  FaceSums out;
  bool inside = true;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3& from = solid.corners[static_cast<std::size_t>(loop[i])];
    const Vec3 side = solid.corners[static_cast<std::size_t>(loop[i + 1 < loop.size() ? i + 1 : 0])] - from;
    const Vec3 arm = from - foot;
    // Outwards in the plane: side x n. Most sides are far from the disc; the squares show this without a root.
    const double scaled = arm.dot(cross(side, n)) + 0.0, length2 = side.squaredNorm();
    if (scaled * scaled >= square * length2) {
      if (scaled < 0) return {};
      continue;
    }
    const double length = std::sqrt(length2), q = scaled / length, half = std::sqrt(square - q * q);
    inside = inside && q >= 0;
    const double begin = arm.dot(side) / length, t0 = std::max(begin, -half), t1 = std::min(begin + length, half);
    if (!(t0 < t1)) continue;
    double sum = 0;
    for (std::size_t k = 0; k < sphere_point.size(); ++k) {
      const double t = t0 + (t1 - t0) * sphere_point[k];
      sum += sphere_weight[k] * mean(q * q + t * t);
    }
    const double angle = portable::atan2(q * (t1 - t0), q * q + t0 * t1);
    out.pressed += (t1 - t0) * q * sum - rim_mean * angle;
    out.area += 0.5 * ((t1 - t0) * q - square * angle);
  }
  if (inside) out.pressed += 2 * std::numbers::pi * rim_mean, out.area += std::numbers::pi * square;
  return out;
}

/// Sums of `quantity` over all faces, including inner ones, which cancel between the pieces that share them.
/// quantity(height)(rho^2) is mean(rho^2) on a face at that height, not negative.
template <class Quantity>
SphereFacets facets_in_sphere(const PlacedSolid& solid, const Sphere& sphere, Quantity&& quantity) {
  SphereFacets out;
  const FaceLoops& faces = solid.solid->shape.faces;
  for (int f = 0; f < faces.count(); ++f)
    out.apart = std::max(out.apart, -depth_below(solid, f, sphere.centre) - sphere.radius);
  if (out.apart >= 0) return out;
  for (int f = 0; f < faces.count(); ++f) {
    const double height = -depth_below(solid, f, sphere.centre);
    const double square = sphere.radius * sphere.radius - height * height;
    if (!(square > 0)) continue;
    const Vec3& n = solid.normals[static_cast<std::size_t>(f)];
    const FaceSums sums =
        face_in_disc(solid, f, sphere.centre - height * n, std::sqrt(square), quantity(std::abs(height)));
    out.pressed += sums.pressed * n, out.area += sums.area * n;
    out.lever += sums.pressed * height;
  }
  return out;
}

/// Sums of max(e(phi) - relief, 0), phi = R - m [m3]; relief [m].
template <class K>
SphereFacets pressed_facets(const PlacedSolid& solid, const Sphere& sphere, const K& law, double relief) {
  if constexpr (K::linear) {
    const Sphere left{sphere.centre, sphere.radius - relief};
    if (!(left.radius > 0)) return {};
    return facets_in_sphere(solid, left, [&](double h) {
      return [h, radius = left.radius](double square) {
        const double m = std::sqrt(h * h + square), sum = m + h;
        return sum > 0 ? 0.5 * radius - (m * m + m * h + h * h) / (3 * sum) : 0.5 * radius;
      };
    });
  } else {
    // With m dm = (R - phi) dphi, Q is the decrease along the path of T(x), the integral of p (R - phi) from 0 to x.
    const double radius = sphere.radius;
    const auto pressure = [&](double depth) { return std::max(0.0, law.effective(depth) - relief); };
    const auto total = [&, radius](double x) {
      return x > 0 ? x * integral_to_rim([&](double share) {
                       const double depth = x * (1 - share);
                       return pressure(depth) * (radius - depth);
                     })
                   : 0.0;
    };
    return facets_in_sphere(solid, sphere, [&](double h) {
      return [&, h, foot = total(radius - h)](double square) {
        if (square < 1e-12 * radius * radius) return 0.5 * pressure(radius - h);
        return (foot - total(radius - std::sqrt(h * h + square))) / square;
      };
    });
  }
}

/// Work over kn to move the sphere from first contact to its position [m4], along the line through the nearest point of
/// the surface. The work is independent of the path, because the force derives from an energy.
template <class K>
double facets_energy(const PlacedSolid& solid, const Sphere& sphere, const K& law) {
  constexpr int stretches = 3;
  const Vec3 way = sphere.centre - nearest_point(solid, sphere.centre);
  double above = -unbounded;
  for (int f = 0; f < solid.solid->shape.faces.count(); ++f)
    above = std::max(above, -depth_below(solid, f, sphere.centre));
  const double distance = above > 0 ? way.norm() : -way.norm(), overlap = sphere.radius - distance;
  if (!(overlap > 0) || distance == 0) return 0;
  const Vec3 out = way / distance;
  double sum = 0;
  for (int i = 0; i < stretches; ++i)
    for (std::size_t k = 0; k < sphere_point.size(); ++k) {
      const Vec3 at = sphere.centre + (i + sphere_point[k]) * overlap / stretches * out;
      sum += sphere_weight[k] * out.dot(pressed_facets(solid, Sphere{at, sphere.radius}, law, 0).pressed);
    }
  return sum * overlap / stretches;
}

}  // namespace trilith
