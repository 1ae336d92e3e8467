#include "draw/scene/scene_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace trilith::draw {
namespace {

/// Sides of the polygon that represents a disc.
constexpr int disc_sides = 16;

/// AABB of a piece in the picture.
struct SeenPiece {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
};

SeenPiece seen_piece(const SolidPiece& piece, const ViewAxes& view) {
  SeenPiece out;
  for (const PieceFace& face : piece.faces)
    for (const Vec3& p : face.corners) {
      const Vec2 flat = view.flat(p);
      out.low = out.low.cwiseMin(flat), out.high = out.high.cwiseMax(flat);
    }
  return out;
}

/// True if a convex piece is behind a sphere: the face with the largest distance to the sphere is visible. A single
/// face is behind if the sphere is above it.
bool lies_behind(const SolidPiece& piece, const SeenSphere& sphere, const ViewAxes& view) {
  double most = -std::numeric_limits<double>::infinity();
  bool behind = false;
  for (const PieceFace& face : piece.faces) {
    const double above = face.normal.dot(sphere.centre - face.corners[0]);
    if (above > most) most = above, behind = face.normal.dot(view.toward) > 0;
  }
  if (piece.faces.size() == 1) return behind == (most > 0);
  return behind;
}

/// Grid of discs with cells as wide as the largest disc.
class DiscGrid {
 public:
  explicit DiscGrid(double width) : width_(width) {}
  void put(const Vec2& at, std::size_t item) { cells_[cell_of(at)].push_back(item); }
  template <class F>
  void for_near(const Vec2& at, F&& f) const {
    const auto [i, j] = cell_of(at);
    for (long di = -1; di <= 1; ++di)
      for (long dj = -1; dj <= 1; ++dj)
        if (const auto cell = cells_.find({i + di, j + dj}); cell != cells_.end())
          for (const std::size_t item : cell->second) f(item);
  }

 private:
  [[nodiscard]] std::pair<long, long> cell_of(const Vec2& at) const {
    return {static_cast<long>(std::floor(at.x() / width_)), static_cast<long>(std::floor(at.y() / width_))};
  }
  double width_;
  std::map<std::pair<long, long>, std::vector<std::size_t>> cells_;
};

std::size_t last_behind(const SeenSphere& sphere, const Vec2& flat, const std::vector<SolidPiece>& pieces,
                        const std::vector<SeenPiece>& seen, const ViewAxes& view) {
  for (std::size_t i = pieces.size(); i-- > 0;) {
    const Vec2 reach = Vec2::Constant(sphere.radius);
    if (((flat + reach).array() < seen[i].low.array()).any() || ((flat - reach).array() > seen[i].high.array()).any())
      continue;
    if (lies_behind(pieces[i], sphere, view)) return i + 1;
  }
  return 0;
}

}  // namespace

std::vector<SeenSphere> seen_spheres(const results::Header& header, const results::Placement& at,
                                     const std::vector<bool>& left_out) {
  std::vector<SeenSphere> out;
  const std::vector<double> radius = header.vertex_radius();
  if (radius.empty()) return out;
  for (std::size_t b = 0; b < header.bodies.size(); ++b) {
    const results::BodyRow& body = header.bodies[b];
    if (left_out[b]) continue;
    for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v)
      if (radius[static_cast<std::size_t>(v)] > 0)
        out.push_back({static_cast<int>(b), at.vertex(v), radius[static_cast<std::size_t>(v)]});
  }
  return out;
}

std::vector<SpherePlace> sphere_places(const std::vector<SeenSphere>& spheres, const std::vector<SolidPiece>& pieces,
                                       const ViewAxes& view) {
  std::vector<SeenPiece> seen;
  for (const SolidPiece& piece : pieces) seen.push_back(seen_piece(piece, view));
  std::vector<std::size_t> order(spheres.size()), before(spheres.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto depth = [&](std::size_t i) { return view.toward.dot(spheres[i].centre); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return depth(a) < depth(b); });
  double widest = 0;
  for (const SeenSphere& s : spheres) widest = std::max(widest, 2 * s.radius);
  DiscGrid grid(widest);
  for (const std::size_t i : order) {
    const Vec2 flat = view.flat(spheres[i].centre);
    before[i] = last_behind(spheres[i], flat, pieces, seen, view);
    grid.for_near(flat, [&](std::size_t k) {
      const double apart = (view.flat(spheres[k].centre) - flat).norm();
      if (apart < spheres[i].radius + spheres[k].radius) before[i] = std::max(before[i], before[k]);
    });
    grid.put(flat, i);
  }
  std::vector<SpherePlace> out;
  for (const std::size_t i : order) out.push_back({i, before[i]});
  std::stable_sort(out.begin(), out.end(),
                   [](const SpherePlace& a, const SpherePlace& b) { return a.pieces_before < b.pieces_before; });
  return out;
}

SceneFace sphere_face(const SeenSphere& sphere, const ViewAxes& view) {
  SceneFace face;
  face.body = sphere.body, face.radius = sphere.radius;
  face.centre = view.flat(sphere.centre);
  for (int i = 0; i < disc_sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / disc_sides;
    face.outline.push_back(face.centre + sphere.radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  face.is_edge.assign(disc_sides, true);
  return face;
}

}  // namespace trilith::draw
