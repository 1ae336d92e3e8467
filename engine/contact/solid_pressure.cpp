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
  static constexpr std::size_t most = 64;
  std::array<PressedPoint, most> corner;
  std::size_t count = 0;

  void add(const PressedPoint& p) {
    if (count < most) corner[count++] = p;
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

/// SolidSums over all pressed faces. Moments are about `origin`, a point near the contact.
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

/// The surface face of a solid that is nearest to a point inside, and how deep the point is below it.
struct NearestFace {
  int face = -1;
  double depth = std::numeric_limits<double>::infinity();
};

double depth_below(const PlacedSolid& solid, int face, const Vec3& x) {
  const auto f = static_cast<std::size_t>(face);
  return solid.normals[f].dot(solid.corners[static_cast<std::size_t>(solid.solid->shape.faces[face][0])] - x);
}

NearestFace nearest_face(const PlacedSolid& solid, const Vec3& x) {
  NearestFace best;
  for (int f = 0; f < solid.solid->shape.faces.count(); ++f) {
    if (!solid.solid->is_surface(f)) continue;
    const double depth = depth_below(solid, f, x);
    if (depth < best.depth) best = {f, depth};
  }
  return best;
}

/// Presses one triangle of a face of the walker against the owner's nearest faces. Where one face is nearest to all
/// three corners it is so to all of the triangle, as depths are linear.
template <class K>
void press_triangle(const MovingSolid& owner, const PressedFace<K>& face, const std::array<PressedPoint, 3>& at,
                    const std::array<int, 3>& nearest, SolidSums& sums) {
  PressedPolygon triangle;
  triangle.count = 3;
  std::copy(at.begin(), at.end(), triangle.corner.begin());
  if (nearest[0] == nearest[1] && nearest[0] == nearest[2]) return face.add_cell(triangle, sums);
  const PlacedSolid& solid = owner.placed;
  PressedPolygon cell, cut_cell;
  for (int f = 0; f < solid.solid->shape.faces.count(); ++f) {
    if (!solid.solid->is_surface(f)) continue;
    cell.count = 0;
    for (const PressedPoint& p : at) cell.add({p.x, depth_below(solid, f, p.x), p.closing});
    for (int g = 0; g < solid.solid->shape.faces.count() && cell.count > 2; ++g) {
      if (g == f || !solid.solid->is_surface(g)) continue;
      keep_above(
          cell, [&](const PressedPoint& p) { return depth_below(solid, g, p.x) - p.depth; }, cut_cell);
      std::swap(cell, cut_cell);
    }
    if (cell.count > 2) face.add_cell(cell, sums);
  }
}

/// One face of the shared solid: the edges `first` to `end` of its rim.
template <class K>
void press_face(const MovingSolid& owner, const MovingSolid& walker, const PressedFace<K>& face,
                const SolidOverlapBuffer& shared, int first, int end, SolidSums& sums) {
  const auto pressed_at = [&](int point, int& nearest) {
    const Vec3& x = shared.points[static_cast<std::size_t>(point)];
    const NearestFace below = nearest_face(owner.placed, x);
    nearest = below.face;
    const double closing = face.normal.dot(walker.velocity_at(x) - owner.velocity_at(x));
    return PressedPoint{x, std::max(0.0, below.depth), closing};
  };
  std::array<PressedPoint, 3> at{};
  std::array<int, 3> nearest{};
  const int base = shared.edges[static_cast<std::size_t>(first)].from;
  at[0] = pressed_at(base, nearest[0]);
  if (nearest[0] < 0) return;  // a piece without a surface presses nothing
  for (int i = first; i < end; ++i) {
    const auto [from, to] = shared.edges[static_cast<std::size_t>(i)];
    if (from == base || to == base) continue;
    at[1] = pressed_at(from, nearest[1]), at[2] = pressed_at(to, nearest[2]);
    press_triangle(owner, face, at, nearest, sums);
  }
}

/// Moves the moments to the centre of pressure and finds the mean distance from it.
SolidPressure finished(SolidSums& sums) {
  SolidPressure& out = sums.out;
  if (!(out.area > 0)) return {};
  const Vec3 middle = sums.area_arm / out.area;
  const Vec3 arm = out.pressure > 0 ? Vec3(sums.arm_sum / out.pressure) : middle;
  out.centre = sums.origin + arm;
  out.moment -= cross(arm, out.force), out.damping_moment -= cross(arm, out.damping);
  const Eigen::Matrix3d about = sums.second / out.area - middle * middle.transpose();
  // A plane area has one principal value of 0, so the sum of the products by twos is that of the other two.
  const double product = about(0, 0) * about(1, 1) + about(1, 1) * about(2, 2) + about(2, 2) * about(0, 0) -
                         about(0, 1) * about(0, 1) - about(1, 2) * about(1, 2) - about(2, 0) * about(2, 0);
  out.radius = turning_radius(about.trace(), product);
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

/// Integral of effective(depth) over a tetrahedron, from the depths at its corners, for laws that are not linear:
/// Gauss's points along each of three shares, the corner that they close in on taken into the weight.
template <class K>
double energy_of_tetrahedron(double volume, const std::array<double, 4>& depth, const K& law) {
  constexpr std::array<double, 4> point{0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                        0.93056815579702629};
  constexpr std::array<double, 4> weight{0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                         0.17392742256872693};
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) {
        const double u = point[i], v = (1 - u) * point[j], w = (1 - u) * (1 - point[j]) * point[k];
        const double at = (1 - u - v - w) * depth[0] + u * depth[1] + v * depth[2] + w * depth[3];
        sum += weight[i] * weight[j] * weight[k] * (1 - u) * (1 - u) * (1 - point[j]) * law.effective(at);
      }
  return 6 * volume * sum;
}

/// Over one cell, in which depths below face `f` of `owner` are linear.
template <class K>
double energy_of_cell(const PlacedSolid& owner, const K& law, int f, const SolidOverlapBuffer& cell) {
  if constexpr (K::linear) {
    const auto [volume, centroid] = measured(cell);
    return volume > 0 ? volume * std::max(0.0, depth_below(owner, f, centroid)) : 0;
  } else {
    const auto point = [&](int i) -> const Vec3& { return cell.points[static_cast<std::size_t>(i)]; };
    const auto depth = [&](int i) { return std::max(0.0, depth_below(owner, f, point(i))); };
    const int top = cell.edges[0].from;
    double sum = 0;
    int i = 0;
    for (const auto& face : cell.faces) {
      const int base = cell.edges[static_cast<std::size_t>(i)].from;
      for (; i < face.end; ++i) {
        const auto [from, to] = cell.edges[static_cast<std::size_t>(i)];
        const Vec3 twice = cross(Vec3(point(from) - point(base)), Vec3(point(to) - point(base)));
        sum += energy_of_tetrahedron(twice.dot(point(base) - point(top)) / 6,
                                     {depth(top), depth(base), depth(from), depth(to)}, law);
      }
    }
    return sum;
  }
}

/// Integral of e(phi) over the solid in `shared`, phi of `owner`, cell by cell.
template <class K>
double energy_in(const PlacedSolid& owner, const K& law, const SolidOverlapBuffer& shared, SolidOverlapBuffer& cell) {
  const FaceLoops& faces = owner.solid->shape.faces;
  const auto point_of = [&](int f) -> const Vec3& { return owner.corners[static_cast<std::size_t>(faces[f][0])]; };
  double sum = 0;
  for (int f = 0; f < faces.count(); ++f) {
    if (!owner.solid->is_surface(f)) continue;
    cell = shared;
    bool some = !cell.faces.empty();
    const Vec3& n = owner.normals[static_cast<std::size_t>(f)];
    for (int g = 0; g < faces.count() && some; ++g) {
      if (g == f || !owner.solid->is_surface(g)) continue;
      // depth below f at most that below g
      const Vec3& m = owner.normals[static_cast<std::size_t>(g)];
      some = cut({m - n, m.dot(point_of(g)) - n.dot(point_of(f)), 0}, cell) && !cell.edges.empty();
    }
    if (some) sum += energy_of_cell(owner, law, f, cell);
  }
  return sum;
}

}  // namespace

double turning_radius(double trace, double product) {
  if (!(trace > 0)) return 0;
  const double roundness = std::clamp(4 * product / (trace * trace), 0.0, 1.0);
  return std::sqrt(trace) * (0.8660 + 0.0725 * std::sqrt(roundness));
}

SolidPressure solid_pressure(const MovingSolid& a, const MovingSolid& b, const LawInUse& law,
                             const SolidOverlapBuffer& shared) {
  if (shared.faces.empty()) return {};
  return with_kernel(law, [&](const auto& kernel) { return press(a, b, kernel, shared); });
}

double solid_energy(const PlacedSolid& a, const PlacedSolid& b, const LawInUse& law, SolidOverlapBuffer& shared,
                    SolidOverlapBuffer& scratch) {
  if (!(solid_overlap(a, b, shared).volume > 0)) return 0;
  return with_kernel(law, [&](const auto& kernel) {
    return 0.5 * kernel.kn * (energy_in(a, kernel, shared, scratch) + energy_in(b, kernel, shared, scratch));
  });
}

}  // namespace trilith
