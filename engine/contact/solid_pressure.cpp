#include "contact/solid_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace trilith {
namespace {

// Stages of one call: for each face of the shared solid, its rim as triangles about one of its points; for each
// triangle, the cells in which one face of the other solid is nearest; over each cell the pressure and its moments.

/// A point of a pressed face: where it is, how deep in the other solid, and how fast the two close there.
struct PressedPoint {
  Vec3 x;
  double depth, closing;  // [m], [m/s]
};

/// A convex polygon with room for a triangle cut by many planes.
struct PressedPolygon {
  static constexpr std::size_t most = 128;
  std::array<PressedPoint, most> corner;
  std::size_t count = 0;

  void add(const PressedPoint& p) {
    if (count < most) corner[count++] = p;
  }
  void take(const PressedPolygon& other) {
    std::copy_n(other.corner.begin(), other.count, corner.begin());
    count = other.count;
  }
};

PressedPoint between(const PressedPoint& p, const PressedPoint& q, double share) {
  return {p.x + share * (q.x - p.x), p.depth + share * (q.depth - p.depth),
          p.closing + share * (q.closing - p.closing)};
}

/// The part of a polygon where a function that is linear over it is not negative.
template <class Height>
void keep_above(const PressedPolygon& from, Height&& height, PressedPolygon& kept) {
  kept.count = 0;
  for (std::size_t i = 0; i < from.count; ++i) {
    const PressedPoint &p = from.corner[i], &q = from.corner[(i + 1) % from.count];
    const double hp = height(p), hq = height(q);
    if (hp >= 0) kept.add(p);
    if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) kept.add(between(p, q, hp / (hp - hq)));
  }
}

/// Integrals over a triangle, over kn: of the pressure and of its first moment about some point, of the pressure times
/// the closing speed.
struct TriangleSums {
  double force = 0, power = 0;
  Vec3 first = Vec3::Zero();
};

/// Of a pressure that is linear over the triangle; arms are from the point the moment is about.
void add_linear(double area, const std::array<double, 3>& p, const std::array<Vec3, 3>& arm,
                const std::array<double, 3>& closing, TriangleSums& sums) {
  const double sum = p[0] + p[1] + p[2], speed = closing[0] + closing[1] + closing[2], twelfth = area / 12;
  sums.force += 4 * twelfth * sum;
  sums.first += twelfth * (sum * (arm[0] + arm[1] + arm[2]) + p[0] * arm[0] + p[1] * arm[1] + p[2] * arm[2]);
  sums.power += twelfth * (sum * speed + p[0] * closing[0] + p[1] * closing[1] + p[2] * closing[2]);
}

/// Six points of a triangle, exact to degree 4 (Dunavant 1985, as in contact/power.hpp), for laws that are not linear.
template <class Pressure>
void add_sampled(double area, const std::array<PressedPoint, 3>& at, const std::array<Vec3, 3>& arm,
                 Pressure&& pressure, TriangleSums& sums) {
  constexpr std::array<std::array<double, 3>, 2> rule{{{0.108103018168070, 0.445948490915965, 0.223381589678011},
                                                       {0.816847572980459, 0.091576213509771, 0.109951743655322}}};
  for (const auto& [own, other, weight] : rule)
    for (const std::size_t i : {0U, 1U, 2U}) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const double closing = own * at[i].closing + other * (at[j].closing + at[k].closing);
      const double p = weight * area * pressure(own * at[i].depth + other * (at[j].depth + at[k].depth), closing);
      sums.force += p, sums.power += p * closing;
      sums.first += p * (own * arm[i] + other * (arm[j] + arm[k]));
    }
}

/// Calls visit(area, corners) for the triangles of a polygon about its first corner.
template <class Visit>
void for_triangles(const PressedPolygon& polygon, const Vec3& normal, Visit&& visit) {
  for (std::size_t i = 2; i < polygon.count; ++i) {
    const std::array<PressedPoint, 3> at{polygon.corner[0], polygon.corner[i - 1], polygon.corner[i]};
    visit(0.5 * normal.dot(cross(Vec3(at[1].x - at[0].x), Vec3(at[2].x - at[0].x))), at);
  }
}

