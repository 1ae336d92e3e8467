#include "geometry/space/sphere.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/portable.hpp"
#include "geometry/least_size.hpp"
#include "geometry/space/polyhedron.hpp"

namespace trilith {
namespace {

// Moments of overlapping spheres, from horizontal sections. A section is a union of discs, whose moments follow from
// its rim by Green's theorem. The sections are integrated by Gauss quadrature between the heights where a sphere, or
// the intersection circle of two spheres, begins or ends; areas are smooth in between.
//
//        __                    __
//       /  \__     section    /  \_
//      |   |  |    of two:   |  (  |   the rim is an arc of each disc
//       \__/\_/               \__/

/// Gauss quadrature with 16 points: the positive points in -1 to 1, and their weights.
constexpr std::array<double, 8> gauss_point{0.0950125098376374, 0.2816035507792589, 0.4580167776572274,
                                            0.6178762444026438, 0.7554044083550030, 0.8656312023878318,
                                            0.9445750230732326, 0.9894009349916499};
constexpr std::array<double, 8> gauss_weight{0.1894506104550685, 0.1826034150449236, 0.1691565193950025,
                                             0.1495959888165767, 0.1246289712555339, 0.0951585116824928,
                                             0.0622535239386479, 0.0271524594117541};

/// Calls f(place, weight) for the points of the quadrature between two ends.
template <class F>
void for_gauss_points(double from, double to, F&& f) {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  for (std::size_t i = 0; i < gauss_point.size(); ++i) {
    f(middle - half * gauss_point[i], half * gauss_weight[i]);
    f(middle + half * gauss_point[i], half * gauss_weight[i]);
  }
}

/// Area of a plane figure and the integrals of x, y, xx, xy, yy over it.
struct PlaneMoments {
  double area = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

struct Disc {
  double x, y, radius;
};

/// Green's theorem along the arc from `from` to `to` [rad]; the whole circle where they differ by 2 pi.
void add_arc(const Disc& d, double from, double to, PlaneMoments& out) {
  for_gauss_points(from, to, [&](double angle, double weight) {
    const portable::SineCosine at = portable::sine_cosine(angle);
    const double x = d.x + d.radius * at.cosine, y = d.y + d.radius * at.sine;
    const double dx = -d.radius * at.sine * weight, dy = d.radius * at.cosine * weight;
    out.area += 0.5 * (x * dy - y * dx);
    out.x += 0.5 * x * x * dy, out.y -= 0.5 * y * y * dx;
    out.xx += x * x * x * dy / 3, out.xy += 0.5 * x * x * y * dy, out.yy -= y * y * y * dx / 3;
  });
}

using Arc = std::pair<double, double>;

/// The arcs of disc i's circle that other discs cover, between 0 and 2 pi; true where they cover all of it.
bool covered_arcs(const std::vector<Disc>& discs, std::size_t i, std::vector<Arc>& arcs) {
  constexpr double turn = 2 * std::numbers::pi;
  const Disc& own = discs[i];
  arcs.clear();
  for (std::size_t j = 0; j < discs.size(); ++j) {
    if (j == i) continue;
    const Disc& by = discs[j];
    const double dx = by.x - own.x, dy = by.y - own.y, apart = std::sqrt(dx * dx + dy * dy);
    if (apart >= own.radius + by.radius || own.radius > apart + by.radius) continue;
    const bool same = apart == 0 && own.radius == by.radius;
    if (same ? j < i : by.radius >= apart + own.radius) return true;
    if (same || own.radius >= apart + by.radius) continue;
    // Half the covered angle, by the law of cosines.
    const double cosine = (apart * apart + own.radius * own.radius - by.radius * by.radius) / (2 * apart * own.radius);
    const double half = portable::acos(std::clamp(cosine, -1.0, 1.0));
    double from = portable::atan2(dy, dx) - half;
    if (from < 0) from += turn;
    arcs.emplace_back(from, std::min(from + 2 * half, turn));
    if (from + 2 * half > turn) arcs.emplace_back(0, from + 2 * half - turn);
  }
  std::sort(arcs.begin(), arcs.end());
  return false;
}

/// Moments of the union of discs, from the uncovered arcs of each disc.
PlaneMoments union_of_discs(const std::vector<Disc>& discs, std::vector<Arc>& arcs) {
  PlaneMoments out;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (covered_arcs(discs, i, arcs)) continue;
    double open = 0;
    for (const auto& [from, to] : arcs) {
      if (from > open) add_arc(discs[i], open, from, out);
      open = std::max(open, to);
    }
    if (open < 2 * std::numbers::pi) add_arc(discs[i], open, 2 * std::numbers::pi, out);
  }
  return out;
}

/// Sums over a body: volume, first moments, second moments.
struct BodyMoments {
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< integral of r r^T

