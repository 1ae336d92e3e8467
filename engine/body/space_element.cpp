#include "body/space_element.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

#include "body/element_gradients.hpp"

namespace trilith {
namespace {

constexpr std::array<ElementShapeInfo, 3> shapes{{
    {"brick", 8, 8, 8, 6, {{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}}, 4, 4},
    {"tetrahedron", 4, 4, 1, 4, {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}}, 3, 3},
    {"quadratic tetrahedron",
     10,
     4,
     4,
     4,
     {{{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 9, 7}, {1, 2, 3, 5, 8, 9}, {0, 3, 2, 7, 8, 6}}},
     3,
     6},
}};

/// Signs of the natural coordinates of a brick's nodes.
constexpr std::array<std::array<double, 3>, 8> corner_of{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

/// Ends of the edges of a tetrahedron, in the order of the nodes on them.
constexpr std::array<std::array<int, 2>, 6> edge_of{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}};

/// Derivatives of the shape functions by the three natural coordinates, a row each.
using Gradient = Eigen::Matrix<double, 3, max_space_nodes>;

Gradient brick_gradient(const Vec3& at) {
  Gradient d = Gradient::Zero();
  for (int i = 0; i < 8; ++i) {
    const auto& c = corner_of[static_cast<std::size_t>(i)];
    const double x = 1 + at.x() * c[0], y = 1 + at.y() * c[1], z = 1 + at.z() * c[2];
    d.col(i) << 0.125 * c[0] * y * z, 0.125 * c[1] * x * z, 0.125 * c[2] * x * y;
  }
  return d;
}

/// Of l_0 = 1 - a - b - c, l_1 = a, l_2 = b, l_3 = c.
constexpr std::array<std::array<double, 3>, 4> volume_gradient{{{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Gradient tetrahedron_gradient(ElementShape shape, const Vec3& at) {
  const std::array<double, 4> l{1 - at.x() - at.y() - at.z(), at.x(), at.y(), at.z()};
  Gradient d = Gradient::Zero();
  const bool quadratic = shape == ElementShape::quadratic_tetrahedron;
  for (int k = 0; k < 3; ++k) {
    const auto g = [&](int i) { return volume_gradient[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]; };
    for (int i = 0; i < 4; ++i) d(k, i) = quadratic ? (4 * l[static_cast<std::size_t>(i)] - 1) * g(i) : g(i);
    for (int e = 0; quadratic && e < 6; ++e) {
      const auto [i, j] = edge_of[static_cast<std::size_t>(e)];
      d(k, 4 + e) = 4 * (l[static_cast<std::size_t>(i)] * g(j) + l[static_cast<std::size_t>(j)] * g(i));
    }
  }
  return d;
}

Gradient natural_gradient(ElementShape shape, const Vec3& at) {
  return shape == ElementShape::brick ? brick_gradient(at) : tetrahedron_gradient(shape, at);
}

struct GaussPoint {
  Vec3 at;
  double weight;
};

/// Of a tetrahedron with four points: exact for quadratic fields.
std::vector<GaussPoint> gauss_points(ElementShape shape) {
  std::vector<GaussPoint> points;
  if (shape == ElementShape::tetrahedron) return {{Vec3(0.25, 0.25, 0.25), 1.0 / 6}};
  if (shape == ElementShape::quadratic_tetrahedron) {
    const double b = (5 - std::sqrt(5.0)) / 20, a = 1 - 3 * b, w = 1.0 / 24;
    return {{Vec3(b, b, b), w}, {Vec3(a, b, b), w}, {Vec3(b, a, b), w}, {Vec3(b, b, a), w}};
  }
  const double at = 1 / std::sqrt(3.0);
  for (const auto& c : corner_of) points.push_back({at * Vec3(c[0], c[1], c[2]), 1});
  return points;
}

Vec3 middle_of(ElementShape shape) {
  return shape == ElementShape::brick ? Vec3(Vec3::Zero()) : Vec3(0.25, 0.25, 0.25);
}

/// Rows: the place by each natural coordinate.
Eigen::Matrix3d jacobian_of(const Gradient& d, std::span<const Vec3> nodes) {
  Eigen::Matrix3d j = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < nodes.size(); ++i) j += d.col(static_cast<Eigen::Index>(i)) * nodes[i].transpose();
  return j;
}

/// Puts the gradient of node or mode `i` where a strain matrix has it: xx, yy, zz, xy, yz, zx.
template <class M>
void set_strain(M& b, int i, const Vec3& g) {
  const int c = 3 * i;
  b(0, c) = g.x(), b(1, c + 1) = g.y(), b(2, c + 2) = g.z();
  b(3, c) = g.y(), b(3, c + 1) = g.x();
  b(4, c + 1) = g.z(), b(4, c + 2) = g.y();
  b(5, c) = g.z(), b(5, c + 2) = g.x();
}

/// Nine incompatible modes, three for each displacement, and three of the change of volume alone.
constexpr int mode_count = 12;
using SpaceModes = Eigen::Matrix<double, 6, mode_count>;

}  // namespace

const ElementShapeInfo& info_of(ElementShape shape) {
  return shapes[static_cast<std::size_t>(shape)];
}

namespace {

/// Points of Gauss, then corners.
std::vector<Vec3> watched_points(ElementShape shape) {
  std::vector<Vec3> points;
  for (const GaussPoint& g : gauss_points(shape)) points.push_back(g.at);
  if (shape == ElementShape::brick)
    for (const auto& c : corner_of) points.emplace_back(c[0], c[1], c[2]);
  else
    for (const auto& c : volume_gradient)  // those of l_1 to l_3 are where l_1 to l_3 are 1
      points.emplace_back(std::max(0.0, c[0]), std::max(0.0, c[1]), std::max(0.0, c[2]));
  return points;
}

}  // namespace

std::vector<std::array<Vec3, max_space_nodes>> watched_gradients(ElementShape shape, std::span<const Vec3> nodes) {
  std::vector<std::array<Vec3, max_space_nodes>> out;
  for (const Vec3& at : watched_points(shape)) {
    const Gradient d = natural_gradient(shape, at), gradient = jacobian_of(d, nodes).inverse() * d;
    auto& of = out.emplace_back();
    for (int i = 0; i < max_space_nodes; ++i) of[static_cast<std::size_t>(i)] = gradient.col(i);
  }
  return out;
}

double least_jacobian(ElementShape shape, std::span<const Vec3> nodes) {
  const auto at = [&](const Vec3& p) { return jacobian_of(natural_gradient(shape, p), nodes).determinant(); };
  double least = at(middle_of(shape));
  for (const Vec3& p : watched_points(shape)) least = std::min(least, at(p));
  const double middle = std::abs(at(middle_of(shape)));
  return middle > 0 ? least / middle : 0;
}

/// Gradients in space: J^-1 d; det J times the weight is the volume that a point stands for.
SpaceElementStrain plain_strain(ElementShape shape, std::span<const Vec3> nodes) {
  SpaceElementStrain out;
  for (const GaussPoint& g : gauss_points(shape)) {
    const Gradient d = natural_gradient(shape, g.at);
    const Eigen::Matrix3d jacobian = jacobian_of(d, nodes);
    const Gradient gradient = jacobian.inverse() * d;
    const auto p = static_cast<std::size_t>(out.points++);
    out.volume[p] = g.weight * jacobian.determinant();
    out.matrix[p].setZero();
    for (int i = 0; i < info_of(shape).nodes; ++i) set_strain(out.matrix[p], i, gradient.col(i));
  }
  return out;
}

/// G in `modes`, G'CG in `inner`, G'CB in `mixed`; B - G (G'CG)^-1 (G'CB) at each point.
SpaceElementStrain assumed_strain(ElementShape shape, std::span<const Vec3> nodes, const SpaceMatrix& elastic) {
  SpaceElementStrain out = plain_strain(shape, nodes);
  if (shape != ElementShape::brick) return out;
  const Eigen::Matrix3d middle = jacobian_of(natural_gradient(shape, Vec3::Zero()), nodes), inverse = middle.inverse();
  const std::vector<GaussPoint> points = gauss_points(shape);
  std::array<SpaceModes, max_space_points> modes;
  Eigen::Matrix<double, mode_count, mode_count> inner = Eigen::Matrix<double, mode_count, mode_count>::Zero();
  Eigen::Matrix<double, mode_count, 24> mixed = Eigen::Matrix<double, mode_count, 24>::Zero();
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double ratio = middle.determinant() / out.volume[p];
    modes[p].setZero();
    for (int k = 0; k < 3; ++k) set_strain(modes[p], k, Vec3(-2 * points[p].at[k] * ratio * inverse.col(k)));
    for (int k = 0; k < 3; ++k)
      modes[p].col(9 + k).head<3>().setConstant(ratio * points[p].at[k] * points[p].at[(k + 1) % 3]);
    inner += out.volume[p] * modes[p].transpose() * elastic * modes[p];
    mixed += out.volume[p] * modes[p].transpose() * elastic * out.matrix[p].leftCols<24>();
  }
  const Eigen::Matrix<double, mode_count, 24> condensed = inner.ldlt().solve(mixed);
  for (std::size_t p = 0; p < points.size(); ++p) out.matrix[p].leftCols<24>() -= modes[p] * condensed;
  return out;
}

Eigen::MatrixXd element_stiffness(ElementShape shape, const SpaceElementStrain& strain, const SpaceMatrix& elastic) {
  const int count = 3 * info_of(shape).nodes;
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(count, count);
  for (int p = 0; p < strain.points; ++p) {
    const auto b = strain.matrix[static_cast<std::size_t>(p)].leftCols(count);
    k += strain.volume[static_cast<std::size_t>(p)] * b.transpose() * elastic * b;
  }
  return 0.5 * (k + k.transpose());
}

std::array<Vec3, max_space_nodes> mean_gradients(ElementShape shape, std::span<const Vec3> nodes) {
  const SpaceElementStrain strain = plain_strain(shape, nodes);
  std::array<Vec3, max_space_nodes> mean;
  mean.fill(Vec3::Zero());
  double volume = 0;
  for (int p = 0; p < strain.points; ++p) {
    const auto& b = strain.matrix[static_cast<std::size_t>(p)];
    const double share = strain.volume[static_cast<std::size_t>(p)];
    volume += share;
    for (int i = 0; i < info_of(shape).nodes; ++i)
      mean[static_cast<std::size_t>(i)] += share * Vec3(b(0, 3 * i), b(1, 3 * i + 1), b(2, 3 * i + 2));
  }
  for (Vec3& g : mean) g /= volume;
  return mean;
}

ElementVolume node_shares(ElementShape shape, std::span<const Vec3> nodes) {
  ElementVolume out;
  const std::vector<GaussPoint> points = gauss_points(shape);
  for (const GaussPoint& g : points) {
    const double volume = g.weight * jacobian_of(natural_gradient(shape, g.at), nodes).determinant();
    out.volume += volume;
    if (shape != ElementShape::brick) continue;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto& c = corner_of[i];
      out.share[i] += 0.125 * volume * (1 + g.at.x() * c[0]) * (1 + g.at.y() * c[1]) * (1 + g.at.z() * c[2]);
    }
  }
  if (shape == ElementShape::brick)
    for (std::size_t i = 0; i < 8; ++i) out.share[i] /= out.volume;
  else if (shape == ElementShape::tetrahedron)
    std::fill_n(out.share.begin(), 4, 0.25);
  else
    for (std::size_t i = 0; i < 10; ++i) out.share[i] = i < 4 ? 1.0 / 36 : 4.0 / 27;
  return out;
}