/// Sums over all pressed faces. Moments are about `origin`, a point near the contact.
struct SolidSums {
  Vec3 origin;
  SolidPressure out;
  Vec3 arm_sum = Vec3::Zero();                       // integral of pressure times arm
  Vec3 area_arm = Vec3::Zero();                      // ... of the arm over the area, by halves as the area is
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // ... of its square
};

void add_area(double area, const std::array<Vec3, 3>& arm, SolidSums& sums) {
  const Vec3 sum = arm[0] + arm[1] + arm[2];
  sums.out.area += 0.5 * area;
  sums.area_arm += area / 6 * sum;
  sums.second +=
      area / 24 *
      (sum * sum.transpose() + arm[0] * arm[0].transpose() + arm[1] * arm[1].transpose() + arm[2] * arm[2].transpose());
}

/// A face of the walker inside the owner.
template <class K>
struct PressedFace {
  const K& law;
  Vec3 normal;  // out of the walker
  bool walker_is_b;

  /// Adds one cell, over which depth and closing speed are linear.
  void add_cell(const PressedPolygon& cell, SolidSums& sums) const {
    TriangleSums springs, total;
    for_triangles(cell, normal, [&](double area, const std::array<PressedPoint, 3>& at) {
      const std::array<Vec3, 3> arm{at[0].x - sums.origin, at[1].x - sums.origin, at[2].x - sums.origin};
      add_area(area, arm, sums);
      if constexpr (K::linear)
        add_linear(area, {at[0].depth, at[1].depth, at[2].depth}, arm, closings(at), springs);
      else {
        add_sampled(
            area, at, arm, [&](double d, double) { return law.effective(d); }, springs);
        add_sampled(
            area, at, arm, [&](double d, double c) { return std::max(0.0, law.effective(d) + law.beta * c); }, total);
      }
    });
    if constexpr (K::linear) {
      if (law.beta > 0)
        add_damped(cell, sums.origin, total);
      else
        total = springs;
    }
    for (std::size_t i = 0; i < cell.count; ++i) sums.out.depth = std::max(sums.out.depth, cell.corner[i].depth);
    add(springs, total, sums);
  }

 private:
  static std::array<double, 3> closings(const std::array<PressedPoint, 3>& at) {
    return {at[0].closing, at[1].closing, at[2].closing};
  }

  /// The pressure with its damping, where that is above 0.
  void add_damped(const PressedPolygon& cell, const Vec3& origin, TriangleSums& total) const {
    const auto pressure = [&](const PressedPoint& p) { return p.depth + law.beta * p.closing; };
    PressedPolygon pressed;
    keep_above(cell, pressure, pressed);
    for_triangles(pressed, normal, [&](double area, const std::array<PressedPoint, 3>& at) {
      add_linear(area, {pressure(at[0]), pressure(at[1]), pressure(at[2])},
                 {at[0].x - origin, at[1].x - origin, at[2].x - origin}, closings(at), total);
    });
  }

  /// k is half of kn, as the faces of the other solid bring the other half. On b acts -n where b walks, as n then
  /// points from b into a, and +n where a does.
  void add(const TriangleSums& springs, const TriangleSums& total, SolidSums& sums) const {
    const double k = 0.5 * law.kn, sign = walker_is_b ? -1 : 1;
    const Vec3 n = sign * k * normal;
    SolidPressure& out = sums.out;
    out.force += total.force * n, out.moment += cross(total.first, n);
    out.damping += (total.force - springs.force) * n;
    out.damping_moment += cross(Vec3(total.first - springs.first), n);
    out.damped += k * (total.power - springs.power);
    out.pressure += k * total.force, sums.arm_sum += k * total.first;
  }
};

