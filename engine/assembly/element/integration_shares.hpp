// Shape functions of quads and bricks of four and eight nodes at their 2 x 2 and 2 x 2 x 2 Gauss points.
#pragma once

#include <array>

namespace trilith {

/// Signs of the natural coordinates of the nodes, and of the integration points near them.
template <int D>
inline constexpr std::array<std::array<double, D>, 1U << D> corner_signs{};
template <>
inline constexpr std::array<std::array<double, 2>, 4> corner_signs<2>{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
template <>
inline constexpr std::array<std::array<double, 3>, 8> corner_signs<3>{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

/// Factor of the shape function of a node at an integration point along axis k.
template <int D>
constexpr double axis_share(int node, int point, int k) {
  constexpr double at = 0.57735026918962576;  // 1 / sqrt(3)
  return 0.5 * (1 + corner_signs<D>[node][k] * corner_signs<D>[point][k] * at);
}
/// Shape function of a node at an integration point.
template <int D>
constexpr double node_share(int node, int point) {
  double out = 1;
  for (int k = 0; k < D; ++k) out *= axis_share<D>(node, point, k);
  return out;
}
/// Its derivative along the natural coordinate k.
template <int D>
constexpr double slope_share(int node, int point, int k) {
  double out = 0.5 * corner_signs<D>[node][k];
  for (int l = 0; l < D; ++l)
    if (l != k) out *= axis_share<D>(node, point, l);
  return out;
}

}  // namespace trilith
