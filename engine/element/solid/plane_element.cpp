#include "element/solid/plane_element.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace trilith {
namespace {

// Natural coordinates of a quadrilateral, and its Gauss points xi, eta = +-1/sqrt(3), each with the weight 1.
//
//     3 (-1, 1) ------ 2 (1, 1)       natural coordinates xi to the right, eta up;
//        |                |           N_i = (1 + xi xi_i) (1 + eta eta_i) / 4
//     0 (-1, -1) ----- 1 (1, -1)

constexpr std::array<double, 4> xi_of{-1, 1, 1, -1}, eta_of{-1, -1, 1, 1};

/// Derivatives of a quadrilateral's shape functions along xi (row 0) and eta (row 1).
Eigen::Matrix<double, 2, 4> natural_gradient(double xi, double eta) {
  Eigen::Matrix<double, 2, 4> d;
  for (int i = 0; i < 4; ++i) {
    d(0, i) = 0.25 * xi_of[i] * (1 + eta * eta_of[i]);
    d(1, i) = 0.25 * eta_of[i] * (1 + xi * xi_of[i]);
  }
  return d;
}

Eigen::Matrix<double, 4, 2> as_rows(std::span<const Vec2> corners) {
  Eigen::Matrix<double, 4, 2> x;
  for (int i = 0; i < 4; ++i) x.row(i) = corners[i].transpose();
  return x;
}

/// Writes the gradient (d/dx, d/dy) of node or mode `i` to a strain matrix.
template <class M>
void set_strain(M& b, int i, double dx, double dy) {
  b(0, 2 * i) = dx, b(1, 2 * i + 1) = dy;
  b(2, 2 * i) = dy, b(2, 2 * i + 1) = dx;
}

/// The gradient of corner i is the opposite edge, rotated inwards by 90 degrees, over twice the area.
ElementStrain triangle_strain(std::span<const Vec2> c) {
  ElementStrain out;
  const double twice = cross(Vec2(c[1] - c[0]), Vec2(c[2] - c[0]));
  out.points = 1;
  out.area[0] = 0.5 * twice;
  out.matrix[0].setZero();
  for (int i = 0; i < 3; ++i) {
    const Vec2 across = (c[(i + 2) % 3] - c[(i + 1) % 3]) / twice;
    set_strain(out.matrix[0], i, -across.y(), across.x());
  }
  return out;
}

using ModeMatrix = Eigen::Matrix<double, 3, 4>;

}  // namespace

/// Spatial gradients J^-1 d, with the rows of J = d x along xi and eta; det J is the area weight of a point.
ElementStrain plain_strain(std::span<const Vec2> corners) {
  if (corners.size() == 3) return triangle_strain(corners);
  ElementStrain out;
  out.points = 4;
  const double at = 1 / std::sqrt(3.0);
  for (int p = 0; p < 4; ++p) {
    const auto d = natural_gradient(at * xi_of[p], at * eta_of[p]);
    const Eigen::Matrix2d jacobian = d * as_rows(corners);
    const Eigen::Matrix<double, 2, 4> gradient = jacobian.inverse() * d;
    out.area[p] = jacobian.determinant();
    out.matrix[p].setZero();
    for (int i = 0; i < 4; ++i) set_strain(out.matrix[p], i, gradient(0, i), gradient(1, i));
  }
  return out;
}

/// G in `modes`, G'CG in `inner`, G'CB in `mixed`; B - G (G'CG)^-1 (G'CB) at each point.
ElementStrain assumed_strain(std::span<const Vec2> corners, const Eigen::Matrix3d& elastic) {
  ElementStrain out = plain_strain(corners);
  if (corners.size() == 3) return out;
  const Eigen::Matrix2d middle = natural_gradient(0, 0) * as_rows(corners), inverse = middle.inverse();
  const double at = 1 / std::sqrt(3.0);
  std::array<ModeMatrix, 4> modes;
  Eigen::Matrix4d inner = Eigen::Matrix4d::Zero();
  Eigen::Matrix<double, 4, 8> mixed = Eigen::Matrix<double, 4, 8>::Zero();
  for (int p = 0; p < 4; ++p) {
    // Gradients of 1 - xi^2 and 1 - eta^2; the ratio of determinants makes their integral vanish: the patch test.
    const double ratio = middle.determinant() / out.area[p];
    const Vec2 along_xi = -2 * at * xi_of[p] * ratio * inverse.col(0),
               along_eta = -2 * at * eta_of[p] * ratio * inverse.col(1);
    modes[p].setZero();
    set_strain(modes[p], 0, along_xi.x(), along_xi.y());
    set_strain(modes[p], 1, along_eta.x(), along_eta.y());
    inner += out.area[p] * modes[p].transpose() * elastic * modes[p];
    mixed += out.area[p] * modes[p].transpose() * elastic * out.matrix[p];
  }
  const Eigen::Matrix<double, 4, 8> condensed = inner.ldlt().solve(mixed);
  for (int p = 0; p < 4; ++p) out.matrix[p] -= modes[p] * condensed;
  return out;
}

ElementMatrix element_stiffness(const ElementStrain& strain, const Eigen::Matrix3d& elastic) {
  ElementMatrix k = ElementMatrix::Zero();
  for (int p = 0; p < strain.points; ++p)
    k += strain.area[p] * strain.matrix[p].transpose() * elastic * strain.matrix[p];
  return 0.5 * (k + k.transpose());
}

