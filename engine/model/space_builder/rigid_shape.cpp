#include "model/space_builder/rigid_shape.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

#include "model/space_builder/space_solid.hpp"

namespace trilith {
namespace {

/// Corners at the ends of the edges with the nodes 4 to 9 of a ten-node tetrahedron.
constexpr std::array<std::array<std::size_t, 2>, 6> edges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}};

/// Four tetrahedra at the corners, four about the line between the midpoints of two opposite edges.
constexpr std::array<std::array<std::size_t, 4>, 8> parts{
    {{0, 4, 6, 7}, {4, 1, 5, 9}, {6, 5, 2, 8}, {7, 9, 8, 3}, {4, 8, 5, 6}, {4, 8, 6, 7}, {4, 8, 7, 9}, {4, 8, 9, 5}}};

/// A node farther than this share of its edge's length from its midpoint makes the edge curved.
constexpr double straight_share = 1e-9;

bool is_curved(ElementShape shape, const std::vector<Vec3>& nodes) {
  if (shape != ElementShape::quadratic_tetrahedron) return false;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Vec3 &a = nodes[edges[e][0]], &b = nodes[edges[e][1]];
    if ((nodes[4 + e] - 0.5 * (a + b)).norm() > straight_share * (b - a).norm()) return true;
  }
  return false;
}

double tetrahedron_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return cross(Vec3(b - a), Vec3(c - a)).dot(d - a) / 6;
}

Polyhedron tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Polyhedron out;
  out.corners = {a, b, c, d};
  const ElementShapeInfo& info = info_of(ElementShape::tetrahedron);
  for (int f = 0; f < info.faces; ++f) out.faces.add(info.corners_of_face(f));
  return out;
}

/// The eight tetrahedra between the ten nodes; empty if one of them has no volume because of strongly curved edges.
std::vector<Polyhedron> parted(const std::vector<Vec3>& x) {
  const double least = 1e-6 * std::abs(tetrahedron_volume(x[0], x[1], x[2], x[3]));
  std::vector<Polyhedron> out;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    auto [a, b, c, d] = parts[p];
    double volume = tetrahedron_volume(x[a], x[b], x[c], x[d]);
    if (p >= 4 && volume < 0) std::swap(c, d), volume = -volume;
    if (volume <= least) return {};
    out.push_back(tetrahedron(x[a], x[b], x[c], x[d]));
  }
  return out;
}

/// Position at natural coordinates of a ten-node element, and its Jacobian.
struct CurvedPoint {
  Vec3 place = Vec3::Zero();
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();

  CurvedPoint(const std::vector<Vec3>& x, double u, double v, double w) {
    const std::array<double, 4> l{1 - u - v - w, u, v, w};
    const std::array<Vec3, 4> slope{Vec3(-1, -1, -1), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    for (std::size_t i = 0; i < 4; ++i) {
      place += l[i] * (2 * l[i] - 1) * x[i];
      jacobian += x[i] * Vec3((4 * l[i] - 1) * slope[i]).transpose();
    }
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto [i, j] = edges[e];
      place += 4 * l[i] * l[j] * x[4 + e];
      jacobian += x[4 + e] * Vec3(4 * (l[i] * slope[j] + l[j] * slope[i])).transpose();
    }
  }
};

/// Gauss quadrature with five points from 0 to 1, exact to degree nine.
struct GaussPoint {
  double at, weight;
};
std::array<GaussPoint, 5> gauss_points() {
  const double near = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3, far = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3;
  const double of_near = (322 + 13 * std::sqrt(70.0)) / 1800, of_far = (322 - 13 * std::sqrt(70.0)) / 1800;
  return {{{0.5 * (1 - far), of_far},
           {0.5 * (1 - near), of_near},
           {0.5, 64.0 / 225},
           {0.5 * (1 + near), of_near},
           {0.5 * (1 + far), of_far}}};
}

/// Moments of several parts together.
SolidMoments sum_of(const std::vector<SolidMoments>& moments) {
  SolidMoments sum{0, Vec3::Zero(), Eigen::Matrix3d::Zero()};
  for (const SolidMoments& m : moments) sum.volume += m.volume, sum.centroid += m.volume * m.centroid;
  sum.centroid /= sum.volume;
  for (const SolidMoments& m : moments) {
    const Vec3 arm = m.centroid - sum.centroid;
    sum.inertia += m.inertia + m.volume * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
  }
  return sum;
}

}  // namespace

/// Gauss quadrature on a cube collapsed to a tetrahedron: the integrands have degree seven at most.
SolidMoments curved_moments(const std::vector<Vec3>& nodes) {
  static const std::array<GaussPoint, 5> points = gauss_points();
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  const Vec3 origin = nodes[0];
  for (const GaussPoint& p : points)
    for (const GaussPoint& q : points)
      for (const GaussPoint& r : points) {
        const double u = p.at, v = q.at * (1 - u), w = r.at * (1 - q.at) * (1 - u);
        const CurvedPoint at(nodes, u, v, w);
        const double share =
            p.weight * q.weight * r.weight * (1 - u) * (1 - u) * (1 - q.at) * at.jacobian.determinant();
        const Vec3 x = at.place - origin;
        volume += share, first += share * x, second += share * (x * x.transpose());
      }
  const Vec3 centre = first / volume;
  second -= volume * (centre * centre.transpose());
  return {volume, origin + centre, second.trace() * Eigen::Matrix3d::Identity() - second};
}

RigidShape rigid_shape(const SpaceMesh& mesh) {
  RigidShape out;
  const std::vector<Polyhedron> whole = solids_of(mesh);
  std::vector<SolidMoments> moments;
  for (std::size_t e = 0; e < mesh.cell.size(); ++e) {
    const std::vector<Vec3> nodes = nodes_of(mesh, e);
    const bool curved = is_curved(mesh.cell[e].shape, nodes);
    moments.push_back(curved ? curved_moments(nodes) : solid_moments(whole[e]));
    std::vector<Polyhedron> pieces;
    if (curved) pieces = parted(nodes);
    if (pieces.empty()) pieces.push_back(whole[e]);
    out.curved += curved ? 1 : 0;
    // A parabola deviates by a quarter of its rise from the chord of each half; by all of it if the element is one
    // piece.
    for (std::size_t k = 0; curved && k < edges.size(); ++k) {
      const double rise = (nodes[4 + k] - 0.5 * (nodes[edges[k][0]] + nodes[edges[k][1]])).norm();
      out.deviation = std::max(out.deviation, pieces.size() == 1 ? rise : 0.25 * rise);
    }
    for (Polyhedron& piece : pieces) {
      out.pieces_volume += solid_moments(piece).volume;
      out.pieces.push_back(std::move(piece));
    }
  }
  if (out.curved > 0) out.moments = sum_of(moments);
  return out;
}

std::string curved_note(const RigidShape& shape, const std::string& owner) {
  if (shape.curved == 0) return {};
  return fmt::format(
      "{}: {} of its elements have curved edges. Mass, centroid and inertia follow the curved elements; contact uses "
      "flat faces through their nodes, which lie up to {:.2g} m off and enclose {:.4g} m3 of {:.4g} m3. A finer mesh "
      "reduces the difference",
      owner, shape.curved, shape.deviation, shape.pieces_volume, shape.moments->volume);
}

}  // namespace trilith
