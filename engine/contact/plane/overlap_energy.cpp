#include "contact/plane/overlap_energy.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "contact/plane/placed_edges.hpp"

namespace trilith {
namespace {

using Outline = std::vector<Vec2>;

/// Keeps the part of `outline` where `inside_depth` (linear in x) is not negative.
template <class Depth>
Outline clip(const Outline& outline, Depth&& inside_depth) {
  Outline kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &p = outline[i], &q = outline[(i + 1) % outline.size()];
    const double dp = inside_depth(p), dq = inside_depth(q);
    if (dp >= 0) kept.push_back(p);
    if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) kept.push_back(p + (dp / (dp - dq)) * (q - p));
  }
  return kept;
}

/// Region where points lie deeper in a piece than the crushed depth of its mortar: its area, and the integral of the
/// pressure there over the stiffness.
struct Pressed {
  double area = 0, pressure = 0;  // [m2], [m3] per metre of thickness

  Pressed& operator+=(const Pressed& more) {
    area += more.area, pressure += more.pressure;
    return *this;
  }
};

/// Over `outline`; depths are measured below the nearest surface face of `piece`. Phi is the minimum of linear depths,
/// so each face f has a cell in which it is nearest: the part of the outline where depth_g >= depth_f for all others.
/// There phi is linear, and the law integrates it over a fan of triangles.
template <class K>
Pressed pressed_in(const K& law, const Outline& outline, const PlacedPiece& piece, const PlacedEdges& edges,
                   double crushed) {
  Pressed sum;
  const auto depth = [&](int f, const Vec2& x) { return edges.normal[f].dot(piece.corner[f] - x) - crushed; };
  for (int f = 0; f < edges.count; ++f) {
    if (!edges.surface[f]) continue;
    Outline cell = outline;
    for (int g = 0; g < edges.count && cell.size() > 2; ++g)
      if (g != f && edges.surface[g]) cell = clip(cell, [&](const Vec2& x) { return depth(g, x) - depth(f, x); });
    if (crushed > 0) cell = clip(cell, [&](const Vec2& x) { return depth(f, x); });
    for (std::size_t i = 2; i < cell.size(); ++i) {
      const double area = 0.5 * cross(Vec2(cell[i - 1] - cell[0]), Vec2(cell[i] - cell[0]));
      sum += {area, law.over(area, depth(f, cell[0]), depth(f, cell[i - 1]), depth(f, cell[i]))};
    }
  }
  return sum;
}

/// Replaces a law if only the area is needed.
struct AreaAlone {
  static double over(double /*area*/, double /*d0*/, double /*d1*/, double /*d2*/) { return 0; }
};

template <class K>
Pressed pressed_between(const K& law, const PlacedPiece& a, const PlacedPiece& b, double crushed) {
  const PlacedEdges edges_a(a), edges_b(b);
  // The intersection: b, clipped by the line of each edge of a, including inner cuts.
  Outline common(b.corner.begin(), b.corner.end());
  for (int f = 0; f < edges_a.count && common.size() > 2; ++f)
    common = clip(common, [&](const Vec2& x) { return edges_a.normal[f].dot(a.corner[f] - x); });
  if (common.size() < 3) return {};
  Pressed sum = pressed_in(law, common, a, edges_a, crushed);
  return sum += pressed_in(law, common, b, edges_b, crushed);
}

}  // namespace

double overlap_energy(const PlacedPiece& a, const PlacedPiece& b, const LawInUse& law, double crushed) {
  const double from = std::max(crushed, law.held);
  return with_kernel(law, [&](const auto& k) { return 0.5 * k.kn * pressed_between(k, a, b, from).pressure; });
}

/// W = kn/2 integral of phi - z over the pressed region of either piece, so -dW/dz is kn/2 times its area.
double crushing_force(const PlacedPiece& a, const PlacedPiece& b, double kn, double crushed) {
  return 0.5 * kn * pressed_between(AreaAlone{}, a, b, crushed).area;
}

OverlapResponse whole_overlap(const PlacedPiece& a, const PlacedPiece& b, const LawInUse& law) {
  constexpr std::size_t numbers = *std::max_element(law_number_counts.begin(), law_number_counts.end());
  const std::array<double, numbers> none{};
  std::array<double, numbers> after;
  std::array<Vec2, 2 * max_piece_corners> force;  // required by the walk, unused
  force.fill(Vec2::Zero());
  return respond_overlap(a, b, {ContactMemory{}, none.data()}, law, std::span(force).first(a.corner.size()),
                         std::span(force).subspan(max_piece_corners, b.corner.size()), after.data());
}

}  // namespace trilith