namespace {

/// A point of a face for integrals over it: shape functions of the face's nodes, their two derivatives, and a weight.
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

/// Nodes of a face where they are, their middle by area, and its area vector.
struct FaceNodes {
  std::vector<Vec3> place;
  std::vector<FacePoint> points;
  std::vector<double> area;  ///< [point] that it stands for
  Vec3 vector = Vec3::Zero();

  FaceNodes(ElementShape shape, std::span<const Vec3> nodes, int face) {
    const ElementShapeInfo& info = info_of(shape);
    for (int i = 0; i < info.face_nodes; ++i)
      place.push_back(
          nodes[static_cast<std::size_t>(info.face[static_cast<std::size_t>(face)][static_cast<std::size_t>(i)])]);
    points = shape == ElementShape::brick ? quadrilateral_points()
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

/// Least squares of (1, s) over the face: the middle is that of the area, so that mean and gradient do not mix.
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

/// Of M^-1/2 K M^-1/2, M lumped at the nodes.
double largest_frequency2(const Eigen::MatrixXd& stiffness, std::span<const double> mass) {
  Eigen::MatrixXd scaled = stiffness;
  for (Eigen::Index i = 0; i < scaled.rows(); ++i)
    for (Eigen::Index j = 0; j < scaled.cols(); ++j)
      scaled(i, j) /= std::sqrt(mass[static_cast<std::size_t>(i / 3)] * mass[static_cast<std::size_t>(j / 3)]);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace trilith
