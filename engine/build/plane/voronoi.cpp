#include "build/plane/voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "geometry/plane/half_plane.hpp"

namespace trilith {
namespace {

/// Indices of the other points from near to far, sorted as far as needed.
class Neighbours {
 public:
  Neighbours(const std::vector<Vec2>& points, std::size_t of) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (i != of) order_.push_back({(points[i] - points[of]).squaredNorm(), i});
  }
  /// The k-th nearest, as (squared distance, index); none if there are no more.
  std::optional<std::pair<double, std::size_t>> at(std::size_t k) {
    if (k >= order_.size()) return {};
    if (k >= sorted_) {
      const std::size_t next = std::min(order_.size(), sorted_ + 24);
      std::partial_sort(order_.begin() + static_cast<std::ptrdiff_t>(sorted_),
                        order_.begin() + static_cast<std::ptrdiff_t>(next), order_.end());
      sorted_ = next;
    }
    return order_[k];
  }

 private:
  std::vector<std::pair<double, std::size_t>> order_;
  std::size_t sorted_ = 0;
};

double farthest_corner(const std::vector<Polygon>& pieces, const Vec2& point) {
  double most = 0;
  for (const Polygon& piece : pieces)
    for (const Vec2& corner : piece) most = std::max(most, (corner - point).norm());
  return most;
}

/// Cuts the outline by the bisectors with the other points, nearest first, each offset by `set_back`. A point at a
/// distance d cuts at d/2 minus the set-back: once that is beyond the farthest remaining corner, no farther point can
/// cut.
std::vector<Polygon> cell_of(const Polygon& outline, const std::vector<Vec2>& points, std::size_t i, double set_back,
                             double same) {
  std::vector<Polygon> pieces{outline};
  Neighbours neighbours(points, i);
  for (std::size_t k = 0; const auto next = neighbours.at(k); ++k) {
    const double distance = std::sqrt(next->first);
    if (distance / 2 - set_back > farthest_corner(pieces, points[i])) break;
    const Vec2 normal = (points[next->second] - points[i]) / distance;
    const HalfPlane half{normal, normal.dot((points[next->second] + points[i]) / 2) - set_back};
    std::vector<Polygon> left;
    for (const Polygon& piece : pieces)
      for (Polygon& part : cut_by(piece, half, same)) left.push_back(std::move(part));
    pieces = std::move(left);
  }
  return pieces;
}

/// Part of the outline on which a corner lies, and along which it may move.
enum class OutlinePart { none, side, corner };

/// Cells as indices into shared corners. Corners are merged by assigning the same index, so neighbours have the same
/// bits. Corners at a corner of the outline take precedence over corners on its sides, and these over free ones,
/// because the outline must keep its shape.
class Corners {
 public:
  Corners(const std::vector<Polygon>& cells, const Polygon& outline, double same) : outline_(outline), same_(same) {
    for (const Polygon& cell : cells) {
      cells_.emplace_back();
      for (const Vec2& p : cell) cells_.back().push_back(index_of(p));
    }
    for (const Vec2& p : place_) lies_on_.push_back(outline_part(p));
    tidy();
  }

  void take_out_short_edges(double least) {
    while (const auto edge = shortest_edge(least)) {
      const auto [a, b] = *edge;
      // the constrained corner remains in place; two on one side meet in the middle
      const bool middle = lies_on_[a] == lies_on_[b];
      const std::size_t keep = lies_on_[a] >= lies_on_[b] ? a : b, drop = keep == a ? b : a;
      if (middle) place_[keep] = (place_[a] + place_[b]) / 2;
      for (std::vector<std::size_t>& cell : cells_) std::replace(cell.begin(), cell.end(), drop, keep);
      tidy();
    }
  }

  [[nodiscard]] std::vector<Polygon> polygons() const {
    std::vector<Polygon> made;
    for (const std::vector<std::size_t>& cell : cells_) {
      if (cell.size() < 3) continue;
      made.emplace_back();
      for (const std::size_t i : cell) made.back().push_back(place_[i]);
    }
    return made;
  }

 private:
  /// Corners are searched in a list sorted by x, to avoid comparing all pairs. The first one within `same`, which is
  /// far below any face, is taken.
  std::size_t index_of(const Vec2& p) {
    const auto by_x = [&](std::size_t i, double x) { return place_[i].x() < x; };
    auto found = std::lower_bound(sorted_.begin(), sorted_.end(), p.x() - same_, by_x);
    for (; found != sorted_.end() && place_[*found].x() <= p.x() + same_; ++found)
      if ((place_[*found] - p).norm() <= same_) return *found;
    place_.push_back(p);
    sorted_.insert(std::lower_bound(sorted_.begin(), sorted_.end(), p.x(), by_x), place_.size() - 1);
    return place_.size() - 1;
  }

  [[nodiscard]] double distance_to_side(const Vec2& p, std::size_t side) const {
    const Vec2 &a = outline_[side], &b = outline_[(side + 1) % outline_.size()];
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - (a + t * (b - a))).norm();
  }

  [[nodiscard]] OutlinePart outline_part(const Vec2& p) const {
    OutlinePart found = OutlinePart::none;
    for (std::size_t side = 0; side < outline_.size(); ++side) {
      if ((p - outline_[side]).norm() <= 10 * same_) return OutlinePart::corner;
      if (distance_to_side(p, side) <= 10 * same_) found = OutlinePart::side;
    }
    return found;
  }

  [[nodiscard]] bool may_join(std::size_t a, std::size_t b) const {
    if (lies_on_[a] == OutlinePart::none || lies_on_[b] == OutlinePart::none) return true;
    if (lies_on_[a] == OutlinePart::corner && lies_on_[b] == OutlinePart::corner) return false;
    for (std::size_t side = 0; side < outline_.size(); ++side)
      if (distance_to_side(place_[a], side) <= 10 * same_ && distance_to_side(place_[b], side) <= 10 * same_)
        return true;
    return false;
  }

  [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> shortest_edge(double least) const {
    std::optional<std::pair<std::size_t, std::size_t>> found;
    for (const std::vector<std::size_t>& cell : cells_)
      for (std::size_t k = 0; k < cell.size(); ++k) {
        const std::size_t a = cell[k], b = cell[(k + 1) % cell.size()];
        const double length = (place_[a] - place_[b]).norm();
        if (length < least && may_join(a, b)) least = length, found = std::minmax(a, b);
      }
    return found;
  }

  /// Merges repeated consecutive corners, and empties cells without area.
  void tidy() {
    for (std::vector<std::size_t>& cell : cells_) {
      cell.erase(std::unique(cell.begin(), cell.end()), cell.end());
      while (cell.size() > 1 && cell.front() == cell.back()) cell.pop_back();
      if (cell.size() < 3) cell.clear();
    }
  }

  const Polygon& outline_;
  double same_;
  std::vector<Vec2> place_;
  std::vector<OutlinePart> lies_on_;
  std::vector<std::size_t> sorted_;
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace

std::vector<std::vector<Polygon>> voronoi_cells(const Polygon& outline, const std::vector<Vec2>& points,
                                                double set_back) {
  const double same = 1e-12 * polygon_size(outline);
  std::vector<std::vector<Polygon>> cells;
  for (std::size_t i = 0; i < points.size(); ++i) cells.push_back(cell_of(outline, points, i, set_back, same));
  return cells;
}

std::vector<Polygon> join_corners(const std::vector<Polygon>& cells, const Polygon& outline, double same,
                                  double least_edge) {
  Corners corners(cells, outline, same);
  corners.take_out_short_edges(least_edge);
  return corners.polygons();
}

}  // namespace trilith