std::array<Vec2, max_element_nodes> mean_gradients(std::span<const Vec2> corners) {
  const ElementStrain strain = plain_strain(corners);
  std::array<Vec2, max_element_nodes> mean;
  mean.fill(Vec2::Zero());
  double area = 0;
  for (int p = 0; p < strain.points; ++p) {
    area += strain.area[p];
    for (int i = 0; i < max_element_nodes; ++i)
      mean[i] += strain.area[p] * Vec2(strain.matrix[p](0, 2 * i), strain.matrix[p](1, 2 * i + 1));
  }
  for (Vec2& g : mean) g /= area;
  return mean;
}

/// Integral of each shape function: its node's share of the element's mass.
std::array<double, max_element_nodes> node_areas(std::span<const Vec2> corners) {
  std::array<double, max_element_nodes> areas{};
  if (corners.size() == 3) {
    const double third = cross(Vec2(corners[1] - corners[0]), Vec2(corners[2] - corners[0])) / 6;
    areas = {third, third, third, 0};
    return areas;
  }
  const double at = 1 / std::sqrt(3.0);
  for (int p = 0; p < 4; ++p) {
    const double xi = at * xi_of[p], eta = at * eta_of[p];
    const Eigen::Matrix2d jacobian = natural_gradient(xi, eta) * as_rows(corners);
    const auto n = shape_functions(4, {xi, eta});
    for (int i = 0; i < 4; ++i) areas[i] += n[i] * jacobian.determinant();
  }
  return areas;
}

std::array<double, max_element_nodes> shape_functions(std::size_t nodes, const Vec2& natural) {
  if (nodes == 3) return {1 - natural.x() - natural.y(), natural.x(), natural.y(), 0};
  std::array<double, max_element_nodes> n{};
  for (int i = 0; i < 4; ++i) n[i] = 0.25 * (1 + natural.x() * xi_of[i]) * (1 + natural.y() * eta_of[i]);
  return n;
}

namespace {

Vec2 place_of(std::span<const Vec2> corners, const Vec2& natural) {
  const auto n = shape_functions(corners.size(), natural);
  Vec2 x = Vec2::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) x += n[i] * corners[i];
  return x;
}

/// Natural coordinates of the nearest point of edge `e`.
Vec2 nearest_on_edge(std::span<const Vec2> corners, std::size_t e, const Vec2& x) {
  const std::size_t f = (e + 1) % corners.size();
  const Vec2 along = corners[f] - corners[e];
  const double share = std::clamp(along.dot(x - corners[e]) / along.squaredNorm(), 0.0, 1.0);
  const auto natural = [&](std::size_t i) {
    if (corners.size() == 4) return Vec2(xi_of[i], eta_of[i]);
    return Vec2(i == 1 ? 1 : 0, i == 2 ? 1 : 0);
  };
  return (1 - share) * natural(e) + share * natural(f);
}

/// A convex counter-clockwise element contains the points to the left of every edge.
bool is_inside(std::span<const Vec2> corners, const Vec2& x) {
  for (std::size_t e = 0; e < corners.size(); ++e)
    if (cross(Vec2(corners[(e + 1) % corners.size()] - corners[e]), Vec2(x - corners[e])) < 0) return false;
  return true;
}

/// Solves x(natural) = x by Newton's method; the map of a convex quadrilateral is one to one inside.
Vec2 natural_inside(std::span<const Vec2> corners, const Vec2& x) {
  if (corners.size() == 3) {
    const Vec2 a = corners[1] - corners[0], b = corners[2] - corners[0], r = x - corners[0];
    return {cross(r, b) / cross(a, b), cross(a, r) / cross(a, b)};
  }
  Vec2 natural = Vec2::Zero();
  for (int i = 0; i < 50; ++i) {
    const Eigen::Matrix2d jacobian = natural_gradient(natural.x(), natural.y()) * as_rows(corners);
    const Vec2 step = jacobian.transpose().inverse() * (x - place_of(corners, natural));
    // Clamped to the element, where the map is one to one.
    natural = (natural + step).cwiseMax(-1).cwiseMin(1);
    if (step.norm() < 1e-15) break;
  }
  return natural;
}

}  // namespace

/// Inside by the inverse map, otherwise on the nearest edge, where the map is linear.
ElementPoint nearest_in_element(std::span<const Vec2> corners, const Vec2& x) {
  if (is_inside(corners, x)) return {natural_inside(corners, x), 0};
  ElementPoint best{Vec2::Zero(), std::numeric_limits<double>::infinity()};
  for (std::size_t e = 0; e < corners.size(); ++e) {
    const Vec2 natural = nearest_on_edge(corners, e, x);
    const double distance = (place_of(corners, natural) - x).norm();
    if (distance < best.distance) best = {natural, distance};
  }
  return best;
}

/// Largest eigenvalue of M^-1/2 K M^-1/2, with lumped M.
double largest_frequency2(const ElementMatrix& stiffness, std::span<const double> mass) {
  const auto count = static_cast<Eigen::Index>(2 * mass.size());
  Eigen::MatrixXd scaled = stiffness.topLeftCorner(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j) scaled(i, j) /= std::sqrt(mass[i / 2] * mass[j / 2]);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace trilith
