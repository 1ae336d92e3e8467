#include "contact/plane/overlap_energy.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "contact/plane/placed_edges.hpp"

namespace trilith {
namespace {

/// A convex polygon. Each cut adds at most one corner: the intersection of two pieces, cut into the cells of their
/// faces, has fewer than three times the corners of a piece.
class Outline {
 public:
  static constexpr std::size_t most = 3 * max_piece_corners + 1;

  Outline() = default;
  explicit Outline(std::span<const Vec2> corners) : count_(corners.size()) {
    std::copy(corners.begin(), corners.end(), corner_.begin());
  }
  Outline(const Outline& other) : count_(other.count_) { std::copy_n(other.corner_.begin(), count_, corner_.begin()); }
  Outline& operator=(const Outline& other) {
    count_ = other.count_;
    std::copy_n(other.corner_.begin(), count_, corner_.begin());
    return *this;
  }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] const Vec2& operator[](std::size_t i) const { return corner_[i]; }
  void clear() { count_ = 0; }
  /// Rounding may cut a polygon of very short edges more than twice: corners beyond the capacity are dropped.
  void push_back(const Vec2& p) {
    if (count_ < most) corner_[count_++] = p;
  }

 private:
  std::size_t count_ = 0;
  std::array<Vec2, most> corner_;
};

/// Keeps the part of `outline` where `inside_depth` (linear in x) is not negative.
template <class Depth>
void clip(Outline& outline, Depth&& inside_depth) {
  std::array<double, Outline::most> depth;
  double least = 0, most = -1;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    depth[i] = inside_depth(outline[i]);
    least = std::min(least, depth[i]), most = std::max(most, depth[i]);
  }
  if (least >= 0) return;
  if (most < 0) return outline.clear();
  const Outline before = outline;
  outline.clear();
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::size_t next = i + 1 == before.size() ? 0 : i + 1;
    const Vec2 &p = before[i], &q = before[next];
    const double dp = depth[i], dq = depth[next];
    if (dp >= 0) outline.push_back(p);
    if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) outline.push_back(p + (dp / (dp - dq)) * (q - p));
  }
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
      if (g != f && edges.surface[g]) clip(cell, [&](const Vec2& x) { return depth(g, x) - depth(f, x); });
    if (crushed > 0) clip(cell, [&](const Vec2& x) { return depth(f, x); });
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
  Outline common(b.corner);
  for (int f = 0; f < edges_a.count && common.size() > 2; ++f)
    clip(common, [&](const Vec2& x) { return edges_a.normal[f].dot(a.corner[f] - x); });
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
