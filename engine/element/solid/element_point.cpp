#include "element/solid/element_point.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace trilith {
namespace {

std::array<double, 4> volume_coordinates(const Vec3& at) {
  return {1 - at.x() - at.y() - at.z(), at.x(), at.y(), at.z()};
}

std::array<double, max_space_nodes> brick_functions(const Vec3& at) {
  // Nodes go around the lower face and then around the upper one.
  constexpr std::array<std::array<double, 2>, 4> round{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  std::array<double, max_space_nodes> n{};
  for (std::size_t i = 0; i < 8; ++i)
    n[i] = 0.125 * (1 + round[i % 4][0] * at.x()) * (1 + round[i % 4][1] * at.y()) * (1 + (i < 4 ? -1 : 1) * at.z());
  return n;
}

std::array<double, max_space_nodes> wedge_functions(const Vec3& at) {
  const std::array<double, 3> l{1 - at.x() - at.y(), at.x(), at.y()};
  std::array<double, max_space_nodes> n{};
  for (std::size_t i = 0; i < 6; ++i) n[i] = 0.5 * l[i % 3] * (1 + (i < 3 ? -1 : 1) * at.z());
  return n;
}

std::array<double, max_space_nodes> tetrahedron_functions(ElementShape shape, const Vec3& at) {
  constexpr std::array<std::array<std::size_t, 2>, 6> edge{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}};
  const std::array<double, 4> l = volume_coordinates(at);
  std::array<double, max_space_nodes> n{};
  const bool quadratic = shape == ElementShape::quadratic_tetrahedron;
  for (std::size_t i = 0; i < 4; ++i) n[i] = quadratic ? l[i] * (2 * l[i] - 1) : l[i];
  for (std::size_t e = 0; quadratic && e < edge.size(); ++e) n[4 + e] = 4 * l[edge[e][0]] * l[edge[e][1]];
  return n;
}

Vec3 place_at(ElementShape shape, std::span<const Vec3> nodes, const Vec3& natural) {
  const auto n = shape_functions(shape, natural);
  Vec3 at = Vec3::Zero();
  for (std::size_t i = 0; i < nodes.size(); ++i) at += n[i] * nodes[i];
  return at;
}

}  // namespace

std::array<double, max_space_nodes> shape_functions(ElementShape shape, const Vec3& natural) {
  if (shape == ElementShape::brick) return brick_functions(natural);
  return shape == ElementShape::wedge ? wedge_functions(natural) : tetrahedron_functions(shape, natural);
}

/// Positions are at most quadratic along each natural coordinate, so central differences are exact derivatives.
Vec3 natural_coordinates(ElementShape shape, std::span<const Vec3> nodes, const Vec3& at) {
  constexpr int most_steps = 30;
  constexpr double exact = 1e-13, half = 0.5;
  Vec3 natural = shape == ElementShape::brick ? Vec3(Vec3::Zero()) : Vec3(0.25, 0.25, 0.25);
  for (int step = 0; step < most_steps; ++step) {
    Eigen::Matrix3d jacobian;
    for (int k = 0; k < 3; ++k) {
      const Vec3 along = half * Vec3::Unit(k);
      jacobian.col(k) = place_at(shape, nodes, natural + along) - place_at(shape, nodes, natural - along);
    }
    const Vec3 change = jacobian.inverse() * (at - place_at(shape, nodes, natural));
    if (!change.allFinite()) break;
    natural += change;
    if (change.cwiseAbs().maxCoeff() < exact) break;
  }
  return natural;
}

double outside_of(ElementShape shape, const Vec3& natural) {
  if (shape == ElementShape::brick) return std::max(0.0, natural.cwiseAbs().maxCoeff() - 1);
  if (shape == ElementShape::wedge)
    return std::max({0.0, -natural.x(), -natural.y(), natural.x() + natural.y() - 1, std::abs(natural.z()) - 1});
  const std::array<double, 4> l = volume_coordinates(natural);
  return std::max(0.0, -*std::min_element(l.begin(), l.end()));
}

}  // namespace trilith
