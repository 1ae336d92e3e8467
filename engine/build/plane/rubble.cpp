#include "build/plane/rubble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.hpp"
#include "build/plane/voronoi.hpp"
#include "geometry/plane/random_convex.hpp"

namespace trilith {
namespace {

/// Trial positions for each stone; a narrow outline covers only a share of its box.
constexpr std::size_t most_trials = 100000;

bool is_inside(const Polygon& outline, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
}

Polygon stretched(const Polygon& outline, double factor) {
  Polygon made = outline;
  for (Vec2& p : made) p.x() *= factor;
  return made;
}

class Filling {
 public:
  explicit Filling(const Rubble& rubble)
      : rubble_(rubble),
        owner_(builder_title("rubble", rubble.name)),
        bits_(static_cast<std::uint64_t>(static_cast<std::int64_t>(rubble.seed))) {
    check_keys(rubble, owner_);
    // cells of about equal width and height in a space compressed along x become long ones in real space
    outline_ = stretched(check_polygon(rubble.outline, owner_).outline, 1 / rubble.aspect);
    size_ = std::sqrt(signed_area(outline_) / rubble.stones);
    check_lengths();
  }

  std::vector<Part> run() {
    scatter();
    for (int i = 0; i < rubble_.relaxations; ++i) relax();
    shift();
    std::vector<Polygon> stones = rubble_.joint > 0 ? apart() : touching();
    for (Polygon& stone : stones) stone = stretched(stone, rubble_.aspect);
    return named(stones);
  }

 private:
  void check_lengths() {
    const auto check = [&](double value, const char* what, double share) {
      require_not_negative(value, fmt::format("{}: {}", owner_, what), "m");
      if (value > share * size_)
        throw InputError(fmt::format("{}: {} is {:g} m, must be at most {:g} of a stone's mean size, {:g} m", owner_,
                                     what, value, share, share * size_));
    };
    least_edge_ = rubble_.least_edge < 0 ? size_ / 10 : rubble_.least_edge;
    check(least_edge_, "least edge", 0.3);
    check(rubble_.joint, "joint", 0.5);
    check(rubble_.jitter, "jitter", 0.5);
  }

  /// Uniformly distributed over the outline, by rejection; without coincident points.
  void scatter() {
    const Box2 box = bounding_box(outline_);
    const auto stones = static_cast<std::size_t>(rubble_.stones);
    for (std::size_t trial = 0; points_.size() < stones; ++trial) {
      if (trial == most_trials * stones)
        throw InputError(
            fmt::format("{}: no room is found for {} stones, because the outline fills too little of the box around "
                        "it; give a wider outline, or fewer stones",
                        owner_, rubble_.stones));
      const double x = random_between(bits_, box.low.x(), box.high.x());
      const double y = random_between(bits_, box.low.y(), box.high.y());
      const Vec2 p(x, y);
      const auto too_near = [&](const Vec2& q) { return (p - q).norm() < 1e-3 * size_; };
      if (is_inside(outline_, p) && std::none_of(points_.begin(), points_.end(), too_near)) points_.push_back(p);
    }
  }

  /// Lloyd's iteration: each point moves to the centroid of the largest piece of its cell, which evens out size and
  /// shape.
  void relax() {
    const auto cells = voronoi_cells(outline_, points_, 0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      double largest = 0;
      for (const Polygon& piece : cells[i]) {
        const PolygonMoments moments = polygon_moments(piece);
        if (moments.area > largest) largest = moments.area, points_[i] = moments.centroid;
      }
    }
  }

  /// A point that would leave the outline is not moved.
  void shift() {
    if (rubble_.jitter == 0) return;
    for (Vec2& p : points_) {
      const double x = random_between(bits_, -1, 1), y = random_between(bits_, -1, 1);
      const Vec2 moved = p + rubble_.jitter * Vec2(x / rubble_.aspect, y);
      if (is_inside(outline_, moved)) p = moved;
    }
  }

  std::vector<Polygon> all_pieces(double set_back) const {
    std::vector<Polygon> pieces;
    for (auto& cell : voronoi_cells(outline_, points_, set_back)) pieces.insert(pieces.end(), cell.begin(), cell.end());
    return pieces;
  }

  std::vector<Polygon> touching() const {
    return join_corners(all_pieces(0), outline_, 1e-9 * polygon_size(outline_), least_edge_);
  }

  bool is_on_outline(const Vec2& p) const {
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      const Vec2 &a = outline_[i], &b = outline_[(i + 1) % outline_.size()];
      const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      if ((p - (a + t * (b - a))).norm() <= 1e-9 * size_) return true;
    }
    return false;
  }

  /// Removes faces shorter than the least edge from a convex stone by cutting off one of their corners, which keeps it
  /// within the stone. Corners on the outline remain.
  Polygon without_short_faces(Polygon stone) const {
    for (std::size_t i = 0; i < stone.size() && stone.size() > 3;) {
      const std::size_t next = (i + 1) % stone.size();
      const bool held = is_on_outline(stone[i]), next_held = is_on_outline(stone[next]);
      if ((stone[next] - stone[i]).norm() >= least_edge_ || (held && next_held)) {
        ++i;
        continue;
      }
      stone.erase(stone.begin() + static_cast<std::ptrdiff_t>(held ? next : i));
      i = 0;
    }
    return stone;
  }

  /// Stones separated by the joint width.
  std::vector<Polygon> apart() const {
    std::vector<Polygon> stones;
    for (const Polygon& piece : all_pieces(rubble_.joint / 2))
      stones.push_back(is_convex(piece) ? without_short_faces(piece) : piece);
    return stones;
  }

  std::vector<Part> named(const std::vector<Polygon>& stones) const {
    std::vector<std::pair<Vec2, Polygon>> placed;
    for (const Polygon& stone : stones) {
      const CheckedPolygon checked = check_polygon(stone, owner_ + ", a stone");
      placed.emplace_back(polygon_moments(checked.outline).centroid, checked.outline);
    }
    std::stable_sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) {
      return std::pair(a.first.y(), a.first.x()) < std::pair(b.first.y(), b.first.x());
    });
    std::vector<Part> parts;
    for (auto& [centre, stone] : placed) {
      parts.push_back({part_name(rubble_.name, fmt::format("r{}", parts.size() + 1)), std::move(stone), {"stones"}});
      if (!rubble_.name.empty()) parts.back().groups.push_back(rubble_.name);
    }
    return parts;
  }

  const Rubble& rubble_;
  std::string owner_;
  std::mt19937_64 bits_;
  Polygon outline_;  ///< compressed along x by the aspect
  double size_ = 0, least_edge_ = 0;
  std::vector<Vec2> points_;
};

}  // namespace

std::vector<Part> Rubble::parts() const {
  return build_rubble(*this);
}

std::vector<Part> build_rubble(const Rubble& rubble) {
  return Filling(rubble).run();
}

}  // namespace trilith