  // A whole sphere: volume 4/3 pi r^3; second moment along each axis about its centre: r^2/5 of the volume.
  void add(const Sphere& s) {
    const double v = 4.0 / 3 * std::numbers::pi * s.radius * s.radius * s.radius;
    volume += v, first += v * s.centre;
    second += v * (s.centre * s.centre.transpose() + 0.2 * s.radius * s.radius * Eigen::Matrix3d::Identity());
  }
  void add_slice(const PlaneMoments& m, double z, double weight) {
    volume += weight * m.area, first += weight * Vec3(m.x, m.y, z * m.area);
    const double zx = z * m.x, zy = z * m.y, zz = z * z * m.area;
    Eigen::Matrix3d slice;
    slice << m.xx, m.xy, zx, m.xy, m.yy, zy, zx, zy, zz;
    second += weight * slice;
  }
};

/// Heights at which a sphere, or the intersection circle of two, begins or ends.
std::vector<double> heights_of(const std::vector<Sphere>& spheres) {
  std::vector<double> at;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const Sphere& a = spheres[i];
    at.push_back(a.centre.z() - a.radius), at.push_back(a.centre.z() + a.radius);
    for (std::size_t j = 0; j < i; ++j) {
      const Sphere& b = spheres[j];
      const Vec3 way = b.centre - a.centre;
      const double apart = way.norm();
      if (!(apart < a.radius + b.radius) || !(apart > std::abs(a.radius - b.radius))) continue;
      // The intersection circle of both lies in a plane `along` from the centre of a and has the radius `ring`.
      const double along = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2 * apart);
      const double ring = std::sqrt(std::max(0.0, a.radius * a.radius - along * along));
      const double steep = way.z() / apart, up = ring * std::sqrt(std::max(0.0, 1 - steep * steep));
      at.push_back(a.centre.z() + along * steep - up), at.push_back(a.centre.z() + along * steep + up);
    }
  }
  std::sort(at.begin(), at.end());
  return at;
}

/// Between two heights the quadrature points are concentrated at both ends, where areas vary with the square root of
/// the distance.
void add_slices(const std::vector<Sphere>& spheres, BodyMoments& out) {
  const std::vector<double> height = heights_of(spheres);
  std::vector<Disc> discs;
  std::vector<Arc> arcs;
  for (std::size_t k = 0; k + 1 < height.size(); ++k) {
    const double tall = height[k + 1] - height[k];
    if (!(tall > 0)) continue;
    for_gauss_points(0, 1, [&](double t, double weight) {
      const double z = height[k] + tall * t * t * (3 - 2 * t);
      discs.clear();
      for (const Sphere& s : spheres) {
        const double square = s.radius * s.radius - (z - s.centre.z()) * (z - s.centre.z());
        if (square > 0) discs.push_back({s.centre.x(), s.centre.y(), std::sqrt(square)});
      }
      out.add_slice(union_of_discs(discs, arcs), z, weight * tall * 6 * t * (1 - t));
    });
  }
}

bool share_something(const std::vector<Sphere>& spheres) {
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if ((spheres[i].centre - spheres[j].centre).norm() < spheres[i].radius + spheres[j].radius) return true;
  return false;
}

}  // namespace

void check_sphere(const Sphere& sphere, std::string_view owner) {
  if (!(sphere.radius > 0))
    throw InputError(fmt::format("{}: radius is {:g} m, must be above 0; try 0.05", owner, sphere.radius));
  if (!(sphere.radius >= kLeastSize) || !(sphere.radius <= 1e12))
    throw InputError(
        fmt::format("{}: radius is {:g} m, must be from {:g} to 1e12 m; try 0.05", owner, sphere.radius, kLeastSize));
  if (!(sphere.centre.cwiseAbs().array() <= 1e12).all())
    throw InputError(fmt::format("{}: centre ({:g}, {:g}, {:g}) is not finite or beyond 1e12 m", owner,
                                 sphere.centre.x(), sphere.centre.y(), sphere.centre.z()));
}

/// About the first centre, so that a body far from the origin loses no digits; then about its own centroid.
SolidMoments sphere_moments(std::span<const Sphere> spheres) {
  const Vec3 origin = spheres[0].centre;
  std::vector<Sphere> near(spheres.begin(), spheres.end());
  for (Sphere& s : near) s.centre -= origin;
  BodyMoments sum;
  if (share_something(near))
    add_slices(near, sum);
  else
    for (const Sphere& s : near) sum.add(s);
  const Vec3 middle = sum.first / sum.volume;
  const Eigen::Matrix3d about = sum.second - sum.volume * middle * middle.transpose();
  return {sum.volume, origin + middle, about.trace() * Eigen::Matrix3d::Identity() - about};
}

}  // namespace trilith
