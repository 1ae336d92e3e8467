#include "geometry/space/cut_solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/space/surface.hpp"

namespace trilith {
namespace {

// Corners are classified by their height over the plane: on it (0) within `same`, above (1) or below (-1). Each corner
// is classified once, so that the two faces of an edge agree.
//
//          +1 o-------o +1            o : removed
//            /       /
//       ----x-------x----  plane      x : new corner, the same for both faces of its edge
//          /       /
//      -1 *-------* -1                * : kept; a new face (the lid) closes the opening
//
/// One cut of one solid.
class SolidCut {
 public:
  SolidCut(const Polyhedron& solid, const CuttingPlane& plane, double same) : solid_(solid) {
    for (const Vec3& p : solid.corners) {
      height_.push_back(plane.normal.dot(p) - plane.offset);
      const double h = height_.back();
      side_.push_back(h > same ? 1 : h < -same ? -1 : 0);
    }
    number_.assign(solid.corners.size(), -1);
  }

  [[nodiscard]] bool is_whole() const { return std::count(side_.begin(), side_.end(), 1) == 0; }
  [[nodiscard]] bool is_nothing() const { return std::count(side_.begin(), side_.end(), -1) == 0; }

  /// False if rounding prevents a single closed lid.
  bool run() {
    for (int f = 0; f < solid_.faces.count(); ++f) keep(solid_.faces[f]);
    return close();
  }

  Polyhedron made;

 private:
  [[nodiscard]] std::size_t at(int i) const { return static_cast<std::size_t>(i); }

  int kept(int corner) {
    int& number = number_[at(corner)];
    if (number < 0) {
      number = static_cast<int>(made.corners.size());
      made.corners.push_back(solid_.corners[at(corner)]);
    }
    return number;
  }

  /// Intersection of the edge between two corners with the plane: the same corner for both of its faces.
  int crossing(int a, int b) {
    if (a > b) std::swap(a, b);
    for (const Crossed& c : crossed_)
      if (c.a == a && c.b == b) return c.number;
    const Vec3 &p = solid_.corners[at(a)], &q = solid_.corners[at(b)];
    const double share = height_[at(a)] / (height_[at(a)] - height_[at(b)]);
    crossed_.push_back({a, b, static_cast<int>(made.corners.size())});
    made.corners.push_back(p + share * (q - p));
    return crossed_.back().number;
  }

  void keep(std::span<const int> loop) {
    const bool reaches_in = std::any_of(loop.begin(), loop.end(), [&](int i) { return side_[at(i)] < 0; });
    if (!reaches_in) return;  // above the plane, or in it: the lid replaces it
    std::vector<int> left;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int from = loop[k], to = loop[k + 1 == loop.size() ? 0 : k + 1];
      if (side_[at(from)] <= 0) left.push_back(kept(from));
      if (side_[at(from)] * side_[at(to)] < 0) left.push_back(crossing(from, to));
    }
    made.faces.add(left);
  }

  /// The lid follows, in the opposite direction, every edge that belongs to one face only.
  bool close() {
    const std::vector<int> across = edges_across(made.faces);
    std::vector<std::pair<int, int>> open;
    for (int f = 0; f < made.faces.count(); ++f) {
      const int first = made.faces.start[at(f)], end = made.faces.start[at(f) + 1];
      for (int k = first; k < end; ++k)
        if (across[at(k)] < 0)
          open.emplace_back(made.faces.corner[at(k + 1 == end ? first : k + 1)], made.faces.corner[at(k)]);
    }
    if (open.size() < 3) return false;
    std::vector<int> lid{open[0].first};
    while (lid.size() <= open.size()) {
      const auto next = std::find_if(open.begin(), open.end(), [&](const auto& e) { return e.first == lid.back(); });
      if (next == open.end()) return false;
      if (next->second == lid[0]) break;
      lid.push_back(next->second);
    }
    made.faces.add(lid);
    return lid.size() == open.size();
  }

  struct Crossed {
    int a, b, number;
  };
  const Polyhedron& solid_;
  std::vector<double> height_;
  std::vector<int> side_, number_;
  std::vector<Crossed> crossed_;
};

}  // namespace

/// If rounding classifies corners near the limit inconsistently, a wider limit is used.
std::optional<Polyhedron> cut_solid(const Polyhedron& solid, const CuttingPlane& plane, double same) {
  for (int round = 0; round < 8; ++round, same *= 2) {
    SolidCut cut(solid, plane, same);
    if (cut.is_nothing()) return {};
    if (cut.is_whole()) return solid;
    if (cut.run()) return std::move(cut.made);
  }
  return solid;
}

std::optional<Polyhedron> cut_solid(Polyhedron around, std::span<const CuttingPlane> planes, double same) {
  for (const CuttingPlane& plane : planes) {
    auto left = cut_solid(around, plane, same);
    if (!left) return {};
    around = std::move(*left);
  }
  return around;
}

// A face of more than three corners that were read or rounded is not plane. Each face is replaced by the plane through
// its centroid along its area vector; the solid is the part of a box around it that all planes leave. Also returns the
// largest distance of an original corner from the nearest new one.
PlanarSolid with_plane_faces(const Polyhedron& solid) {
  std::vector<CuttingPlane> planes;
  for (int f = 0; f < solid.faces.count(); ++f) {
    const auto loop = solid.faces[f];
    const Vec3 normal = area_vector(solid.corners, loop).normalized();
    Vec3 middle = Vec3::Zero();
    for (const int i : loop) middle += solid.corners[static_cast<std::size_t>(i)] / static_cast<double>(loop.size());
    planes.push_back({normal, normal.dot(middle)});
  }
  Vec3 low = solid.corners[0], high = low;
  for (const Vec3& p : solid.corners) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double size = (high - low).norm();
  const Vec3 margin = Vec3::Constant(0.1 * size);
  auto made = cut_solid(box_solid(low - margin, high + margin), planes, 1e-12 * size);
  if (!made) return {solid, 0};
  double moved = 0;
  for (const Vec3& p : solid.corners) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& q : made->corners) nearest = std::min(nearest, (p - q).squaredNorm());
    moved = std::max(moved, nearest);
  }
  return {std::move(*made), std::sqrt(moved)};
}

}  // namespace trilith