/// Faces of the owner as seen from a triangle.
struct NearestFaces {
  std::array<int, 3> face{-1, -1, -1};                     // nearest to each corner
  std::array<double, 3> depth;                             // of each corner below it [m]
  double reach = std::numeric_limits<double>::infinity();  // a face that all of it is deeper below is nearest nowhere

  NearestFaces(const PlacedSolid& owner, const std::array<Vec3, 3>& at) {
    depth.fill(std::numeric_limits<double>::infinity());
    for (int f = 0; f < owner.solid->shape.faces.count(); ++f) {
      if (!owner.solid->is_surface(f)) continue;
      double deepest = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double d = depth_below(owner, f, at[i]);
        if (d < depth[i]) depth[i] = d, face[i] = f;
        deepest = std::max(deepest, d);
      }
      reach = std::min(reach, deepest);
    }
  }
  [[nodiscard]] bool is_one() const { return face[0] == face[1] && face[0] == face[2]; }
};

/// Faces that may be nearest to some point of a triangle: depths of its corners below them.
struct NearFaces {
  struct Row {
    int face;
    std::array<double, 3> depth;
  };
  static constexpr std::size_t most = 256;
  std::array<Row, most> row;
  std::size_t count = 0;

  NearFaces(const PlacedSolid& owner, const std::array<PressedPoint, 3>& at, double reach) {
    for (int f = 0; f < owner.solid->shape.faces.count() && count < most; ++f) {
      if (!owner.solid->is_surface(f)) continue;
      const Row r{f, {depth_below(owner, f, at[0].x), depth_below(owner, f, at[1].x), depth_below(owner, f, at[2].x)}};
      if (std::min({r.depth[0], r.depth[1], r.depth[2]}) <= reach && !has_first_like(owner, f)) row[count++] = r;
    }
  }
};

/// Presses one triangle of a face of the walker against the owner's nearest faces. Where one face is nearest to all
/// three corners it is so to all of the triangle, as depths are linear.
template <class K>
void press_triangle(const PlacedSolid& owner, const PressedFace<K>& face, std::array<PressedPoint, 3> at,
                    SolidSums& sums) {
  const NearestFaces nearest(owner, {at[0].x, at[1].x, at[2].x});
  if (nearest.face[0] < 0) return;  // a piece without a surface presses nothing
  PressedPolygon cell, cut_cell;
  if (nearest.is_one()) {
    for (std::size_t i = 0; i < 3; ++i) {
      at[i].depth = std::max(0.0, nearest.depth[i]);
      cell.add(at[i]);
    }
    return face.add_cell(cell, sums);
  }
  const NearFaces faces(owner, at, nearest.reach);
  for (std::size_t f = 0; f < faces.count; ++f) {
    cell.count = 0;
    for (std::size_t i = 0; i < 3; ++i) cell.add({at[i].x, std::max(0.0, faces.row[f].depth[i]), at[i].closing});
    for (std::size_t g = 0; g < faces.count && cell.count > 2; ++g) {
      if (g == f) continue;
      keep_above(
          cell, [&](const PressedPoint& p) { return depth_below(owner, faces.row[g].face, p.x) - p.depth; }, cut_cell);
      cell.take(cut_cell);
    }
    if (cell.count > 2) face.add_cell(cell, sums);
  }
}

/// One face of the shared solid: the edges `first` to `end` of its rim.
template <class K>
void press_face(const MovingSolid& owner, const MovingSolid& walker, const PressedFace<K>& face,
                const SolidOverlapBuffer& shared, int first, int end, SolidSums& sums) {
  const auto point_at = [&](int point) {
    const Vec3& x = shared.points[static_cast<std::size_t>(point)];
    return PressedPoint{x, 0, face.normal.dot(walker.velocity_at(x) - owner.velocity_at(x))};
  };
  const int base = shared.edges[static_cast<std::size_t>(first)].from;
  const PressedPoint about = point_at(base);
  for (int i = first; i < end; ++i) {
    const auto [from, to] = shared.edges[static_cast<std::size_t>(i)];
    if (from != base && to != base) press_triangle(owner.placed, face, {about, point_at(from), point_at(to)}, sums);
  }
}

