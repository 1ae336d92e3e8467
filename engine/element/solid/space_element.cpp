#include "element/solid/space_element.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

#include "element/solid/element_gradients.hpp"

namespace trilith {
namespace {

constexpr std::array<ElementShapeInfo, 4> shapes{{
    {"brick",
     8,
     8,
     8,
     6,
     {{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
     {4, 4, 4, 4, 4, 4},
     {4, 4, 4, 4, 4, 4}},
    {"tetrahedron", 4, 4, 1, 4, {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}}, {3, 3, 3, 3}, {3, 3, 3, 3}},
    {"quadratic tetrahedron",
     10,
     4,
     4,
     4,
     {{{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 9, 7}, {1, 2, 3, 5, 8, 9}, {0, 3, 2, 7, 8, 6}}},
     {3, 3, 3, 3},
     {6, 6, 6, 6}},
    {"wedge",
     6,
     6,
     6,
     5,
     {{{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
     {3, 3, 4, 4, 4},
     {3, 3, 4, 4, 4}},
}};

/// Signs of the natural coordinates of a brick's nodes.
constexpr std::array<std::array<double, 3>, 8> corner_of{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

/// Ends of a tetrahedron's edges, in the order of the nodes on them.
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

/// Shape functions of a wedge's triangle at (a, b), and their derivatives.
constexpr std::array<std::array<double, 2>, 3> triangle_gradient{{{-1, -1}, {1, 0}, {0, 1}}};

Gradient wedge_gradient(const Vec3& at) {
  const std::array<double, 3> l{1 - at.x() - at.y(), at.x(), at.y()};
  Gradient d = Gradient::Zero();
  for (int i = 0; i < 6; ++i) {
    const auto corner = static_cast<std::size_t>(i % 3);
    const double side = i < 3 ? -1 : 1, half = 0.5 * (1 + side * at.z());
    d.col(i) << half * triangle_gradient[corner][0], half * triangle_gradient[corner][1], 0.5 * side * l[corner];
  }
  return d;
}

Gradient natural_gradient(ElementShape shape, const Vec3& at) {
  if (shape == ElementShape::brick) return brick_gradient(at);
  return shape == ElementShape::wedge ? wedge_gradient(at) : tetrahedron_gradient(shape, at);
}

struct GaussPoint {
  Vec3 at;
  double weight;
};

/// A tetrahedron with four points, and a wedge's triangle with three: exact for quadratic fields.
std::vector<GaussPoint> gauss_points(ElementShape shape) {
  std::vector<GaussPoint> points;
  if (shape == ElementShape::tetrahedron) return {{Vec3(0.25, 0.25, 0.25), 1.0 / 6}};
  if (shape == ElementShape::quadratic_tetrahedron) {
    const double b = (5 - std::sqrt(5.0)) / 20, a = 1 - 3 * b, w = 1.0 / 24;
    return {{Vec3(b, b, b), w}, {Vec3(a, b, b), w}, {Vec3(b, a, b), w}, {Vec3(b, b, a), w}};
  }
  const double at = 1 / std::sqrt(3.0);
  if (shape == ElementShape::wedge) {
    for (const double c : {-at, at})
      for (const auto& [a, b] : {std::pair(1.0 / 6, 1.0 / 6), std::pair(2.0 / 3, 1.0 / 6), std::pair(1.0 / 6, 2.0 / 3)})
        points.push_back({Vec3(a, b, c), 1.0 / 6});
    return points;
  }
  for (const auto& c : corner_of) points.push_back({at * Vec3(c[0], c[1], c[2]), 1});
  return points;
}

Vec3 middle_of(ElementShape shape) {
  if (shape == ElementShape::wedge) return {1.0 / 3, 1.0 / 3, 0};
  return shape == ElementShape::brick ? Vec3(Vec3::Zero()) : Vec3(0.25, 0.25, 0.25);
}

/// Shape functions of all nodes at a point.
Eigen::RowVectorXd values_at(ElementShape shape, const Vec3& at) {
  Eigen::RowVectorXd n = Eigen::RowVectorXd::Zero(shapes[static_cast<std::size_t>(shape)].nodes);
  if (shape == ElementShape::brick) {
    for (int i = 0; i < 8; ++i) {
      const auto& c = corner_of[static_cast<std::size_t>(i)];
      n[i] = 0.125 * (1 + at.x() * c[0]) * (1 + at.y() * c[1]) * (1 + at.z() * c[2]);
    }
  } else if (shape == ElementShape::wedge) {
    const std::array<double, 3> l{1 - at.x() - at.y(), at.x(), at.y()};
    for (int i = 0; i < 6; ++i) n[i] = 0.5 * (1 + (i < 3 ? -1 : 1) * at.z()) * l[static_cast<std::size_t>(i % 3)];
  } else {
    const std::array<double, 4> l{1 - at.x() - at.y() - at.z(), at.x(), at.y(), at.z()};
    const bool quadratic = shape == ElementShape::quadratic_tetrahedron;
    for (std::size_t i = 0; i < 4; ++i) n[static_cast<int>(i)] = quadratic ? l[i] * (2 * l[i] - 1) : l[i];
    for (std::size_t e = 0; quadratic && e < 6; ++e)
      n[static_cast<int>(4 + e)] =
          4 * l[static_cast<std::size_t>(edge_of[e][0])] * l[static_cast<std::size_t>(edge_of[e][1])];
  }
  return n;
}

/// Rows: derivatives of the position by each natural coordinate.
Eigen::Matrix3d jacobian_of(const Gradient& d, std::span<const Vec3> nodes) {
  Eigen::Matrix3d j = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < nodes.size(); ++i) j += d.col(static_cast<Eigen::Index>(i)) * nodes[i].transpose();
  return j;
}

/// Writes the gradient of node or mode `i` to a strain matrix: xx, yy, zz, xy, yz, zx.
template <class M>
void set_strain(M& b, int i, const Vec3& g) {
  const int c = 3 * i;
  b(0, c) = g.x(), b(1, c + 1) = g.y(), b(2, c + 2) = g.z();
  b(3, c) = g.y(), b(3, c + 1) = g.x();
  b(4, c + 1) = g.z(), b(4, c + 2) = g.y();
  b(5, c) = g.z(), b(5, c + 2) = g.x();
}

}  // namespace

const ElementShapeInfo& info_of(ElementShape shape) {
  return shapes[static_cast<std::size_t>(shape)];
}

namespace {

/// Gauss points, then corners.
std::vector<Vec3> watched_points(ElementShape shape) {
  std::vector<Vec3> points;
  for (const GaussPoint& g : gauss_points(shape)) points.push_back(g.at);
  if (shape == ElementShape::brick)
    for (const auto& c : corner_of) points.emplace_back(c[0], c[1], c[2]);
  else if (shape == ElementShape::wedge)
    for (const double c : {-1.0, 1.0})
      for (const auto& l : triangle_gradient) points.emplace_back(std::max(0.0, l[0]), std::max(0.0, l[1]), c);
  else
    for (const auto& c : volume_gradient)  // the corner of l_k, k = 1 to 3, is where l_k is 1
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

Eigen::MatrixXd shape_values(ElementShape shape) {
  const std::vector<GaussPoint> points = gauss_points(shape);
  Eigen::MatrixXd out(static_cast<Eigen::Index>(points.size()), info_of(shape).nodes);
  for (std::size_t p = 0; p < points.size(); ++p)
    out.row(static_cast<Eigen::Index>(p)) = values_at(shape, points[p].at);
  return out;
}

/// Spatial gradients J^-1 d; det J times the weight is the volume weight of a point.
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

namespace {

/// The Jacobian at the centre of an element, used for the strains of its incompatible modes everywhere.
struct ModeScale {
  Eigen::Matrix3d inverse;  ///< inverse Jacobian at the centre
  double determinant;       ///< determinant at the centre [m3]

  ModeScale(ElementShape shape, std::span<const Vec3> nodes) {
    const Eigen::Matrix3d middle = jacobian_of(natural_gradient(shape, middle_of(shape)), nodes);
    inverse = middle.inverse(), determinant = middle.determinant();
  }
};

/// G in `modes`, G'CG in `inner`, G'CB in `mixed`; B - G (G'CG)^-1 (G'CB) at each point.
template <int Modes, int Nodes>
void condense(const std::array<Eigen::Matrix<double, 6, Modes>, max_space_points>& modes, const SpaceMatrix& elastic,
              SpaceElementStrain& out) {
  constexpr int columns = 3 * Nodes;
  Eigen::Matrix<double, Modes, Modes> inner = Eigen::Matrix<double, Modes, Modes>::Zero();
  Eigen::Matrix<double, Modes, columns> mixed = Eigen::Matrix<double, Modes, columns>::Zero();
  const auto points = static_cast<std::size_t>(out.points);
  for (std::size_t p = 0; p < points; ++p) {
    inner += out.volume[p] * modes[p].transpose() * elastic * modes[p];
    mixed += out.volume[p] * modes[p].transpose() * elastic * out.matrix[p].template leftCols<columns>();
  }
  const Eigen::Matrix<double, Modes, columns> condensed = inner.ldlt().solve(mixed);
  for (std::size_t p = 0; p < points; ++p) out.matrix[p].template leftCols<columns>() -= modes[p] * condensed;
}

/// Nine incompatible modes, three for each displacement, and three modes of volume change alone.
void assume_brick(std::span<const Vec3> nodes, const SpaceMatrix& elastic, SpaceElementStrain& out) {
  const ModeScale scale(ElementShape::brick, nodes);
  const std::vector<GaussPoint> points = gauss_points(ElementShape::brick);
  std::array<Eigen::Matrix<double, 6, 12>, max_space_points> modes;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double ratio = scale.determinant / out.volume[p];
    modes[p].setZero();
    for (int k = 0; k < 3; ++k) set_strain(modes[p], k, Vec3(-2 * points[p].at[k] * ratio * scale.inverse.col(k)));
    for (int k = 0; k < 3; ++k)
      modes[p].col(9 + k).head<3>().setConstant(ratio * points[p].at[k] * points[p].at[(k + 1) % 3]);
  }
  condense<12, 8>(modes, elastic, out);
}

/// One incompatible mode for each displacement, along the direction between the triangles.
void assume_wedge(std::span<const Vec3> nodes, const SpaceMatrix& elastic, SpaceElementStrain& out) {
  const ModeScale scale(ElementShape::wedge, nodes);
  const std::vector<GaussPoint> points = gauss_points(ElementShape::wedge);
  std::array<Eigen::Matrix<double, 6, 3>, max_space_points> modes;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double ratio = scale.determinant / out.volume[p];
    modes[p].setZero();
    set_strain(modes[p], 0, Vec3(-2 * points[p].at[2] * ratio * scale.inverse.col(2)));
  }
  condense<3, 6>(modes, elastic, out);
}

}  // namespace

SpaceElementStrain assumed_strain(ElementShape shape, std::span<const Vec3> nodes, const SpaceMatrix& elastic) {
  SpaceElementStrain out = plain_strain(shape, nodes);
  if (shape == ElementShape::brick) assume_brick(nodes, elastic, out);
  if (shape == ElementShape::wedge) assume_wedge(nodes, elastic, out);
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

namespace {

/// Volume of a ten-node tetrahedron whose points give `by_points`. The Jacobian's determinant is a polynomial of degree
/// three where edges are curved, which the four points of the strains do not integrate exactly; these five do (Keast
/// 1986). Elements with straight edges keep the volume of their points [m3].
double curved_volume(std::span<const Vec3> nodes, double by_points) {
  constexpr double rounding = 1e-12, side = 1.0 / 6;
  const auto at = [&](const Vec3& p) {
    return jacobian_of(natural_gradient(ElementShape::quadratic_tetrahedron, p), nodes).determinant();
  };
  const double corners = at({side, side, side}) + at({0.5, side, side}) + at({side, 0.5, side}) + at({side, side, 0.5});
  const double volume = (0.45 * corners - 0.8 * at({0.25, 0.25, 0.25})) / 6;
  return std::abs(volume - by_points) > rounding * std::abs(by_points) ? volume : by_points;
}

}  // namespace

ElementVolume node_shares(ElementShape shape, std::span<const Vec3> nodes) {
  ElementVolume out;
  const std::vector<GaussPoint> points = gauss_points(shape);
  for (const GaussPoint& g : points) {
    const double volume = g.weight * jacobian_of(natural_gradient(shape, g.at), nodes).determinant();
    out.volume += volume;
    if (shape == ElementShape::wedge)
      for (std::size_t i = 0; i < 6; ++i) {
        const std::array<double, 3> l{1 - g.at.x() - g.at.y(), g.at.x(), g.at.y()};
        out.share[i] += 0.5 * volume * l[i % 3] * (1 + (i < 3 ? -1 : 1) * g.at.z());
      }
    if (shape != ElementShape::brick) continue;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto& c = corner_of[i];
      out.share[i] += 0.125 * volume * (1 + g.at.x() * c[0]) * (1 + g.at.y() * c[1]) * (1 + g.at.z() * c[2]);
    }
  }
  if (shape == ElementShape::quadratic_tetrahedron) out.volume = curved_volume(nodes, out.volume);
  if (shape == ElementShape::brick || shape == ElementShape::wedge)
    for (std::size_t i = 0; i < 8; ++i) out.share[i] /= out.volume;
  else if (shape == ElementShape::tetrahedron)
    std::fill_n(out.share.begin(), 4, 0.25);
  else
    for (std::size_t i = 0; i < 10; ++i) out.share[i] = i < 4 ? 1.0 / 36 : 4.0 / 27;
  return out;
}

/// Largest eigenvalue of M^-1/2 K M^-1/2, with lumped M.
double largest_frequency2(const Eigen::MatrixXd& stiffness, std::span<const double> mass) {
  Eigen::MatrixXd scaled = stiffness;
  for (Eigen::Index i = 0; i < scaled.rows(); ++i)
    for (Eigen::Index j = 0; j < scaled.cols(); ++j)
      scaled(i, j) /= std::sqrt(mass[static_cast<std::size_t>(i / 3)] * mass[static_cast<std::size_t>(j / 3)]);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace trilith
