// Faces of elements in space: the plane fitted to each.
#include <Eigen/Dense>

#include <cmath>
#include <vector>

#include "element/solid/face_products.hpp"
#include "element/solid/space_element.hpp"

namespace trilith {
namespace {

/// A quadrature point of a face: shape functions of the face's nodes, their two derivatives, and a weight.
struct FacePoint {
  std::array<double, max_face_nodes> n{};
  std::array<Vec2, max_face_nodes> d;
  double weight = 0;

  FacePoint() { d.fill(Vec2::Zero()); }
};

std::vector<FacePoint> quadrilateral_points() {
  constexpr std::array<double, 4> x{-1, 1, 1, -1}, y{-1, -1, 1, 1};
  const double at = std::sqrt(0.6);
  std::vector<FacePoint> points;
  for (const double u : {-at, 0.0, at})
    for (const double v : {-at, 0.0, at}) {
      FacePoint p;
      p.weight = (u == 0 ? 8.0 / 9 : 5.0 / 9) * (v == 0 ? 8.0 / 9 : 5.0 / 9);
      for (std::size_t i = 0; i < 4; ++i) {
        p.n[i] = 0.25 * (1 + u * x[i]) * (1 + v * y[i]);
        p.d[i] = {0.25 * x[i] * (1 + v * y[i]), 0.25 * y[i] * (1 + u * x[i])};
      }
      points.push_back(p);
    }
  return points;
}

/// Six points, exact for polynomials of the fourth order (Strang and Fix 1973; Dunavant 1985).
std::vector<FacePoint> triangle_points(bool quadratic) {
  constexpr std::array<std::array<double, 2>, 2> rule{
      {{0.445948490915965, 0.223381589678011}, {0.091576213509771, 0.109951743655322}}};
  constexpr std::array<std::array<double, 2>, 3> slope{{{-1, -1}, {1, 0}, {0, 1}}};
  constexpr std::array<std::array<std::size_t, 2>, 3> side{{{0, 1}, {1, 2}, {2, 0}}};
  std::vector<FacePoint> points;
  for (const auto& [a, w] : rule)
    for (std::size_t far = 0; far < 3; ++far) {
      std::array<double, 3> l{a, a, a};
      l[far] = 1 - 2 * a;
      FacePoint p;
      p.weight = 0.5 * w;
      const auto g = [&](std::size_t i) { return Vec2(slope[i][0], slope[i][1]); };
      for (std::size_t i = 0; i < 3; ++i) {
        p.n[i] = quadratic ? l[i] * (2 * l[i] - 1) : l[i];
        p.d[i] = quadratic ? Vec2((4 * l[i] - 1) * g(i)) : g(i);
      }
      for (std::size_t e = 0; quadratic && e < 3; ++e) {
        const auto [i, j] = side[e];
        p.n[3 + e] = 4 * l[i] * l[j], p.d[3 + e] = 4 * (l[i] * g(j) + l[j] * g(i));
      }
      points.push_back(p);
    }
  return points;
}

/// Positions of a face's nodes, its area centroid, and its area vector.
struct FaceNodes {
  std::vector<Vec3> place;
  std::vector<FacePoint> points;
  std::vector<double> area;  ///< [point] weight
  Vec3 vector = Vec3::Zero();

  FaceNodes(ElementShape shape, std::span<const Vec3> nodes, int face) {
    const ElementShapeInfo& info = info_of(shape);
    for (const int node : info.nodes_of_face(face)) place.push_back(nodes[static_cast<std::size_t>(node)]);
    points = info.corners_of_face(face).size() == 4 ? quadrilateral_points()
                                                    : triangle_points(shape == ElementShape::quadratic_tetrahedron);
    for (const FacePoint& p : points) {
      Vec3 along = Vec3::Zero(), across = Vec3::Zero();
      for (std::size_t i = 0; i < place.size(); ++i) along += p.d[i].x() * place[i], across += p.d[i].y() * place[i];
      const Vec3 v = p.weight * cross(along, across);
      area.push_back(v.norm()), vector += v;
    }
  }
  [[nodiscard]] Vec3 at(const FacePoint& p) const {
    Vec3 x = Vec3::Zero();
    for (std::size_t i = 0; i < place.size(); ++i) x += p.n[i] * place[i];
    return x;
  }
};

}  // namespace

/// Least squares of (1, s) over the face: s starts at the area centroid, so mean and gradient are decoupled.
FaceFit fit_face(ElementShape shape, std::span<const Vec3> nodes, int face) {
  const FaceNodes f(shape, nodes, face);
  FaceFit fit;
  fit.middle = Vec3::Zero();
  fit.normal = f.vector.normalized();
  for (std::size_t p = 0; p < f.points.size(); ++p) {
    fit.area += f.area[p], fit.middle += f.area[p] * f.at(f.points[p]);
    for (std::size_t i = 0; i < f.place.size(); ++i) fit.mean[i] += f.area[p] * f.points[p].n[i];
  }
  fit.middle /= fit.area;
  for (double& m : fit.mean) m /= fit.area;
  const Vec3 along = f.place[1] - f.place[0];
  fit.x = Vec3(along - fit.normal.dot(along) * fit.normal).normalized();
  fit.y = cross(fit.normal, fit.x);
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  fit.gradient.fill(Vec2::Zero());
  for (std::size_t p = 0; p < f.points.size(); ++p) {
    const Vec3 arm = f.at(f.points[p]) - fit.middle;
    const Vec2 s(fit.x.dot(arm), fit.y.dot(arm));
    second += f.area[p] * s * s.transpose();
    for (std::size_t i = 0; i < f.place.size(); ++i) fit.gradient[i] += f.area[p] * f.points[p].n[i] * s;
  }
  const Eigen::Matrix2d inverse = second.inverse();
  for (Vec2& g : fit.gradient) g = inverse * g;
  return fit;
}

FaceProducts face_products(ElementShape shape, std::span<const Vec3> nodes, int face) {
  const FaceFit fit = fit_face(shape, nodes, face);
  const FaceNodes f(shape, nodes, face);
  FaceProducts out;
  for (std::size_t p = 0; p < f.points.size(); ++p) {
    const Vec3 arm = f.at(f.points[p]) - fit.middle;
    const Vec2 s(fit.x.dot(arm), fit.y.dot(arm));
    out.second += f.area[p] * s * s.transpose();
    for (std::size_t i = 0; i < f.place.size(); ++i)
      for (std::size_t j = 0; j < f.place.size(); ++j)
        out.products(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) +=
            f.area[p] * f.points[p].n[i] * f.points[p].n[j];
  }
  return out;
}

}  // namespace trilith