/// Any line across n.
Vec3 line_across(const Vec3& n) {
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  return cross(n, Vec3(Vec3::Unit(least))).normalized();
}

/// Moves the moments to the centre of pressure and finds the mean distance from it.
SolidPressure finished(SolidSums& sums) {
  SolidPressure& out = sums.out;
  if (!(out.area > 0)) return {};
  const Vec3 middle = sums.area_arm / out.area;
  const Vec3 arm = out.pressure > 0 ? Vec3(sums.arm_sum / out.pressure) : middle;
  out.centre = sums.origin + arm, out.middle = sums.origin + middle;
  out.moment -= cross(arm, out.force), out.damping_moment -= cross(arm, out.damping);
  const Eigen::Matrix3d about = sums.second / out.area - middle * middle.transpose();
  // A plane area has one principal value of 0, so the sum of the products by twos is that of the other two.
  const double product = about(0, 0) * about(1, 1) + about(1, 1) * about(2, 2) + about(2, 2) * about(0, 0) -
                         about(0, 1) * about(0, 1) - about(1, 2) * about(1, 2) - about(2, 0) * about(2, 0);
  out.radius = turning_radius(about.trace(), product);
  const Vec3 n = out.force.squaredNorm() > 0 ? Vec3(out.force.normalized()) : Vec3(Vec3::UnitZ());
  const Vec3 x = line_across(n), y = cross(n, x);
  out.arm = spread_arms(x.dot(about * x), x.dot(about * y), y.dot(about * y), x, y);
  return out;
}

/// Which face of which solid a face of the shared one is.
const Vec3& normal_of(const PlacedSolid& a, const PlacedSolid& b, int of) {
  return of >= 0 ? a.normals[static_cast<std::size_t>(of)] : b.normals[static_cast<std::size_t>(-1 - of)];
}
bool on_surface(const PlacedSolid& a, const PlacedSolid& b, int of) {
  return of >= 0 ? a.solid->is_surface(of) : b.solid->is_surface(-1 - of);
}

template <class K>
SolidPressure press(const MovingSolid& a, const MovingSolid& b, const K& law, const SolidOverlapBuffer& shared) {
  SolidSums sums;
  sums.origin = shared.points[static_cast<std::size_t>(shared.edges[0].from)];
  int first = 0;
  for (const auto& [of, end] : shared.faces) {
    const bool of_b = of < 0;
    if (on_surface(a.placed, b.placed, of)) {
      const PressedFace<K> face{law, normal_of(a.placed, b.placed, of), of_b};
      press_face(of_b ? a : b, of_b ? b : a, face, shared, first, end, sums);
    }
    first = end;
  }
  return finished(sums);
}

}  // namespace

double turning_radius(double trace, double product) {
  if (!(trace > 0)) return 0;
  const double roundness = std::clamp(4 * product / (trace * trace), 0.0, 1.0);
  return std::sqrt(trace) * (0.8660 + 0.0725 * std::sqrt(roundness));
}

/// By Cholesky: a = (sqrt(xx), xy / sqrt(xx)), b = (0, the root of what is left).
std::array<Vec3, 2> spread_arms(double xx, double xy, double yy, const Vec3& x, const Vec3& y) {
  if (!(xx > 0)) return {Vec3(Vec3::Zero()), Vec3(std::sqrt(std::max(0.0, yy)) * y)};
  const double along = std::sqrt(xx), aside = xy / along;
  return {Vec3(along * x + aside * y), Vec3(std::sqrt(std::max(0.0, yy - aside * aside)) * y)};
}

SolidPressure solid_pressure(const MovingSolid& a, const MovingSolid& b, const LawInUse& law,
                             const SolidOverlapBuffer& shared) {
  if (shared.faces.empty()) return {};
  return with_kernel(law, [&](const auto& kernel) { return press(a, b, kernel, shared); });
}

}  // namespace trilith
