#include "geometry/space/polyhedron.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/principal_axes.hpp"
#include "base/rotation_3d.hpp"

namespace trilith {

void FaceLoops::add(std::span<const int> loop) {
  corner.insert(corner.end(), loop.begin(), loop.end());
  start.push_back(static_cast<int>(corner.size()));
}

namespace {

const Vec3& corner_at(std::span<const Vec3> corners, int i) {
  return corners[static_cast<std::size_t>(i)];
}

/// The edge along which a face runs from `from` to `to` and which has no face on its right yet, if any.
SolidEdge* unpaired(std::vector<SolidEdge>& edges, int from, int to) {
  for (SolidEdge& e : edges)
    if (e.from == from && e.to == to && e.right < 0) return &e;
  return nullptr;
}

}  // namespace

/// Each edge once, from the first face that runs along it; the face that runs the other way is on its right.
std::vector<SolidEdge> solid_edges(const FaceLoops& faces) {
  std::vector<SolidEdge> edges;
  for (int f = 0; f < faces.count(); ++f) {
    const auto loop = faces[f];
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int from = loop[k], to = loop[k + 1 == loop.size() ? 0 : k + 1];
      if (SolidEdge* other = unpaired(edges, to, from))
        other->right = f;
      else
        edges.push_back({from, to, f, -1});
    }
  }
  return edges;
}

/// Half the sum of the cross products of a fan of triangles: the normal times the area, averaged over the triangles'
/// planes where the corners are not coplanar.
Vec3 area_vector(std::span<const Vec3> corners, std::span<const int> loop) {
  Vec3 twice = Vec3::Zero();
  const Vec3 origin = corner_at(corners, loop[0]);
  for (std::size_t k = 2; k < loop.size(); ++k)
    twice += cross(Vec3(corner_at(corners, loop[k - 1]) - origin), Vec3(corner_at(corners, loop[k]) - origin));
  return twice / 2;
}

std::vector<Vec3> face_normals(const Polyhedron& solid) {
  std::vector<Vec3> normals;
  for (int f = 0; f < solid.faces.count(); ++f)
    normals.push_back(area_vector(solid.corners, solid.faces[f]).normalized());
  return normals;
}

double solid_size(std::span<const Vec3> points) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

// For a tetrahedron between 0 and a, b, c with s = a + b + c and volume V, the integral of r is V s / 4. The integral
// of r r^T is V (s s^T + a a^T + b b^T + c c^T) / 20.
SolidMoments solid_moments(const Polyhedron& solid) {
  const Vec3 origin = solid.corners[0];
  double six = 0;
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (int f = 0; f < solid.faces.count(); ++f) {
    const auto loop = solid.faces[f];
    const Vec3 a = corner_at(solid.corners, loop[0]) - origin;
    for (std::size_t k = 2; k < loop.size(); ++k) {
      const Vec3 b = corner_at(solid.corners, loop[k - 1]) - origin, c = corner_at(solid.corners, loop[k]) - origin;
      const Vec3 sum = a + b + c;
      const double d = a.dot(cross(b, c));
      six += d;
      first += d * sum;
      second += d * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    }
  }
  if (six == 0) return {0, origin, Eigen::Matrix3d::Zero()};
  const double volume = six / 6;
  const Vec3 arm = first / (4 * six);
  second = (second / 120 - volume * arm * arm.transpose()).eval();
  return {volume, origin + arm, second.trace() * Eigen::Matrix3d::Identity() - second};
}

namespace {

/// Column and sign of the first, second and third axis.
struct AxisChoice {
  std::array<int, 3> from;
  std::array<double, 3> sign;
};

/// The right-handed choice of columns that rotates least, i.e. with the largest trace. A later choice must exceed
/// earlier ones by more than rounding.
AxisChoice nearest_axes(const Eigen::Matrix3d& axes) {
  static constexpr std::array<std::array<int, 3>, 6> orders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
  AxisChoice best{orders[0], {1, 1, 1}};
  double largest = -4;
  for (std::size_t o = 0; o < orders.size(); ++o)
    for (const double first : {1.0, -1.0})
      for (const double second : {1.0, -1.0}) {
        const double third = first * second * (o < 3 ? 1 : -1);
        const double trace =
            first * axes(0, orders[o][0]) + second * axes(1, orders[o][1]) + third * axes(2, orders[o][2]);
        if (trace <= largest + 1e-12) continue;
        largest = trace;
        best = {orders[o], {first, second, third}};
      }
  return best;
}

}  // namespace

/// Jacobi's method. Of the 24 ways to name the axes the one nearest to the body's axes is used, so that a box keeps x,
/// y and z.
PrincipalInertia principal_inertia(const Eigen::Matrix3d& inertia) {
  const auto [moments, axes] = principal_axes(inertia, 1e-14 * inertia.diagonal().cwiseAbs().maxCoeff());
  const AxisChoice choice = nearest_axes(axes);
  Eigen::Matrix3d chosen;
  PrincipalInertia out;
  for (int k = 0; k < 3; ++k) {
    const int from = choice.from[static_cast<std::size_t>(k)];
    chosen.col(k) = choice.sign[static_cast<std::size_t>(k)] * axes.col(from);
    out.moments[k] = moments[from];
  }
  out.axes = rotation_of(chosen);
  return out;
}

Polyhedron box_solid(const Vec3& low, const Vec3& high) {
  const std::array<Vec3, 4> floor{low, Vec3(high.x(), low.y(), low.z()), Vec3(high.x(), high.y(), low.z()),
                                  Vec3(low.x(), high.y(), low.z())};
  return extrusion(floor, Vec3(0, 0, high.z() - low.z()));
}

/// Two copies of the polygon, the near one reversed, and a quadrilateral between each pair of edges.
Polyhedron extrusion(std::span<const Vec3> polygon, const Vec3& along) {
  const int n = static_cast<int>(polygon.size());
  Polyhedron solid;
  std::vector<int> near_end, far_end;
  for (int i = 0; i < n; ++i) near_end.push_back(i);
  solid.corners.assign(polygon.begin(), polygon.end());
  for (const Vec3& p : polygon) solid.corners.push_back(p + along);
  // seen from the far end the polygon runs counter-clockwise, or is reversed
  if (area_vector(solid.corners, near_end).dot(along) < 0) std::reverse(near_end.begin(), near_end.end());
  for (const int i : near_end) far_end.push_back(i + n);
  solid.faces.add(std::vector<int>(near_end.rbegin(), near_end.rend()));
  solid.faces.add(far_end);
  for (std::size_t k = 0; k < near_end.size(); ++k) {
    const std::size_t next = k + 1 == near_end.size() ? 0 : k + 1;
    solid.faces.add(std::array{near_end[k], near_end[next], far_end[next], far_end[k]});
  }
  return solid;
}

Polyhedron prism(std::span<const Vec2> outline, double low, double high) {
  std::vector<Vec3> floor;
  for (const Vec2& p : outline) floor.emplace_back(p.x(), p.y(), low);
  return extrusion(floor, Vec3(0, 0, high - low));
}

Polyhedron placed(const Polyhedron& solid, const UnitQuaternion& rotation, const Vec3& shift) {
  const Turn3 turn = turn_of(rotation);
  Polyhedron moved = solid;
  for (Vec3& p : moved.corners) p = turn.apply(p) + shift;
  return moved;
}

}  // namespace trilith
